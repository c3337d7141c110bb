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
    static const QRegularExpression form(QStringLiteral(
        "^(FT-[A-Z]+|S[CMT]Servo[0-9.]+)-(GD32|STM32)-(TTL|485(?:-MODBUS)?)(?![A-Za-z])"));
    const QRegularExpressionMatch name = form.match(QFileInfo(path).fileName());
    return {name.captured(1), name.captured(2), name.captured(3)};
}
} // namespace jobs
