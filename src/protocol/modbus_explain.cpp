// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/modbus_codec.h"
#include "protocol/modbus_frame.h"

namespace protocol {
namespace {
using base::ByteView;

QString withData(const QString& head, ByteView data)
{
    return data.empty() ? head : head + QStringLiteral(": ") + base::toHex(data);
}

QString functionName(std::uint8_t function)
{
    switch (function) {
    case modbus::fnRead:
        return QStringLiteral("READ");
    case modbus::fnWriteOne:
    case modbus::fnWrite:
        return QStringLiteral("WRITE");
    case modbus::fnReportId:
    case modbus::fnReportIdDisputed:
        return QStringLiteral("REPORT ID");
    case modbus::fnReboot:
        return QStringLiteral("REBOOT");
    default:
        return QStringLiteral("0x%1").arg(function, 2, 16, QLatin1Char('0'));
    }
}

QString exceptionText(std::uint8_t reason)
{
    switch (reason) {
    case 1:
        return QStringLiteral("illegal function");
    case 2:
        return QStringLiteral("illegal address");
    case 3:
        return QStringLiteral("illegal value");
    default:
        return QStringLiteral("reason %1").arg(reason);
    }
}

QString addressed(std::uint8_t function, std::uint8_t station)
{
    return functionName(function) + u' ' +
           (station == 0 ? QStringLiteral("all") : QString::number(station));
}

quint64 word(ByteView data, std::size_t position)
{
    return base::readUnsigned(data.subspan(position, 2), base::ByteOrder::Big);
}

/// "READ 1 @256 ×8", "WRITE 1 @129: 00 01", "WRITE 1 @128 ×4: 08 00 …"
QString explainRequest(ByteView frame)
{
    const QString head = addressed(frame[1], frame[0]);
    const ByteView data = modbus::content(frame);
    if (data.size() < 4)
        return withData(head, data);
    const QString position = head + QStringLiteral(" @%1").arg(word(data, 0));
    if (frame[1] == modbus::fnWriteOne)
        return withData(position, data.subspan(2));
    const QString span = position + QStringLiteral(" ×%1").arg(word(data, 2));
    return data.size() > 5 ? withData(span, data.subspan(5)) : span;
}

QString explainReply(ByteView frame)
{
    const ByteView data = modbus::content(frame);
    if ((frame[1] & modbus::exceptionFlag) != 0)
        return QStringLiteral("EXCEPTION ") + addressed(frame[1] & 0x7FU, frame[0]) +
               QStringLiteral(": ") + exceptionText(data[0]);
    const bool write = frame[1] == modbus::fnWriteOne || frame[1] == modbus::fnWrite;
    return QStringLiteral("REPLY ") +
           (write ? explainRequest(frame)
                  : withData(addressed(frame[1], frame[0]), data.subspan(1)));
}
} // namespace

QString explainModbus(ByteView frame, bool fromHost)
{
    const std::size_t size = fromHost ? modbus::requestSize(frame) : modbus::replySize(frame);
    if (frame.empty() || size != frame.size())
        return withData(QStringLiteral("bytes"), frame);
    const QString text = fromHost ? explainRequest(frame) : explainReply(frame);
    return modbus::isCrcValid(frame) ? text : text + QStringLiteral(" (CRC wrong)");
}
} // namespace protocol
