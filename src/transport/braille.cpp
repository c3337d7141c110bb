// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_inventory.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <array>

namespace transport {
namespace {
/// Converter chips that braille displays are built with too: what brltty's rules take.
constexpr std::array sharedChips{"1a86:7523", "10c4:ea60", "0403:6001"};

QString contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.read(256)).trimmed()
                                          : QString();
}

bool brailleServiceRuns(const QString& root)
{
    const QDir processes(root + QStringLiteral("/proc"));
    const QStringList names = processes.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString& name : names) {
        if (name.front().isDigit() &&
            contentOf(processes.filePath(name + QStringLiteral("/comm"))) ==
                QLatin1String("brltty"))
            return true;
    }
    return false;
}

/// Its interface is served by a program instead of the serial driver.
bool servedByProgram(const QDir& devices, const QString& device)
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

QStringList takenByBraille(const QString& root)
{
    const QDir devices(root + QStringLiteral("/sys/bus/usb/devices"));
    QStringList taken;
    for (const QString& device :
         devices.entryList(QDir::Dirs | QDir::System | QDir::NoDotAndDotDot)) {
        if (device.contains(QLatin1Char(':')))
            continue;
        const QString chip = contentOf(devices.filePath(device + QStringLiteral("/idVendor"))) +
                             QLatin1Char(':') +
                             contentOf(devices.filePath(device + QStringLiteral("/idProduct")));
        const bool shared =
            std::any_of(sharedChips.begin(), sharedChips.end(),
                        [&](const char* one) { return chip == QLatin1String(one); });
        if (shared && servedByProgram(devices, device))
            taken << chip;
    }
    return taken.isEmpty() || !brailleServiceRuns(root) ? QStringList() : taken;
}
} // namespace transport
