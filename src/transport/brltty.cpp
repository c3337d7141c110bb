// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_inventory.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <array>

namespace transport {
namespace {
/// Converter chips that braille displays are built with too: what brltty's rules take.
constexpr std::array sharedUsbIds{"1a86:7523", "10c4:ea60", "0403:6001"};

QString readText(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.read(256)).trimmed()
                                          : QString();
}

bool isBrlttyRunning(const QString& root)
{
    const QDir processes(root + QStringLiteral("/proc"));
    const QStringList names = processes.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString& name : names) {
        if (name.front().isDigit() &&
            readText(processes.filePath(name + QStringLiteral("/comm"))) == QLatin1String("brltty"))
            return true;
    }
    return false;
}

/// Its interface is served by a program instead of the serial driver.
bool hasUserSpaceDriver(const QDir& devices, const QString& device)
{
    const QStringList interfaces =
        devices.entryList({device + QStringLiteral(":*")}, QDir::Dirs | QDir::System);
    for (const QString& interface : interfaces) {
        const QString driver =
            QFile::symLinkTarget(devices.filePath(interface + QStringLiteral("/driver")));
        if (driver.section(QLatin1Char('/'), -1) == QLatin1String("usbfs"))
            return true;
    }
    return false;
}
} // namespace

QStringList adaptersClaimedByBrltty(const QString& root)
{
    const QDir devices(root + QStringLiteral("/sys/bus/usb/devices"));
    QStringList claimed;
    for (const QString& device :
         devices.entryList(QDir::Dirs | QDir::System | QDir::NoDotAndDotDot)) {
        if (device.contains(QLatin1Char(':')))
            continue;
        const QString chip = readText(devices.filePath(device + QStringLiteral("/idVendor"))) +
                             QLatin1Char(':') +
                             readText(devices.filePath(device + QStringLiteral("/idProduct")));
        const bool shared =
            std::any_of(sharedUsbIds.begin(), sharedUsbIds.end(),
                        [&](const char* usbId) { return chip == QLatin1String(usbId); });
        if (shared && hasUserSpaceDriver(devices, device))
            claimed << chip;
    }
    return claimed.isEmpty() || !isBrlttyRunning(root) ? QStringList() : claimed;
}
} // namespace transport
