// SPDX-License-Identifier: GPL-3.0-or-later
// The window is closed, or the cable pulled, during a long operation: a sweep test, a step
// response, a restore, a recording, commissioning. Another program on the same terminal then reads
// the state of the servo; the journal shows whether anything is open. A second window on a port
// that is in use names the program that uses it and writes nothing.
#include "gui/main_window_fixture.h"
#include "session/commission/commissioning.h"
#include "session/recording/live_data.h"
#include "session/step/step_test.h"
#include "session/sweep/sweep_test.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/deep_check.h"
#include "support/test_main.h"
#include "ui/charts/trend_chart.h"
#include "ui/commissioning/commission_page.h"
#include "ui/step/step_page.h"
#include "ui/widgets/banner.h"

#include <QCheckBox>
#include <QComboBox>
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
constexpr int factoryId = 1;
constexpr int newId = 7; ///< given by commissioning

struct WindowCloseFixture : gui::MainWindowFixture {
    WindowCloseFixture()
        : simulator(support::words("--servos sts3215@1 --baud 1000000 --latency-ms 10"))
        , cable(std::make_unique<support::CutCable>(simulator.port(), false))
    {
        settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
    }
    /// `cutAt`: the cable is cut before the frame with this number among those that change
    /// something; 0: it is not cut.
    bool begins(const QString& what, int cutAt = 0)
    {
        page = what == QLatin1String("recording")        ? QStringLiteral("operate")
               : what == QLatin1String("restore")        ? QStringLiteral("snapshots")
               : what.startsWith(QLatin1String("sweep")) ? QStringLiteral("sweep")
                                                         : what;
        if (!connectTo(cable->port()))
            return false;
        // On a busy machine its answer may come later than a search waits.
        for (int tries = 0; tries < 5 && workbench().registry().order().empty(); ++tries) {
            workbench().search().start({.firstId = factoryId, .lastId = factoryId, .bauds = {}});
            if (!waitUntilIdle())
                return false;
        }
        if (!choose(factoryId))
            return false;
        if (what.startsWith(QLatin1String("sweep")))
            return sweep(what == QLatin1String("sweep, released"));
        if (what == QLatin1String("step"))
            return step();
        if (what == QLatin1String("commission"))
            return commission(cutAt);
        return what == QLatin1String("restore") ? restore(cutAt) : record();
    }
    session::Commissioning& line() { return workbench().commissioning(); }
    QString bannerText()
    {
        QString all;
        for (const QLabel* label : find<ui::Banner>("banner")->findChildren<QLabel*>())
            all += label->text() + QLatin1Char('\n');
        return all;
    }
    /// A running test needs a question first; what the question promises is done.
    bool closed()
    {
        window->close();
        const auto answered = [this] {
            auto* yes = find<QPushButton>("questionYes");
            if (yes != nullptr && yes->isVisible()) {
                for (const QLabel* label : yes->window()->findChildren<QLabel*>())
                    question += label->text() + QLatin1Char('\n');
                QTest::mouseClick(yes, Qt::LeftButton);
            }
            return !window->isVisible();
        };
        return support::waitFor(answered);
    }
    /// Registers by name, read by another program after this one has closed the port; empty: no
    /// servo answers under this ID.
    QJsonObject registers(const char* keys, int id = factoryId)
    {
        cable.reset();
        CliProgram other;
        other.setPort(simulator.port());
        const support::ProgramResult result = other.json(
            qPrintable(QStringLiteral("read %1 %2 --retries 5").arg(id).arg(QLatin1String(keys))));
        QJsonObject values;
        for (const QJsonValue& one : result.json()[QStringLiteral("registers")].toArray())
            values[one[QStringLiteral("key")].toString()] = one[QStringLiteral("raw")];
        return values;
    }
    int raw(const char* key) { return registers(key)[QLatin1String(key)].toInt(-1); }

