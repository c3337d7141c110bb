// SPDX-License-Identifier: GPL-3.0-or-later
// How quick the window is, without a screen: from the start of the program to a window that has
// been painted, beside a bare Qt window of that size and a start that opens none; from a click on a
// servo to its whole table, beside the time its bytes need on the paced 1 Mbaud wire; the longest
// time the main thread was busy while a dead port is searched, a servo polled as fast as the wire
// allows and a register edited; memory after that. Wanted: 250 ms and three times the bare window,
// 100 ms, p99 16 ms, 150 MB.
#include "bench/stall_probe.h"
#include "gui/main_window_fixture.h"
#include "support/test_paths.h"

#include <QProcess>
#include <QTextStream>

#include <algorithm>

using namespace std::chrono_literals;

using namespace bench;

namespace {
QTextStream out(stdout);

const QString bareWindow = QStringLiteral("--bare-window");

/// The least a program with a window of that size does: painted, written to a file and ended.
int showBareWindow(const QString& file)
{
    QWidget window;
    window.resize(1280, 800);
    window.show();
    QCoreApplication::processEvents();
    return window.grab().save(file) ? 0 : 1;
}

double runProgram(const QString& path, const QStringList& arguments)
{
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    const auto start = Clock::now();
    program.start(path, arguments);
    if (!program.waitForFinished() || program.exitCode() != 0)
        qFatal("the program did not run");
    return since(start);
}

void benchmarkStart()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.bmp"));
    const QString servodesk = QStringLiteral(BIN_DIR "/servodesk");
    const QStringList version{QStringLiteral("--version")};
    std::vector<double> without;
    std::vector<double> bare;
    std::vector<double> whole;
    runProgram(servodesk, version);
    for (int i = 0; i < 7; ++i) {
        without.push_back(runProgram(servodesk, version));
        bare.push_back(runProgram(QCoreApplication::applicationFilePath(), {bareWindow, file}));
        whole.push_back(runProgram(servodesk, {QStringLiteral("--size"), QStringLiteral("1280x800"),
                                               QStringLiteral("--screenshot"), file,
                                               QStringLiteral("--after"), QStringLiteral("0")}));
    }
    out << "start, painted, written to a file and ended: " << median(whole)
        << " ms (wanted <= 250), " << median(whole) / median(bare)
        << " times a bare window (wanted <= 3); without window: " << median(without) << " ms\n";
}

void benchmarkTable()
{
    gui::MainWindowFixture bench;
    if (!bench.connectTo(QStringLiteral("sim:demo")))
        qFatal("no simulated bus");
    std::vector<double> times;
    for (const session::ServoRef ref : bench.workbench().registry().order()) {
        bench.waitUntilIdle();
        const auto start = Clock::now();
        bench.selection().select(ref);
        QEventLoop loop;
        QObject::connect(&bench.workbench().registry(), &session::ServoRegistry::tableChanged,
                         &loop, [&] {
                             if (bench.workbench().registry().servo(ref)->hasFullTable)
                                 loop.quit();
                         });
        loop.exec();
        bench.window->repaint();
        times.push_back(since(start));
    }
    out << "click to whole table, six servos: median " << median(times) << " ms, worst "
        << *std::max_element(times.begin(), times.end()) << " ms (wanted <= 100)\n";
}

void benchmarkUnavailablePort()
{
    gui::MainWindowFixture bench;
    bench.window->start({.port = session::PortRequest{.name = QStringLiteral("sim:sts3215@1")}});
    if (!QTest::qWaitFor(
            [&] { return bench.workbench().link().state() == session::LinkState::Open; }))
        qFatal("no simulated bus");
    StallProbe probe;
    jobs::ScanSpec all;
    all.firstId = 100;
    all.bauds = {1'000'000, 500'000, 115'200};
    bench.waitUntilIdle();
    bench.workbench().search().start(all);
    runEventLoop(5000);
    bench.workbench().search().stop();
    bench.waitUntilIdle();
    probe.report(out, "searching where nobody is");
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

void benchmarkLive()
{
    gui::MainWindowFixture bench;
    if (!bench.ready(1))
        qFatal("no simulated bus");
    const session::ServoRef ref = bench.selection().current();
    QStringList keys;
    for (const catalog::Register& reg : bench.entry().servo.profile->registers)
        keys << reg.key;
    bench.workbench().polling().subscribe(QStringLiteral("bench"), {{{ref, keys}}, {}});
    runEventLoop(500);
    const double before = residentMb();
    StallProbe probe;
    for (int i = 0; i < 60; ++i) {
        bench.workbench().writes().write(ref,
                                         {{{QStringLiteral("position_p"), 30 + i % 10}}, true, {}});
        runEventLoop(100);
    }
    probe.report(out, "polling the whole table at full speed, a write every 100 ms");
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
    if (argc == 3 && QString::fromLocal8Bit(argv[1]) == bareWindow)
        return showBareWindow(QString::fromLocal8Bit(argv[2]));
    benchmarkStart();
    benchmarkTable();
    benchmarkUnavailablePort();
    benchmarkLive();
    return 0;
}
