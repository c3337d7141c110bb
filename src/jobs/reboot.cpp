// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion.h"
#include "jobs/change_steps.h"

namespace jobs {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
/// Every start passes a loader that listens at this rate for about 0.8 s; a PING there could be
/// taken for the beginning of a firmware update (protocol sheet §2.5).
constexpr int loaderBaud = 500'000;
constexpr base::Duration quietTime = 700ms;
constexpr base::Duration longestStart = 2s;
constexpr base::Duration askEvery = 50ms;
} // namespace

base::Result<int> reboot(const device::Context& outer, device::Servo& servo)
{
    const QString operation = QStringLiteral("reboot");
    if (const auto writable = requireWritable(servo, operation); !writable)
        return tl::unexpected(writable.error());
    const auto reboots = protocol::Request::reboot(servo.id).in(servo.protocol);
    if (const auto possible =
            requireSayable(servo, reboots, operation, QStringLiteral("no-reboot"));
        !possible)
        return tl::unexpected(possible.error());
    // Everybody keeps quiet meanwhile.
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    if (context.stop.requested())
        return base::fail(ErrorCode::Stopped, operation, {}, servo.id);
    if (const auto sent = sendOnce(context, reboots); !sent)
        return tl::unexpected(sent.error());
    base::Clock& clock = context.bus.clock();
    const base::Duration start = clock.now();
    const base::Duration listenFrom = context.bus.baud() == loaderBaud ? longestStart : quietTime;
    clock.sleepUntil(start + listenFrom);
    servo.image.clear();
    for (;;) {
        const auto here = answers(context, servo.protocol, servo.id);
        if (!here && here.error().code == ErrorCode::LinkLost)
            return tl::unexpected(here.error());
        const base::Duration passed = clock.now() - start;
        if (here && *here) {
            const int milliseconds = static_cast<int>(passed / 1ms);
            context.note(device::NoticeCode::RebootedAfter, servo.id, {}, milliseconds);
            if (const auto fresh = device::readSettings(context, servo); !fresh)
                return tl::unexpected(fresh.error());
            return milliseconds;
        }
        if (passed > longestStart + 200ms)
            return base::fail(ErrorCode::NoAnswer, operation, {}, servo.id);
        clock.sleepFor(askEvery);
    }
}
} // namespace jobs
