// SPDX-License-Identifier: GPL-3.0-or-later
// A protocol as the bus sees it: request to bytes, bytes to replies. A codec has no state and does
// no I/O; one instance may be shared by all threads. A protocol is known in one codec only.
#pragma once

#include "base/clock.h"
#include "base/error.h"
#include "protocol/request.h"

#include <QString>

namespace protocol {
/// The reply that a request expects: its sender and its length. The end of a reply is computed from
/// this, never guessed from silence.
struct Expectation {
    std::vector<int> ids; ///< one reply each; empty: nothing is answered. broadcastId: any servo
    int alternateId = -1; ///< this ID is as good as the first of `ids` (Request::alternateReplyId)
    int replyBytes = 0;   ///< length of one whole reply on the wire
    int dataBytes = 0;    ///< payload of one reply
    int command = -1;     ///< Modbus function, LX command: what the reply must repeat
    base::Bytes head{};   ///< Modbus: what stands between function and data (byte count, address)
    bool any() const { return !ids.empty(); }
};

enum class ScanKind : std::uint8_t {
    Incomplete,  ///< nothing to decide yet
    Reply,       ///< the reply expected: `part`
    Foreign,     ///< a valid frame, but not the one expected: `part` (late, another master, echo)
    BadChecksum, ///< a frame of the expected shape with a wrong checksum: `part.id` only
    Noise,       ///< bytes that belong to no frame
};

/// What the front of a receive buffer is: `consumed` bytes, which the caller drops before it scans
/// again. Noise ahead of a frame is reported first, then the frame, so each byte has one verdict.
struct ScanResult {
    ScanKind kind = ScanKind::Incomplete;
    std::size_t consumed = 0;
    Reply part{};
};

class Codec {
public:
    virtual ~Codec() = default;

    virtual QString name() const = 0; ///< "feetech"

    /// How long the wire must have been silent before a request may begin: Modbus-RTU knows frames
    /// by the gaps between them.
    virtual base::Duration silence(int baud) const;

    /// BadArgument when the request cannot exist on this wire (ID, length); NotSupported when the
    /// language has no such operation.
    virtual base::Result<base::Bytes> encode(const Request& request) const = 0;

    virtual Expectation expect(const Request& request) const = 0;

    /// Looks at the front of `buffer`. Resynchronizes after noise: a false header never hides a
    /// valid reply behind it, and a frame cut short never blocks the next one. With `atDeadline`
    /// an unfinished false header is given up as noise.
    virtual ScanResult scan(base::ByteView buffer, const Expectation& expected,
                            bool atDeadline = false) const = 0;

    /// The request that decides whether an adapter echoes: no servo answers it, and its echo is
    /// no valid reply to it (Feetech: READ of 254, count not 2).
    virtual Request echoProbe() const = 0;

    /// One line for the trace: "READ 1 @56 ×15".
    virtual QString explain(base::ByteView frame, bool fromHost) const = 0;
};

const Codec& feetechCodec();
const Codec& modbusCodec();
const Codec& lxCodec();
const Codec& codecFor(base::Protocol protocol);

/// A request frame as a servo sees it on a Feetech line, for the simulator. Kind Reply: a valid
/// frame, the rest is filled in; BadChecksum, Incomplete and Noise as in Codec::scan. A servo that
/// hears nothing for a while gives up an incomplete frame: dropping the buffer is the caller's
/// part. `instruction` keeps the byte when it is not one we know.
struct RequestScan {
    ScanKind kind = ScanKind::Incomplete;
    std::size_t consumed = 0;
    int id = 0;
    std::uint8_t instruction = 0;
    base::Bytes params;
};
RequestScan scanFeetechRequest(base::ByteView buffer);

/// A status packet of a Feetech servo.
base::Bytes encodeFeetechStatus(int id, std::uint8_t status, base::ByteView data);

/// The same for a Modbus-RTU station and for an LX servo: `instruction` is the function or command
/// code, `params` what follows it, the checksum left out. `buffer` begins where a silence ended;
/// a Modbus frame is whole when its length by function and its CRC fit.
RequestScan scanModbusRequest(base::ByteView buffer);
RequestScan scanLxRequest(base::ByteView buffer);

/// `data` is everything between function code and CRC. An exception is function + 0x80 with the
/// reason as its one byte.
base::Bytes encodeModbusReply(int station, std::uint8_t function, base::ByteView data);
base::Bytes encodeLxReply(int id, std::uint8_t command, base::ByteView params);
} // namespace protocol
