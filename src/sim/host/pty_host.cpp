// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/host/pty_host.h"

#include <algorithm>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace sim {
namespace {
constexpr base::Duration tick = std::chrono::milliseconds(20);
constexpr base::Duration maxLead = std::chrono::milliseconds(2);
/// The system wakes a sleeper some ten microseconds late; the rest of the way is spun.
constexpr base::Duration spinTime{60};

// By default the kernel may put a wake-up off by 50 µs to save power.
void setMinTimerSlack()
{
#ifdef __linux__
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
#endif
}

/// Requested delays are kept; only the transmission time itself may be shortened.
base::Duration leadTime(const WireConfig& wire, bool wireTime)
{
    const bool delays = wire.adapterLatency > base::Duration{} || wire.faults.late > 0;
    return wireTime || delays ? base::Duration{} : maxLead;
}
} // namespace

PtyHost::PtyHost(VirtualBus& bus, PtyDevice& device, bool wireTime)
    : m_bus(bus)
    , m_device(device)
    , m_wireTime(wireTime)
    , m_lead(leadTime(bus.config(), wireTime))
{}

void PtyHost::serve(std::optional<base::Duration> until, const std::function<void()>& housekeeping)
{
    if (m_wireTime)
        setMinTimerSlack();
    m_bus.hostReads(m_clock.now());
    base::Duration nextTick = m_clock.now() + tick;
    while (!m_device.isWoken()) {
        const base::Duration now = m_clock.now();
        if (until && now >= *until)
            break;
        const auto due = m_bus.nextHostRun(now + m_lead + tick);
        if (due && *due - m_lead <= now) {
            deliver(*due);
            continue;
        }
        if (now >= nextTick) {
            // Idle servos advance in small steps; a reply under way is not split.
            if (!due)
                deliver(now);
            housekeeping();
            nextTick = now + tick;
        }
        waitFor(due, until ? std::min(nextTick, *until) : nextTick);
        listen();
    }
}

void PtyHost::waitFor(std::optional<base::Duration> due, base::Duration latest)
{
    if (!due) {
        m_device.wait(latest - m_clock.now());
        return;
    }
    const base::Duration instant = *due - m_lead;
    const base::Duration spin = m_wireTime ? spinTime : base::Duration{};
    m_device.wait(std::min(instant - spin, latest) - m_clock.now());
    if (instant - m_clock.now() > spin)
        return;
    while (m_clock.now() < instant) {
    }
}

void PtyHost::listen()
{
    const base::Bytes bytes = m_device.read();
    if (bytes.empty())
        return;
    const base::Duration now = m_clock.now();
    const int baud = m_device.baud();
    if (baud <= 0)
        return;
    if (baud != m_bus.hostBaud()) {
        deliver(now);
        m_bus.setHostBaud(baud);
    }
    m_bus.hostWrites(bytes, baud, now);
}

void PtyHost::deliver(base::Duration upTo)
{
    const base::Bytes bytes = m_bus.hostReads(upTo);
    if (!bytes.empty())
        m_device.write(bytes);
}
} // namespace sim
