// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes.h"

#include <QRegularExpression>
#include <QStringList>

namespace base {
std::uint64_t readUnsigned(ByteView bytes, ByteOrder order)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t index = order == ByteOrder::Big ? i : bytes.size() - 1 - i;
        value = (value << 8) | bytes[index];
    }
    return value;
}

Bytes writeUnsigned(std::uint64_t value, std::size_t size, ByteOrder order)
{
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t index = order == ByteOrder::Little ? i : size - 1 - i;
        bytes[index] = static_cast<std::uint8_t>(value & 0xFF);
        value >>= 8;
    }
    return bytes;
}

QString toHex(ByteView bytes)
{
    static constexpr char digits[] = "0123456789ABCDEF";
    QString text;
    text.reserve(static_cast<qsizetype>(bytes.size()) * 3);
    for (const std::uint8_t byte : bytes) {
        if (!text.isEmpty())
            text += u' ';
        text += QLatin1Char(digits[byte >> 4]);
        text += QLatin1Char(digits[byte & 0x0F]);
    }
    return text;
}

Result<Bytes> fromHex(const QString& text)
{
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    Bytes bytes;
    for (QString word : text.split(separators, Qt::SkipEmptyParts)) {
        if (word.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
            word.remove(0, 2);
        if (word.size() == 1)
            word.prepend(u'0');
        if (word.isEmpty() || word.size() % 2 != 0)
            return fail(ErrorCode::BadArgument, QStringLiteral("hex"), word);
        for (qsizetype i = 0; i < word.size(); i += 2) {
            bool ok = false;
            const uint value = QStringView(word).mid(i, 2).toUInt(&ok, 16);
            if (!ok)
                return fail(ErrorCode::BadArgument, QStringLiteral("hex"), word);
            bytes.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return bytes;
}
} // namespace base
