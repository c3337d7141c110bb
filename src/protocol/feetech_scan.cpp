// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/feetech_codec.h"
#include "protocol/feetech_frame.h"

#include <algorithm>

namespace protocol {
namespace {
using base::ByteView;
using feetech::FrameState;

bool isExpectedId(int id, const Expectation& expected)
{
    return std::any_of(expected.ids.begin(), expected.ids.end(),
                       [id](int expectedReply) {
                           return expectedReply == id ||
                                  (expectedReply == broadcastId && id <= maxId);
                       }) ||
           (expected.any() && id == expected.alternateId);
}

/// ID and LEN of the expected reply are at `offset`, with any checksum.
bool matchesExpected(ByteView buffer, std::size_t offset, const Expectation& expected)
{
    return buffer.size() >= offset + 4 &&
           std::size_t{buffer[offset + 3]} + 4 == static_cast<std::size_t>(expected.replyBytes) &&
           isExpectedId(buffer[offset + 2], expected);
}

/// The first whole, valid, expected reply wherever it starts; the buffer's size if there is none.
std::size_t findReply(ByteView buffer, const Expectation& expected)
{
    if (!expected.any())
        return buffer.size();
    const auto expectedReply = static_cast<std::size_t>(expected.replyBytes);
    for (std::size_t i = 0; i + expectedReply <= buffer.size(); ++i) {
        if (buffer[i] == 0xFF && matchesExpected(buffer, i, expected) &&
            feetech::frameStateAt(buffer, i) == FrameState::Valid)
            return i;
    }
    return buffer.size();
}

/// The expected reply may have begun inside the frame at the front and still be on its way, so
/// that the checksum of that frame may be right by chance only.
bool replyMayOverlap(ByteView buffer, const Expectation& expected)
{
    const std::size_t end = feetech::frameSize(buffer, 0);
    for (std::size_t i = 1; expected.any() && i < end; ++i) {
        if (feetech::frameStateAt(buffer, i) != FrameState::Partial)
            continue;
        const std::size_t known = buffer.size() - i;
        if (known <= 2 || (known == 3 && isExpectedId(buffer[i + 2], expected)) ||
            matchesExpected(buffer, i, expected))
            return true;
    }
    return false;
}

ScanResult frameAtFront(ScanKind kind, ByteView buffer)
{
    const ByteView frame = buffer.first(feetech::frameSize(buffer, 0));
    const ByteView data = feetech::params(frame);
    return {kind, frame.size(), {frame[2], frame[4], {data.begin(), data.end()}}};
}

/// Drops the front up to the next place where a frame may start, but never into `reply`.
ScanResult dropFront(ByteView buffer, const Expectation& expected, std::size_t reply)
{
    const std::size_t next = std::min(feetech::nextStart(buffer, 1), reply);
    if (feetech::frameStateAt(buffer, 0) != FrameState::Broken ||
        !matchesExpected(buffer, 0, expected))
        return {ScanKind::Noise, next, {}};
    return {
        ScanKind::BadChecksum, std::min(next, feetech::frameSize(buffer, 0)), {buffer[2], 0, {}}};
}
} // namespace

ScanResult scanFeetech(ByteView buffer, const Expectation& expected, bool atDeadline)
{
    if (buffer.empty())
        return {};
    const std::size_t reply = findReply(buffer, expected);
    if (reply == 0)
        return frameAtFront(ScanKind::Reply, buffer);
    const bool replyFollows = reply < buffer.size();
    switch (feetech::frameStateAt(buffer, 0)) {
    case FrameState::Valid:
        // Overlapping claims: the frame that was asked for counts.
        if (replyFollows && reply < feetech::frameSize(buffer, 0))
            return {ScanKind::Noise, reply, {}};
        if (!replyFollows && !atDeadline && replyMayOverlap(buffer, expected))
            return {};
        return frameAtFront(ScanKind::Foreign, buffer);
    case FrameState::Partial:
        if (!replyFollows && !atDeadline)
            return {};
        break;
    case FrameState::Broken:
    case FrameState::None:
        break;
    }
    return dropFront(buffer, expected, reply);
}

RequestScan scanFeetechRequest(ByteView buffer)
{
    RequestScan result;
    if (buffer.empty())
        return result;
    const std::size_t next = feetech::nextStart(buffer, 1);
    switch (feetech::frameStateAt(buffer, 0)) {
    case FrameState::Partial:
        return result;
    case FrameState::None:
        result.kind = ScanKind::Noise;
        break;
    case FrameState::Broken:
        result.kind = ScanKind::BadChecksum;
        break;
    case FrameState::Valid: {
        const ByteView frame = buffer.first(feetech::frameSize(buffer, 0));
        const ByteView params = feetech::params(frame);
        return {ScanKind::Reply, frame.size(), frame[2], frame[4], {params.begin(), params.end()}};
    }
    }
    result.consumed =
        result.kind == ScanKind::Noise ? next : std::min(next, feetech::frameSize(buffer, 0));
    return result;
}
} // namespace protocol
