// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/feetech_codec.h"

#include "protocol/feetech_frame.h"

namespace protocol {
namespace {
Expectation answer(std::vector<int> ids, int dataBytes)
{
    Expectation expected;
    expected.ids = std::move(ids);
    expected.dataBytes = dataBytes;
    expected.replyBytes = static_cast<int>(feetech::overhead) + dataBytes;
    return expected;
}

std::vector<int> targetIds(const Request& request)
{
    std::vector<int> ids;
    ids.reserve(request.targets.size());
    for (const Target& target : request.targets)
        ids.push_back(target.id);
    return ids;
}

/// Response level 0 answers only PING and READ; broadcast is answered to PING alone.
Expectation acknowledgement(const Request& request)
{
    if (!request.acknowledged || request.id == broadcastId)
        return {};
    Expectation expected = answer({request.id}, 0);
    expected.alternateId = request.alternateReplyId;
    return expected;
}

class FeetechCodec final : public Codec {
public:
    QString name() const override { return QStringLiteral("feetech"); }

    base::Result<base::Bytes> encode(const Request& request) const override
    {
        return encodeFeetech(request);
    }

    Expectation expect(const Request& request) const override
    {
        switch (request.op) {
        case Op::Ping:
            return answer({request.id}, 0);
        case Op::Read:
            return request.id == broadcastId ? Expectation{} : answer({request.id}, request.count);
        case Op::SyncRead:
            return answer(targetIds(request), request.count);
        case Op::Reboot:
        case Op::SyncWrite:
        case Op::Raw:
            return {};
        default:
            return acknowledgement(request);
        }
    }

    ScanResult scan(base::ByteView buffer, const Expectation& expected,
                    bool atDeadline) const override
    {
        return scanFeetech(buffer, expected, atDeadline);
    }

    Request echoProbe() const override { return feetechEchoProbe(); }

    QString explain(base::ByteView frame, bool fromHost) const override
    {
        return explainFeetech(frame, fromHost);
    }
};
} // namespace

const Codec& feetechCodec()
{
    static const FeetechCodec codec;
    return codec;
}
} // namespace protocol
