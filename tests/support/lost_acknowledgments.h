// SPDX-License-Identifier: GPL-3.0-or-later
// A line on which answers to reading come through, but every acknowledgement of a change is lost —
// the trap behind blind repeating. Drives the fault plan of a SimFixture through its tap.
#pragma once

#include "support/sim_fixture.h"

namespace support {
inline bool isWriteFrame(const base::Bytes& frame)
{
    return frame.size() > 4 && frame[4] != Ping && frame[4] != Read && frame[4] != SyncRead;
}

inline void dropAcknowledgments(SimFixture& fixture)
{
    fixture.tap().onWrite = [&fixture](const base::Bytes& frame) {
        fixture.wireConfig().faults.drop = isWriteFrame(frame) ? 1.0 : 0.0;
    };
}

inline void restoreReplies(SimFixture& fixture)
{
    fixture.tap().onWrite = nullptr;
    fixture.wireConfig().faults.drop = 0;
}
} // namespace support
