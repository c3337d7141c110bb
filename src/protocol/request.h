// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked of servos, independent of the bytes that ask it: the same request type serves
// every protocol. Values; any thread. Addresses and counts are in bytes of the servo's table, which
// each codec turns into what its wire has: Feetech bytes as they are; Modbus two bytes a register
// (address 256 of the sheet is 512 here); LX eight bytes a command (reading 21 is 168, writing 20
// is 160), so that a parameter's place is a byte behind that.
// Source of the operations: Feetech protocol page (instructions 0x01–0x0B, 0x82, 0x83).
#pragma once

#include "base/bytes.h"
#include "base/protocol.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace protocol {
constexpr int broadcastId = 254;
constexpr int maxId = 253;

enum class Op : std::uint8_t {
    Ping, ///< to 254: "who is there?", for one servo on the bus only
    Read,
    Write,
    RegWrite,   ///< held until Action
    Action,     ///< carries out what RegWrite (LX: a stored move) holds
    Halt,       ///< LX 12: ends a move and holds
    Restore,    ///< 0x06: parameters back to what Backup stored, ID excepted
    Backup,     ///< 0x09
    StateReset, ///< 0x0A: turn count
    Calibrate,  ///< 0x0B, with or without a value
    Reboot,     ///< 0x08, Modbus 0x41: never answered
    SyncRead,
    SyncWrite,
    Raw, ///< bytes as given, and so is the answer
};

/// May this request be sent again when its answer was lost? A relative move, an ID write or a
/// calibration may not: the caller reads the state and decides.
enum class Repeat : std::uint8_t { Safe, Never };

struct Target {
    int id = 0;
    base::Bytes data; ///< empty for SyncRead
};

struct Request {
    base::Protocol protocol = base::Protocol::Feetech;
    Op op = Op::Ping;
    int id = 0;
    int address = 0;
    int count = 0;    ///< bytes to read, for Read and SyncRead; Raw: see raw()
    base::Bytes data; ///< for Write, RegWrite, Raw; the value of Calibrate (0 or 2 bytes)
    std::vector<Target> targets; ///< for SyncRead and SyncWrite
    Repeat repeat = Repeat::Never;
    bool acknowledged = true; ///< false: the servo is at response level 0 and stays silent
    int alternateReplyId =
        -1; ///< the reply may also name this ID: the new one, when the ID is written

    /// The same request in another language.
    Request in(base::Protocol wireProtocol) const
    {
        Request request = *this;
        request.protocol = wireProtocol;
        return request;
    }

    /// Nothing in a servo changes: it may be asked again.
    bool isRead() const { return op == Op::Ping || op == Op::Read || op == Op::SyncRead; }

    static Request ping(int id);
    static Request read(int id, int address, int count);
    static Request write(int id, int address, base::Bytes data, Repeat repeat);
    static Request regWrite(int id, int address, base::Bytes data, Repeat repeat);
    static Request action(int id = broadcastId);
    static Request halt(int id);
    static Request restore(int id);
    static Request backup(int id);
    static Request stateReset(int id);
    static Request calibrate(int id, std::optional<int> value, base::ByteOrder order);
    static Request reboot(int id);
    static Request syncRead(int address, int count, const std::vector<int>& ids);
    static Request syncWrite(int address, std::vector<Target> targets);
    /// `replyBytes` 0: all bytes until the deadline are the answer; else it ends with so many, and
    /// the next request does not wait for late ones.
    static Request raw(base::Bytes bytes, int replyBytes = 0);
};

/// One servo's answer. `status` is the error byte as data (0 = no alarm).
struct Reply {
    int id = 0;
    std::uint8_t status = 0;
    base::Bytes data;
    std::uint8_t exception = 0; ///< Modbus: refused; 1 function, 2 address, 3 value
};
} // namespace protocol
