// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan_all.h"

#include <algorithm>

namespace jobs {
namespace {
const QString operation = QStringLiteral("search");
constexpr int mostSearches = 4;

bool holds(const std::vector<Found>& list, const Found& one)
{
    return std::any_of(list.begin(), list.end(), [&](const Found& other) {
        return other.servo.id == one.servo.id && other.servo.protocol == one.servo.protocol;
    });
}

/// The first that only one of both lists has.
std::optional<int> odd(const std::vector<Found>& a, const std::vector<Found>& b)
{
    for (const Found& one : a)
        if (!holds(b, one))
            return one.servo.id;
    for (const Found& one : b)
        if (!holds(a, one))
            return one.servo.id;
    return {};
}

/// One that is there and cannot be read would be missing without a word.
base::Result<std::vector<device::Servo>> readable(const std::vector<Found>& found)
{
    std::vector<device::Servo> servos;
    for (const Found& one : found) {
        if (!one.servo.profile || one.twinsSuspected)
            return base::fail(base::ErrorCode::Garbled, operation, {}, one.servo.id);
        servos.push_back(one.servo);
    }
    return servos;
}
} // namespace

base::Result<std::vector<device::Servo>> scanAll(const device::Context& context,
                                                 const std::vector<base::Protocol>& protocols,
                                                 const ProgressFn& progress)
{
    ScanSpec spec;
    spec.protocols = protocols;
    std::optional<std::vector<Found>> before;
    std::optional<int> doubtful;
    for (int search = 0; search < mostSearches; ++search) {
        auto report = scan(context, spec, progress);
        if (!report)
            return tl::unexpected(report.error());
        if (report->stopped)
            return base::fail(base::ErrorCode::Stopped, operation);
        if (before) {
            doubtful = odd(*before, report->found);
            if (!doubtful)
                return readable(report->found);
        }
        before = std::move(report->found);
        spec.slowPass = spec.slowPass || report->slowPassAdvised;
    }
    return base::fail(base::ErrorCode::Garbled, operation, {}, doubtful.value_or(-1));
}
} // namespace jobs
