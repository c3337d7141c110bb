// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_page.h"

#include "device/motion/move_limits.h"
#include "report/sweep_text.h"
#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/step/step_form.h"
#include "ui/step/step_gains.h"
#include "ui/step/step_results.h"
#include "ui/step/step_runs_dialog.h"
#include "ui/step/step_text.h"
#include "ui/widgets/allow_movement_button.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/thin_progress.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

namespace ui {
namespace {
constexpr int minSetupWidth = 280;
constexpr int maxSetupWidth = 340;
constexpr int setupPercent = 27;
} // namespace

StepPage::StepPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_selection(appContext.selection)
    , m_historyService(appContext.workbench.history())
    , m_test(appContext.workbench.stepTest())
{
    setObjectName(QStringLiteral("stepPage"));
    build(settings);
    connectAll();
    followLanguage(this, [this] {
        retranslate();
        showState();
    });
    onServoSelected();
}

void StepPage::connectAll()
{
    connect(m_form, &StepForm::changed, this, &StepPage::showState);
    connect(m_gains, &StepGains::changed, this, &StepPage::showState);
    connect(m_switchMode, &QCheckBox::toggled, this, &StepPage::showState);
    connect(m_run, &QPushButton::clicked, this, [this] { run(false); });
    connect(m_try, &QPushButton::clicked, this, [this] { run(true); });
    connect(m_allow, &AllowMovementButton::allowed, this, [this] { m_confirmed = false; });
    connect(m_stop, &QPushButton::clicked, &m_test, &session::StepTest::stop);
    connect(m_accept, &QPushButton::clicked, this, &StepPage::accept);
    connect(m_back, &QPushButton::clicked, this, [this] {
        if (m_gains->trial().empty())
            m_test.revert(m_selection.current());
        else
            m_gains->reset();
    });
    connect(m_results, &StepResults::adviceRequested, this,
            [this](const results::StepAdvice& advice) {
                m_gains->setTrial(advice.key, advice.proposed);
                m_try->setFocus();
            });
    connect(m_results, &StepResults::previousRunsRequested, this, &StepPage::showPreviousRuns);
    connect(&m_test, &session::StepTest::progressChanged, this, &StepPage::showProgress);
    connect(&m_test, &session::StepTest::finished, this, &StepPage::onTestFinished);
    connect(&m_test, &session::StepTest::failed, this, &StepPage::onTestFailed);
    connect(&m_test, &session::StepTest::acceptedChanged, this, &StepPage::showState);
    connect(&m_selection, &Selection::changed, this, &StepPage::onServoSelected);
    connect(&m_workbench, &session::Workbench::stateChanged, this, &StepPage::showState);
    const auto isShownServo = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            onServoSelected();
    };
    connect(&m_workbench.registry(), &session::ServoRegistry::servoChanged, this, isShownServo);
    connect(&m_workbench.registry(), &session::ServoRegistry::tableChanged, this, isShownServo);
}

void StepPage::onServoSelected()
{
    if (!m_workbenchGuard)
        return;
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    m_form->showServo(entry);
    // The values of a trial are not the servo's own.
    if (!m_test.isRunning())
        m_gains->showServo(entry);
    if (m_test.servo() != 0 && m_test.servo() != m_selection.current() && !m_test.isRunning() &&
        !m_test.runs().empty()) {
        m_test.clearMeasured();
        m_results->refresh();
    }
    showState();
}

void StepPage::showPreviousRuns()
{
    auto* runs = findChild<StepRunsDialog*>(); // one is enough
    if (runs == nullptr) {
        runs = new StepRunsDialog(m_historyService, m_workbench.catalog(), this);
        connect(runs, &StepRunsDialog::openRequested, this, &StepPage::openStored);
    }
    runs->show();
    runs->raise();
    runs->activateWindow();
}

