// SPDX-License-Identifier: GPL-3.0-or-later
// Which serial ports this computer has, with what is known about their adapters. May take tens of
// milliseconds: never call it on the main thread of a window.
#pragma once

#include <QString>

#include <vector>

namespace transport {
struct PortInfo {
    QString path;        ///< /dev/ttyUSB0
    QString description; ///< USB Serial
    QString manufacturer;
    QString serialNumber;
    int vendorId = 0; ///< 0: not a USB adapter or unknown
    int productId = 0;
};

std::vector<PortInfo> listPorts();
} // namespace transport
