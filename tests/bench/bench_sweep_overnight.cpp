// SPDX-License-Identifier: GPL-3.0-or-later
// A night of the sweep test: eight hours of simulated time, six servos there and back once a
// second, readings streamed to a file, report as page and JSON at the end, kept in the history.
// Memory is to stay flat (at most 200 MB), the report to be readable. And the report of a run of
// 1000 legs is to be on the disk within 2 s of the last one. Hours and baud rate may be given as
// arguments.
#include "history/history.h"
#include "jobs/sweep/sweep.h"
#include "jobs/sweep/sweep_recording.h"
#include "results/sweep_json.h"
#include "session/sweep/sweep_report.h"
#include "support/sim_fixture.h"
#include "support/text.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <cstdio>
#include <malloc.h>

using support::utf8;
using namespace std::chrono_literals;

namespace {
constexpr double maxMegabytes = 200;
constexpr double maxSeconds = 2;
constexpr int defaultHours = 8;
constexpr int lineBaud = 115'200; ///< at the fastest rate it takes a quarter of an hour
constexpr auto checkInterval = 30min;

/// A line of /proc/self/status, in MB.
double megabytes(const char* name)
{
    QFile status(utf8("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : status.readAll().split('\n')) {
        if (line.startsWith(name))
            return line.simplified().split(' ').value(1).toDouble() / 1024;
    }
    return 0;
}

struct NightSpec {
    int servos = 6;
    base::Duration length{};
    int cycles = 0; ///< 0: as long as `length`
    base::Duration pause = 1s;
    int baud = 1'000'000;
};

struct SavedRun {
    results::SweepRun run;
    std::unique_ptr<jobs::SweepRecording> readings;
    bool fine = false;
};

std::vector<device::Servo> servosOf(support::SimFixture& bench, int count)
{
    std::vector<device::Servo> servos;
    for (int id = 1; id <= count; ++id)
        servos.push_back(bench.servo(id));
    return servos;
}

jobs::SweepRequest orderOf(const NightSpec& night, const std::vector<device::Servo>& servos)
{
    jobs::SweepRequest order;
    order.spec.range = {utf8("1800"), utf8("2300")};
    order.spec.speed = utf8("3000");
    order.spec.pace = results::SweepPace::Delay;
    order.spec.pause = night.pause;
    order.spec.cycles = night.cycles;
    order.spec.length = night.length;
    order.program = utf8("bench_sweep_overnight");
    order.simulated = true;
    for (const device::Servo& servo : servos)
        order.limits.push_back(
            results::builtInSweepLimits(servo.profile->modelName, servo.profile->series));
    return order;
}

SavedRun measure(const NightSpec& night, const QString& report)
{
    QStringList names;
    for (int id = 1; id <= night.servos; ++id)
        names << utf8("sts3215@%1").arg(id);
    support::SimFixtureOptions options;
    options.baud = night.baud;
    options.servoBaud = night.baud;
    support::SimFixture bench(names.join(QLatin1Char(',')), options);
    auto servos = servosOf(bench, night.servos);
    const jobs::SweepRequest order = orderOf(night, servos);
    SavedRun kept;
    jobs::SweepCallbacks watch;
    watch.onBegin = [&](const results::SweepRun& run) -> std::optional<base::Error> {
        auto made = jobs::SweepRecording::start(run, session::sweepReadingsPath(report));
        if (!made)
            return made.error();
        kept.readings = std::move(*made);
        return std::nullopt;
    };
    std::uint64_t readings = 0;
    watch.onSample = [&](std::size_t servo, const jobs::SweepSample& sample, double goal, int leg) {
        ++readings;
        kept.readings->add(servo, sample, goal, leg);
    };
    watch.onGoal = [&](std::size_t servo, int leg, base::Duration at) {
        kept.readings->goal(servo, leg, at);
    };
    base::Duration next{};
    watch.onProgress = [&](const jobs::SweepProgress& progress) {
        bench.clearFrames(); // the bench's own record of the wire
        if (progress.elapsed < next)
            return;
        next = progress.elapsed + checkInterval;
        std::printf("  %5.1f h: leg %d, %.1f M readings, %.0f MB\n",
                    std::chrono::duration<double, std::ratio<3600>>(progress.elapsed).count(),
                    progress.leg, double(readings) / 1e6, megabytes("VmRSS:"));
        std::fflush(stdout);
    };
    auto done = jobs::sweep(bench.context(), servos, order, watch);
    if (!done) {
        std::printf("failed: %s %s\n", qPrintable(base::errorName(done.error().code)),
                    qPrintable(done.error().detail));
        return kept;
    }
    kept.run = std::move(*done);
    kept.fine = kept.run.end == results::SweepEnd::Finished;
    return kept;
}

/// Seconds until readings and report are on the disk.
double write(const SavedRun& kept, session::SweepFormat format, const QString& path)
{
    QElapsedTimer timer;
    timer.start();
    kept.readings->finish();
    const auto saved = session::saveSweepReport(kept.run, *kept.readings, format, false, path);
    const double seconds = double(timer.nsecsElapsed()) * 1e-9;
    std::printf("  %s after %.2f s, %.1f MB\n", qPrintable(QFileInfo(path).fileName()), seconds,
                double(QFileInfo(path).size()) / (1 << 20));
    return saved && !kept.readings->failure() ? seconds : 1e9;
}

bool readable(const SavedRun& kept, const QString& path)
{
    const auto read = results::loadSweepRun(path);
    if (!read || read->servos.size() != kept.run.servos.size())
        return false;
    for (std::size_t i = 0; i < read->servos.size(); ++i) {
        if (read->servos[i].legs != kept.run.servos[i].legs ||
            read->servos[i].metrics != kept.run.servos[i].metrics)
            return false;
    }
    return true;
}

bool night(int hours, int baud)
{
    const QTemporaryDir dir;
    std::printf("%d h, six servos, %d baud:\n", hours, baud);
    NightSpec order;
    order.length = std::chrono::hours(hours);
    order.baud = baud;
    const QString page = dir.filePath(utf8("night.html"));
    QElapsedTimer timer;
    timer.start();
    const SavedRun kept = measure(order, page);
    if (!kept.fine)
        return false;
    std::printf("  measured in %.0f s, %zu legs of each servo, %.0f MB at most\n",
                double(timer.elapsed()) / 1000, kept.run.servos[0].legs.size(),
                megabytes("VmHWM:"));
    const QString json = dir.filePath(utf8("night.json"));
    write(kept, session::SweepFormat::Html, page);
    write(kept, session::SweepFormat::Json, json);
    std::printf("  readings %.0f MB, %llu lost\n",
                double(QFileInfo(session::sweepReadingsPath(page)).size()) / (1 << 20),
                static_cast<unsigned long long>(kept.readings->lost()));
    timer.restart();
    const auto number = history::saveRun(dir.filePath(utf8("history.sqlite")), kept.run);
    std::printf("  in the history after %.2f s\n", double(timer.elapsed()) / 1000);
    const double peakMegabytes = megabytes("VmHWM:");
    const bool flat = peakMegabytes <= maxMegabytes;
    std::printf("  %.0f MB at most with reports and history, %.2f x the aim of %.0f MB\n",
                peakMegabytes, peakMegabytes / maxMegabytes, maxMegabytes);
    // Reading it back costs more than writing it, and is another program's business.
    const bool fine = readable(kept, json) && number.number == 1 && kept.readings->lost() == 0;
    std::printf("  report %s\n", fine ? "readable" : "NOT READABLE");
    return flat && fine;
}

bool runThousandLegs()
{
    const QTemporaryDir dir;
    std::printf("1000 legs of one servo, 1 Mbaud:\n");
    NightSpec order;
    order.servos = 1;
    order.cycles = 500;
    const QString page = dir.filePath(utf8("legs.html"));
    const SavedRun kept = measure(order, page);
    if (!kept.fine || kept.run.servos[0].legs.size() != 1000)
        return false;
    const double seconds = write(kept, session::SweepFormat::Html, page);
    std::printf("  %.2f x the aim of %.0f s\n", seconds / maxSeconds, maxSeconds);
    return seconds <= maxSeconds;
}
} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication app(argc, argv);
    const int hours = argc > 1 ? std::max(1, std::atoi(argv[1])) : defaultHours;
    const int baud = argc > 2 ? std::atoi(argv[2]) : lineBaud;
    const bool quick = runThousandLegs();
    malloc_trim(0);
    const bool flat = night(hours, baud);
    return quick && flat ? 0 : 1;
}