void StepPage::openStored(const std::vector<std::int64_t>& numbers)
{
    const auto opened = std::make_shared<std::vector<session::StoredStep>>();
    for (const std::int64_t number : numbers) {
        m_historyService.loadStep(number, this,
                                  [this, opened, number, count = numbers.size()](
                                      const base::Result<session::SharedStep>& run) {
                                      if (!run) {
                                          m_banner->showMessage(run.error());
                                          return;
                                      }
                                      opened->push_back({number, *run});
                                      if (opened->size() == count)
                                          m_test.openStored(*opened);
                                  });
    }
}

bool StepPage::otherMode() const
{
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    if (entry == nullptr || !entry->servo.profile || entry->servo.mode() == nullptr)
        return false;
    const auto kind = device::goalKind(entry->servo);
    return kind != device::GoalKind::Position && kind != device::GoalKind::Turns;
}

QString StepPage::blockedReason() const
{
    if (m_workbench.link().state() != session::LinkState::Open)
        return tr("Connect to a port first.");
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    if (entry == nullptr)
        return tr("Select a servo in the list.");
    if (!entry->servo.profile || !entry->servo.profile->writable)
        return tr("This servo could not be identified, so ServoDesk does not move it.");
    if (m_workbench.search().isSearching())
        return tr("A search is running; you can start the run after it ends.");
    if (m_workbench.tasks().isTesting())
        return tr("Another test is running.");
    if (entry->stopped)
        return tr(
            "Movement is blocked by the emergency stop, and torque is off. Click Allow movement to "
            "turn torque on; nothing moves until you click Measure or Try gains.");
    if (otherMode() && !m_switchMode->isChecked())
        return tr("The servo is in a mode that does not use positions. Select \"Switch to position "
                  "mode for the run\" or change the mode yourself.");
    if (m_form->spec().size.isEmpty())
        return tr("Enter the step size.");
    return {};
}

QString StepPage::trialBlockedReason() const
{
    const QString why = blockedReason();
    if (!why.isEmpty())
        return why;
    return m_gains->trial().empty() ? tr("Change a value under Trial first.") : QString();
}

void StepPage::showState()
{
    if (!m_workbenchGuard)
        return;
    const bool running = m_test.isRunning();
    const session::ServoRef ref = m_selection.current();
    m_switchMode->setVisible(otherMode() && !running);
    const session::ServoEntry* entry = m_workbench.registry().servo(ref);
    const catalog::Profile* profile = entry != nullptr ? entry->servo.profile.get() : nullptr;
    const QString why = blockedReason();
    const QString noTrial = trialBlockedReason();
    m_setup->setEnabled(!running);
    m_run->setEnabled(!running && why.isEmpty());
    m_try->setEnabled(!running && noTrial.isEmpty());
    m_stop->setEnabled(running);
    const bool open =
        m_workbench.link().state() == session::LinkState::Open && !m_workbench.tasks().isTesting();
    m_allow->showFor({ref});
    m_accept->setEnabled(!running && open && !m_gains->trial().empty());
    m_back->setEnabled(!running && open &&
                       (!m_gains->trial().empty() || !m_test.previousValues(ref).empty()));
    m_progress->setVisible(running);
    m_reasonLabel->setText(
        running ? tr("The servo is moving. Esc turns torque off on all servos.")
        : !why.isEmpty()
            ? why
            : tr("ID %1 moves when you click Measure or Try gains.").arg(entry->servo.id));
    m_try->setToolTip(noTrial.isEmpty()
                          ? tr("Measures the same step with these values and restores the old "
                               "values afterwards: %1")
                                .arg(stepGainsText(m_gains->trial(), profile))
                          : noTrial);
    std::vector<results::StepGain> earlier;
    for (const device::WriteItem& item : m_test.previousValues(ref))
        earlier.push_back({item.key, item.raw});
    const bool discards = earlier.empty() || !m_gains->trial().empty();
    m_back->setText(discards ? tr("Discard") : tr("Restore old values"));
    m_back->setAccessibleName(m_back->text());
    m_back->setToolTip(discards ? tr("Resets the values under Trial to the present values")
                                : tr("Writes the gains that were set before the last change: %1")
                                      .arg(stepGainsText(earlier, profile)));
    showProgress();
}

