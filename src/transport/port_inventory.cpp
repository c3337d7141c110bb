// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_inventory.h"

#include <QFile>
#include <QSerialPortInfo>

#include <algorithm>

namespace transport {
namespace {
// Linux creates ttyS0… whether or not there is a chip behind them; type 0 means none was found. In
// a container they may be listed in /sys without a device to open.
bool isPhantom(const QSerialPortInfo& port)
{
    if (!QFile::exists(port.systemLocation()))
        return true;
    QFile type(QStringLiteral("/sys/class/tty/%1/type").arg(port.portName()));
    return type.open(QIODevice::ReadOnly) && type.readAll().trimmed() == "0";
}
} // namespace

std::vector<PortInfo> listPorts()
{
    std::vector<PortInfo> ports;
    const auto serialPorts = QSerialPortInfo::availablePorts();
    for (const QSerialPortInfo& port : serialPorts) {
        if (isPhantom(port))
            continue;
        ports.push_back({port.systemLocation(), port.description(), port.manufacturer(),
                         port.serialNumber(), port.vendorIdentifier(), port.productIdentifier()});
    }
    std::sort(ports.begin(), ports.end(),
              [](const PortInfo& a, const PortInfo& b) { return a.path < b.path; });
    return ports;
}

std::optional<int> latencyTimer(const QString& canonicalPath, const QString& root)
{
    QFile file(root + QStringLiteral("/sys/bus/usb-serial/devices/") +
               canonicalPath.section(QLatin1Char('/'), -1) + QStringLiteral("/latency_timer"));
    bool isNumber = false;
    const int span = file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().toInt(&isNumber) : 0;
    return isNumber ? std::optional(span) : std::nullopt;
}
} // namespace transport
