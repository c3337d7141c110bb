// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/record_ranges.h"

#include "device/motion/motion.h"
#include "jobs/arm/calibration.h"
#include "jobs/arm/joint_access.h"
#include "jobs/watch/watch.h"

#include <algorithm>
#include <cmath>

namespace jobs {
namespace {
using catalog::Role;
using namespace std::chrono_literals;

constexpr base::Duration readingPeriod = 20ms;
constexpr double degreesPerSecondPerRpm = 6;

struct JointColumns {
    std::optional<std::size_t> position{};
    double stepsPerUnit = 1; ///< of the position
    std::optional<std::size_t> speed{};
};

std::optional<std::size_t> columnOf(const std::vector<WatchColumn>& columns,
                                    const device::Servo& servo, Role role)
{
    const catalog::Register* reg = servo.profile->byRole(role);
    if (reg == nullptr)
        return std::nullopt;
    const WatchColumn wanted{reg->key, servo.meaning(*reg).unit};
    const auto found = std::find(columns.begin(), columns.end(), wanted);
    return found == columns.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

JointColumns columnsOf(const std::vector<WatchColumn>& columns, const device::Servo& servo)
{
    JointColumns result;
    result.position = columnOf(columns, servo, Role::PresentPosition);
    const catalog::Register* position = servo.profile->byRole(Role::PresentPosition);
    if (const double scale = servo.meaning(*position).scale; scale != 0)
        result.stepsPerUnit = 1 / scale;
    const catalog::Register* speed = servo.profile->byRole(Role::PresentSpeed);
    if (speed != nullptr && servo.meaning(*speed).unit == QLatin1String("rpm"))
        result.speed = columnOf(columns, servo, Role::PresentSpeed);
    return result;
}

QStringList keysOf(const std::vector<device::Servo>& servos)
{
    QStringList keys;
    for (const device::Servo& servo : servos) {
        for (const Role role : {Role::PresentPosition, Role::PresentSpeed}) {
            const catalog::Register* reg = servo.profile->byRole(role);
            if (reg != nullptr && !keys.contains(reg->key))
                keys << reg->key;
        }
    }
    return keys;
}

/// Nothing is turned off before all can be recorded.
base::Result<void> releaseJoints(const device::Context& context, std::vector<device::Servo>& servos)
{
    for (device::Servo& servo : servos) {
        const auto possible =
            readJoint(context, servo).and_then([&] { return requireCalibratable(servo); });
        if (!possible)
            return possible;
    }
    for (device::Servo& servo : servos) {
        if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
            return off;
    }
    return {};
}
} // namespace

base::Result<std::vector<JointRange>> recordRanges(const device::Context& context,
                                                   std::vector<device::Servo>& servos,
                                                   const RangesFn& onRanges)
{
    if (const auto released = releaseJoints(context, servos); !released)
        return tl::unexpected(released.error());
    const WatchSpec spec{servos, keysOf(servos), readingPeriod};
    const std::vector<WatchColumn> columns = watchColumns(spec);
    std::vector<JointRangeRecorder> recorders;
    std::vector<JointColumns> places;
    for (const device::Servo& servo : servos) {
        recorders.emplace_back(servo);
        places.push_back(columnsOf(columns, servo));
    }
    std::vector<JointRange> ranges(servos.size());
    bool isEnough = false;
    const auto onRow = [&](const WatchRow& row) -> base::Result<void> {
        const auto servo = std::find_if(servos.begin(), servos.end(), [&](const auto& one) {
            return one.id == row.id && one.protocol == row.protocol;
        });
        if (servo == servos.end())
            return {};
        const auto index = static_cast<std::size_t>(servo - servos.begin());
        const auto valueAt = [&](std::optional<std::size_t> place) {
            return place && row.answered ? row.values[*place] : std::nullopt;
        };
        if (const auto position = valueAt(places[index].position)) {
            auto speed = valueAt(places[index].speed);
            if (speed)
                *speed *= degreesPerSecondPerRpm;
            recorders[index].add(std::llround(*position * places[index].stepsPerUnit), speed,
                                 row.at);
            ranges[index] = recorders[index].range();
        }
        isEnough = row.id == servos.back().id && !onRanges(ranges);
        return isEnough ? base::fail(base::ErrorCode::Stopped) : base::Result<void>{};
    };
    const auto watched = watch(context, spec, onRow);
    if (!watched && !isEnough)
        return tl::unexpected(watched.error());
    return ranges;
}
} // namespace jobs
