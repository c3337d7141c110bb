// SPDX-License-Identifier: GPL-3.0-or-later
// A QString out of a literal, the bytes of a file.
#pragma once

#include <QFile>
#include <QString>

namespace support {
inline QString utf8(const char* text)
{
    return QString::fromUtf8(text);
}

/// Empty if it cannot be read.
inline QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace support
