// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/frame_scan.h"

#include <algorithm>

namespace protocol {
namespace {
using base::ByteView;

/// One look at a buffer.
struct Look {
    const FrameRules& rules;
    ByteView buffer;
    const Expectation& expected;

    Claim replyAt(std::size_t place) const
    {
        return expected.any() ? rules.replyAt(buffer.subspan(place), expected) : Claim{};
    }

    /// The first place in [from, end) whose claim to be the reply is as `fits` says, else `end`.
    template <typename Fits>
    std::size_t findReply(std::size_t from, std::size_t end, Fits&& fits) const
    {
        while (from < end && expected.any() && !fits(replyAt(from).fit))
            ++from;
        return expected.any() ? from : end;
    }

    /// Where the next frame may begin. At the deadline half frames will not become whole any more.
    std::size_t nextStart(bool atDeadline) const
    {
        const auto starts = [&](Fit fit) {
            return fit == Fit::Valid || (fit == Fit::Partial && !atDeadline);
        };
        std::size_t place = 1;
        while (place < buffer.size() && !starts(rules.frameAt(buffer.subspan(place)).fit) &&
               !starts(replyAt(place).fit) && replyAt(place).fit != Fit::Broken)
            ++place;
        return place;
    }
};
} // namespace

ScanResult scanFrames(const FrameRules& rules, ByteView buffer, const Expectation& expected,
                      bool atDeadline)
{
    if (buffer.empty())
        return {};
    const Look look{rules, buffer, expected};
    const Claim wanted = look.replyAt(0);
    if (wanted.fit == Fit::Valid)
        return {ScanKind::Reply, wanted.size, rules.replyPart(buffer.first(wanted.size), expected)};

    const auto valid = [](Fit fit) { return fit == Fit::Valid; };
    const auto partial = [](Fit fit) { return fit == Fit::Partial; };
    const auto begun = [](Fit fit) { return fit != Fit::None; };
    const std::size_t reply = look.findReply(1, buffer.size(), valid);
    const bool mayWait = reply == buffer.size() && !atDeadline;
    const Claim frame = rules.frameAt(buffer);
    if (frame.fit == Fit::Valid) {
        // Overlapping claims: the frame that was asked for counts, also while it is on its way.
        if (reply < frame.size)
            return {ScanKind::Noise, reply, {}};
        if (mayWait && look.findReply(0, frame.size, partial) < frame.size)
            return {};
        return {ScanKind::Foreign, frame.size, rules.foreignPart(buffer.first(frame.size))};
    }
    if (wanted.fit == Fit::Broken) {
        Part part;
        part.id = rules.replyPart(buffer.first(wanted.size), expected).id;
        return {ScanKind::BadCheck, look.findReply(1, wanted.size, begun), part};
    }
    if (mayWait && (wanted.fit == Fit::Partial || frame.fit == Fit::Partial))
        return {};
    return {ScanKind::Noise, std::min(look.nextStart(atDeadline), reply), {}};
}

bool mayAnswer(int id, int highest, const Expectation& expected)
{
    return std::any_of(expected.ids.begin(), expected.ids.end(),
                       [&](int wanted) {
                           return wanted == id || (wanted == broadcastId && id <= highest);
                       }) ||
           (expected.any() && id == expected.alsoFrom);
}
} // namespace protocol
