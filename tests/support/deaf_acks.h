// SPDX-License-Identifier: GPL-3.0-or-later
// A line on which answers to reading come through, but every acknowledgement of a change is lost —
// the trap behind blind repeating. Drives the fault plan of a SimBench through its tap.
#pragma once

#include "support/sim_bench.h"

namespace support {
inline bool isChange(const base::Bytes& frame)
{
    return frame.size() > 4 && frame[4] != Ping && frame[4] != Read && frame[4] != SyncRead;
}

inline void loseAcknowledgements(SimBench& bench)
{
    bench.tap().onWrite = [&bench](const base::Bytes& frame) {
        bench.wireConfig().faults.drop = isChange(frame) ? 1.0 : 0.0;
    };
}

inline void hearEverything(SimBench& bench)
{
    bench.tap().onWrite = nullptr;
    bench.wireConfig().faults.drop = 0;
}
} // namespace support
