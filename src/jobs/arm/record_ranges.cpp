// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/record_ranges.h"

#include "device/motion/motion.h"
#include "device/reader.h"
#include "jobs/watch/watch.h"

#include <algorithm>

namespace jobs {
namespace {
using namespace std::chrono_literals;

constexpr base::Duration readingPeriod = 20ms;
constexpr double degreesPerSecondPerRpm = 6;

/// The columns of one servo: positions in degrees, speeds in the unit it has.
std::optional<double> valueIn(const std::vector<WatchColumn>& columns, const WatchRow& row,
                              const QString& key, const QString& unit)
{
    for (std::size_t i = 0; i < columns.size() && i < row.values.size(); ++i) {
        if (columns[i].key == key && columns[i].unit == unit)
            return row.values[i];
    }
    return std::nullopt;
}

base::Result<void> releaseJoints(const device::Context& context, std::vector<device::Servo>& servos)
{
    for (device::Servo& servo : servos) {
        const auto released = device::setTorque(context, servo, device::Torque::Off).and_then([&] {
            return device::readSettings(context, servo);
        });
        if (!released)
            return released;
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
    std::vector<JointRangeRecorder> recorders(servos.begin(), servos.end());
    std::vector<JointRange> ranges(servos.size());
    const WatchSpec spec{servos,
                         {QStringLiteral("present_position"), QStringLiteral("present_speed")},
                         readingPeriod};
    const std::vector<WatchColumn> columns = watchColumns(spec);
    bool isEnough = false;
    const auto onRow = [&](const WatchRow& row) -> base::Result<void> {
        const auto servo = std::find_if(servos.begin(), servos.end(), [&](const auto& one) {
            return one.id == row.id && one.protocol == row.protocol;
        });
        const auto position =
            valueIn(columns, row, QStringLiteral("present_position"), QStringLiteral("deg"));
        if (servo != servos.end() && row.answered && position) {
            auto speed =
                valueIn(columns, row, QStringLiteral("present_speed"), QStringLiteral("rpm"));
            if (speed)
                *speed *= degreesPerSecondPerRpm;
            const auto index = static_cast<std::size_t>(servo - servos.begin());
            recorders[index].add(*position, speed, row.at);
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
