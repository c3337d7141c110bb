// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_all.h"

#include <algorithm>

namespace jobs {
namespace {
const QString scanAllOperation = QStringLiteral("search");
constexpr int maxSearches = 4;

bool containsServo(const std::vector<FoundServo>& list, const FoundServo& one)
{
    return std::any_of(list.begin(), list.end(), [&](const FoundServo& other) {
        return other.servo.id == one.servo.id && other.servo.protocol == one.servo.protocol;
    });
}

/// The first servo that is in only one of the two lists.
std::optional<int> firstDifference(const std::vector<FoundServo>& a,
                                   const std::vector<FoundServo>& b)
{
    for (const FoundServo& one : a)
        if (!containsServo(b, one))
            return one.servo.id;
    for (const FoundServo& one : b)
        if (!containsServo(a, one))
            return one.servo.id;
    return {};
}

/// A servo that answers but cannot be read would be missing without notice.
base::Result<std::vector<device::Servo>> identifiedServos(const std::vector<FoundServo>& found)
{
    std::vector<device::Servo> servos;
    for (const FoundServo& one : found) {
        if (!one.servo.profile || one.duplicateSuspected)
            return base::fail(base::ErrorCode::Garbled, scanAllOperation, {}, one.servo.id);
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
    std::optional<std::vector<FoundServo>> before;
    std::optional<int> differingId;
    for (int search = 0; search < maxSearches; ++search) {
        auto report = scan(context, spec, progress);
        if (!report)
            return tl::unexpected(report.error());
        if (report->stopped)
            return base::fail(base::ErrorCode::Stopped, scanAllOperation);
        if (before) {
            differingId = firstDifference(*before, report->found);
            if (!differingId)
                return identifiedServos(report->found);
        }
        before = std::move(report->found);
        spec.slowPass = spec.slowPass || report->slowPassAdvised;
    }
    return base::fail(base::ErrorCode::Garbled, scanAllOperation, {}, differingId.value_or(-1));
}
} // namespace jobs
