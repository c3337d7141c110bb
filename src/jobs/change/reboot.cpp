// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/late_reply_guard.h"
#include "device/bootloader.h"
#include "device/motion/motion.h"
#include "device/motion/move_limits.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"
#include "jobs/temporary_settings.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString rebootOperation = QStringLiteral("reboot");

constexpr base::Duration quietTime = 700ms;
constexpr base::Duration maxStartTime = 2s;
constexpr base::Duration pingInterval = 25ms;
/// One lost PING is no proof that the servo was away.
constexpr int missedPingsProvingRestart = 2;

/// A RAM value that every restart changes: the torque limit, which every start loads from the
/// EPROM, or the running time, which every start sets to its default. One step off, with torque
/// off, it moves nothing.
struct RestartMarker {
    const catalog::Register* reg = nullptr; ///< null: this servo has none
    std::int64_t raw = 0;
    std::unique_ptr<TemporarySettings> written{}; ///< null: the value already differed

    bool isUnchanged(const device::Servo& servo) const { return servo.raw(*reg) == raw; }
};

/// The servo has no such value, or does not take another one. Other errors, such as a full disk or
/// a lost link, do not come from the servo.
bool isMarkerImpossible(ErrorCode code)
{
    switch (code) {
    case ErrorCode::NotSupported:
    case ErrorCode::OutOfRange:
    case ErrorCode::ReadOnly:
    case ErrorCode::NeedsConsent:
    case ErrorCode::Refused:
    case ErrorCode::Mismatch:
        return true;
    default:
        return false;
    }
}

/// Null: this servo has no register for a mark. In motor mode the running time is the motor's
/// output.
const catalog::Register* markerRegister(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    if (profile.byRole(Role::TorqueLimit) != nullptr && profile.byRole(Role::MaxTorque) != nullptr)
        return profile.byRole(Role::TorqueLimit);
    const catalog::Register* time = profile.byRole(Role::GoalTime);
    const bool positions = device::goalKind(servo) == device::GoalKind::Position;
    return time != nullptr && time->defaultRaw && positions ? time : nullptr;
}

/// The value of the mark's register after a start.
std::optional<std::int64_t> valueAfterRestart(const device::Servo& servo,
                                              const catalog::Register& marker)
{
    return marker.role == Role::TorqueLimit ? servo.raw(Role::MaxTorque) : marker.defaultRaw;
}

/// Without a mark silence has to prove the restart, so a servo that takes none is no error. A
/// journal that cannot be written and a lost line are, before the command is sent.
base::Result<RestartMarker> setMarker(const device::Context& context, device::Servo& servo)
{
    const catalog::Register* reg = markerRegister(servo);
    if (reg == nullptr)
        return RestartMarker{};
    const auto read = device::readRoles(context, servo, {reg->role, Role::MaxTorque});
    if (!read && !isMarkerImpossible(read.error().code))
        return tl::unexpected(read.error());
    const auto now = servo.raw(reg->role);
    const auto loaded = valueAfterRestart(servo, *reg);
    if (!read || !now || !loaded)
        return RestartMarker{};
    if (*now != *loaded)
        return RestartMarker{reg, *now};
    const std::int64_t raw = *now > reg->min.value_or(0) ? *now - 1 : *now + 1;
    auto written = TemporarySettings::set(context, servo, {{reg->key, raw}});
    if (!written && !isMarkerImpossible(written.error().code))
        return tl::unexpected(written.error());
    return written ? RestartMarker{reg, raw, std::move(*written)} : RestartMarker{};
}

/// True: it acknowledged a command that has no reply. Listens for as long as nothing may be sent.
base::Result<bool> isAcknowledged(const device::Context& context, const device::Servo& servo)
{
    // A PING could be misread as the beginning of a firmware update (protocol sheet §2.5).
    const bool isHeard = context.bus.baud() == device::bootloaderBaud;
    const base::Duration quiet = isHeard ? maxStartTime : quietTime;
    const auto listened = context.bus.listen(std::max(quiet, context.bus.maxReplyLateness()));
    if (!listened)
        return tl::unexpected(listened.error());
    bool answered = false;
    for (const bus::UnexpectedFrame& stray : context.bus.takeUnexpectedFrames()) {
        if (stray.id != servo.id)
            continue;
        if (stray.exception != 0)
            return base::fail(ErrorCode::Refused, rebootOperation,
                              bus::exceptionName(stray.exception), servo.id);
        answered = true;
    }
    return answered;
}

/// How many of the PINGs since `first` were answered late. All replies look alike: the one that was
/// taken for that of the last PING may be that of the first one, and the others come after it.
int lateReplies(const device::Context& context, const device::Servo& servo, base::Duration first)
{
    const base::Duration span = context.bus.clock().now() - first;
    if (span < bus::LateReplyGuard::maxStall)
        (void)context.bus.listen(span + context.bus.maxReplyLateness());
    const auto frames = context.bus.takeUnexpectedFrames();
    return static_cast<int>(
        std::count_if(frames.begin(), frames.end(),
                      [&](const bus::UnexpectedFrame& frame) { return frame.id == servo.id; }));
}

