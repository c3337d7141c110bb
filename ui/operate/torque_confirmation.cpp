// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/torque_confirmation.h"

#include "ui/operate/torque_hint.h"

#include <algorithm>
#include <utility>

namespace ui {
/// The mode key is empty while the mode is unknown.
TorqueConfirmation::Targets TorqueConfirmation::currentTargets() const
{
    Targets targets;
    for (const session::ServoRef ref : m_motion.servos()) {
        const session::ServoEntry* entry = m_registry.servo(ref);
        const catalog::Mode* mode =
            entry != nullptr && entry->servo.profile ? entry->servo.mode() : nullptr;
        targets.push_back({ref, mode != nullptr ? mode->key : QString()});
    }
    return targets;
}

/// A mode that becomes known is not a change.
bool TorqueConfirmation::isUnchanged(const Targets& targets) const
{
    const Targets now = currentTargets();
    return m_link.state() == session::LinkState::Open &&
           std::equal(targets.begin(), targets.end(), now.begin(), now.end(),
                      [](const auto& before, const auto& after) {
                          return before.first == after.first &&
                                 (before.second.isEmpty() || before.second == after.second);
                      });
}

bool TorqueConfirmation::confirm(std::function<void()> action)
{
    Targets targets = currentTargets();
    const bool isConfirmed = m_hint.isConfirmed([this, targets, action = std::move(action)] {
        if (action && isUnchanged(targets))
            action();
    });
    if (!isConfirmed)
        m_targets = std::move(targets);
    return isConfirmed;
}

bool TorqueConfirmation::confirmEnergize(std::function<void()> action)
{
    const auto& servos = m_motion.servos();
    const bool allOn = std::all_of(servos.begin(), servos.end(), [this](session::ServoRef ref) {
        const session::ServoEntry* entry = m_registry.servo(ref);
        return entry != nullptr && entry->servo.profile &&
               entry->servo.raw(catalog::Role::TorqueSwitch) == 1;
    });
    return allOn || confirm(std::move(action));
}

void TorqueConfirmation::dismiss()
{
    m_hint.dismiss();
}

void TorqueConfirmation::dismissIfOutdated()
{
    if (m_targets && !isUnchanged(*m_targets))
        m_hint.dismiss();
}
} // namespace ui
