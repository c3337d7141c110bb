// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/modbus_codec.h"

namespace protocol {
namespace {
using namespace std::chrono_literals;

constexpr base::Duration fixedSilence = 1750us;
constexpr int maxBaudForScaledSilence = 19'200;
constexpr std::int64_t silenceHalfBits = 70; ///< 3.5 characters of 10 bits

class ModbusCodec final : public Codec {
public:
    QString name() const override { return QStringLiteral("modbus"); }

    base::Duration silence(int baud) const override
    {
        if (baud <= 0 || baud > maxBaudForScaledSilence)
            return fixedSilence;
        return base::Duration((silenceHalfBits * 500'000 + baud - 1) / baud);
    }

    base::Result<base::Bytes> encode(const Request& request) const override
    {
        return encodeModbus(request);
    }

    Expectation expect(const Request& request) const override { return expectModbus(request); }

    ScanResult scan(base::ByteView buffer, const Expectation& expected,
                    bool atDeadline) const override
    {
        return scanModbus(buffer, expected, atDeadline);
    }

    Request echoProbe() const override { return modbusEchoProbe(); }

    QString explain(base::ByteView frame, bool fromHost) const override
    {
        return explainModbus(frame, fromHost);
    }
};
} // namespace

const Codec& modbusCodec()
{
    static const ModbusCodec codec;
    return codec;
}
} // namespace protocol
