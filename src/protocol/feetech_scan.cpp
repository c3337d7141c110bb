// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/feetech_codec.h"
#include "protocol/feetech_frame.h"

#include <algorithm>

namespace protocol {
namespace {
using base::ByteView;
using feetech::Shape;

bool isExpectedId(int id, const Expectation& expected)
{
    return std::any_of(expected.ids.begin(), expected.ids.end(),
                       [id](int wanted) {
                           return wanted == id || (wanted == broadcastId && id <= maxId);
                       }) ||
           (expected.any() && id == expected.alsoFrom);
}

/// ID and LEN of the expected reply stand at `offset`, whatever the checksum.
bool looksExpected(ByteView buffer, std::size_t offset, const Expectation& expected)
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
    const auto wanted = static_cast<std::size_t>(expected.replyBytes);
    for (std::size_t i = 0; i + wanted <= buffer.size(); ++i) {
        if (buffer[i] == 0xFF && looksExpected(buffer, i, expected) &&
            feetech::shapeAt(buffer, i) == Shape::Valid)
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
        if (feetech::shapeAt(buffer, i) != Shape::Partial)
            continue;
        const std::size_t known = buffer.size() - i;
        if (known <= 2 || (known == 3 && isExpectedId(buffer[i + 2], expected)) ||
            looksExpected(buffer, i, expected))
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
    if (feetech::shapeAt(buffer, 0) != Shape::Broken || !looksExpected(buffer, 0, expected))
        return {ScanKind::Noise, next, {}};
    return {ScanKind::BadCheck, std::min(next, feetech::frameSize(buffer, 0)), {buffer[2], 0, {}}};
}
} // namespace

ScanResult scanFeetech(ByteView buffer, const Expectation& expected, bool atDeadline)
{
    if (buffer.empty())
        return {};
    const std::size_t reply = findReply(buffer, expected);
    if (reply == 0)
        return frameAtFront(ScanKind::Reply, buffer);
    const bool replyBehind = reply < buffer.size();
    switch (feetech::shapeAt(buffer, 0)) {
    case Shape::Valid:
        // Overlapping claims: the frame that was asked for counts.
        if (replyBehind && reply < feetech::frameSize(buffer, 0))
            return {ScanKind::Noise, reply, {}};
        if (!replyBehind && !atDeadline && replyMayOverlap(buffer, expected))
            return {};
        return frameAtFront(ScanKind::Foreign, buffer);
    case Shape::Partial:
        if (!replyBehind && !atDeadline)
            return {};
        break;
    case Shape::Broken:
    case Shape::None:
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
    switch (feetech::shapeAt(buffer, 0)) {
    case Shape::Partial:
        return result;
    case Shape::None:
        result.kind = ScanKind::Noise;
        break;
    case Shape::Broken:
        result.kind = ScanKind::BadCheck;
        break;
    case Shape::Valid: {
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
