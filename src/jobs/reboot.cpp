// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion.h"
#include "device/move_limits.h"
#include "device/talk.h"
#include "device/write_access.h"
#include "jobs/change_steps.h"
#include "jobs/temporary.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString operation = QStringLiteral("reboot");

/// Every start passes a loader that listens at this rate for about 0.8 s; a PING there could be
/// taken for the beginning of a firmware update (protocol sheet §2.5).
constexpr int loaderBaud = 500'000;
constexpr base::Duration quietTime = 700ms;
constexpr base::Duration longestStart = 2s;
constexpr base::Duration askEvery = 25ms;
/// One lost PING is no proof that the servo was away.
constexpr int silencesThatProve = 2;

/// A RAM value that no restart leaves as it is: the torque limit, which every start loads from the
/// EPROM, or the running time, which every start sets to its default. One step off, with torque
/// off, it moves nothing.
struct Mark {
    const catalog::Register* reg = nullptr; ///< null: this servo has none
    std::int64_t raw = 0;
    std::unique_ptr<TemporarySettings> written{}; ///< null: the value was another one by itself

    bool stands(const device::Servo& servo) const { return servo.raw(*reg) == raw; }
};

bool endsAll(ErrorCode code)
{
    return code == ErrorCode::LinkLost || code == ErrorCode::Stopped || code == ErrorCode::Held ||
           code == ErrorCode::Preempted;
}

/// The servo has no such value, or does not take another one. Anything else, such as a full disk
/// or a lost line, is none of its doing.
bool takesNoMark(ErrorCode code)
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

/// Null: nothing in this servo can be a mark. In motor mode the running time is the motor's output.
const catalog::Register* markOf(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    if (profile.byRole(Role::TorqueLimit) != nullptr && profile.byRole(Role::MaxTorque) != nullptr)
        return profile.byRole(Role::TorqueLimit);
    const catalog::Register* time = profile.byRole(Role::GoalTime);
    const bool positions = device::goalKind(servo) == device::GoalKind::Position;
    return time != nullptr && time->defaultRaw && positions ? time : nullptr;
}

/// What a start leaves in the mark's register.
std::optional<std::int64_t> loadedAtStart(const device::Servo& servo, const catalog::Register& mark)
{
    return mark.role == Role::TorqueLimit ? servo.raw(Role::MaxTorque) : mark.defaultRaw;
}

/// Without a mark silence has to prove the restart, so a servo that takes none is no error. A
/// journal that cannot be written and a lost line are, before the command is sent.
base::Result<Mark> setMark(const device::Context& context, device::Servo& servo)
{
    const catalog::Register* reg = markOf(servo);
    if (reg == nullptr)
        return Mark{};
    const auto read = device::readRoles(context, servo, {reg->role, Role::MaxTorque});
    if (!read && !takesNoMark(read.error().code))
        return tl::unexpected(read.error());
    const auto now = servo.raw(reg->role);
    const auto loaded = loadedAtStart(servo, *reg);
    if (!read || !now || !loaded)
        return Mark{};
    if (*now != *loaded)
        return Mark{reg, *now};
    const std::int64_t raw = *now > reg->min.value_or(0) ? *now - 1 : *now + 1;
    auto written = TemporarySettings::set(context, servo, {{reg->key, raw}});
    if (!written && !takesNoMark(written.error().code))
        return tl::unexpected(written.error());
    return written ? Mark{reg, raw, std::move(*written)} : Mark{};
}

/// True: it acknowledged a command that has no answer. Listens for as long as nothing may be sent.
base::Result<bool> acknowledged(const device::Context& context, const device::Servo& servo)
{
    const base::Duration quiet = context.bus.baud() == loaderBaud ? longestStart : quietTime;
    const auto heard = context.bus.listen(std::max(quiet, context.bus.replyTimeout()));
    if (!heard)
        return tl::unexpected(heard.error());
    bool answered = false;
    for (const bus::Stray& stray : context.bus.takeStrays()) {
        if (stray.id != servo.id)
            continue;
        if (stray.exception != 0)
            return base::fail(ErrorCode::Refused, operation, bus::exceptionName(stray.exception),
                              servo.id);
        answered = true;
    }
    return answered;
}

