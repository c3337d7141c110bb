// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change/blink.h"

#include "device/persistence.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using catalog::Area;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
const QString blinkOperation = QStringLiteral("identify");
constexpr base::Duration slice = 50ms; ///< how late a stop may be noticed

/// How this servo's LED is switched.
struct Led {
    const catalog::Register* reg = nullptr;
    std::int64_t before = 0;
    std::int64_t other = 0;
    base::Duration half{}; ///< of a blink
};

bool isPersistent(const catalog::Register& reg)
{
    return device::retentionOf(reg) == device::Retention::Always;
}

base::Result<const catalog::Register*> ledRegister(const device::Servo& servo)
{
    const catalog::Register* reg = servo.profile->byRole(Role::Led);
    if (reg == nullptr)
        reg = servo.profile->byRole(Role::LedCondition);
    if (reg == nullptr || !reg->writable())
        return base::fail(ErrorCode::NotSupported, blinkOperation, QStringLiteral("no-led"),
                          servo.id);
    if (reg->area == Area::Factory)
        return base::fail(ErrorCode::NotSupported, blinkOperation, QStringLiteral("factory-led"),
                          servo.id);
    return reg;
}

/// The LED is on unless the condition is 0 (register sheet, row 20); any named fault is enough.
std::int64_t toggledValue(const catalog::Register& reg, std::int64_t before)
{
    if (reg.role == Role::Led || before == 0)
        return before == 0 ? 1 : 0;
    return 0;
}

/// An open lock would keep each blink in the EPROM.
base::Result<void> ensureLockClosed(const device::Context& context, device::Servo& servo)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (lock == nullptr)
        return {};
    const auto flag = device::readRegister(context, servo, *lock);
    if (!flag)
        return tl::unexpected(flag.error());
    if (!device::isLockOpen(*flag))
        return {};
    context.note(device::NoticeCode::LockFoundOpen, servo.id, lock->key);
    if (device::closeLock(context, servo) != device::LockState::Closed)
        return base::fail(ErrorCode::LockOpen, blinkOperation, {}, servo.id);
    context.note(device::NoticeCode::LockClosed, servo.id, lock->key);
    return {};
}

/// False when stop was requested.
bool waitUntil(const device::Context& context, base::Duration until)
{
    base::Clock& clock = context.bus.clock();
    while (!context.stop.isRequested() && clock.now() < until)
        clock.sleepFor(std::min(slice, until - clock.now()));
    return !context.stop.isRequested();
}

/// The servo is held only during each transaction, so that its live values continue.
base::Result<void> writeLed(const device::Context& outer, device::Servo& servo, const Led& led,
                            std::int64_t raw)
{
    const device::Owned owned = device::own(outer, {servo.id});
    return device::writeVerified(owned.context, servo, *led.reg, raw);
}

base::Result<void> blinkUntil(const device::Context& context, device::Servo& servo, const Led& led,
                              base::Duration time, const ProgressFn& progress, BlinkReport& report)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration start = clock.now();
    const base::Duration end = start + time;
    bool changed = false;
    while (clock.now() < end) {
        changed = !changed;
        if (const auto shown = writeLed(context, servo, led, changed ? led.other : led.before);
            !shown)
            return shown;
        report.blinks += changed ? 1 : 0;
        const base::Duration now = clock.now();
        if (progress) {
            const double fraction = double((now - start).count()) / double(time.count());
            progress({std::min(1.0, fraction), std::max(base::Duration(), end - now)});
        }
        if (!waitUntil(context, std::min(now + led.half, end))) {
            report.stopped = true;
            break;
        }
    }
    return {};
}

/// Also after a lost reply or an emergency stop: the LED must not stay as it is.
base::Result<void> restoreLed(const device::Context& context, device::Servo& servo, const Led& led)
{
    constexpr int rounds = 3;
    base::Result<void> back;
    for (int round = 0; round < rounds; ++round) {
        back = writeLed(context, servo, led, led.before);
        if (back || back.error().code == ErrorCode::LinkLost)
            break;
        context.bus.clock().sleepFor(slice);
    }
    if (!back)
        context.note(device::NoticeCode::LedNotRestored, servo.id, led.reg->key);
    return back;
}

base::Result<QString> journal(const device::Context& context, const device::Servo& servo,
                              const Led& led)
{
    base::Intent intent;
    intent.kind = base::IntentKind::Identify;
    intent.temporary = !isPersistent(*led.reg);
    intent.servo = servo.identity();
    intent.items = {{led.reg->key, led.reg->address, led.before, led.other}};
    return context.journal.begin(intent);
}

base::Result<Led> prepare(const device::Context& outer, device::Servo& servo,
                          const catalog::Register& reg)
{
    const device::Owned owned = device::own(outer, {servo.id});
    const device::Context& context = owned.context;
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    const auto before = device::readRegister(context, servo, reg);
    if (!before)
        return tl::unexpected(before.error());
    if (!isPersistent(reg)) {
        if (const auto shut = ensureLockClosed(context, servo); !shut)
            return tl::unexpected(shut.error());
    }
    return Led{&reg, *before, toggledValue(reg, *before), isPersistent(reg) ? 1000ms : 400ms};
}
} // namespace

base::Result<BlinkReport> blink(const device::Context& context, device::Servo& servo,
                                base::Duration time, const ProgressFn& progress)
{
    if (const auto writable = device::requireWritable(servo, blinkOperation); !writable)
        return tl::unexpected(writable.error());
    const auto reg = ledRegister(servo);
    if (!reg)
        return tl::unexpected(reg.error());
    if (const auto may = device::beginWriting(context, servo, blinkOperation); !may)
        return tl::unexpected(may.error());
    const auto led = prepare(context, servo, **reg);
    if (!led)
        return tl::unexpected(led.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, blinkOperation, {}, servo.id);
    const auto uuid = journal(context, servo, *led);
    if (!uuid)
        return tl::unexpected(uuid.error());
    BlinkReport report{led->reg->key, led->before};
    const auto blinked = blinkUntil(context, servo, *led, time, progress, report);
    const auto back = restoreLed(context, servo, *led);
    endIntent(context, *uuid, servo.id, back.has_value(), blinked.has_value());
    if (!blinked)
        return tl::unexpected(blinked.error());
    if (!back)
        return tl::unexpected(back.error());
    return report;
}
} // namespace jobs
