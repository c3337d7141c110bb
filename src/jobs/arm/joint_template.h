// SPDX-License-Identifier: GPL-3.0-or-later
// Settings for a joint's servo: what they change, and as a template, which writeJoints()
// writes. Pure; any thread.
#pragma once

#include "device/servo.h"
#include "snapshot/snapshot.h"

namespace jobs {
struct JointSetting {
    const catalog::Register* reg = nullptr;
    std::int64_t raw = 0;
};
using JointSettings = std::vector<JointSetting>;

/// Left out where the servo has no such register.
void addSetting(JointSettings& settings, const catalog::Register* reg, std::int64_t raw);

struct SettingChange {
    const catalog::Register* reg = nullptr;
    std::int64_t now = 0;
    std::int64_t wanted = 0;
};
/// Those that the servo holds with other values, as far as they have been read.
std::vector<SettingChange> changesOf(const device::Servo& servo, const JointSettings& settings);

snapshot::Snapshot jointTemplate(const device::Servo& servo, const JointSettings& settings,
                                 const QString& program);
} // namespace jobs
