// SPDX-License-Identifier: GPL-3.0-or-later
// How servos of each protocol are searched: which IDs exist, how long an absent one takes, and how
// to recognize a late reply. Data; any thread. Sources: Feetech, Modbus and LX protocol sheets
// (IDs, stations, timeouts in use).
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
struct ScanProfile {
    int firstId = 0;
    int lastId = 0;
    base::Duration timeout{};       ///< beyond wire time, for an ID that may not exist
    int wireBytes = 0;              ///< request and reply
    base::Duration pause{};         ///< silence between frames in this protocol
    bool supportsBroadcast = false; ///< one broadcast finds a single servo
};
const ScanProfile& scanProfileOf(base::Protocol protocol);

/// The IDs of the spec that exist in this protocol; empty when `first` > `last`.
struct IdRange {
    int first = 0;
    int last = -1;
    int count() const { return last < first ? 0 : last - first + 1; }
    bool contains(int id) const { return id >= first && id <= last; }
};
IdRange idsToScan(const ScanSpec& spec, base::Protocol protocol);

/// Time one absent ID takes.
base::Duration pingTime(const ScanProfile& scanProfile, int baud, base::Duration timeout);

/// Is this a late reply to a request of a scan, not to another one?
bool isPingReply(base::Protocol protocol, const bus::UnexpectedFrame& stray);

/// The echo of a PING is the reply of a servo with a voltage alarm, byte for byte. The bus strips
/// echoes that come in time.
bool looksLikeEcho(const bus::Bus& bus, base::Protocol protocol, const bus::UnexpectedFrame& stray);
} // namespace jobs
