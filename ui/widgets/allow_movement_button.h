// SPDX-License-Identifier: GPL-3.0-or-later
// "Allow movement", beside the button that starts a test: after an emergency stop it asks, then
// turns torque on for the servos that are blocked; nothing moves by that. Hidden while there is
// nothing to allow, disabled while a search, a test or a task keeps the bus. A failure is shown in
// the banner. Owned by its page; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/servos/servo_registry.h"
#include "session/tasks/emergency_stop.h"

#include <QPushButton>

namespace ui {
class Banner;

class AllowMovementButton final : public QPushButton {
    Q_OBJECT

public:
    AllowMovementButton(session::EmergencyStop& emergencyStop,
                        const session::ServoRegistry& registry, const session::LinkController& link,
                        Banner& banner, QWidget* parent);

    /// The servos that the page would move.
    void showFor(const std::vector<session::ServoRef>& servos);

Q_SIGNALS:
    void allowed(); ///< the user has agreed: the page asks again before the next run

private:
    struct AskedServo {
        session::ServoRef servo;
        base::Duration stoppedAt;
    };
    std::vector<session::ServoRef> blocked() const;
    void askToAllow();
    void allow(const std::vector<AskedServo>& asked);
    void retranslate();

    session::EmergencyStop& m_emergencyStop;
    const session::ServoRegistry& m_registry;
    const session::LinkController& m_link;
    Banner& m_banner;
    std::vector<session::ServoRef> m_servos;
};

/// "ID 1, ID 2" of those that an emergency stop blocks; empty: none.
QString blockedByStopText(const session::ServoRegistry& registry,
                          const std::vector<session::ServoRef>& servos);
} // namespace ui
