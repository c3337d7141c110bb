// SPDX-License-Identifier: GPL-3.0-or-later
// Asks with the torque hint before servos are energized, and keeps the answer to the servos and
// modes it was asked for: the same number is a position in one mode and a speed in another. Owned
// by the control panel; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/motion/motion_controller.h"
#include "session/servos/servo_registry.h"

#include <functional>
#include <optional>

namespace ui {
class TorqueHint;

class TorqueConfirmation final {
public:
    TorqueConfirmation(const session::LinkController& link, const session::ServoRegistry& registry,
                       const session::MotionController& motion, TorqueHint& hint)
        : m_link(link)
        , m_registry(registry)
        , m_motion(motion)
        , m_hint(hint)
    {}

    /// True: already confirmed. False: the hint is shown, and `action` (which may be empty) follows
    /// its confirmation if the servos and their modes are still the same.
    bool confirm(std::function<void()> action);
    /// As confirm(), but true for servos that all have torque already.
    bool confirmEnergize(std::function<void()> action);
    void dismiss();
    /// Dismisses the hint if other servos are controlled, a mode has changed or the port is closed.
    void dismissIfOutdated();

private:
    using Targets = std::vector<std::pair<session::ServoRef, QString>>; ///< servos and mode keys
    Targets currentTargets() const;
    bool isUnchanged(const Targets& targets) const;

    const session::LinkController& m_link;
    const session::ServoRegistry& m_registry;
    const session::MotionController& m_motion;
    TorqueHint& m_hint;
    std::optional<Targets> m_targets; ///< the hint was last shown for these
};
} // namespace ui
