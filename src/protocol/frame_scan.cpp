// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/frame_scan.h"

#include <algorithm>

namespace protocol {
namespace {
using base::ByteView;

/// One scan of a buffer.
struct Scanner {
    const FrameRules& rules;
    ByteView buffer;
    const Expectation& expected;

    FrameMatch replyAt(std::size_t offset) const
    {
        return expected.any() ? rules.replyAt(buffer.subspan(offset), expected) : FrameMatch{};
    }

    /// The first position in [from, end) that is a reply in the sense of `fits`, else `end`.
    template <typename Predicate>
    std::size_t findReply(std::size_t from, std::size_t end, Predicate&& predicate) const
    {
        while (from < end && expected.any() && !predicate(replyAt(from).status))
            ++from;
        return expected.any() ? from : end;
    }

    /// Where the next frame may begin. At the deadline half frames will not become whole any more.
    std::size_t nextStart(bool atDeadline) const
    {
        const auto starts = [&](FrameStatus status) {
            return status == FrameStatus::Valid || (status == FrameStatus::Partial && !atDeadline);
        };
        std::size_t offset = 1;
        while (offset < buffer.size() && !starts(rules.frameAt(buffer.subspan(offset)).status) &&
               !starts(replyAt(offset).status) && replyAt(offset).status != FrameStatus::Broken)
            ++offset;
        return offset;
    }
};
} // namespace

ScanResult scanFrames(const FrameRules& rules, ByteView buffer, const Expectation& expected,
                      bool atDeadline)
{
    if (buffer.empty())
        return {};
    const Scanner scanner{rules, buffer, expected};
    const FrameMatch expectedReply = scanner.replyAt(0);
    if (expectedReply.status == FrameStatus::Valid)
        return {ScanKind::Reply, expectedReply.size,
                rules.parseReply(buffer.first(expectedReply.size), expected)};

    const auto valid = [](FrameStatus status) { return status == FrameStatus::Valid; };
    const auto partial = [](FrameStatus status) { return status == FrameStatus::Partial; };
    const auto started = [](FrameStatus status) { return status != FrameStatus::None; };
    const std::size_t reply = scanner.findReply(1, buffer.size(), valid);
    const bool canWait = reply == buffer.size() && !atDeadline;
    const FrameMatch frame = rules.frameAt(buffer);
    if (frame.status == FrameStatus::Valid) {
        // Overlapping claims: the frame that was asked for counts, also while it is on its way.
        if (reply < frame.size)
            return {ScanKind::Noise, reply, {}};
        if (canWait && scanner.findReply(0, frame.size, partial) < frame.size)
            return {};
        return {ScanKind::Foreign, frame.size, rules.parseForeign(buffer.first(frame.size))};
    }
    if (expectedReply.status == FrameStatus::Broken) {
        Reply part;
        part.id = rules.parseReply(buffer.first(expectedReply.size), expected).id;
        return {ScanKind::BadChecksum, scanner.findReply(1, expectedReply.size, started), part};
    }
    if (canWait &&
        (expectedReply.status == FrameStatus::Partial || frame.status == FrameStatus::Partial))
        return {};
    return {ScanKind::Noise, std::min(scanner.nextStart(atDeadline), reply), {}};
}

bool canReply(int id, int maxReplyId, const Expectation& expected)
{
    return std::any_of(expected.ids.begin(), expected.ids.end(),
                       [&](int expectedReply) {
                           return expectedReply == id ||
                                  (expectedReply == broadcastId && id <= maxReplyId);
                       }) ||
           (expected.any() && id == expected.alternateId);
}
} // namespace protocol
