// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "session/search/port_finder.h"
#include "text/bus_text.h"
#include "text/error_text.h"

#include <algorithm>

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

Json jsonPort(const QString& port, const base::Result<jobs::ScanReport>& report)
{
    return report ? jsonScan(*report)
                  : Json::object().add("port", port).add("error", jsonError(report.error()));
}

void addNote(Table& table, const QString& port, const QString& note)
{
    table.add({port, noValue(), noValue(), noValue(), note});
}

/// A line for each protocol.
void addLines(Table& table, const QString& port, const base::Result<jobs::ScanReport>& report)
{
    if (!report)
        return addNote(table, port, text::describe(report.error()).message);
    if (report->found.empty())
        return addNote(table, port,
                       report->stopped ? translate("cli", "search not finished")
                                       : translate("cli", "no servo replied"));
    for (const auto& [protocol, ids] : session::idsByProtocol(report->found)) {
        const bool duplicates =
            std::any_of(report->found.begin(), report->found.end(),
                        [protocol = protocol](const jobs::FoundServo& one) {
                            return one.servo.protocol == protocol && one.duplicateSuspected;
                        });
        table.add(
            {port, text::idRangesText(ids), base::protocolName(protocol),
             QString::number(report->found.front().servo.baud),
             duplicates ? translate("cli", "possibly several servos with one ID") : QString()});
    }
}

/// Each line names its port.
QString remarksOn(const QString& port, const jobs::ScanReport& report)
{
    QString remarks;
    for (const QString& line : scanRemarks(report).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        remarks += port + QStringLiteral(": ") + line + QLatin1Char('\n');
    return remarks;
}

base::Result<Exit> runFind(Run& run, const Values& values)
{
    const QStringList ports = portsToSearch(run, values);
    Json::Array documents;
    Table table({translate("cli", "Port"), translate("cli", "ID"), translate("cli", "Protocol"),
                 translate("cli", "Baud rate"), translate("cli", "Note")});
    std::optional<base::Error> firstError;
    QString remarks;
    bool hasServos = false;
    bool isSearched = false; ///< one port could be
    for (const QString& port : ports) {
        if (run.stop().isRequested())
            break;
        ProgressLine progress(run.console(), translate("cli", "Searching %1").arg(port));
        const auto report =
            session::findServos(run.session(), run.requestFor(port), run.stop(),
                                [&](const jobs::Progress& now) { progress.update(now); });
        documents.push_back(jsonPort(port, report));
        addLines(table, port, report);
        hasServos |= report && !report->found.empty();
        isSearched |= report.has_value();
        remarks += report ? remarksOn(port, *report) : QString();
        if (!report && !firstError)
            firstError = report.error();
    }
    Json document = Json::object().add("ports", std::move(documents));
    if (run.stop().isRequested())
        document.add("stopped", true);
    run.finish(std::move(document),
               ports.isEmpty()
                   ? translate("cli", "This computer has no serial port.") + QLatin1Char('\n')
                   : table.text() + remarks);
    if (run.stop().isRequested())
        return Exit::Failed;
    if (firstError && !isSearched)
        return exitCode(firstError->code);
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
