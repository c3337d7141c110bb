// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/lx_codec.h"
#include "protocol/lx_frame.h"

namespace protocol {
namespace {
using base::ByteView;

class LxRules final : public FrameRules {
public:
    /// The command tells a late reply to another question from the answer.
    Claim replyAt(ByteView rest, const Expectation& expected) const override
    {
        const Claim claim = lx::claimAt(rest);
        if (claim.fit == Fit::None || (rest.size() > 2 && !mayAnswer(rest[2], maxId, expected)) ||
            (rest.size() > 3 && claim.size != static_cast<std::size_t>(expected.replyBytes)) ||
            (rest.size() > 4 && rest[4] != expected.command))
            return {};
        return claim;
    }

    Claim frameAt(ByteView rest) const override { return lx::claimAt(rest); }

    Part replyPart(ByteView frame, const Expectation& /*expected*/) const override
    {
        return foreignPart(frame);
    }

    Part foreignPart(ByteView frame) const override
    {
        const ByteView data = lx::params(frame);
        return {frame[2], 0, {data.begin(), data.end()}};
    }
};
} // namespace

ScanResult scanLx(ByteView buffer, const Expectation& expected, bool atDeadline)
{
    return scanFrames(LxRules(), buffer, expected, atDeadline);
}

RequestScan scanLxRequest(ByteView buffer)
{
    RequestScan result;
    if (buffer.empty())
        return result;
    const Claim claim = lx::claimAt(buffer);
    if (claim.fit == Fit::Partial)
        return result;
    if (claim.fit == Fit::Valid) {
        const ByteView params = lx::params(buffer.first(claim.size));
        return {ScanKind::Reply, claim.size, buffer[2], buffer[4], {params.begin(), params.end()}};
    }
    result.kind = claim.fit == Fit::Broken ? ScanKind::BadCheck : ScanKind::Noise;
    const std::size_t end = claim.fit == Fit::Broken ? claim.size : buffer.size();
    result.consumed = 1;
    while (result.consumed < end && lx::claimAt(buffer.subspan(result.consumed)).fit == Fit::None)
        ++result.consumed;
    return result;
}
} // namespace protocol
