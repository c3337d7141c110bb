// SPDX-License-Identifier: GPL-3.0-or-later
// What a codec makes of a line, in words, and bytes and requests written short, for the codec tests
// of every protocol. One thread.
#pragma once

#include "protocol/codec.h"

#include <QStringList>

inline base::Bytes hex(const QString& text)
{
    return base::fromHex(text).value();
}

inline base::Bytes hex(const char* text)
{
    return hex(QString::fromLatin1(text));
}

inline protocol::Request unacknowledged(protocol::Request request)
{
    request.acknowledged = false;
    return request;
}

inline QString kindName(protocol::ScanKind kind)
{
    switch (kind) {
    case protocol::ScanKind::Incomplete:
        return QStringLiteral("wait");
    case protocol::ScanKind::Reply:
        return QStringLiteral("reply");
    case protocol::ScanKind::Foreign:
        return QStringLiteral("foreign");
    case protocol::ScanKind::BadChecksum:
        return QStringLiteral("bad");
    case protocol::ScanKind::Noise:
        return QStringLiteral("noise");
    }
    return {};
}

/// ID, status byte, data: "1 00 [18 05]"; an exception follows.
inline QString partText(const protocol::Reply& part)
{
    QString words = QStringLiteral("%1 %2 [%3]")
                        .arg(part.id)
                        .arg(part.status, 2, 16, QLatin1Char('0'))
                        .arg(base::toHex(part.data));
    if (part.exception != 0)
        words += QStringLiteral(" exception %1").arg(part.exception);
    return words;
}

/// One item an event, as "noise 3", "reply 1 00 [18 05]", "wait 4" for what is left.
inline QStringList verdicts(const protocol::Codec& codec, base::Bytes buffer,
                            const protocol::Expectation& expected, bool atDeadline)
{
    using protocol::ScanKind;
    QStringList words;
    while (!buffer.empty()) {
        const protocol::ScanResult result = codec.scan(buffer, expected, atDeadline);
        if (result.kind == ScanKind::Incomplete) {
            words += QStringLiteral("wait %1").arg(buffer.size());
            break;
        }
        const bool frame = result.kind == ScanKind::Reply || result.kind == ScanKind::Foreign;
        words += kindName(result.kind) + u' ' +
                 (frame ? partText(result.part) : QString::number(result.consumed));
        buffer.erase(buffer.begin(), buffer.begin() + std::ptrdiff_t(result.consumed));
    }
    return words;
}
