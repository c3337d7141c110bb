// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/explain.h"
#include "protocol/feetech_codec.h"
#include "protocol/feetech_frame.h"

#include <QStringList>

namespace protocol {
namespace {
using base::ByteView;

QString idText(int id)
{
    return id == broadcastId ? QStringLiteral("all") : QString::number(id);
}

QString instructionName(std::uint8_t code)
{
    switch (code) {
    case feetech::instPing:
        return QStringLiteral("PING");
    case feetech::instRead:
        return QStringLiteral("READ");
    case feetech::instWrite:
        return QStringLiteral("WRITE");
    case feetech::instRegWrite:
        return QStringLiteral("REG WRITE");
    case feetech::instAction:
        return QStringLiteral("ACTION");
    case feetech::instRestore:
        return QStringLiteral("RESTORE");
    case feetech::instReboot:
        return QStringLiteral("REBOOT");
    case feetech::instBackup:
        return QStringLiteral("BACKUP");
    case feetech::instStateReset:
        return QStringLiteral("STATE RESET");
    case feetech::instCalibrate:
        return QStringLiteral("CALIBRATE");
    case feetech::instSyncRead:
        return QStringLiteral("SYNC READ");
    case feetech::instSyncWrite:
        return QStringLiteral("SYNC WRITE");
    default:
        return QStringLiteral("0x%1").arg(code, 2, 16, QLatin1Char('0'));
    }
}

/// "SYNC WRITE @42 ×6: 1 = 00 08 …, 2 = …"; SYNC READ lists the IDs only.
QString explainSync(const QString& name, ByteView params, std::size_t perServo)
{
    QStringList servos;
    for (ByteView rest = params.subspan(2); rest.size() > perServo;
         rest = rest.subspan(perServo + 1)) {
        const QString id = QString::number(rest[0]);
        servos += perServo == 0
                      ? id
                      : id + QStringLiteral(" = ") + base::toHex(rest.subspan(1, perServo));
    }
    return QStringLiteral("%1 @%2 ×%3: ").arg(name).arg(params[0]).arg(params[1]) +
           servos.join(QStringLiteral(", "));
}

QString explainRequest(int id, std::uint8_t code, ByteView params)
{
    const QString name = instructionName(code);
    const QString head = name + u' ' + idText(id);
    switch (code) {
    case feetech::instRead:
        if (params.size() == 2)
            return head + QStringLiteral(" @%1 ×%2").arg(params[0]).arg(params[1]);
        break;
    case feetech::instWrite:
    case feetech::instRegWrite:
        if (params.size() > 1)
            return withData(head + QStringLiteral(" @%1").arg(params[0]), params.subspan(1));
        break;
    case feetech::instSyncRead:
        if (params.size() > 2)
            return explainSync(name, params, 0);
        break;
    case feetech::instSyncWrite:
        if (params.size() > 2)
            return explainSync(name, params, params[1]);
        break;
    default:
        break;
    }
    return withData(head, params);
}
} // namespace

QString explainFeetech(ByteView frame, bool fromHost)
{
    const feetech::FrameState state =
        frame.empty() ? feetech::FrameState::None : feetech::frameStateAt(frame, 0);
    const bool complete =
        state == feetech::FrameState::Valid || state == feetech::FrameState::Broken;
    if (!complete || feetech::frameSize(frame, 0) != frame.size())
        return withData(QStringLiteral("bytes"), frame);
    QString text;
    if (fromHost) {
        text = explainRequest(frame[2], frame[4], feetech::params(frame));
    } else {
        text = QStringLiteral("STATUS ") + idText(frame[2]);
        if (frame[4] != 0)
            text += QStringLiteral(" error 0x%1").arg(frame[4], 2, 16, QLatin1Char('0'));
        text = withData(text, feetech::params(frame));
    }
    return state == feetech::FrameState::Valid ? text : text + QStringLiteral(" (checksum wrong)");
}
} // namespace protocol
