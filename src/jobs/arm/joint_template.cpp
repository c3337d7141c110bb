// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/joint_template.h"

#include "jobs/restore/take_snapshot.h"

namespace jobs {
void addSetting(JointSettings& settings, const catalog::Register* reg, std::int64_t raw)
{
    if (reg != nullptr)
        settings.push_back({reg, raw});
}

std::vector<SettingChange> changesOf(const device::Servo& servo, const JointSettings& settings)
{
    std::vector<SettingChange> changes;
    for (const JointSetting& one : settings) {
        const auto now = servo.raw(*one.reg);
        if (now && *now != one.raw)
            changes.push_back({one.reg, *now, one.raw});
    }
    return changes;
}

snapshot::Snapshot jointTemplate(const device::Servo& servo, const JointSettings& settings,
                                 const QString& program)
{
    snapshot::Snapshot result = emptySnapshot(servo, program);
    result.isTemplate = true;
    for (const JointSetting& one : settings) {
        const catalog::ValueFormat meaning = servo.meaning(*one.reg);
        result.registers.push_back({one.reg->key, one.reg->address, one.raw,
                                    catalog::toPhysical(one.raw, meaning), meaning.unit,
                                    one.reg->area, one.reg->access});
    }
    return result;
}
} // namespace jobs
