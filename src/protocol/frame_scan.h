// SPDX-License-Identifier: GPL-3.0-or-later
// The scanner behind Codec::scan for protocols where any position shows whether a frame may begin
// there (Modbus, LX): the order of claims, and where to go on after what is no frame. Pure, any
// thread.
#pragma once

#include "protocol/codec.h"

namespace protocol {
enum class FrameStatus : std::uint8_t {
    None,    ///< no such frame begins here
    Partial, ///< all bytes so far fit
    Broken,  ///< whole, but its checksum is wrong
    Valid,
};

struct FrameMatch {
    FrameStatus status = FrameStatus::None;
    std::size_t size = 0; ///< of the frame, when it is whole
};

class FrameRules {
public:
    virtual ~FrameRules() = default;
    /// A reply as expected at the front of `rest`; never called with nothing expected.
    virtual FrameMatch replyAt(base::ByteView rest, const Expectation& expected) const = 0;
    /// Any frame of this language.
    virtual FrameMatch frameAt(base::ByteView rest) const = 0;
    virtual Reply parseReply(base::ByteView frame, const Expectation& expected) const = 0;
    virtual Reply parseForeign(base::ByteView frame) const = 0;
};

ScanResult scanFrames(const FrameRules& rules, base::ByteView buffer, const Expectation& expected,
                      bool atDeadline);

/// `id` may send the reply: it was addressed, or all up to `highest` were, or it is equivalent.
bool canReply(int id, int maxReplyId, const Expectation& expected);
} // namespace protocol
