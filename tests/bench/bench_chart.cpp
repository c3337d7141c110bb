// SPDX-License-Identifier: GPL-3.0-or-later
// How long one frame of the trend chart takes: 8 channels of 200 Hz over 60 minutes (5.76 million
// samples) at 1600x900 without a screen, from advance() or the mouse's event to painted pixels,
// legend, axes, cursors, marks and overview included. Wanted: p99 at most 8 ms while following,
// panning and zooming, at most 16 ms at 200 % (a process of its own); p50 at most 1.3 times that of
// a bare loop of QPainter, which draws as many lines into an image, while following, and 2 times
// while panning and zooming. An argument chooses: what has it in its name.
#include "ui/charts/trend_chart.h"
#include "ui/common/palette.h"
#include "ui/common/theme.h"

#include <QApplication>
#include <QGraphicsView>
#include <QMouseEvent>
#include <QPainter>
#include <QProcess>
#include <QTest>
#include <QTextStream>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <thread>

using namespace std::chrono_literals;

namespace {
QTextStream out(stdout);
QByteArray only; ///< measure what has this in its name

using Clock = std::chrono::steady_clock;
constexpr int channelCount = 8;
constexpr base::Duration period = 5ms;
constexpr base::Duration length = 60min;
constexpr int frames = 300;
constexpr auto frameTime = 34ms;

/// Of this thread alone: what a frame costs, also while others want the processor.
double cpuMs()
{
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return double(spent.tv_sec) * 1e3 + double(spent.tv_nsec) / 1e6;
}

double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double part(std::vector<double> times, std::size_t percent)
{
    std::sort(times.begin(), times.end());
    return times[std::min(times.size() * percent / 100, times.size() - 1)];
}

void report(const char* what, std::vector<double> times, std::vector<double> cpu, double maxMs)
{
    out << what << ": p50 " << part(times, 50) << " ms, p99 " << part(times, 99)
        << " ms; of processor time p50 " << part(cpu, 50) << " ms, p99 " << part(cpu, 99) << " ms"
        << " (wanted p99 <= " << maxMs << ")\n";
    out.flush();
}

/// As many lines as the chart has columns, by QPainter into an image.
class BareLoop {
public:
    explicit BareLoop(double ratio)
        : m_image((QSizeF(1600, 900) * ratio).toSize(), QImage::Format_RGB32)
    {}

    void paint()
    {
        const auto start = Clock::now();
        m_image.fill(Qt::white);
        QPainter painter(&m_image);
        for (int channel = 0; channel < channelCount; ++channel) {
            QVector<QLineF> lines;
            for (int x = 0; x < m_image.width(); ++x) {
                const double y =
                    m_image.height() / 2.0 * (1 + 0.9 * std::sin((x + m_frame) * 0.01 + channel));
                lines << QLineF(x, y - 2, x, y + 2);
            }
            painter.setPen(QPen(ui::trendColor(channel, Qt::white), 0));
            painter.drawLines(lines);
        }
        painter.end();
        ++m_frame;
        m_times.push_back(since(start));
    }
    double takeMedian() { return part(std::exchange(m_times, {}), 50); }

private:
    QImage m_image;
    int m_frame = 0;
    std::vector<double> m_times;
};

/// Two servos that move to and fro, with speed, current and voltage as such servos have them.
double sampleOf(int channel, base::Duration at)
{
    const double t = double(at.count()) / 1e6 + channel / 4 * 0.7;
    const double noise = std::sin(t * 911 + channel) * std::sin(t * 577);
    switch (channel % 4) {
    case 0:
        return 180 + 150 * std::sin(t * 0.9) + noise * 0.1;
    case 1:
        return 135 * std::cos(t * 0.9) + noise * 2;
    case 2:
        return 200 + 90 * std::abs(std::cos(t * 0.9)) + noise * 30;
    default:
        return 7.4 - 0.1 * std::abs(std::cos(t * 0.9)) + noise * 0.02;
    }
}

struct Fixture {
    Fixture()
    {
        const char* const units[] = {"°", "rpm", "mA", "V"};
        for (int i = 0; i < channelCount; ++i) {
            ui::TrendChannel channel;
            channel.id = store.open();
            channel.key = QString::number(i);
            channel.name = QStringLiteral("ID %1 · Value %2").arg(1 + i / 4).arg(i);
            channel.unit = QString::fromUtf8(units[i % 4]);
            channel.color = ui::trendColor(i, Qt::white);
            channels.push_back(channel);
        }
        const auto start = Clock::now();
        grow(length);
        out << store.count() << " samples in " << double(store.bytes()) / 1048576
            << " MiB, filled at " << double(store.count()) / since(start) / 1000
            << " M/s, the values' own cost included\n";
        for (base::Duration at{}; at < length; at += 20s)
            marks.push_back(
                {at, recording::MarkKind::Write, 1, QStringLiteral("position_p 32 → 40")});
        chart.resize(1600, 900);
        chart.setStore(&store);
        chart.setChannels(channels);
        chart.setMarks(&marks);
        chart.show();
        plot = chart.findChild<QGraphicsView*>(QStringLiteral("trendPlot"));
        if (!QTest::qWaitForWindowExposed(&chart) || plot == nullptr)
            qFatal("no window");
        chart.advance(now);
        chart.setCursors(now - 7s, now - 3s);
    }

    void grow(base::Duration by)
    {
        for (base::Duration at = now; at < now + by; at += period) {
            for (int i = 0; i < channelCount; ++i)
                store.append(channels[std::size_t(i)].id, at, sampleOf(i, at));
        }
        now += by;
    }

