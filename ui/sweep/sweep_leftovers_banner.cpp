// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_leftovers_banner.h"

#include "text/error_text.h"
#include "text/language.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/test_text.h"

#include <algorithm>

namespace ui {
SweepLeftoversBanner::SweepLeftoversBanner(session::SweepTest& test,
                                           const session::ServoRegistry& registry,
                                           const session::HistoryService& history, Banner& banner,
                                           QObject* parent)
    : QObject(parent)
    , m_registry(registry)
    , m_test(test)
    , m_banner(banner)
{
    connect(&history, &session::HistoryService::runSaveFailed, this,
            &SweepLeftoversBanner::showNotSaved);
    connect(&m_test, &session::SweepTest::leftoversChanged, this, &SweepLeftoversBanner::update);
    connect(&m_banner, &Banner::dismissed, this, [this] { m_shown = false; });
}

void SweepLeftoversBanner::hide()
{
    m_banner.hideMessage();
    m_shown = false;
}

void SweepLeftoversBanner::showNotSaved(const base::Error& error, const QString& file)
{
    m_shown = false;
    m_banner.showMessage([error, file] {
        const text::Description words = text::describe(error);
        return BannerText{
            Tone::Bad, tr("The test could not be saved to the history."), words.message,
            file.isEmpty() ? words.remedy : tr("The test was saved to the file %1.").arg(file)};
    });
}

/// "ID 1: Operating mode (own value 1), Goal speed (own value 0)"
QString SweepLeftoversBanner::unrevertedSettingsText() const
{
    std::map<int, QStringList> names;
    for (const device::Notice& one : m_test.unrevertedSettings()) {
        const auto& all = m_registry.order();
        const auto found = std::find_if(all.begin(), all.end(), [&](session::ServoRef ref) {
            const session::ServoEntry* entry = m_registry.servo(ref);
            return entry != nullptr && entry->servo.id == one.id && entry->servo.profile;
        });
        const catalog::Profile* profile =
            found != all.end() ? m_registry.servo(*found)->servo.profile.get() : nullptr;
        names[one.id]
            << tr("%1 (old value %2)").arg(text::registerName(profile, one.key)).arg(one.a);
    }
    QStringList servos;
    for (const auto& [id, registers] : names)
        servos << QStringLiteral("ID %1: %2").arg(id).arg(text::joinItems(registers));
    return text::joinClauses(servos);
}

void SweepLeftoversBanner::show(const std::optional<base::Error>& error)
{
    m_failure = error;
    m_shown = !m_test.unrevertedSettings().empty() || !m_test.unreleasedTorque().empty();
    if (!m_shown) {
        if (error && error->code != base::ErrorCode::Stopped)
            m_banner.showMessage(*error);
        return;
    }
    m_banner.showMessage([this] {
        QStringList what;
        QStringList remedies;
        if (const auto& torque = m_test.unreleasedTorque(); !torque.empty()) {
            what << unreleasedTorqueText(torque);
            remedies << unreleasedTorqueRemedy();
        }
        if (!m_test.unrevertedSettings().empty()) {
            what << tr("Test settings are still in effect: %1.").arg(unrevertedSettingsText());
            remedies << unrevertedSettingsRemedy();
        }
        if (m_failure)
            what.prepend(text::describe(*m_failure).message);
        const QString first = what.isEmpty() ? QString() : what.takeFirst();
        return BannerText{Tone::Bad, first, text::joinSentences(what),
                          text::joinSentences(remedies)};
    });
}

/// A part of the message may be resolved.
void SweepLeftoversBanner::update()
{
    if (!m_shown)
        return;
    m_banner.hideMessage();
    show(m_failure);
}
} // namespace ui
