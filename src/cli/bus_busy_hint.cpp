// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_busy_hint.h"

#include "cli/output/report_text.h"

namespace cli {
void explainBusyLine(Console& console, const device::Context& context, const device::Servo& servo,
                     results::SweepEnd end)
{
    if (end != results::SweepEnd::LinkLost || context.bus.lost())
        return;
    bus::Transaction ping;
    ping.request = protocol::Request::ping(servo.id).in(servo.protocol);
    ping.stop = &context.stop;
    const auto answer = context.bus.transact(ping);
    if (!answer && answer.error().code == base::ErrorCode::LineBusy)
        console.printMessage(errorText(answer.error()));
}
} // namespace cli
