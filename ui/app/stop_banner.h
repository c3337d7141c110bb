// SPDX-License-Identifier: GPL-3.0-or-later
// Shows in the banner that an emergency stop has not reached the servos, or that closing was
// canceled and servos move or EPROM locks are open. Hides it when that is no longer true. Owned by
// the window; main thread.
#pragma once

#include "session/workbench.h"
#include "ui/common/commands.h"

namespace ui {
class Banner;

class StopBanner final : public QObject {
    Q_OBJECT

public:
    StopBanner(const session::Workbench& workbench, const Commands& commands, Banner& banner,
               QObject* parent);

private:
    void onEvent(const session::Event& event);
    void show(const session::Event& event);
    void hideWhenLocksAreClosed();

    const session::Workbench& m_workbench;
    const Commands& m_commands;
    Banner& m_banner;
    bool m_isShown = false;
    /// The open locks are all that the banner shows; else empty.
    std::vector<session::ServoRef> m_unlocked;
};
} // namespace ui
