// SPDX-License-Identifier: GPL-3.0-or-later
// Real servos share no processor with the computer. Where the system allows it (as root), the
// simulator of a test goes before the programs of all tests that run at the same time. POSIX only.
#pragma once

#include <QProcess>

#include <sys/resource.h>

namespace support {
/// Before `simulator` is started.
inline void raisePriority(QProcess& simulator)
{
    constexpr int niceness = -10;
    simulator.setChildProcessModifier([] { (void)setpriority(PRIO_PROCESS, 0, niceness); });
}
} // namespace support
