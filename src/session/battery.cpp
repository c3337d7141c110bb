// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/battery.h"

#include <QDir>
#include <QFile>

namespace session {
namespace {
constexpr int lowPercent = 20;

QString lineOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readLine()).trimmed()
                                          : QString();
}
} // namespace

std::optional<int> lowBatteryPercent(const QString& folder)
{
    const QDir supplies(folder);
    for (const QString& name : supplies.entryList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
        const QString supply = supplies.filePath(name);
        // A mouse has a battery as well: of scope "Device".
        if (lineOf(supply + QStringLiteral("/type")) != QLatin1String("Battery") ||
            lineOf(supply + QStringLiteral("/scope")) == QLatin1String("Device") ||
            lineOf(supply + QStringLiteral("/status")) != QLatin1String("Discharging"))
            continue;
        bool isKnown = false;
        const int percent = lineOf(supply + QStringLiteral("/capacity")).toInt(&isKnown);
        if (isKnown && percent < lowPercent)
            return percent;
    }
    return std::nullopt;
}
} // namespace session
