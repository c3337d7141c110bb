// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/lx_codec.h"

namespace protocol {
namespace {
class LxCodec final : public Codec {
public:
    QString name() const override { return QStringLiteral("lx"); }

    base::Result<base::Bytes> encode(const Request& request) const override
    {
        return encodeLx(request);
    }

    Expectation expect(const Request& request) const override { return expectLx(request); }

    ScanResult scan(base::ByteView buffer, const Expectation& expected,
                    bool atDeadline) const override
    {
        return scanLx(buffer, expected, atDeadline);
    }

    Request echoProbe() const override { return lxEchoProbe(); }

    QString explain(base::ByteView frame, bool fromHost) const override
    {
        return explainLx(frame, fromHost);
    }
};
} // namespace

const Codec& lxCodec()
{
    static const LxCodec codec;
    return codec;
}
} // namespace protocol
