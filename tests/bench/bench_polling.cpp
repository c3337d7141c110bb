// SPDX-License-Identifier: GPL-3.0-or-later
// What the window's feed makes of a paced wire: six STS servos by sync read at 1 Mbaud through
// Workbench with an event loop on the main thread, against a bare write/poll/read loop on the same
// pseudo-terminal. Interleaved pairs; prints every ratio and the median (wanted: 0.93), what the
// main thread spent on it, and how soon the first stop frame left after Workbench::emergencyStop().
// POSIX, since the bare loop is.
#include "bench/baseline_sync.h"
#include "session/workbench.h"
#include "support/temporary_data_folder.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTextStream>

#include <algorithm>
#include <ctime>

using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int pairs = 5;
constexpr int servos = 6;
constexpr Duration span = 2s;
constexpr double wanted = 0.93;
constexpr int stops = 20;

base::SystemClock wallClock;
const QString user = QStringLiteral("bench");

template <typename Condition>
void runUntil(Condition&& condition)
{
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (condition())
            loop.quit();
    });
    look.start(5);
    loop.exec();
}

double threadCpu()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

struct FeedMeasurement {
    double rounds = 0; ///< a second
    double cpu = 0;    ///< share of a core the main thread took
    std::uint64_t missed = 0;
};

FeedMeasurement feedRate(session::Workbench& workbench, const QStringList& keys)
{
    session::Subscription subscription;
    for (const session::ServoRef ref : workbench.registry().order())
        subscription.parts.push_back({ref, keys});
    std::vector<Duration> answered;
    FeedMeasurement measured;
    const session::ServoRef first = workbench.registry().order().front();
    const auto readingsConnection =
        QObject::connect(&workbench.polling(), &session::PollController::readingsReceived,
                         &workbench, [&](const std::vector<session::Reading>& batch) {
                             for (const session::Reading& reading : batch) {
                                 measured.missed += reading.answered ? 0 : 1;
                                 if (reading.answered && reading.servo == first)
                                     answered.push_back(reading.at);
                             }
                         });
    workbench.polling().subscribe(user, subscription);
    const Duration until = workbench.now() + span;
    const double cpu = threadCpu();
    runUntil([&] { return workbench.now() >= until; });
    measured.cpu = (threadCpu() - cpu) / std::chrono::duration<double>(span).count();
    workbench.polling().subscribe(user, {});
    QObject::disconnect(readingsConnection);
    if (answered.size() < 2)
        qFatal("the feed was not answered");
    measured.rounds = double(answered.size() - 1) /
                      std::chrono::duration<double>(answered.back() - answered.front()).count();
    return measured;
}

bool open(session::Workbench& workbench, const QString& path)
{
    workbench.link().connectTo({.name = path, .baud = 1'000'000});
    runUntil([&] {
        return workbench.link().state() == session::LinkState::Open ||
               workbench.link().state() == session::LinkState::Off;
    });
    return workbench.link().state() == session::LinkState::Open;
}

void close(session::Workbench& workbench)
{
    workbench.closing().disconnectFrom();
    runUntil([&] { return workbench.link().state() == session::LinkState::Off; });
}

/// Worst time from the call to the first byte of the broadcast, while the feed runs.
Duration stopDelay(session::Workbench& workbench, const QStringList& keys)
{
    session::Subscription subscription;
    for (const session::ServoRef ref : workbench.registry().order())
        subscription.parts.push_back({ref, keys});
    workbench.polling().subscribe(user, subscription);
    Duration worst{};
    for (int i = 0; i < stops; ++i) {
        const Duration until = workbench.now() + 70ms + i * 1ms;
        runUntil([&] { return workbench.now() >= until; });
        workbench.link().connection()->bus().takeTrace();
        const Duration callTime = workbench.now();
        workbench.emergencyStop().trigger();
        std::optional<Duration> sent;
        runUntil([&] {
            for (const bus::TraceEntry& entry : workbench.link().connection()->bus().takeTrace()) {
                const bool broadcast = entry.kind == bus::TraceKind::Sent &&
                                       entry.bytes.size() > 2 && entry.bytes[2] == 0xFE;
                if (broadcast && !sent)
                    sent = entry.at;
            }
            return sent && !workbench.tasks().isBusy();
        });
        worst = std::max(worst, *sent - callTime);
    }
    workbench.polling().subscribe(user, {});
    return worst;
}
} // namespace

int main(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    QStringList list;
    for (int id = 1; id <= servos; ++id)
        list += QStringLiteral("sts3215@%1").arg(id);
    const raw::Simulator simulator({QStringLiteral("--servos"), list.join(u','),
                                    QStringLiteral("--baud"), QStringLiteral("1000000"),
                                    QStringLiteral("--wire-time")});
    const QStringList keys{QStringLiteral("present_position"),    QStringLiteral("present_speed"),
                           QStringLiteral("present_load"),        QStringLiteral("present_voltage"),
                           QStringLiteral("present_temperature"), QStringLiteral("moving"),
                           QStringLiteral("present_current")};
    constexpr int feedback = 56;
    constexpr int feedbackBytes = 15;

    support::TemporaryDataFolder place;
    session::Session session;
    session::Workbench workbench(session);
    if (!open(workbench, simulator.port()))
        qFatal("the port does not open");
    workbench.search().start({.firstId = 1, .lastId = servos, .bauds = {}});
    runUntil([&] { return !workbench.search().isSearching() && !workbench.tasks().isBusy(); });
    if (workbench.registry().order().size() != servos)
        qFatal("not all servos were found");
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        close(workbench);
        const double baseline =
            bench::baselineSyncRate(simulator.port(), servos, feedback, feedbackBytes, span);
        if (!open(workbench, simulator.port()))
            qFatal("the port does not open again");
        const FeedMeasurement feed = feedRate(workbench, keys);
        ratios.push_back(feed.rounds / baseline);
        out << QStringLiteral("sync read of six: bare %1/s, feed %2/s, ratio %3; main thread %4 % "
                              "of a core, %5 missed\n")
                   .arg(baseline, 0, 'f', 0)
                   .arg(feed.rounds, 0, 'f', 0)
                   .arg(feed.rounds / baseline, 0, 'f', 3)
                   .arg(feed.cpu * 100, 0, 'f', 1)
                   .arg(feed.missed);
        out.flush();
    }
    std::sort(ratios.begin(), ratios.end());
    out << QStringLiteral("median ratio %1 (wanted %2)\n")
               .arg(ratios[pairs / 2], 0, 'f', 3)
               .arg(wanted, 0, 'f', 2);
    out << QStringLiteral("first stop frame after %1 ms at worst of %2 (wanted: 50)\n")
               .arg(double(stopDelay(workbench, keys).count()) / 1000, 0, 'f', 1)
               .arg(stops);
    close(workbench);
    return 0;
}
