// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/diagnose/conclusion.h"

#include "jobs/diagnose/diagnose.h"

#include <algorithm>

namespace jobs {
namespace {
using base::Cause;
using device::DuplicateIdSign;

/// Two servos that reply at once damage nearly every reply to a PING, or none, because their
/// replies are the same bytes. Noise damages some.
constexpr double minTwinDamage = 0.8;
constexpr double maxTwinAccord = 0.05;
/// More lost and damaged replies than this are no accident.
constexpr double maxErrorShare = 0.03;
constexpr int maxErrors = 1;
/// Programs that wait for as long as the vendor's tool does hear no servo behind a slower adapter.
constexpr base::Duration patienceOfOthers = std::chrono::milliseconds(25);

enum class Twins { No, Maybe, Likely };

Twins twinsBehind(const ServoProbe& probe)
{
    if (!probe.duplicateSuspected)
        return Twins::No;
    const auto sign = probe.duplicate ? probe.duplicate->sign : DuplicateIdSign::BrokenReplies;
    switch (sign) {
    case DuplicateIdSign::SecondReply:
    case DuplicateIdSign::DifferentValues:
        return Twins::Likely;
    case DuplicateIdSign::BrokenReplies: {
        const double errors = probe.lost + probe.damaged;
        const bool some =
            errors > maxTwinAccord * probe.asked && errors < minTwinDamage * probe.asked;
        return some ? Twins::Maybe : Twins::Likely;
    }
    case DuplicateIdSign::None:
        break;
    }
    return Twins::No;
}

bool isDisturbed(const ServoProbe& probe)
{
    const int errors = probe.lost + probe.damaged;
    return errors > maxErrors && errors > maxErrorShare * probe.asked;
}

/// The causes that were seen, the most certain first.
std::vector<Cause> causesBehind(const Observations& seen)
{
    std::vector<Cause> causes;
    const auto add = [&](Cause cause, bool is) {
        if (is && std::find(causes.begin(), causes.end(), cause) == causes.end())
            causes.push_back(cause);
    };
    const auto anyProbe = [&](auto&& is) {
        return std::any_of(seen.probes.begin(), seen.probes.end(), is);
    };
    const auto anyFound = [&](auto&& is) {
        return std::any_of(seen.found.begin(), seen.found.end(),
                           [&](const FoundServo& found) { return is(found.servo); });
    };
    add(Cause::TwoServosOneId,
        anyProbe([](const ServoProbe& probe) { return twinsBehind(probe) == Twins::Likely; }));
    add(Cause::WrongBaudRate,
        anyFound([&](const device::Servo& servo) { return servo.baud != seen.homeRate; }));
    add(Cause::OtherProtocol, anyFound([&](const device::Servo& servo) {
            const auto& chosen = seen.protocols;
            return !chosen.empty() &&
                   std::find(chosen.begin(), chosen.end(), servo.protocol) == chosen.end();
        }));
    add(Cause::Noise, anyProbe([](const ServoProbe& probe) {
                          return isDisturbed(probe) && twinsBehind(probe) != Twins::Likely;
                      }) ||
                          !seen.busyRates.empty());
    add(Cause::TwoServosOneId,
        anyProbe([](const ServoProbe& probe) { return twinsBehind(probe) == Twins::Maybe; }));
    add(Cause::LateAdapter,
        anyProbe([](const ServoProbe& probe) { return probe.replyTime > patienceOfOthers; }));
    add(Cause::ResponseLevel0,
        anyProbe([](const ServoProbe& probe) { return !probe.acknowledges; }));
    add(Cause::Noise, seen.hasGarbledReplies);
    return causes;
}

std::vector<Cause> causesOfSilence(const Observations& seen)
{
    if (seen.hasBootloader)
        return {Cause::Bootloader};
    if (!seen.text.isEmpty())
        return {Cause::BoardNotAdapter};
    if (!seen.busyRates.empty())
        return {Cause::Noise, Cause::BoardNotAdapter};
    if (seen.hasGarbledReplies || seen.totalBytes() > 0) {
        if (seen.hasEcho)
            return {Cause::EchoOnly, Cause::Noise};
        return {Cause::Noise, Cause::TwoServosOneId};
    }
    if (seen.hasEcho)
        return {Cause::EchoOnly, Cause::NoServoOrNoPower};
    return {Cause::NoServoOrNoPower};
}
} // namespace

base::Diagnosis conclude(const Observations& seen)
{
    std::vector<Cause> causes = seen.found.empty() ? causesOfSilence(seen) : causesBehind(seen);
    // Two programs take each other's replies, which looks like any of the others.
    if (seen.isShared)
        causes.insert(causes.begin(), Cause::PortBusy);
    if (causes.empty())
        causes.push_back(Cause::Found);
    base::Diagnosis diagnosis;
    diagnosis.cause = causes.front();
    diagnosis.also.assign(causes.begin() + 1, causes.end());
    return diagnosis;
}

Cause causeOf(const base::Error& error)
{
    switch (error.code) {
    case base::ErrorCode::PortMissing:
        return Cause::PortMissing;
    case base::ErrorCode::PortPermission:
        return Cause::PortPermission;
    case base::ErrorCode::PortBusy:
        return Cause::PortBusy;
    default:
        return Cause::PortFailed;
    }
}
} // namespace jobs