    QString question;
    SimProgram simulator;
    std::unique_ptr<support::CutCable> cable; ///< goes before the simulator

private:
    bool press(const char* name)
    {
        auto* button = find<QPushButton>(name);
        if (button == nullptr || !support::waitFor([&] { return button->isEnabled(); }))
            return false;
        QTest::mouseClick(button, Qt::LeftButton);
        if (auto* yes = find<QPushButton>("questionYes"))
            QTest::mouseClick(yes, Qt::LeftButton);
        return true;
    }
    bool sweep(bool released)
    {
        find<QSpinBox>("sweepCycles")->setValue(500);
        find<QComboBox>("sweepAfterwards")->setCurrentIndex(released ? 1 : 0);
        return press("sweepRun") && support::waitFor([this] {
                   const results::SweepRun* run = context.workbench.sweepTest().run();
                   return run != nullptr && !run->servos[0].legs.empty();
               });
    }
    bool step()
    {
        find<QSpinBox>("stepRepeats")->setValue(20);
        return press("stepRun") && support::waitFor([this] {
                   return !find<ui::StepPage>("stepPage")->test().liveResponses().empty();
               });
    }
    bool restore(int cutAt)
    {
        auto* snapshotTree = find<QTreeWidget>("shelfTree");
        const int before = snapshotTree->topLevelItemCount();
        if (!press("snapshotTake") ||
            !support::waitFor([&] { return snapshotTree->topLevelItemCount() > before; }))
            return false;
        workbench().writes().write(selection().current(),
                                   {{{QStringLiteral("position_p"), 50},
                                     {QStringLiteral("position_d"), 50},
                                     {QStringLiteral("min_angle_limit"), 100},
                                     {QStringLiteral("max_angle_limit"), 3000}}});
        snapshotTree->setCurrentItem(
            snapshotTree->topLevelItem(snapshotTree->topLevelItemCount() - 1));
        if (!waitUntilIdle())
            return false;
        if (cutAt > 0)
            cable->cutAtWrite(cutAt);
        return press("restoreWrite") && workbench().tasks().isBusy();
    }
    bool commission(int cutAt)
    {
        find<QLineEdit>("commissionBatch")->setText(m_files.filePath(QStringLiteral("b.csv")));
        find<QSpinBox>("commissionFirstId")->setValue(newId);
        auto* go = find<QPushButton>("commissionContinue");
        if (!press("commissionStart") || !support::waitFor([&] { return go->isVisible(); }))
            return false;
        if (cutAt > 0)
            cable->cutAtWrite(cutAt);
        const int before = cable->writes();
        QTest::mouseClick(go, Qt::LeftButton);
        return support::waitFor([&] { return cable->writes() > before; });
    }
    bool record()
    {
        const auto hasCurves = [this] {
            const auto& channels =
                find<QWidget>("trendPanel")->findChild<ui::TrendChart*>()->channels();
            return std::any_of(channels.begin(), channels.end(),
                               [](const auto& one) { return one.visible && one.id >= 0; });
        };
        if (!support::waitFor(hasCurves))
            return false;
        action(ui::Command::Record)->trigger();
        auto* path = find<QLineEdit>("recordPath");
        if (path == nullptr)
            return false;
        path->setText(file());
        return press("recordStart") && support::waitFor([this] {
                   return context.workbench.liveData().recording().status().rows > 20;
               });
    }

public:
    QString file() const { return m_files.filePath(QStringLiteral("readings.csv")); }

private:
    QTemporaryDir m_files;
};

bool hasOpen(qint64 program, const QString& port)
{
    const QDir open(QStringLiteral("/proc/%1/fd").arg(program));
    const QFileInfoList files = open.entryInfoList(QDir::Files | QDir::System);
    return std::any_of(files.begin(), files.end(),
                       [&](const QFileInfo& one) { return one.symLinkTarget() == port; });
}

void addOperations(std::initializer_list<const char*> operations)
{
    QTest::addColumn<QString>("what");
    for (const char* what : operations)
        QTest::newRow(what) << QString::fromLatin1(what);
}
} // namespace

