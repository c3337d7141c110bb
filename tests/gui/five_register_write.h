// SPDX-License-Identifier: GPL-3.0-or-later
// A write that takes long enough to be interrupted: five registers of an STS3215 behind its lock.
#pragma once

#include "session/workbench.h"
#include "sim/servo/virtual_servo.h"

namespace gui {
inline session::WriteRequest fiveRegisterWrite()
{
    session::WriteRequest order;
    for (const auto& [key, raw] : {std::pair{"min_angle_limit", 500},
                                   {"max_angle_limit", 3500},
                                   {"max_temperature", 61},
                                   {"position_p", 20},
                                   {"overload_torque", 70}})
        order.items.push_back({QString::fromLatin1(key), raw});
    order.consent = device::Consent::confirmed();
    return order;
}

inline bool isSecondRegisterWritten(const sim::VirtualServo& servo)
{
    return servo.raw(QStringLiteral("max_angle_limit")) == 3500;
}
} // namespace gui
