// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep page while a test of six servos runs on a paced wire at 1 Mbaud, its curves, legs and
// figures in sight: how long the main thread was busy. Wanted: p99 16 ms.
#include "bench/baseline_sync.h"
#include "bench/stall_probe.h"
#include "gui/main_window_fixture.h"
#include "session/sweep/sweep_test.h"

#include <QAbstractButton>

using namespace std::chrono_literals;

namespace {
constexpr int servos = 6;
constexpr int length = 30; // s

session::SweepTestRequest orderForServo(session::Workbench& workbench)
{
    session::SweepTestRequest order;
    order.spec.range = {QStringLiteral("1500"), QStringLiteral("2500")};
    order.spec.pause = 600ms;
    order.spec.cycles = 10'000;
    order.servos = workbench.registry().order();
    for (const session::ServoRef ref : order.servos) {
        const auto& profile = *workbench.registry().servo(ref)->servo.profile;
        order.limits.push_back(results::builtInSweepLimits(profile.modelName, profile.series));
    }
    return order;
}
} // namespace

int main(int argc, char* argv[])
{
    const QTemporaryDir place; // the user's settings and journal are nobody's business here
    qputenv("SERVODESK_DATA_DIR", place.path().toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", place.path().toLocal8Bit());
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("servodesk-bench"));
    QTextStream out(stdout);
    QStringList list;
    for (int id = 1; id <= servos; ++id)
        list += QStringLiteral("sts3215@%1").arg(id);
    const raw::Simulator simulator({QStringLiteral("--servos"), list.join(u','),
                                    QStringLiteral("--baud"), QStringLiteral("1000000"),
                                    QStringLiteral("--wire-time")});
    gui::MainWindowFixture bench;
    bench.window->resize(1600, 900);
    bench.window->start({.port = session::PortRequest{.name = simulator.port(), .baud = 1'000'000},
                         .page = QStringLiteral("sweep")});
    bool searched = QTest::qWaitFor(
        [&] {
            return bench.workbench().search().lastReport() &&
                   !bench.workbench().search().isSearching();
        },
        30000);
    // On a busy machine an answer may come later than a search waits.
    for (int tries = 0;
         searched && bench.workbench().registry().order().size() != servos && tries < 5; ++tries) {
        bench.workbench().search().start({.firstId = 1, .lastId = servos, .bauds = {}});
        searched = bench.waitUntilIdle();
    }
    if (!searched || bench.workbench().registry().order().size() != servos || !bench.choose(1))
        qFatal("not all servos were found");
    session::SweepTest& test = bench.context.workbench.sweepTest();
    const bool started = test.start(orderForServo(bench.workbench()));
    const bool legs = QTest::qWaitFor(
        [&] { return test.run() != nullptr && test.run()->servos[0].legs.size() > 3; }, 30000);
    if (!started || !legs)
        qFatal("the test did not begin");
    bench::StallProbe probe;
    bench::runEventLoop(length * 1000);
    probe.report(out, "test of six servos runs");
    out << "legs of each servo: " << test.run()->servos[0].legs.size()
        << ", readings: " << test.store().count() / 2 << '\n';
    test.stop();
    return QTest::qWaitFor([&] { return !test.isRunning(); }, 10000) ? 0 : 1;
}
