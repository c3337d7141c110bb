// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/firmware/firmware_file.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace jobs {
namespace {
const QString fileOperation = QStringLiteral("firmware");
constexpr qint64 minSize = 64;
constexpr qint64 maxSize = 65'535;
} // namespace

base::Result<FirmwareFile> loadFirmwareFile(const QString& path)
{
    const auto refuse = [&path](base::ErrorCode code, const QString& why) {
        base::Error error{code, fileOperation, path};
        if (!why.isEmpty())
            error.detail = why;
        return tl::unexpected(error);
    };
    // .hex, .fbin, .mbin and .xbin are for other devices, and none was ever seen at work.
    if (QFileInfo(path).suffix().compare(QLatin1String("bin"), Qt::CaseInsensitive) != 0)
        return refuse(base::ErrorCode::NotSupported, QStringLiteral("firmware-kind"));
    QFile file(path);
    if (!file.exists())
        return refuse(base::ErrorCode::FileMissing, {});
    if (!file.open(QIODevice::ReadOnly))
        return refuse(base::ErrorCode::FileUnreadable, {});
    const QByteArray bytes = file.read(maxSize + 1);
    if (file.error() != QFileDevice::NoError)
        return refuse(base::ErrorCode::FileUnreadable, {});
    if (bytes.size() < minSize || bytes.size() > maxSize)
        return refuse(base::ErrorCode::NotSupported, QStringLiteral("firmware-size"));
    return FirmwareFile{path, base::Bytes(bytes.begin(), bytes.end())};
}

FirmwareName firmwareNameOf(const QString& path)
{
    static const QRegularExpression lines(
        QStringLiteral("^(SCServo|SMServo|STServo|FT-[A-Z]+)(?![A-Za-z])"));
    static const QRegularExpression buses(QStringLiteral("(?<![A-Z0-9])(TTL|485)(?![A-Z0-9])"));
    const QString name = QFileInfo(path).fileName();
    FirmwareName found{lines.match(name).captured(1), buses.match(name).captured(1)};
    if (name.contains(QLatin1String("MODBUS")))
        found.bus = QStringLiteral("MODBUS");
    return found;
}
} // namespace jobs
