// SPDX-License-Identifier: GPL-3.0-or-later
// Real servos and cables share no processor with the computer. Where the system allows it (as
// root), the simulator of a test and the threads that stand for cables run before everything else,
// however busy the machine is. POSIX only.
#pragma once

#include <QProcess>

#include <sched.h>
#include <sys/resource.h>

namespace support {
/// Of the calling thread, not of what it starts. Without the right to real time, a better niceness.
inline void raisePriority()
{
    const sched_param lowest{1};
    constexpr int niceness = -10;
    if (sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &lowest) != 0)
        (void)setpriority(PRIO_PROCESS, 0, niceness);
}

/// Before `simulator` is started.
inline void raisePriority(QProcess& simulator)
{
    simulator.setChildProcessModifier([] { raisePriority(); });
}
} // namespace support
