// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/stop_banner.h"

#include "text/language.h"
#include "ui/app/event_text.h"
#include "ui/widgets/banner.h"

#include <algorithm>
#include <utility>

namespace ui {
StopBanner::StopBanner(const session::Workbench& workbench, const Commands& commands,
                       Banner& banner, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_commands(commands)
    , m_banner(banner)
{
    connect(&workbench, &session::Workbench::eventOccurred, this, &StopBanner::onEvent);
    connect(&workbench.registry(), &session::ServoRegistry::servoChanged, this,
            &StopBanner::hideWhenLocksAreClosed);
    connect(&banner, &Banner::dismissed, this, [this] { m_isShown = false; });
}

void StopBanner::onEvent(const session::Event& event)
{
    using Kind = session::Event::Kind;
    const bool needsAttention =
        event.kind == Kind::StopNotSent || event.isPending || event.kind == Kind::CloseCanceled;
    if (needsAttention)
        show(event);
    else if (event.kind == Kind::Stopped && std::exchange(m_isShown, false))
        m_banner.hideMessage();
}

void StopBanner::show(const session::Event& event)
{
    m_isShown = true;
    m_unlocked = event.moving.empty() ? event.unlocked : std::vector<session::ServoRef>{};
    QList<QAction*> actions;
    if (m_workbench.link().state() == session::LinkState::Open && !event.isPending)
        actions << m_commands.action(Command::TorqueOffAll);
    m_banner.showMessage(
        [this, event] {
            const EventText words = describe(event, m_workbench.registry());
            return BannerText{Tone::Bad, words.message, {}, text::joinSentences(words.details)};
        },
        actions);
}

void StopBanner::hideWhenLocksAreClosed()
{
    const auto isOpen = [this](session::ServoRef ref) {
        const session::ServoEntry* entry = m_workbench.registry().servo(ref);
        return entry == nullptr || entry->isLockOpen().value_or(true);
    };
    if (!m_isShown || m_unlocked.empty() ||
        std::any_of(m_unlocked.begin(), m_unlocked.end(), isOpen))
        return;
    m_unlocked.clear();
    m_isShown = false;
    m_banner.hideMessage();
}
} // namespace ui
