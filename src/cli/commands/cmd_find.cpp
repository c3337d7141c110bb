// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "session/search/port_finder.h"
#include "text/bus_text.h"
#include "text/error_text.h"

namespace cli {
namespace {
constexpr const char* portArgument = "PORT";

QStringList portsToSearch(const Run& run, const Values& values)
{
    QStringList ports = values.arguments(portArgument);
    if (ports.isEmpty() && !run.globals().port.isEmpty())
        ports << run.globals().port;
    if (!ports.isEmpty())
        return ports;
    for (const transport::PortInfo& port : transport::listPorts())
        ports << port.path;
    return ports;
}

Json jsonFound(const std::vector<jobs::FoundServo>& found)
{
    Json::Array servos;
    for (const jobs::FoundServo& one : found) {
        const catalog::Profile* profile = one.servo.profile.get();
        servos.push_back(Json::object()
                             .add("id", one.servo.id)
                             .add("model", profile != nullptr ? Json(profile->modelName) : Json())
                             .add("protocol", base::protocolName(one.servo.protocol))
                             .add("baud", one.servo.baud));
    }
    return servos;
}

/// What is said of one port, in both forms.
struct PortLine {
    QStringList cells;
    Json json;
    bool hasServos = false;
};

PortLine portLine(const QString& port, const base::Result<jobs::ScanReport>& report)
{
    PortLine line{{port}, Json::object().add("port", port), false};
    if (!report) {
        const QString why = text::describe(report.error()).message;
        line.cells << noValue() << noValue() << noValue() << why;
        line.json.add("error", jsonError(report.error()));
        return line;
    }
    line.hasServos = !report->found.empty();
    line.json.add("found", jsonFound(report->found));
    if (report->stopped)
        line.json.add("stopped", true);
    if (!line.hasServos) {
        line.cells << noValue() << noValue() << noValue()
                   << (report->stopped ? translate("cli", "not searched to the end")
                                       : translate("cli", "no servo replied"));
        return line;
    }
    std::vector<int> ids;
    bool duplicates = false;
    for (const jobs::FoundServo& one : report->found) {
        ids.push_back(one.servo.id);
        duplicates |= one.duplicateSuspected;
    }
    const device::Servo& first = report->found.front().servo;
    line.cells << text::idRangesText(ids) << base::protocolName(first.protocol)
               << QString::number(first.baud)
               << (duplicates ? translate("cli", "possibly several servos with one ID")
                              : QString());
    return line;
}

base::Result<Exit> runFind(Run& run, const Values& values)
{
    Json::Array ports;
    Table table({translate("cli", "Port"), translate("cli", "ID"), translate("cli", "Protocol"),
                 translate("cli", "Baud rate"), translate("cli", "Note")});
    bool hasServos = false;
    for (const QString& port : portsToSearch(run, values)) {
        if (run.stop().isRequested())
            break;
        ProgressLine progress(run.console(), translate("cli", "Searching %1").arg(port));
        const PortLine line = portLine(
            port, session::findServos(run.session(), port, run.stop(),
                                      [&](const jobs::Progress& now) { progress.update(now); }));
        ports.push_back(line.json);
        table.add(line.cells);
        hasServos |= line.hasServos;
    }
    const bool isEmpty = ports.empty();
    Json document = Json::object().add("ports", std::move(ports));
    if (run.stop().isRequested())
        document.add("stopped", true);
    run.finish(std::move(document),
               isEmpty ? translate("cli", "This computer has no serial port.") + QLatin1Char('\n')
                       : table.text());
    if (run.stop().isRequested())
        return Exit::Failed;
    return hasServos ? Exit::Success : Exit::NoReply;
}
} // namespace

Command findCommand()
{
    return {"find",
            QT_TRANSLATE_NOOP("cli", "search all ports at all baud rates until servos reply"),
            {{portArgument, QT_TRANSLATE_NOOP("cli", "only these ports"), 0, many}},
            {},
            runFind};
}
} // namespace cli
