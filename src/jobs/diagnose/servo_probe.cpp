// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/diagnose/servo_probe.h"

#include "device/reader.h"
#include "device/transactions.h"
#include "jobs/scan/scan_profile.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Evidence;
using base::EvidenceKind;
using base::Result;
using catalog::Role;

constexpr int maxPings = 40;
constexpr int minPings = 10;
constexpr int allPings = 200;
constexpr int maxListened = 3;
constexpr base::Duration longestStall = std::chrono::milliseconds(500);

/// A busy computer holds replies back for longer than an adapter does. Where many are lost, there
/// is no need to wait for each.
Result<bool> listenForLateReply(const device::Context& context, const ServoProbe& probe)
{
    if (probe.lost >= maxListened)
        return false;
    if (const auto listened = context.bus.listen(longestStall); !listened)
        return tl::unexpected(listened.error());
    const auto strays = context.bus.takeUnexpectedFrames();
    return std::any_of(strays.begin(), strays.end(),
                       [&](const bus::UnexpectedFrame& stray) { return stray.id == probe.id; });
}

Result<void> countReplies(const device::Context& context, ServoProbe& probe, int pings)
{
    const base::Duration wireTime =
        pingTime(scanProfileOf(probe.protocol), probe.baud, base::Duration{});
    std::vector<base::Duration> times;
    context.bus.takeUnexpectedFrames();
    for (; probe.asked < pings && !context.stop.isRequested(); ++probe.asked) {
        const auto outcome =
            device::pingOnce(context, probe.protocol, probe.id, context.bus.maxReplyLateness());
        if (outcome)
            times.push_back(std::max(outcome->roundTrip - wireTime, base::Duration{}));
        else if (base::endsJob(outcome.error().code))
            return tl::unexpected(outcome.error());
        else if (outcome.error().code == ErrorCode::NoReply) {
            const auto late = listenForLateReply(context, probe);
            if (!late)
                return tl::unexpected(late.error());
            probe.lost += *late ? 0 : 1;
        } else if (outcome.error().code != ErrorCode::Refused) // a refusal is a reply
            ++probe.damaged;
    }
    if (times.empty())
        return {};
    const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    probe.replyTime = *middle;
    return {};
}

Result<void> lookForSecondServo(const device::Context& context, const FoundServo& found,
                                ServoProbe& probe)
{
    if (!found.duplicateSuspected || !found.servo.profile)
        return {};
    const auto checked = device::checkDuplicateId(context, found.servo);
    if (checked)
        probe.duplicate = *checked;
    else if (base::endsJob(checked.error().code))
        return tl::unexpected(checked.error());
    return {};
}

Result<void> readResponseLevel(const device::Context& context, const FoundServo& found,
                               ServoProbe& probe)
{
    device::Servo servo = found.servo;
    if (!servo.profile || servo.profile->byRole(Role::ResponseLevel) == nullptr)
        return {};
    const auto read = device::readRoles(context, servo, {Role::ResponseLevel});
    if (!read && base::endsJob(read.error().code))
        return read;
    probe.acknowledges = servo.raw(Role::ResponseLevel).value_or(1) != 0;
    return {};
}
} // namespace

Result<ServoProbe> probeServo(const device::Context& context, const FoundServo& found, int servos)
{
    ServoProbe probe;
    probe.id = found.servo.id;
    probe.baud = found.servo.baud;
    probe.protocol = found.servo.protocol;
    probe.duplicateSuspected = found.duplicateSuspected;
    const int pings = std::clamp(allPings / std::max(servos, 1), minPings, maxPings);
    const auto done = countReplies(context, probe, pings)
                          .and_then([&] { return lookForSecondServo(context, found, probe); })
                          .and_then([&] { return readResponseLevel(context, found, probe); });
    if (!done)
        return tl::unexpected(done.error());
    return probe;
}

std::vector<Evidence> evidenceOf(const ServoProbe& probe)
{
    std::vector<Evidence> lines;
    const auto addCount = [&](EvidenceKind kind, int count, int total) {
        if (count > 0)
            lines.push_back({.kind = kind, .id = probe.id, .count = count, .total = total});
    };
    addCount(EvidenceKind::LostReplies, probe.lost, probe.asked);
    addCount(EvidenceKind::DamagedReplies, probe.damaged, probe.asked);
    if (probe.duplicate) {
        switch (probe.duplicate->sign) {
        case device::DuplicateIdSign::SecondReply:
            lines.push_back({.kind = EvidenceKind::SecondReply, .id = probe.id});
            break;
        case device::DuplicateIdSign::DifferentValues:
            lines.push_back({.kind = EvidenceKind::DifferentValues, .id = probe.id});
            break;
        case device::DuplicateIdSign::BrokenReplies:
            addCount(EvidenceKind::UnreadableReplies, probe.duplicate->broken,
                     probe.duplicate->reads);
            break;
        case device::DuplicateIdSign::None:
            break;
        }
    }
    if (!probe.acknowledges)
        lines.push_back({.kind = EvidenceKind::NoAcknowledgement, .id = probe.id});
    return lines;
}
} // namespace jobs
