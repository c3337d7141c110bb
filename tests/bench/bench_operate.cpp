// SPDX-License-Identifier: GPL-3.0-or-later
// The operate page on a paced wire: six STS servos by sync read at 1 Mbaud with gauges, strip and
// chart open, against a bare loop without a window on the same pseudo-terminal; frames of the
// chart, and how long the main thread was busy. Interleaved pairs. Wanted: median ratio 0.93, 30
// frames a second, p99 16 ms. POSIX, since the bare loop is.
#include "bench/baseline_sync.h"
#include "bench/stall_probe.h"
#include "gui/main_window_fixture.h"
#include "ui/charts/trend_chart.h"

#include <QGraphicsView>

using namespace std::chrono_literals;

namespace {
constexpr int pairs = 5;
constexpr int servos = 6;
constexpr auto span = 3s;

/// Counts what is painted of the chart.
class PaintCounter : public QObject {
public:
    int count = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
};

struct FrameStats {
    double rounds = 0;
    double frames = 0;
};

FrameStats watch(const QString& port, QTextStream& out)
{
    gui::MainWindowFixture bench;
    bench.window->resize(1600, 900);
    bench.window->start({.port = session::PortRequest{.name = port, .baud = 1'000'000},
                         .page = QStringLiteral("operate")});
    const bool searched = QTest::qWaitFor(
        [&] {
            return bench.workbench().search().lastReport() &&
                   !bench.workbench().search().isSearching();
        },
        30000);
    if (!searched || bench.workbench().registry().order().size() != servos || !bench.choose(1))
        qFatal("not all servos were found");
    bench::runEventLoop(500);
    auto* chart = bench.find<ui::TrendChart>("trendChart");
    PaintCounter frames;
    for (QWidget* part : chart->findChildren<QWidget*>()) {
        if (auto* view = qobject_cast<QGraphicsView*>(part))
            view->viewport()->installEventFilter(&frames);
    }
    std::vector<base::Duration> answered;
    const session::ServoRef first = bench.workbench().registry().order().front();
    QObject::connect(&bench.workbench().polling(), &session::PollController::readingsReceived,
                     &frames, [&](const std::vector<session::Reading>& batch) {
                         for (const session::Reading& reading : batch) {
                             const bool whole = reading.values.size() > 6;
                             if (reading.answered && reading.servo == first && whole)
                                 answered.push_back(reading.at);
                         }
                     });
    bench::StallProbe probe;
    bench::runEventLoop(int(std::chrono::milliseconds(span).count()));
    probe.report(out, "page open");
    if (answered.size() < 2)
        qFatal("nothing was read");
    const auto time = std::chrono::duration<double>(answered.back() - answered.front()).count();
    return {double(answered.size() - 1) / time,
            frames.count / std::chrono::duration<double>(span).count()};
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
    constexpr int feedback = 56;
    constexpr int feedbackBytes = 15;
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const double bare =
            bench::baselineSyncRate(simulator.port(), servos, feedback, feedbackBytes, span);
        const FrameStats seen = watch(simulator.port(), out);
        ratios.push_back(seen.rounds / bare);
        out << "sync read of six: bare " << bare << "/s, page open " << seen.rounds << "/s, ratio "
            << ratios.back() << "; chart " << seen.frames << " frames/s\n";
        out.flush();
    }
    out << "median ratio " << bench::median(ratios) << " (wanted 0.93)\n";
    return 0;
}
