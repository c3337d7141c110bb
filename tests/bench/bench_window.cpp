// SPDX-License-Identifier: GPL-3.0-or-later
// How quick the window is, without a screen: from the start of the program to a window that has
// been painted (beside a start that opens none); from a click on a servo to its whole table, beside
// the time its bytes need on the paced 1 Mbaud wire; the longest time the main thread was busy
// while a dead port is searched, a servo polled as fast as the wire allows and a register edited;
// memory after that. Wanted: 250 ms, 100 ms, p99 16 ms, 150 MB.
#include "gui/window_bench.h"

#include <QProcess>
#include <QTextStream>

#include <algorithm>

using namespace std::chrono_literals;

namespace {
QTextStream out(stdout);

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

double runProgram(const QStringList& arguments)
{
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    const auto start = Clock::now();
    program.start(QStringLiteral(BIN_DIR "/servodesk"), arguments);
    if (!program.waitForFinished() || program.exitCode() != 0)
        qFatal("servodesk did not run");
    return since(start);
}

void benchStart()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    std::vector<double> bare;
    std::vector<double> whole;
    runProgram({QStringLiteral("--version")});
    for (int i = 0; i < 7; ++i) {
        bare.push_back(runProgram({QStringLiteral("--version")}));
        whole.push_back(runProgram({QStringLiteral("--screenshot"), file, QStringLiteral("--after"),
                                    QStringLiteral("0")}));
    }
    out << "start, painted, written to a PNG and ended: " << median(whole)
        << " ms (wanted <= 250); without window: " << median(bare) << " ms\n";
}

void benchTable()
{
    gui::WindowBench bench;
    if (!bench.connectTo(QStringLiteral("sim:demo")))
        qFatal("no simulated bus");
    std::vector<double> times;
    for (const session::ServoRef ref : bench.desk().servos()) {
        bench.settled();
        const auto start = Clock::now();
        bench.selection().select(ref);
        QEventLoop loop;
        QObject::connect(&bench.desk(), &session::Desk::tableChanged, &loop, [&] {
            if (bench.desk().servo(ref)->tableRead)
                loop.quit();
        });
        loop.exec();
        bench.window->repaint();
        times.push_back(since(start));
    }
    out << "click to whole table, six servos: median " << median(times) << " ms, worst "
        << *std::max_element(times.begin(), times.end()) << " ms (wanted <= 100)\n";
}

/// An event loop as the program has it; QTest::qWait sleeps in between.
void letRun(int ms)
{
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Notes how late each tick of a busy timer comes.
class Probe : public QObject {
public:
    Probe()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(1ms);
        connect(&m_timer, &QTimer::timeout, this, [this] {
            m_gaps.push_back(since(m_last));
            m_last = Clock::now();
        });
        m_last = Clock::now();
        m_timer.start();
    }
    void report(const char* what)
    {
        m_timer.stop();
        std::sort(m_gaps.begin(), m_gaps.end());
        out << what << ": main thread busy p50 " << m_gaps[m_gaps.size() / 2] << " ms, p99 "
            << m_gaps[m_gaps.size() * 99 / 100] << " ms, longest " << m_gaps.back()
            << " ms (wanted p99 <= 16)\n";
    }

private:
    QTimer m_timer;
    Clock::time_point m_last;
    std::vector<double> m_gaps;
};

void benchDeadPort()
{
    gui::WindowBench bench;
    bench.window->start({.port = session::PortRequest{.name = QStringLiteral("sim:sts3215@1")}});
    if (!QTest::qWaitFor([&] { return bench.desk().state() == session::LinkState::Open; }))
        qFatal("no simulated bus");
    Probe probe;
    jobs::ScanSpec all;
    all.firstId = 100;
    all.bauds = {1'000'000, 500'000, 115'200};
    bench.settled();
    bench.desk().search(all);
    letRun(5000);
    bench.desk().stopSearch();
    bench.settled();
    probe.report("searching where nobody is");
}

double residentMb()
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : status.readAll().split('\n')) {
        if (line.startsWith("VmRSS:"))
            return line.mid(6).simplified().split(' ').front().toDouble() / 1024;
    }
    return 0;
}

void benchLive()
{
    gui::WindowBench bench;
    if (!bench.ready(1))
        qFatal("no simulated bus");
    const session::ServoRef ref = bench.selection().current();
    QStringList keys;
    for (const catalog::Register& reg : bench.entry().servo.profile->registers)
        keys << reg.key;
    bench.desk().wish(QStringLiteral("bench"), {{{ref, keys}}, {}});
    letRun(500);
    const double before = residentMb();
    Probe probe;
    for (int i = 0; i < 60; ++i) {
        bench.desk().write(ref, {{{QStringLiteral("position_p"), 30 + i % 10}}, true, false});
        letRun(100);
    }
    probe.report("polling the whole table at full speed, a write every 100 ms");
    out << "memory: " << residentMb() << " MB, grown by " << residentMb() - before
        << " MB in 6 s of polling at full speed (wanted <= 150 MB)\n";
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
    benchStart();
    benchTable();
    benchDeadPort();
    benchLive();
    return 0;
}
