// SPDX-License-Identifier: GPL-3.0-or-later
// What can go wrong, as data. An Error is untranslated: the text layer gives it words, cause and
// remedy. Device faults (a reply with its overload bit set) are not errors; they are data.
#pragma once

#include <QString>
#include <tl/expected.hpp>

#include <cstdint>

namespace base {
enum class ErrorCode {
    // port
    PortMissing,     ///< no such device or host
    PortBusy,        ///< opened by another program; detail names it if known
    PortPermission,  ///< detail names the group that may open it, if known
    PortFailed,      ///< any other failure to open; detail is the system's message
    RateUnsupported, ///< the adapter cannot run this baud rate
    LinkLost,        ///< unplugged, hung up, connection closed
    // wire
    NoReply,         ///< nothing came before the deadline
    Garbled,         ///< bytes came, but no valid reply (checksum, noise, collision)
    UnexpectedReply, ///< a valid reply of another shape than the one asked for
    LineBusy,        ///< bytes arrive without a pause: no reply can be recognized among them
    Uncertain,       ///< unknown whether it was executed or kept; detail may say why
    Stopped,         ///< the user stopped it
    Preempted,       ///< the emergency lane took the wire
    Held,            ///< the servo belongs to a running job
    // request
    BadArgument,     ///< malformed or contradictory input; detail says what
    UnknownRegister, ///< this map has no such register
    ReadOnly,
    OutOfRange,
    NeedsConsent, ///< dangerous register without --dangerous
    NotSupported, ///< this family has no such thing; detail says why
    // servo
    IdInUse,
    Refused,        ///< the servo did not take it
    Mismatch,       ///< read back differs from what was written
    LockOpen,       ///< the EPROM lock could not be proven closed
    UnknownModel,   ///< identity read, but no register map fits
    FamilyConflict, ///< firmware, byte order, model or lock contradict each other; see FamilyFacts
    DuplicateId,    ///< two servos seem to answer under this ID; detail says what was seen
    IdentityMismatch,  ///< another servo answers under this ID than the one expected
    TurnsUnknown,      ///< multi-turn position not known since power-on
    AmbiguousProtocol, ///< the ID answers in more than one; detail lists them
    // files
    FileMissing,
    FileUnreadable,
    FileFormat, ///< detail says where and what
    FileUnwritable,
    DiskFull,
};

/// Why a request was refused, where a program decides on it. The detail says the same in JSON.
enum class Reason : std::uint8_t {
    None,
    NotInPositionMode,
    IdentityRegister, ///< a template contains ID and baud rate only on request
    ReadOnlyRegister,
    NoValue, ///< the snapshot has no value for this register
};

/// Context is filled in as far as it is known; -1 and empty mean "not applicable".
struct Error {
    ErrorCode code = ErrorCode::BadArgument;
    QString operation{};   ///< technical name: "read", "set-id", "open"
    QString detail{};      ///< technical detail: path, key, system message
    int id = -1;           ///< servo
    QString registerKey{}; ///< register, if one is concerned
    int attempts = 0;      ///< transactions tried
    Reason reason = Reason::None;
};

template <typename T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, QString operation = {}, QString detail = {},
                                  int id = -1)
{
    return tl::unexpected<Error>(Error{code, std::move(operation), std::move(detail), id});
}

/// Stable English identifier, for JSON and logs: "no-answer".
QString errorName(ErrorCode code);

/// The link, the user or another task ended the work, so that the next servo or attempt would fare
/// no better. Every other error concerns one servo or one request.
bool endsJob(ErrorCode code);
} // namespace base