struct FirstReply {
    base::Duration at{};
    int missedPings = 0; ///< before it; a PING that was answered late is not missed
};

base::Result<FirstReply> waitForReply(const device::Context& context, const device::Servo& servo,
                                      base::Duration sentAt)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration first = clock.now();
    const base::Duration end = sentAt + maxStartTime + 200ms + 2 * context.bus.maxReplyLateness();
    for (int missedPings = 0;; ++missedPings) {
        const auto answering = isAnswering(context, servo.protocol, servo.id, 0);
        if (!answering && base::endsJob(answering.error().code))
            return tl::unexpected(answering.error());
        if (answering && *answering) {
            const base::Duration at = clock.now();
            const int late = missedPings == 0 ? 0 : lateReplies(context, servo, first);
            return FirstReply{at, missedPings - late};
        }
        if (clock.now() > end)
            return base::fail(ErrorCode::NoReply, rebootOperation, {}, servo.id);
        clock.sleepFor(pingInterval);
    }
}

/// The result of one request for a restart.
struct RebootAttempt {
    bool isAcknowledged = false;
    bool wasUnresponsive = false;
    bool isMarkerUnchanged = false;
    base::Duration duration{};

    /// Proven not to have happened: it is safe to send it again.
    bool ignored() const { return isMarkerUnchanged && !wasUnresponsive && !isAcknowledged; }
};

base::Result<RebootAttempt> rebootOnce(const device::Context& context, device::Servo& servo,
                                       const RestartMarker& marker)
{
    context.bus.takeUnexpectedFrames();
    const auto sent = sendOnce(context, protocol::Request::reboot(servo.id).in(servo.protocol));
    if (!sent)
        return tl::unexpected(sent.error());
    const base::Duration sentAt = context.bus.clock().now();
    const auto word = isAcknowledged(context, servo);
    if (!word)
        return tl::unexpected(word.error());
    const auto reply = waitForReply(context, servo, sentAt);
    if (!reply)
        return tl::unexpected(reply.error());
    RebootAttempt result{*word, reply->missedPings >= missedPingsProvingRestart, false,
                         reply->at - sentAt};
    servo.image.clear();
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (marker.reg == nullptr)
        return result;
    if (const auto fresh = device::readRoles(context, servo, {marker.reg->role}); !fresh)
        return tl::unexpected(fresh.error());
    result.isMarkerUnchanged = marker.isUnchanged(servo);
    return result;
}

/// Why this is no proof of a restart; empty: it is one.
QString failureDetail(const RebootAttempt& last, const RestartMarker& marker)
{
    const bool isProven = marker.reg != nullptr ? !last.isMarkerUnchanged : last.wasUnresponsive;
    if (isProven)
        return {};
    if (marker.reg == nullptr || last.wasUnresponsive)
        return QStringLiteral("restart-unproven");
    return last.isAcknowledged ? QStringLiteral("restart-acknowledged")
                               : QStringLiteral("not-restarted");
}

base::Result<int> restart(const device::Context& context, device::Servo& servo,
                          const RestartMarker& marker)
{
    auto last = rebootOnce(context, servo, marker);
    if (last && last->ignored() && !context.stop.isRequested()) {
        context.note(device::NoticeCode::Resent, servo.id);
        last = rebootOnce(context, servo, marker);
    }
    if (!last)
        return tl::unexpected(last.error());
    const QString why = failureDetail(*last, marker);
    if (!why.isEmpty())
        return base::fail(ErrorCode::Refused, rebootOperation, why, servo.id);
    return static_cast<int>(last->duration / 1ms);
}
} // namespace

base::Result<int> reboot(const device::Context& outer, device::Servo& servo)
{
    if (const auto writable = device::requireWritable(servo, rebootOperation); !writable)
        return tl::unexpected(writable.error());
    const auto reboots = protocol::Request::reboot(servo.id).in(servo.protocol);
    if (const auto possible =
            requireEncodable(servo, reboots, rebootOperation, QStringLiteral("no-reboot"));
        !possible)
        return tl::unexpected(possible.error());
    // Nothing else is sent meanwhile.
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, rebootOperation); !may)
        return tl::unexpected(may.error());
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, rebootOperation, {}, servo.id);
    auto marker = setMarker(context, servo);
    if (!marker) {
        context.note(device::NoticeCode::TorqueStaysOff, servo.id); // it was proven a moment ago
        return tl::unexpected(marker.error());
    }
    const auto milliseconds = restart(context, servo, *marker);
    if (!milliseconds)
        return milliseconds; // the mark is removed
    context.note(device::NoticeCode::RebootedAfter, servo.id, {}, *milliseconds);
    if (marker->written)
        marker->written->forget();
    return milliseconds;
}
} // namespace jobs
