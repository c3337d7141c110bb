// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/lx_codec.h"
#include "protocol/lx_frame.h"

namespace protocol {
namespace {
using base::ByteView;

class LxRules final : public FrameRules {
public:
    /// The command distinguishes the reply from a late reply to another request.
    FrameMatch replyAt(ByteView rest, const Expectation& expected) const override
    {
        const FrameMatch match = lx::matchAt(rest);
        if (match.status == FrameStatus::None ||
            (rest.size() > 2 && !canReply(rest[2], maxId, expected)) ||
            (rest.size() > 3 && match.size != static_cast<std::size_t>(expected.replyBytes)) ||
            (rest.size() > 4 && rest[4] != expected.command))
            return {};
        return match;
    }

    FrameMatch frameAt(ByteView rest) const override { return lx::matchAt(rest); }

    Reply parseReply(ByteView frame, const Expectation& /*expected*/) const override
    {
        return parseForeign(frame);
    }

    Reply parseForeign(ByteView frame) const override
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
    const FrameMatch match = lx::matchAt(buffer);
    if (match.status == FrameStatus::Partial)
        return result;
    if (match.status == FrameStatus::Valid) {
        const ByteView params = lx::params(buffer.first(match.size));
        return {ScanKind::Reply, match.size, buffer[2], buffer[4], {params.begin(), params.end()}};
    }
    result.kind = match.status == FrameStatus::Broken ? ScanKind::BadChecksum : ScanKind::Noise;
    const std::size_t end = match.status == FrameStatus::Broken ? match.size : buffer.size();
    result.consumed = 1;
    while (result.consumed < end &&
           lx::matchAt(buffer.subspan(result.consumed)).status == FrameStatus::None)
        ++result.consumed;
    return result;
}
} // namespace protocol