    /// The time until all is painted, without the wait for the next frame's turn. The bare loop
    /// has turns between the frames, so that both find the processor and its caches alike.
    void measure(const char* what, double maxMs, double maxRatio,
                 const std::function<void(int)>& step)
    {
        if (!QByteArray(what).contains(only))
            return;
        std::vector<double> times;
        std::vector<double> cpu;
        for (int i = -10; i < frames; ++i) {
            const auto start = Clock::now();
            const double spent = cpuMs();
            step(i);
            const auto painted = Clock::now();
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            const double took = since(start);
            if (i >= 0) {
                times.push_back(took);
                cpu.push_back(cpuMs() - spent);
            }
            std::this_thread::sleep_until(painted + frameTime);
            if (i % 4 == 0) {
                bareLoop.paint();
                std::this_thread::sleep_for(frameTime);
            }
            grow(35ms);
        }
        report(what, times, cpu, maxMs);
        const double bare = bareLoop.takeMedian();
        out << "    " << part(times, 50) / bare << " times the bare loop, p50 " << bare
            << " ms (wanted <= " << maxRatio << ")\n";
        out.flush();
    }

    /// What comes when the hand rests: the parts of the fine picture and its frame, the longest
    /// turn of the event loop of each.
    void measureRest(double maxMs)
    {
        if (!QByteArray("fine picture").contains(only))
            return;
        std::vector<double> times;
        std::vector<double> cpu;
        for (int i = 0; i < 24; ++i) {
            wheel(i % 2 == 0 ? 120 : -120);
            QCoreApplication::processEvents();
            double longest = 0;
            double slowestMs = 0;
            for (const auto until = Clock::now() + 300ms; Clock::now() < until;) {
                const auto start = Clock::now();
                const double spent = cpuMs();
                QCoreApplication::processEvents();
                longest = std::max(longest, since(start));
                slowestMs = std::max(slowestMs, cpuMs() - spent);
                std::this_thread::sleep_for(1ms);
            }
            times.push_back(longest);
            cpu.push_back(slowestMs);
        }
        report("the fine picture after zooming 60 min", times, cpu, maxMs);
    }

    void wheel(int delta)
    {
        const QPointF place(plot->width() / 2.0, plot->height() / 2.0);
        QWheelEvent event(place, plot->viewport()->mapToGlobal(place), {}, {0, delta}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot->viewport(), &event);
    }

    void drag(int step)
    {
        const QPoint from(800, 450);
        if (step == -10)
            QTest::mousePress(plot->viewport(), Qt::MiddleButton, Qt::NoModifier, from);
        QMouseEvent move(QEvent::MouseMove, from + QPoint((step + 10) * 2, 0),
                         plot->viewport()->mapToGlobal(QPointF(from)), Qt::NoButton,
                         Qt::MiddleButton, Qt::NoModifier);
        QCoreApplication::sendEvent(plot->viewport(), &move);
        if (step == frames - 1)
            QTest::mouseRelease(plot->viewport(), Qt::MiddleButton, Qt::NoModifier, from);
    }

    recording::SampleStore store{std::size_t(384) << 20};
    std::vector<ui::TrendChannel> channels;
    std::vector<recording::Mark> marks;
    base::Duration now{};
    ui::TrendChart chart;
    BareLoop bareLoop{chart.devicePixelRatioF()};
    QGraphicsView* plot = nullptr;
};

void benchmarkAll(double maxMs)
{
    Fixture fixture;
    ui::TrendChart& chart = fixture.chart;
    const auto follow = [&](int) { chart.advance(fixture.now); };
    fixture.measure("following 10 s", maxMs, 1.3, follow);
    chart.setWidth(10min);
    fixture.measure("following 10 min", maxMs, 1.3, follow);
    chart.setWidth(length);
    fixture.measure("following 60 min", maxMs, 1.3, follow);
    chart.show({30min, 30min + 10s});
    fixture.measure("panning 10 s with the mouse", maxMs, 2, [&](int i) { fixture.drag(i); });
    chart.show({20min, 40min});
    fixture.measure("panning 20 min with the mouse", maxMs, 2, [&](int i) { fixture.drag(i); });
    chart.setLanes(true);
    fixture.measure("panning 20 min in lanes", maxMs, 2, [&](int i) { fixture.drag(i); });
    chart.setFollowing(true);
    fixture.measure("following 20 min in lanes", maxMs, 1.3, follow);
    chart.setLanes(false);
    chart.show({0min, length});
    fixture.measure("zooming with the wheel, 60 min to 50 ms and back", maxMs, 2,
                    [&](int i) { fixture.wheel((i + 10) % 100 < 50 ? 120 : -120); });
    chart.show({0min, length});
    fixture.measureRest(16);
}
} // namespace

int main(int argc, char* argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const bool child = argc > 1 && qstrcmp(argv[1], "--child") == 0;
    only = argc > 1 && !child ? argv[1] : argc > 2 ? argv[2] : "";
    QApplication app(argc, argv);
    ui::ThemeSwitch theme;
    theme.apply(session::Theme::Light);
    const double ratio = qApp->devicePixelRatio();
    out << "1600x900 at " << ratio * 100 << " %\n";
    out.flush();
    benchmarkAll(ratio > 1 ? 16 : 8);
    if (child)
        return 0;
    QProcess large;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
    large.setProcessEnvironment(environment);
    large.setProcessChannelMode(QProcess::ForwardedChannels);
    large.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("--child"), QString::fromUtf8(only)});
    return large.waitForFinished(600000) ? large.exitCode() : 1;
}
