// SPDX-License-Identifier: GPL-3.0-or-later
// The window is closed, or the cable pulled, in the middle of what lasts: a sweep test, a step
// response, a restore, a recording. Another program on the same terminal then says what the servo
// was left as; the journal says whether anything is open. A second window on a port that is taken
// says who holds it and writes nothing.
#include "gui/window_bench.h"
#include "session/step_test.h"
#include "support/cli_program.h"
#include "ui/pages/step_page.h"
#include "ui/widgets/banner.h"

#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>

#include <csignal>

using support::CliProgram;
using support::SimProgram;

namespace {
constexpr int longTime = 60'000;

struct Bench : gui::WindowBench {
    Bench()
        : simulator(support::words("--servos sts3215@1 --baud 1000000 --latency-ms 10"))
    {
        settings.setChoice(QStringLiteral("operate/no_torque_hint"), true);
    }
    bool begins(const QString& what)
    {
        page = what == QLatin1String("recording") ? QStringLiteral("operate")
               : what == QLatin1String("restore") ? QStringLiteral("snapshots")
                                                  : what;
        if (!ready(1, simulator.port()))
            return false;
        if (what == QLatin1String("sweep"))
            return sweep();
        if (what == QLatin1String("step"))
            return step();
        return what == QLatin1String("restore") ? restore() : record();
    }
    bool over(const QString& what)
    {
        return what == QLatin1String("sweep") ? !bench.sweep.running() : !desk().busy();
    }
    bool closed()
    {
        window->close();
        return QTest::qWaitFor([this] { return !window->isVisible(); }, longTime);
    }
    /// Of the servo, asked by another program after this one has let go of the port.
    int raw(const char* key)
    {
        CliProgram other;
        other.setPort(simulator.port());
        const support::Ran ran =
            other.json(qPrintable(QStringLiteral("read 1 %1").arg(QLatin1String(key))));
        return ran.json()[QStringLiteral("registers")].toArray()[0][QStringLiteral("raw")].toInt(
            -1);
    }

    SimProgram simulator;

private:
    bool press(const char* name)
    {
        auto* button = find<QPushButton>(name);
        if (button == nullptr || !QTest::qWaitFor([&] { return button->isEnabled(); }, 20'000))
            return false;
        QTest::mouseClick(button, Qt::LeftButton);
        if (auto* yes = find<QPushButton>("questionYes"))
            QTest::mouseClick(yes, Qt::LeftButton);
        return true;
    }
    bool sweep()
    {
        find<QSpinBox>("sweepCycles")->setValue(500);
        return press("sweepRun") && QTest::qWaitFor(
                                        [this] {
                                            const record::SweepRun* run = bench.sweep.run();
                                            return run != nullptr && !run->servos[0].legs.empty();
                                        },
                                        longTime);
    }
    bool step()
    {
        find<QSpinBox>("stepRepeats")->setValue(20);
        return press("stepRun") && QTest::qWaitFor([this] { return desk().testing(); }, longTime);
    }
    bool restore()
    {
        auto* shelf = find<QTreeWidget>("shelfTree");
        const int before = shelf->topLevelItemCount();
        if (!press("snapshotTake") ||
            !QTest::qWaitFor([&] { return shelf->topLevelItemCount() > before; }, longTime))
            return false;
        desk().write(selection().current(), {{{QStringLiteral("position_p"), 50},
                                              {QStringLiteral("position_d"), 50},
                                              {QStringLiteral("min_angle_limit"), 100},
                                              {QStringLiteral("max_angle_limit"), 3000}}});
        shelf->setCurrentItem(shelf->topLevelItem(shelf->topLevelItemCount() - 1));
        if (!settled() || !press("restoreWrite"))
            return false;
        return QTest::qWaitFor(
            [this] {
                const auto open = session.journal().open();
                return open && !open->empty();
            },
            longTime);
    }
    bool record()
    {
        const auto feeds = [this] { return desk().rate(selection().current()).lastAt.has_value(); };
        if (!QTest::qWaitFor(feeds, longTime))
            return false;
        QTest::qWait(0); // the chart has taken its curves
        action(ui::Command::Record)->trigger();
        auto* path = find<QLineEdit>("recordPath");
        if (path == nullptr)
            return false;
        path->setText(file());
        return press("recordStart") &&
               QTest::qWaitFor([this] { return bench.scope.recordingStatus().rows > 20; },
                               longTime);
    }

public:
    QString file() const { return m_files.filePath(QStringLiteral("readings.csv")); }

private:
    QTemporaryDir m_files;
};

void whatLasts()
{
    QTest::addColumn<QString>("what");
    for (const char* what : {"sweep", "step", "restore", "recording"})
        QTest::newRow(what) << QString::fromLatin1(what);
}
} // namespace

class TestWindowCloses : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void closingEndsSafely_data() { whatLasts(); }
    void closingEndsSafely()
    {
        QFETCH(QString, what);
        Bench bench;
        QVERIFY(bench.begins(what));
        QVERIFY(bench.closed());
        QCOMPARE(bench.raw("lock"), 1);
        const auto open = bench.session.journal().open();
        QVERIFY(open && open->empty());
        const int place = bench.raw("present_position");
        QVERIFY(std::abs(bench.raw("present_position") - place) <= 2); // it does not go on
        if (what == QLatin1String("restore"))
            QCOMPARE(bench.raw("position_p"), 32);
        if (what == QLatin1String("recording")) {
            QFile file(bench.file());
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY(file.readAll().endsWith('\n')); // to the last reading
        }
    }

    void unpluggingIsSaidAndTheWindowStays_data() { whatLasts(); }
    void unpluggingIsSaidAndTheWindowStays()
    {
        QFETCH(QString, what);
        Bench bench;
        QVERIFY(bench.begins(what));
        bench.simulator.end();
        if (what != QLatin1String("sweep") && what != QLatin1String("step")) {
            QTRY_COMPARE_WITH_TIMEOUT(bench.desk().state(), session::LinkState::Lost, longTime);
            QTRY_VERIFY(bench.find<ui::Banner>("banner")->isVisible());
        }
        if (what == QLatin1String("restore")) {
            // What is unfinished stays in the journal; what has ended was not sent, row by row.
            QTRY_VERIFY(!bench.entry().writing());
            const auto all = bench.session.journal().entries();
            QVERIFY(all && !all->empty());
            if (const auto& end = all->back().end) {
                QCOMPARE(end->outcome, QStringLiteral("failed"));
                QVERIFY(!end->items.empty());
                for (const base::ItemEnd& item : end->items)
                    QCOMPARE(item.outcome, QStringLiteral("not-sent"));
            }
        }
        QVERIFY(bench.closed());
    }

    void aSecondWindowOnThePortSaysWhoHoldsIt()
    {
        SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
        CliProgram first;
        first.setPort(simulator.port());
        first.start(support::words("watch 1"));
        QVERIFY(first.waitForOutput("1"));
        gui::WindowBench bench;
        bench.window->start(
            {.port = session::PortRequest{.name = simulator.port()}, .page = bench.page});
        auto* banner = bench.find<ui::Banner>("banner");
        QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), longTime);
        QString all;
        for (const QLabel* label : banner->findChildren<QLabel*>())
            all += label->text() + QLatin1Char('\n');
        QVERIFY2(all.contains(QLatin1String("servodesk-cli")), qPrintable(all));
        QVERIFY(bench.desk().state() != session::LinkState::Open);
        first.signal(SIGINT);
        (void)first.finish();
    }
};

QTEST_MAIN(TestWindowCloses)
#include "tst_window_closes.moc"
