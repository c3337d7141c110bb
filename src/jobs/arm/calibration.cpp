// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/calibration.h"

#include <algorithm>
#include <cstdlib>
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
} // namespace

base::Result<void> requireCalibratable(const device::Servo& servo)
{
    if (!calibrationIn(servo) || servo.profile->byRole(Role::PresentPosition) == nullptr)
        return refuse(servo, "no-position-limits");
    if (servo.profile->multiTurn && device::turnBasis(servo).steps == 0)
        return refuse(servo, "joint-in-step-mode");
    return {};
}

namespace {
const char* refusalOf(JointState state, base::JointKind kind)
{
    switch (state) {
    case JointState::Recorded:
        return nullptr;
    case JointState::FullTurn:
        return kind == base::JointKind::Continuous ? nullptr : "joint-full-turn";
    case JointState::LostTrack:
        return "joint-lost-track";
    case JointState::NotMoved:
    case JointState::KeepMoving:
    case JointState::NoReply:
        break;
    }
    return "joint-not-recorded";
}
} // namespace

base::Result<JointCalibration> calibrationOf(const device::Servo& servo, base::JointKind kind,
                                             const JointRange& range,
                                             std::optional<std::int64_t> middle)
{
    if (const auto possible = requireCalibratable(servo); !possible)
        return tl::unexpected(possible.error());
    if (const char* reason = refusalOf(range.state, kind))
        return refuse(servo, reason);
    const JointCalibration present = *calibrationIn(servo);
    const std::int64_t turn = servo.profile->stepsPerTurn;
    if (!servo.profile->multiTurn)
        return JointCalibration{present.homingOffset, static_cast<int>(range.low),
                                static_cast<int>(range.high)};
    const bool isFullTurn = range.state == JointState::FullTurn;
    if (isFullTurn && !middle)
        return JointCalibration{present.homingOffset, 0, static_cast<int>(turn - 1)};

    // The position that a joint has under the new offset is what it has now, moved by `shift`.
    const std::int64_t center = middle.value_or(std::midpoint(range.low, range.high));
    const std::int64_t wanted = middle ? turn / 2 - 1 : turn / 2; // LeRobot's own middle is 2047
    const int offset = nearestOffset(center + present.homingOffset - wanted, turn);
    const std::int64_t shown = withinTurn(center + present.homingOffset - offset, turn);
    const std::int64_t shift = shown - center;
    if (isFullTurn)
        return JointCalibration{offset, 0, static_cast<int>(turn - 1)};
    if (range.low + shift < seamMargin || range.high + shift >= turn - seamMargin)
        return refuse(servo, "joint-beyond-turn");
    return JointCalibration{offset, static_cast<int>(range.low + shift),
                            static_cast<int>(range.high + shift)};
}

std::optional<JointCalibration> calibrationIn(const device::Servo& servo)
{
    if (!servo.profile)
        return std::nullopt;
    const auto low = servo.raw(Role::MinAngle);
    const auto high = servo.raw(Role::MaxAngle);
    const auto offset = servo.raw(Role::PositionOffset);
    const bool hasOffset = servo.profile->byRole(Role::PositionOffset) != nullptr;
    if (!low || !high || (hasOffset && !offset))
        return std::nullopt;
    return JointCalibration{static_cast<int>(offset.value_or(0)), static_cast<int>(*low),
                            static_cast<int>(*high)};
}

base::Result<void> requireValid(const device::Servo& servo, const JointCalibration& values)
{
    const int turn = servo.profile->stepsPerTurn;
    const bool hasOffset = servo.profile->byRole(Role::PositionOffset) != nullptr;
    const int maxOffset = hasOffset && servo.profile->multiTurn ? turn / 2 - 1 : 0;
    const bool isOffsetKept =
        calibrationIn(servo) && calibrationIn(servo)->homingOffset == values.homingOffset;
    if ((std::abs(values.homingOffset) > maxOffset && !isOffsetKept) || values.rangeMin < 0 ||
        values.rangeMax >= turn || values.rangeMin >= values.rangeMax)
        return refuse(servo, "calibration-out-of-range");
    return {};
}

JointSettings positionSettings(const device::Servo& servo, base::JointKind kind)
{
    JointSettings settings;
    const catalog::Profile& profile = *servo.profile;
    const catalog::Mode* mode = profile.mode(QStringLiteral("position"));
    if (kind != base::JointKind::Wheel && mode != nullptr && mode->operatingMode)
        addSetting(settings, profile.byRole(Role::OperatingMode), *mode->operatingMode);
    const auto phase = servo.raw(Role::Phase);
    if (profile.multiTurn && phase)
        addSetting(settings, profile.byRole(Role::Phase), *phase & ~device::fullAnglePhaseBit);
    return settings;
}

snapshot::Snapshot calibrationTemplate(const device::Servo& servo, base::JointKind kind,
                                       const JointCalibration& values, const QString& program)
{
    JointSettings settings;
    addSetting(settings, servo.profile->byRole(Role::PositionOffset), values.homingOffset);
    addSetting(settings, servo.profile->byRole(Role::MinAngle), values.rangeMin);
    addSetting(settings, servo.profile->byRole(Role::MaxAngle), values.rangeMax);
    for (const JointSetting& one : positionSettings(servo, kind))
        settings.push_back(one);
    return jointTemplate(servo, settings, program);
}
} // namespace jobs
