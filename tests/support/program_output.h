// SPDX-License-Identifier: GPL-3.0-or-later
// What another program prints, such as poppler about a PDF. Waits for its end; any thread.
#pragma once

#include <QProcess>

namespace support {
/// "failed: …" where it did not end well.
inline QString outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        return QStringLiteral("failed: ") + QString::fromUtf8(process.readAllStandardError());
    return QString::fromUtf8(process.readAllStandardOutput());
}
} // namespace support