void StepPage::showProgress()
{
    if (m_test.isRunning())
        m_progress->setValue(int(m_test.progress().fraction * 1000));
}

void StepPage::run(bool trial)
{
    if (m_confirmed)
        start(trial);
    else
        askForConfirmation(trial);
}

void StepPage::askForConfirmation(bool trial)
{
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    if (entry == nullptr || !entry->servo.profile)
        return;
    Question question;
    question.title = tr("Start the run?");
    question.text = tr("Torque is turned on for ID %1 · %2, and the servo moves by itself at "
                       "maximum speed until the run has ended.")
                        .arg(entry->servo.id)
                        .arg(entry->servo.profile->modelName) +
                    QLatin1Char('\n') +
                    tr("Afterwards, the servo holds its position with torque on, even if you stop "
                       "the run or close the window.");
    question.risk = tr("Keep hands and objects away from the servo. Esc immediately turns torque "
                       "off on all servos.");
    question.acceptText = tr("Start");
    question.guard = this;
    ask(this, question, [this, trial] {
        m_confirmed = true;
        start(trial);
    });
}

void StepPage::start(bool trial)
{
    m_banner->hideMessage();
    m_form->saveSettings();
    session::StepTestRequest order{m_form->spec(), m_selection.current()};
    if (trial)
        order.spec.trial = m_gains->trial();
    order.switchMode = otherMode() && m_switchMode->isChecked();
    if (!m_test.start(order))
        m_banner->showMessage([] { return notStartedText(); });
    showState();
}

/// Writes the values to try permanently, by a safe write that the journal and Undo know.
void StepPage::accept()
{
    m_test.accept(m_selection.current(), m_gains->trial());
}

void StepPage::onTestFinished()
{
    const results::StepRun& run = m_test.runs().back();
    const bool early =
        run.end != results::SweepEnd::Finished && run.end != results::SweepEnd::Stopped;
    if (early || !run.isReverted || !m_test.unreleasedTorque().empty())
        m_banner->showMessage(endMessage());
    onServoSelected();
}

/// How the latest run ended, and everything that it has left in the servo.
std::function<BannerText()> StepPage::endMessage() const
{
    const results::StepRun& run = m_test.runs().back();
    const session::ServoEntry* entry = m_workbench.registry().servo(m_test.servo());
    return [end = run.end, isReverted = run.isReverted, trial = m_test.unrevertedItems(),
            torque = m_test.unreleasedTorque(),
            profile = entry != nullptr ? entry->servo.profile : catalog::ProfilePtr()] {
        const bool bad = !isReverted || !torque.empty();
        BannerText message{bad ? Tone::Bad : Tone::Warn, text::localized(report::endText(end))};
        QStringList left;
        QStringList remedies;
        if (!trial.empty())
            left << tr("Trial values are still in the servo: %1.")
                        .arg(unrevertedTrialText(trial, profile.get()));
        else if (!isReverted)
            left << tr("The settings that were changed for the run could not be restored.");
        if (!isReverted)
            remedies << unrevertedSettingsRemedy();
        if (!torque.empty()) {
            left << unreleasedTorqueText(torque);
            remedies << unreleasedTorqueRemedy();
        }
        message.cause = text::joinSentences(left);
        message.remedy = text::joinSentences(remedies);
        return message;
    };
}

void StepPage::onTestFailed(const base::Error& error)
{
    if (!m_test.unreleasedTorque().empty())
        m_banner->showMessage(
            [error, left = m_test.unreleasedTorque()] { return failureText(error, left); });
    else if (error.code != base::ErrorCode::Stopped)
        m_banner->showMessage(error);
    onServoSelected();
}

void StepPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_scroll->setFixedWidth(std::clamp(width() * setupPercent / 100, minSetupWidth, maxSetupWidth));
}

void StepPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    onServoSelected();
}
} // namespace ui
