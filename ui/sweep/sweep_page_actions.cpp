// SPDX-License-Identifier: GPL-3.0-or-later
// What the page starts, and what it does with the result.
#include "report/sweep_text.h"
#include "results/sweep_verdict.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/sweep/limits_dialog.h"
#include "ui/sweep/runs_dialog.h"
#include "ui/sweep/sweep_form.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_results.h"
#include "ui/sweep/sweep_servos.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/test_text.h"

#include <QLabel>

#include <algorithm>

namespace ui {
void SweepPage::run()
{
    const session::SweepTestRequest now = testRequest();
    const Consent consent{now.servos, now.spec.releaseAtEnd, now.switchMode};
    if (m_consent == consent) {
        start();
        return;
    }
    QStringList names;
    for (const session::ServoRef ref : now.servos) {
        const session::ServoEntry* entry = m_desk.servo(ref);
        names.append(QStringLiteral("ID %1 · %2, %3")
                         .arg(QString::number(entry->servo.id), entry->servo.profile->modelName,
                              rangeOf(ref, now.spec)));
    }
    Question question;
    question.title = tr("Start the test?");
    question.text = tr("These servos get torque and move by themselves until the test has ended: "
                       "%1")
                        .arg(QLatin1Char('\n') + names.join(QLatin1Char('\n'))) +
                    QLatin1Char('\n') + torqueAfterwards(consent);
    question.risk = tr("Keep hands and objects out of their way. Esc takes torque off all servos "
                       "at once.");
    question.acceptText = tr("Start");
    question.guard = this;
    ask(this, question, [this, consent] {
        m_consent = consent;
        start();
    });
}

/// "1500 … 2500" as typed; of a list its outermost targets, as far as they have been worked out.
QString SweepPage::rangeOf(session::ServoRef ref, const record::SweepSpec& spec) const
{
    const auto words = [](const QString& from, const QString& to) {
        return tr("range %1 … %2").arg(from, to);
    };
    const auto preview = std::find_if(m_previews.begin(), m_previews.end(), [ref](const auto& one) {
        return one.servo == ref && one.estimate;
    });
    if (spec.shape != record::SweepShape::Points) {
        const auto own = spec.ranges.find(m_desk.servo(ref)->servo.id);
        const record::SweepRange& range = own != spec.ranges.end() ? own->second : spec.range;
        return words(range.from, range.to);
    }
    if (preview == m_previews.end())
        return tr("targets of the list");
    const auto& axis = preview->estimate->axis;
    return words(QString::number(axis.from), QString::number(axis.to));
}

/// However it ends, apart from faults and the emergency stop; also of servos without torque before.
QString SweepPage::torqueAfterwards(const Consent& consent)
{
    if (consent.released)
        return tr("Afterwards their torque is off. The same applies if you stop the test or close "
                  "the window during it.");
    const QString held = tr("Afterwards they hold their position with torque on. The same applies "
                            "if you stop the test or close the window during it.");
    return consent.switchMode
               ? held + QLatin1Char('\n') +
                     tr("Those that go back to another mode have their torque off afterwards.")
               : held;
}

void SweepPage::start()
{
    m_banner->hideMessage();
    m_leftoversShown = false;
    m_references.clear();
    m_form->saveSettings();
    m_previewTimer.stop();
    if (m_test.start(testRequest()))
        m_progressLabel->setText(tr("On the way to the start"));
    else
        m_banner->showMessage([] { return notStartedText(); });
    showState();
}

void SweepPage::onTestFinished()
{
    saveRun();
    showLeftovers({});
    showVerdicts();
    showState();
    schedulePreview(); // what the servo has set now may be something else
}

/// "ID 1: Operating mode (own value 1), Goal speed (own value 0)"
QString SweepPage::unrevertedSettingsText() const
{
    std::map<int, QStringList> names;
    for (const device::Notice& one : m_test.unrevertedSettings()) {
        const auto& all = m_desk.servos();
        const auto found = std::find_if(all.begin(), all.end(), [&](session::ServoRef ref) {
            const session::ServoEntry* entry = m_desk.servo(ref);
            return entry != nullptr && entry->servo.id == one.id && entry->servo.profile;
        });
        const catalog::Register* reg =
            found != all.end() ? m_desk.servo(*found)->servo.profile->find(one.key) : nullptr;
        names[one.id] << tr("%1 (own value %2)")
                             .arg(reg != nullptr ? reg->name.in(text::isUiChinese()) : one.key)
                             .arg(one.a);
    }
    QStringList servos;
    for (const auto& [id, registers] : names)
        servos << QStringLiteral("ID %1: %2").arg(id).arg(registers.join(QStringLiteral(", ")));
    return servos.join(QStringLiteral("; "));
}

/// All that a test has left in its servos, and why it failed, if it did.
void SweepPage::showLeftovers(const std::optional<base::Error>& error)
{
    m_failure = error;
    m_leftoversShown = !m_test.unrevertedSettings().empty() || !m_test.unreleasedTorque().empty();
    if (!m_leftoversShown) {
        if (error && error->code != base::ErrorCode::Stopped)
            m_banner->showMessage(*error);
        return;
    }
    m_banner->showMessage([this] {
        QStringList what;
        QStringList remedies;
        if (const auto& torque = m_test.unreleasedTorque(); !torque.empty()) {
            what << unreleasedTorqueText(torque);
            remedies << unreleasedTorqueRemedy();
        }
        if (!m_test.unrevertedSettings().empty()) {
            what
                << tr("Settings of the test still in the servo: %1.").arg(unrevertedSettingsText());
            remedies << unrevertedSettingsRemedy();
        }
        if (m_failure)
            what.prepend(text::describe(*m_failure).message);
        const QString first = what.isEmpty() ? QString() : what.takeFirst();
        return BannerText{Tone::Bad, first, what.join(QLatin1Char(' ')),
                          remedies.join(QLatin1Char(' '))};
    });
}

/// Something of it is over: it must not be said any longer.
void SweepPage::showRemainingLeftovers()
{
    if (!m_leftoversShown)
        return;
    m_banner->hideMessage();
    showLeftovers(m_failure);
}

/// Of the latest test, in the table of servos.
void SweepPage::showVerdicts()
{
    std::map<session::ServoRef, SweepServos::Verdict> verdicts;
    const record::SweepRun* run = m_test.run();
    for (std::size_t i = 0; run != nullptr && !m_test.isRunning() && i < run->servos.size(); ++i) {
        const record::SweepVerdict found = record::sweepVerdict(*run, run->servos[i]);
        const bool bare = found.reason == record::NoVerdictReason::None;
        verdicts[m_test.servos().at(i)] = {
            found.grade, bare ? gradeText(found.grade)
                              : report::noVerdictReasonText(found.reason).in(text::isUiChinese())};
    }
    m_servos->setVerdicts(verdicts);
}

/// In the history, and held against the reference of its model.
void SweepPage::saveRun()
{
    const auto run = std::make_shared<const record::SweepRun>(*m_test.run());
    m_historyService.saveRun(run, {m_test.readingsPath()});
    m_historyService.compareWithReference(
        run, this, [this](const base::Result<std::vector<session::ReferenceResult>>& found) {
            m_references = found.value_or(std::vector<session::ReferenceResult>{});
            showReference();
        });
}

void SweepPage::showReference()
{
    const record::SweepRun* run = m_test.run();
    const std::size_t shown = m_results->shownServo();
    if (run == nullptr || m_test.isRunning() || shown >= run->servos.size())
        return;
    const int id = run->servos[shown].parameters.servo.id;
    const auto found = std::find_if(m_references.begin(), m_references.end(),
                                    [id](const auto& one) { return one.servo == id; });
    m_results->setComparison(found != m_references.end() ? referenceText(*found) : QString());
}

void SweepPage::onTestFailed(const base::Error& error)
{
    showLeftovers(error);
    showState();
    schedulePreview();
}

void SweepPage::editLimits(session::ServoRef ref)
{
    const session::ServoEntry* entry = m_desk.servo(ref);
    if (entry == nullptr || !entry->servo.profile)
        return;
    const auto& profile = *entry->servo.profile;
    auto* dialog = new LimitsDialog(m_servos->limits(ref), profile.modelName, profile.series, this);
    connect(dialog, &LimitsDialog::limitsAccepted, this,
            [this, model = profile.modelName, series = profile.series](
                const record::SweepLimits& limits) { m_servos->setLimits(model, series, limits); });
    dialog->open();
}
} // namespace ui
