// SPDX-License-Identifier: GPL-3.0-or-later
// Which serial ports this computer has, with what is known about their adapters. May take tens of
// milliseconds: never call it on the main thread of a window.
#pragma once

#include <QStringList>

#include <optional>
#include <vector>

namespace transport {
struct PortInfo {
    QString path;        ///< /dev/ttyUSB0
    QString description; ///< USB Serial
    QString manufacturer;
    QString serialNumber;
    int vendorId = 0; ///< 0: not a USB adapter or unknown
    int productId = 0;
    bool operator==(const PortInfo&) const = default;
};

std::vector<PortInfo> listPorts();

/// USB adapters that are plugged in, but that the braille service (brltty) has taken away from the
/// system, so that they have no port: "1a86:7523". Known only where the system shows its processes
/// and USB devices (Linux); `root` is the folder in which proc and sys lie, for tests.
QStringList adaptersClaimedByBrltty(const QString& root = QStringLiteral("/"));

/// Milliseconds for which an FTDI adapter collects bytes before it hands them over; nullopt:
/// another chip or system.
std::optional<int> latencyTimer(const QString& canonicalPath,
                                const QString& root = QStringLiteral("/"));
} // namespace transport
