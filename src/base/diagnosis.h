// SPDX-License-Identifier: GPL-3.0-or-later
// What the diagnosis of a bus found: one cause, the other possible ones, and the evidence. Data
// only; made by jobs::diagnose() (or from the error of a port that could not be opened), worded by
// the text layer. Any thread.
#pragma once

#include "base/clock.h"
#include "base/protocol.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace base {
enum class Cause : std::uint8_t {
    Found, ///< all is well
    PortMissing,
    PortPermission,
    PortBusy,
    PortFailed,
    NoServoOrNoPower,
    EchoOnly,      ///< the adapter returns what is sent, and nothing else comes
    WrongBaudRate, ///< servos reply at another rate
    OtherProtocol, ///< servos reply in a protocol that was not selected
    TwoServosOneId,
    LateAdapter,
    ResponseLevel0,  ///< servos carry out writes without acknowledging them
    Noise,           ///< damaged or lost replies, or a line that never falls silent
    BoardNotAdapter, ///< text comes from the port
    Bootloader       ///< a servo waits for a firmware, as after an update that was cut off
};

enum class EvidenceKind : std::uint8_t {
    PortOpened,   ///< baud; text: the port
    OtherProgram, ///< text: that has the port open too
    LatencyTimer, ///< time: of the adapter
    Echo,
    NoEcho,
    NothingReceived,   ///< count: rates tried
    BytesReceived,     ///< count, baud; text: the first ones in hexadecimal
    TextReceived,      ///< baud; text: a part of it
    LineNeverIdle,     ///< baud
    RatesRefused,      ///< text: the rates that the adapter cannot run
    RateFixed,         ///< baud: the only one, because it is set elsewhere
    ServosFound,       ///< ids, baud, protocol
    AllReplied,        ///< count: queries
    ReplyTime,         ///< id of the slowest servo; time: median beyond the time on the wire
    LostReplies,       ///< id; count of total
    DamagedReplies,    ///< id; count of total
    SecondReply,       ///< id: several replies to one request
    DifferentValues,   ///< id: readings that one servo could not give
    UnreadableReplies, ///< id; count of total
    NoAcknowledgement, ///< id: response level 0
    BootloaderReplied, ///< baud
};

struct Evidence {
    EvidenceKind kind = EvidenceKind::PortOpened;
    int id = -1;
    int baud = 0;
    int count = 0;
    int total = 0;
    std::vector<int> ids{};
    Protocol protocol = Protocol::Feetech;
    Duration time{};
    QString text{};
};

struct Diagnosis {
    Cause cause = Cause::Found;
    std::vector<Cause> also{}; ///< other possible causes, the likeliest first
    std::vector<Evidence> evidence{};
    bool stopped = false;
};

/// "two-servos-one-id": the stable name for programs.
QString causeName(Cause cause);
} // namespace base
