// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "text/bus_text.h"

namespace cli {
namespace {
QString usbId(const transport::PortInfo& port)
{
    if (port.vendorId == 0)
        return noValue();
    return QStringLiteral("%1:%2")
        .arg(port.vendorId, 4, 16, QLatin1Char('0'))
        .arg(port.productId, 4, 16, QLatin1Char('0'));
}

base::Result<Exit> runPorts(Run& run, const Values&)
{
    Json::Array ports;
    Table table({translate("cli", "Port"), translate("cli", "Description"),
                 translate("cli", "Manufacturer"), translate("cli", "Serial number"),
                 translate("cli", "USB")});
    for (const transport::PortInfo& port : transport::listPorts()) {
        ports.push_back(Json::object()
                            .add("path", port.path)
                            .add("description", port.description)
                            .add("manufacturer", port.manufacturer)
                            .add("serial_number", port.serialNumber)
                            .add("vendor_id", port.vendorId)
                            .add("product_id", port.productId)
                            .add("simulated", false));
        table.add({port.path, port.description, port.manufacturer, port.serialNumber, usbId(port)});
    }
    for (const QString& name : session::simulatedPorts()) {
        ports.push_back(Json::object().add("path", name).add("simulated", true));
        table.add({name, translate("cli", "simulated bus: %1").arg(text::simulatedBusText(name))});
    }
    run.finish(Json::object().add("ports", std::move(ports)), table.text());
    return Exit::Success;
}
} // namespace

Command portsCommand()
{
    return {"ports", QT_TRANSLATE_NOOP("cli", "list the ports on this computer"), {}, {}, runPorts};
}
} // namespace cli
