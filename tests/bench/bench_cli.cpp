// SPDX-License-Identifier: GPL-3.0-or-later
// What the program costs as a user sees it: servodesk-cli against servodesk-sim on a
// pseudo-terminal with real wire times. Prints figures beside their aims; exit code 1 if one is
// missed. Run it on a machine that has nothing else to do.
#include "device/reader.h"
#include "session/session.h"
#include "support/cli_program.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonArray>

#include <cstdio>
#include <cstdlib>
#include <sys/resource.h>

using support::CliProgram;
using support::SimProgram;
using support::words;

namespace {
bool allTargetsMet = true;

void figure(const char* what, double value, const char* unit, double target)
{
    const bool met = value <= target;
    allTargetsMet = allTargetsMet && met;
    std::printf("%-58s %8.2f %-4s aim <= %-6.2f %s\n", what, value, unit, target,
                met ? "met" : "MISSED");
    std::fflush(stdout);
}

/// Of all programs that have been run to their end so far.
rusage ended()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage;
}

double cpuSeconds(const rusage& usage)
{
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + double(t.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void scan(const char* what, const char* simulator, const char* command, double target)
{
    const SimProgram sim(words(simulator));
    CliProgram cli;
    cli.setPort(sim.port());
    const QJsonObject json = cli.json(command).json();
    if (json[QLatin1String("found")].toArray().size() != 6) {
        std::printf("%s: not all six servos were found\n", what);
        allTargetsMet = false;
    }
    figure(what, json[QLatin1String("elapsed_ms")].toDouble() / 1000, "s", target);
}

void watch()
{
    constexpr int seconds = 10;
    const SimProgram sim(words("--preset demo --wire-time"));
    CliProgram cli;
    cli.setPort(sim.port());
    const QString csv = cli.dataFolder() + QStringLiteral("/watch.csv");
    const double before = cpuSeconds(ended());
    const auto result = cli.run(words("watch 1-6 --rate 50 --csv")
                                << csv << QStringLiteral("--duration") << QString::number(seconds));
    std::printf("%s", qPrintable(result.out));
    figure("CPU of watch, six servos at 50 Hz, share of a core",
           100 * (cpuSeconds(ended()) - before) / seconds, "%", 10);
}

void fullRead()
{
    session::Session session;
    session::PortRequest request;
    request.name = QStringLiteral("sim:sts3215@1");
    const auto connection = session.connect(request);
    if (!connection)
        std::abort();
    const base::StopToken stop;
    device::Notices notices;
    const device::Context context = (*connection)->context(stop, notices);
    auto servo = device::identify(context, 1);
    if (!servo)
        std::abort();
    const auto before = context.bus.statistics().total.sent;
    if (!device::readAll(context, *servo))
        std::abort();
    figure("Transactions of a full STS table read",
           double(context.bus.statistics().total.sent - before), "", 4);
}
} // namespace

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    scan("Scan of 254 IDs, pty, six servos", "--preset demo --wire-time", "scan", 1.5);
    scan("Scan of 254 IDs, adapter with 16 ms latency", "--preset demo --wire-time --latency-ms 16",
         "scan", 2.0);
    scan("Scan of 254 LX IDs, pty, six servos",
         "--servos lx16a@1,lx16a@2,lx16a@3,lx16a@100,lx224hv@200,lx224hv@253 --wire-time",
         "--protocol lx scan --retries 0", 8.0);
    fullRead();
    watch();
    CliProgram cli;
    cli.run("dump 1");
    cli.run("tour");
    figure("Peak memory of servodesk-cli (or -sim, if that is more)",
           double(ended().ru_maxrss) / 1024, "MB", 40);
    return allTargetsMet ? EXIT_SUCCESS : EXIT_FAILURE;
}