/// Waits until it answers; how many questions before that it did not.
base::Result<int> awaitAnswer(const device::Context& context, const device::Servo& servo,
                              base::Duration sentAt)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration end = sentAt + longestStart + 200ms + 2 * context.bus.replyTimeout();
    for (int silences = 0;; ++silences) {
        const auto here = answers(context, servo.protocol, servo.id, 0);
        if (!here && endsAll(here.error().code))
            return tl::unexpected(here.error());
        if (here && *here)
            return silences;
        if (clock.now() > end)
            return base::fail(ErrorCode::NoAnswer, operation, {}, servo.id);
        clock.sleepFor(askEvery);
    }
}

/// What one request for a restart came to.
struct Try {
    bool acknowledged = false;
    bool wasSilent = false;
    bool markStands = false;
    base::Duration took{};

    /// Proven not to have happened: it is safe to ask again.
    bool ignored() const { return markStands && !wasSilent && !acknowledged; }
};

base::Result<Try> tryOnce(const device::Context& context, device::Servo& servo, const Mark& mark)
{
    context.bus.takeStrays();
    const auto sent = sendOnce(context, protocol::Request::reboot(servo.id).in(servo.protocol));
    if (!sent)
        return tl::unexpected(sent.error());
    const base::Duration sentAt = context.bus.clock().now();
    const auto word = acknowledged(context, servo);
    if (!word)
        return tl::unexpected(word.error());
    const auto silences = awaitAnswer(context, servo, sentAt);
    if (!silences)
        return tl::unexpected(silences.error());
    Try result{*word, *silences >= silencesThatProve, false, context.bus.clock().now() - sentAt};
    servo.image.clear();
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (mark.reg == nullptr)
        return result;
    if (const auto fresh = device::readRoles(context, servo, {mark.reg->role}); !fresh)
        return tl::unexpected(fresh.error());
    result.markStands = mark.stands(servo);
    return result;
}

/// Why this is no proof of a restart; empty: it is one.
QString doubt(const Try& last, const Mark& mark)
{
    const bool proven = mark.reg != nullptr ? !last.markStands : last.wasSilent;
    if (proven)
        return {};
    if (mark.reg == nullptr || last.wasSilent)
        return QStringLiteral("restart-unproven");
    return last.acknowledged ? QStringLiteral("restart-acknowledged")
                             : QStringLiteral("not-restarted");
}

base::Result<int> restart(const device::Context& context, device::Servo& servo, const Mark& mark)
{
    auto last = tryOnce(context, servo, mark);
    if (last && last->ignored() && !context.stop.requested()) {
        context.note(device::NoticeCode::SentAgain, servo.id);
        last = tryOnce(context, servo, mark);
    }
    if (!last)
        return tl::unexpected(last.error());
    const QString why = doubt(*last, mark);
    if (!why.isEmpty())
        return base::fail(ErrorCode::Refused, operation, why, servo.id);
    return static_cast<int>(last->took / 1ms);
}
} // namespace

base::Result<int> reboot(const device::Context& outer, device::Servo& servo)
{
    if (const auto writable = device::requireWritable(servo, operation); !writable)
        return tl::unexpected(writable.error());
    const auto reboots = protocol::Request::reboot(servo.id).in(servo.protocol);
    if (const auto possible =
            requireSayable(servo, reboots, operation, QStringLiteral("no-reboot"));
        !possible)
        return tl::unexpected(possible.error());
    // Nothing else is sent meanwhile.
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, operation); !may)
        return tl::unexpected(may.error());
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    if (context.stop.requested())
        return base::fail(ErrorCode::Stopped, operation, {}, servo.id);
    auto mark = setMark(context, servo);
    if (!mark) {
        context.note(device::NoticeCode::TorqueStaysOff, servo.id); // it was proven a moment ago
        return tl::unexpected(mark.error());
    }
    const auto milliseconds = restart(context, servo, *mark);
    if (!milliseconds)
        return milliseconds; // the mark is taken back
    context.note(device::NoticeCode::RebootedAfter, servo.id, {}, *milliseconds);
    if (mark->written)
        mark->written->forget();
    return milliseconds;
}
} // namespace jobs
