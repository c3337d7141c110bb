// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/calibration.h"

#include "jobs/restore/take_snapshot.h"

#include <algorithm>
#include <numeric>

namespace jobs {
namespace {
using base::JointState;
using catalog::Role;

tl::unexpected<base::Error> refuse(const device::Servo& servo, const char* reason)
{
    return base::fail(base::ErrorCode::NotSupported, QStringLiteral("calibrate"),
                      QLatin1String(reason), servo.id);
}

bool isRecorded(JointState state)
{
    return state == JointState::Recorded || state == JointState::FullTurn;
}

/// Within one turn, from 0 on.
std::int64_t withinTurn(std::int64_t steps, std::int64_t turn)
{
    return ((steps % turn) + turn) % turn;
}

/// The offset takes away so much; the register holds less than half a turn either way.
int nearestOffset(std::int64_t steps, std::int64_t turn)
{
    const std::int64_t half = turn / 2;
    const std::int64_t offset = withinTurn(steps + half, turn) - half;
    return static_cast<int>(std::max(offset, 1 - half));
}

const catalog::Mode* positionMode(const catalog::Profile& profile)
{
    const auto mode =
        std::find_if(profile.modes.begin(), profile.modes.end(),
                     [](const catalog::Mode& one) { return one.key == QLatin1String("position"); });
    return mode == profile.modes.end() ? nullptr : &*mode;
}
} // namespace

base::Result<JointCalibration> calibrationOf(const device::Servo& servo, const JointRange& range,
                                             std::optional<std::int64_t> middle)
{
    const auto present = calibrationIn(servo);
    if (!present)
        return refuse(servo, "no-position-limits");
    if (!isRecorded(range.state))
        return refuse(servo, "joint-not-recorded");
    const std::int64_t turn = servo.profile->stepsPerTurn;
    const bool isFullTurn = range.state == JointState::FullTurn;
    if (servo.profile->byRole(Role::PositionOffset) == nullptr)
        return JointCalibration{0, static_cast<int>(range.low), static_cast<int>(range.high)};
    if (isFullTurn && !middle)
        return JointCalibration{present->homingOffset, 0, static_cast<int>(turn - 1)};

    // The position that a joint has under the new offset is what it has now, moved by `shift`.
    const std::int64_t center = middle.value_or(std::midpoint(range.low, range.high));
    const std::int64_t wanted = middle ? turn / 2 - 1 : turn / 2; // LeRobot's own middle is 2047
    const int offset = nearestOffset(center + present->homingOffset - wanted, turn);
    const std::int64_t shown = withinTurn(center + present->homingOffset - offset, turn);
    const std::int64_t shift = shown - center;
    if (isFullTurn)
        return JointCalibration{offset, 0, static_cast<int>(turn - 1)};
    if (range.low + shift < 0 || range.high + shift >= turn)
        return refuse(servo, "joint-beyond-turn");
    return JointCalibration{offset, static_cast<int>(range.low + shift),
                            static_cast<int>(range.high + shift)};
}

std::optional<JointCalibration> calibrationIn(const device::Servo& servo)
{
    const auto low = servo.raw(Role::MinAngle);
    const auto high = servo.raw(Role::MaxAngle);
    if (!low || !high)
        return std::nullopt;
    return JointCalibration{static_cast<int>(servo.raw(Role::PositionOffset).value_or(0)),
                            static_cast<int>(*low), static_cast<int>(*high)};
}

snapshot::Snapshot calibrationTemplate(const device::Servo& servo, base::JointKind kind,
                                       const JointCalibration& values, const QString& program)
{
    const catalog::Profile& profile = *servo.profile;
    std::vector<std::pair<Role, int>> wanted{{Role::PositionOffset, values.homingOffset},
                                             {Role::MinAngle, values.rangeMin},
                                             {Role::MaxAngle, values.rangeMax}};
    const catalog::Mode* mode = kind == base::JointKind::Wheel ? nullptr : positionMode(profile);
    if (mode != nullptr && mode->operatingMode)
        wanted.emplace_back(Role::OperatingMode, *mode->operatingMode);
    snapshot::Snapshot result;
    result.program = program;
    result.at = QDateTime::currentDateTimeUtc();
    result.port = servo.port;
    result.baud = servo.baud;
    result.servo = snapshotServo(servo);
    result.isTemplate = true;
    for (const auto& [role, raw] : wanted) {
        const catalog::Register* reg = profile.byRole(role);
        if (reg == nullptr)
            continue;
        const catalog::ValueFormat meaning = servo.meaning(*reg);
        result.registers.push_back({reg->key, reg->address, raw, catalog::toPhysical(raw, meaning),
                                    meaning.unit, reg->area, reg->access});
    }
    return result;
}
} // namespace jobs