class TestWindowClose : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void closingEndsSafely_data()
    {
        addOperations({"sweep", "sweep, released", "step", "restore", "recording", "commission"});
    }
    void closingEndsSafely()
    {
        QFETCH(QString, what);
        WindowCloseFixture fixture;
        QVERIFY(fixture.begins(what));
        QVERIFY(fixture.closed());
        const auto* const keys = "lock torque_switch present_position position_p";
        int id = factoryId;
        QJsonObject first = fixture.registers(keys, id);
        if (first.isEmpty())
            first = fixture.registers(keys, id = newId);
        QCOMPARE(first[QLatin1String("lock")].toInt(), 1);
        const auto open = fixture.session.journal().open();
        QVERIFY(open && open->empty());
        const auto place = [](const QJsonObject& values) {
            return values[QLatin1String("present_position")].toInt(-1);
        };
        const QJsonObject second = fixture.registers("present_position", id);
        QVERIFY2(
            place(second) >= 0 && std::abs(place(second) - place(first)) <= 2,
            qPrintable(
                QStringLiteral("it goes on, from %1 to %2").arg(place(first)).arg(place(second))));
        const bool holds = what == QLatin1String("sweep") || what == QLatin1String("step");
        QCOMPARE(first[QLatin1String("torque_switch")].toInt(-1), holds ? 1 : 0);
        // Torque was off before, and the question said what happens to it.
        const bool tests = holds || what.startsWith(QLatin1String("sweep"));
        QCOMPARE(fixture.question.contains(QLatin1String("hold their position with torque on")),
                 holds);
        QCOMPARE(fixture.question.contains(QLatin1String("Torque will then be turned off")),
                 tests && !holds);
        if (what == QLatin1String("commission")) { // it had begun, and the batch knows it
            QCOMPARE(fixture.line().batch().rows.size() + fixture.line().batch().pending.size(),
                     std::size_t(1));
            QVERIFY(id == newId || fixture.line().batch().rows.empty());
        }
        if (what == QLatin1String("restore"))
            QCOMPARE(first[QLatin1String("position_p")].toInt(), 32);
        if (what == QLatin1String("recording")) {
            QFile file(fixture.file());
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY(file.readAll().endsWith('\n')); // to the last reading
        }
    }

    /// The second frame that changes something is cut off: the lock is open by then, the row or the
    /// ID not written.
    void anInterruptedChangeStaysOpen_data()
    {
        QTest::addColumn<QString>("what");
        QTest::newRow("restore") << QStringLiteral("restore");
        QTest::newRow("commission") << QStringLiteral("commission");
    }
    void anInterruptedChangeStaysOpen()
    {
        QFETCH(QString, what);
        WindowCloseFixture fixture;
        QVERIFY(fixture.begins(what, 2));
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Lost);
        QTRY_VERIFY(fixture.find<ui::Banner>("banner")->isVisible());
        QTRY_VERIFY(!fixture.workbench().tasks().isBusy());
        const auto open = fixture.session.journal().open();
        QVERIFY(open);
        QCOMPARE(open->size(), std::size_t(1));
        QCOMPARE(open->front().servo.id, factoryId);
        if (what == QLatin1String("commission")) {
            QCOMPARE(fixture.line().batch().pending.size(), std::size_t(1));
            QTRY_VERIFY(fixture.find<QLabel>("commissionDetail")
                            ->text()
                            .contains(QLatin1String("Unfinished")));
        }
        QVERIFY(fixture.closed());
        QVERIFY(fixture.question.contains(QLatin1String("is recorded in the journal")));
        QCOMPARE(fixture.raw("lock"), 0);
        QVERIFY2(what != QLatin1String("commission") ||
                     fixture.question.contains(QLatin1String("EPROM of the servo")),
                 qPrintable(fixture.question));
    }

    void unpluggingIsReportedAndTheWindowStays_data()
    {
        addOperations({"sweep", "restore", "recording", "commission"});
        if (support::isDeepCheck()) {
            QTest::newRow("sweep, released") << QStringLiteral("sweep, released");
            QTest::newRow("step") << QStringLiteral("step");
        }
    }
    void unpluggingIsReportedAndTheWindowStays()
    {
        QFETCH(QString, what);
        WindowCloseFixture fixture;
        QVERIFY(fixture.begins(what, 1)); // what writes is cut off at the first frame that does
        if (what != QLatin1String("restore"))
            fixture.cable->cut();
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Lost);
        QTRY_VERIFY(fixture.find<ui::Banner>("banner")->isVisible());
        QTRY_VERIFY(!fixture.workbench().tasks().isBusy());
        if (what.startsWith(QLatin1String("sweep"))) {
            QTRY_VERIFY(!fixture.context.workbench.sweepTest().isRunning());
            QCOMPARE(results::sweepEndName(fixture.context.workbench.sweepTest().run()->end),
                     results::sweepEndName(results::SweepEnd::LinkLost));
            QCOMPARE(fixture.context.workbench.sweepTest().run()->verdict(),
                     results::Grade::NotMeasured);
        }
        if (what == QLatin1String("restore")) {
            // What is unfinished stays in the journal; what has ended was not sent, row by row.
            const auto all = fixture.session.journal().entries();
            QVERIFY(all && !all->empty());
            if (const auto& end = all->back().end) {
                QCOMPARE(end->outcome, QStringLiteral("failed"));
                QVERIFY(!end->items.empty());
                for (const base::ItemResult& item : end->items)
                    QCOMPARE(item.outcome, QStringLiteral("not-sent"));
            }
        }
        QVERIFY(fixture.window->isVisible());
        QVERIFY(fixture.closed());
    }

    void aSecondWindowShowsWhoHoldsThePort_data()
    {
        QTest::addColumn<QString>("program");
        QTest::newRow("command line") << QStringLiteral("servodesk-cli");
        QTest::newRow("window") << QStringLiteral("servodesk");
    }
    void aSecondWindowShowsWhoHoldsThePort()
    {
        QFETCH(QString, program);
        WindowCloseFixture fixture;
        const QString port = fixture.simulator.port();
        fixture.cable.reset();
        const QTemporaryDir data;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("SERVODESK_DATA_DIR"), data.path());
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        QProcess first;
        first.setProcessEnvironment(environment);
        first.start(QCoreApplication::applicationDirPath() + QStringLiteral("/../bin/") + program,
                    program == QLatin1String("servodesk")
                        ? QStringList{QStringLiteral("--port"), port}
                        : QStringList{QStringLiteral("--port"), port, QStringLiteral("watch"),
                                      QStringLiteral("1")});
        QVERIFY(first.waitForStarted());
        QTRY_VERIFY(hasOpen(first.processId(), port));
        fixture.window->start({.port = session::PortRequest{.name = port}, .page = fixture.page});
        QTRY_VERIFY(fixture.find<ui::Banner>("banner")->isVisible());
        const QString words = fixture.bannerText();
        QVERIFY2(words.contains(program), qPrintable(words));
        QVERIFY2(words.contains(QString::number(first.processId())), qPrintable(words));
        QVERIFY(fixture.workbench().link().state() != session::LinkState::Open);
        QCOMPARE(first.state(), QProcess::Running); // it was not disturbed
        first.kill();
        QVERIFY(first.waitForFinished());
    }
};

SERVODESK_TEST(TestWindowClose)
#include "tst_window_close.moc"
