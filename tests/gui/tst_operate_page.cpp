// SPDX-License-Identifier: GPL-3.0-or-later
// The operate page on the simulated bus: opening it and selecting move nothing, what is read shows
// on dial, gauges, lights, strip and chart, alarms stay until they are acknowledged, recordings are
// made and shown again.
#include "gui/window_bench.h"
#include "sim/sim_link.h"
#include "ui/charts/trend_chart.h"
#include "ui/pages/trend_panel.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/position_dial.h"
#include "ui/widgets/servo_card.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeWidget>

namespace {
struct OperateBench : gui::WindowBench {
    explicit OperateBench(const QString& language = QStringLiteral("en"))
        : WindowBench(language)
    {
        page = QStringLiteral("operate");
    }
    template <typename Function>
    void withWire(Function&& function)
    {
        desk().connection()->simulation()->with(std::forward<Function>(function));
    }
    ui::Gauge* gauge(int index)
    {
        return window->findChild<ui::Gauge*>(QStringLiteral("gauge%1").arg(index));
    }
    QStringList alarmWords()
    {
        QStringList words;
        for (const ui::Pill* pill :
             window->findChildren<ui::Pill*>(QStringLiteral("statusAlarm"))) {
            if (pill->isVisible())
                words << pill->accessibleName();
        }
        return words;
    }
    void click(const char* name)
    {
        auto* button = find<QAbstractButton>(name);
        QVERIFY(button != nullptr);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    const ui::TrendChannel* curve(const QString& key)
    {
        for (const ui::TrendChannel& channel : find<ui::TrendChart>("trendChart")->channels()) {
            if (channel.key == key)
                return &channel;
        }
        return nullptr;
    }
    bool drawn(const QString& key)
    {
        const ui::TrendChannel* found = curve(key);
        return found != nullptr && found->id >= 0;
    }
};
} // namespace

class TestOperatePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void lookingMovesNothing_data()
    {
        QTest::addColumn<QString>("port");
        QTest::newRow("STS, SMS, SCS") << "sim:demo";
        QTest::newRow("LX") << "sim:lx";
        QTest::newRow("Modbus") << "sim:modbus";
    }
    void lookingMovesNothing()
    {
        QFETCH(QString, port);
        OperateBench bench;
        QVERIFY(bench.connectTo(port));
        const auto goals = [&] {
            std::vector<std::int64_t> all;
            for (const session::ServoRef ref : bench.desk().servos()) {
                const device::Servo& servo = bench.desk().servo(ref)->servo;
                const QString key = servo.profile->byRole(catalog::Role::GoalPosition)->key;
                bench.withWire(
                    [&](sim::VirtualBus& bus) { all.push_back(bus.servo(servo.id)->raw(key)); });
            }
            return all;
        };
        const auto before = goals();
        for (const session::ServoRef ref : bench.desk().servos()) {
            bench.selection().select(ref);
            QTRY_VERIFY(bench.desk().rate(ref).hz > 0);
            const auto& entry = *bench.desk().servo(ref);
            QTRY_VERIFY(entry.servo.raw(catalog::Role::TorqueSwitch).has_value());
            QCOMPARE(entry.servo.raw(catalog::Role::TorqueSwitch), std::int64_t(0));
            QVERIFY(entry.writes.empty());
        }
        QCOMPARE(goals(), before);
    }

    void whatIsReadIsShown()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_COMPARE(bench.gauge(0)->valueText(), QStringLiteral("7.4"));
        QTRY_VERIFY(bench.find<ui::PositionDial>("positionDial")->view().position.has_value());
        QCOMPARE(bench.find<ui::Pill>("statusLink")->accessibleName(),
                 QStringLiteral("Communication fine"));
        QTRY_VERIFY(bench.find<QLabel>("statusAge")->text().contains(QLatin1String("Hz")));
        QTRY_VERIFY(bench.curve(QStringLiteral("*/@position")) != nullptr);
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        // Goal and position of a servo at rest.
        QCOMPARE(bench.curve(QStringLiteral("*/@goal"))->unit, QStringLiteral("°"));
    }

    void theWordsOfTheTradeInChinese()
    {
        OperateBench bench(QStringLiteral("zh_CN"));
        QVERIFY(bench.ready(1));
        auto* link = bench.find<ui::Pill>("statusLink");
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("通信正常"));
        bench.withWire(
            [](sim::VirtualBus& bus) { bus.servo(1)->surroundings().supplyVolts = 3.0; });
        QTRY_VERIFY(bench.alarmWords().join(QLatin1Char(' ')).contains(QStringLiteral("过压欠压")));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("通信超时"));
    }

    void anAlarmStaysUntilItIsAcknowledged()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.desk().rate(bench.selection().current()).hz > 0);
        QVERIFY(bench.alarmWords().isEmpty());
        bench.withWire(
            [](sim::VirtualBus& bus) { bus.servo(1)->surroundings().supplyVolts = 3.0; });
        QTRY_COMPARE(bench.alarmWords(), QStringList{QStringLiteral("✗ Voltage out of range")});
        bench.withWire(
            [](sim::VirtualBus& bus) { bus.servo(1)->surroundings().supplyVolts = 7.4; });
        QTRY_VERIFY(bench.alarmWords().join(QString()).contains(QLatin1String("over")));
        bench.click("acknowledge");
        QTRY_VERIFY(bench.alarmWords().isEmpty());
    }

    /// Garbage is not called silence, and no alarm is claimed of a servo that cannot be read.
    void whatIsNotReadIsNotClaimed()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        auto* link = bench.find<ui::Pill>("statusLink");
        auto* alarm = bench.find<ui::Pill>("statusNoAlarm");
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("no alarm"));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 1; });
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("Unreadable answers"));
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("alarms: –"));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 0; });
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("no alarm"));
    }

    void whatAFamilyCannotMeasureIsSaid()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:scs15@1")));
        QTRY_VERIFY(bench.gauge(3)->accessibleDescription().contains(QLatin1String("SCS15")));
        QVERIFY(bench.curve(QStringLiteral("*/@current")) == nullptr);
        QVERIFY(bench.curve(QStringLiteral("*/@load")) != nullptr);
    }

    void theStripSelects()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        const auto cards = bench.window->findChildren<ui::ServoCard*>();
        QCOMPARE(cards.size(), 6);
        QTest::mouseClick(cards[2], Qt::LeftButton);
        QCOMPARE(bench.selection().current(), bench.desk().servos()[2]);
        QTest::keyClick(cards[1], Qt::Key_Space);
        QCOMPARE(bench.selection().current(), bench.desk().servos()[1]);
        QTest::mouseClick(cards[3], Qt::LeftButton, Qt::ControlModifier);
        QCOMPARE(bench.selection().chosen().size(), std::size_t(2));
        QCOMPARE(bench.selection().current(), bench.desk().servos()[1]);
    }

    /// The curves go on while another page is shown.
    void measuringGoesOnOnEveryPage()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        bench.action(ui::Command::PageMemory)->trigger();
        const auto count = bench.bench.scope.store().count();
        QTRY_VERIFY(bench.bench.scope.store().count() > count + 50);
    }

    void pauseStandsStillAndGoesOn()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        auto* chart = bench.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(bench.bench.scope.store().count() > 50);
        bench.action(ui::Command::PauseTrend)->trigger();
        QVERIFY(!chart->following());
        QVERIFY(bench.find<QToolButton>("trendPause")->isChecked());
        const auto shown = chart->shown();
        const auto count = bench.bench.scope.store().count();
        QTRY_VERIFY(bench.bench.scope.store().count() > count + 50);
        QCOMPARE(chart->shown(), shown);
        bench.action(ui::Command::PauseTrend)->trigger();
        QTRY_VERIFY(chart->shown().to > shown.to);
    }

    void cursorsComeWithTheirTable()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.bench.scope.store().count() > 50);
        QVERIFY(!bench.find<QWidget>("cursorPanel")->isVisible());
        bench.click("trendCursors");
        QVERIFY(bench.find<QWidget>("cursorPanel")->isVisible());
        QVERIFY(bench.find<QTableWidget>("cursorTable")->rowCount() >= 3);
        QVERIFY(bench.find<QTableWidget>("cursorTable")->height() > 40);
        bench.click("trendCursors");
        QVERIFY(!bench.find<QWidget>("cursorPanel")->isVisible());
    }

    void aTickedRegisterIsReadAndShown()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        bench.click("trendChannels");
        auto* tree = bench.find<QTreeWidget>("channelTree");
        QTRY_VERIFY(tree != nullptr);
        QTreeWidgetItem* row = nullptr;
        for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it) {
            if ((*it)->data(0, Qt::UserRole).toString() == QLatin1String("2/position_p"))
                row = *it;
        }
        QVERIFY(row != nullptr);
        row->setCheckState(0, Qt::Checked);
        const QString key = QStringLiteral("2/position_p");
        QTRY_VERIFY(bench.drawn(key));
        const auto latest = bench.bench.scope.store().latest(bench.curve(key)->id);
        QCOMPARE(latest->value, 32.0);
        // Remembered for the next start.
        QVERIFY(bench.settings.choice(QStringLiteral("trend/curves"), QStringList())
                    .toStringList()
                    .join(QLatin1Char(' '))
                    .contains(key));
    }

    void aRecordingIsMadeAndShownAgain()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.csv"));
        bench.action(ui::Command::Record)->trigger();
        auto* edit = bench.find<QLineEdit>("recordPath");
        QVERIFY(edit != nullptr);
        edit->setText(folder.filePath(QStringLiteral("nowhere/run.csv")));
        bench.click("recordStart");
        QTRY_VERIFY(!bench.find<QLabel>("recordTrouble")->text().isEmpty());
        QVERIFY(!bench.bench.scope.recording());
        edit->setText(path);
        bench.click("recordStart");
        QTRY_VERIFY(bench.find<QLabel>("trendRecordState")->isVisible());
        QTRY_VERIFY(bench.bench.scope.recordingStatus().rows > 100);
        bench.action(ui::Command::Record)->trigger();
        QTRY_VERIFY(!bench.bench.scope.recording());
        const auto rows = bench.bench.scope.recordingStatus().rows;

        auto* panel = bench.find<ui::TrendPanel>("trendPanel");
        panel->load(path);
        QTRY_VERIFY(panel->replaying());
        const auto* chart = bench.find<ui::TrendChart>("trendChart");
        QCOMPARE(chart->shown().from.count() <= 0, true);
        QVERIFY(bench.find<QSlider>("replaySlider")->isVisible());
        QVERIFY(rows > 0);
        const auto before = chart->shown();
        bench.find<QSlider>("replaySlider")->setValue(5000);
        QVERIFY(chart->shown().to != before.to);
        bench.click("replayPlay");
        const auto begun = chart->shown();
        QTRY_VERIFY(chart->shown().to > begun.to);
        bench.click("trendLive");
        QVERIFY(!panel->replaying());
        QVERIFY(chart->following());
    }

    /// What is recorded is read on, whatever page is shown and whatever servo is selected.
    void aRecordingGoesOnOnOtherPages()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        const session::ServoRef first = bench.desk().servos().front();
        QTRY_VERIFY(bench.bench.scope.find(first, QStringLiteral("present_voltage")) != nullptr);
        const QTemporaryDir folder;
        QVERIFY(bench.bench.scope.record({.path = folder.filePath(QStringLiteral("run.csv"))}));
        QTRY_VERIFY(bench.bench.scope.recordingStatus().rows > 20);
        // The channel itself moves when others come.
        const int voltage = bench.bench.scope.find(first, QStringLiteral("present_voltage"))->id;
        bench.action(ui::Command::PageMemory)->trigger();
        bench.selection().select(bench.desk().servos()[1]);
        const auto& store = bench.bench.scope.store();
        const base::Duration then = bench.desk().now();
        QTRY_VERIFY(store.latest(voltage)->at > then + std::chrono::milliseconds(300));
        bench.bench.scope.stopRecording();
        QTRY_VERIFY(!bench.bench.scope.recording());
    }

    void oneRecordingAfterTheOther()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        const QTemporaryDir folder;
        auto* panel = bench.find<ui::TrendPanel>("trendPanel");
        auto* chart = bench.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        for (const char* name : {"a.csv", "b.jsonl"}) {
            const QString path = folder.filePath(QString::fromLatin1(name));
            QVERIFY(bench.bench.scope.record({.path = path}).has_value());
            QTRY_VERIFY(bench.bench.scope.recordingStatus().rows > 50);
            bench.bench.scope.stopRecording();
            QTRY_VERIFY(!bench.bench.scope.recording());
            panel->load(path);
            auto* slider = bench.find<QSlider>("replaySlider");
            QTRY_VERIFY(panel->replaying() && slider->toolTip() == QString::fromLatin1(name));
            chart->flush();
            // "Now" has no meaning in a recording.
            chart->setFollowing(true);
            QVERIFY(!chart->following());
        }
        bench.click("trendLive");
        QVERIFY(chart->following());
        QCOMPARE(chart->width(), base::Duration(std::chrono::seconds(10)));
    }

    void anExistingFileIsAskedFor()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        QTRY_VERIFY(bench.drawn(QStringLiteral("*/@position")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("yesterday.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("precious");
        file.close();
        bench.action(ui::Command::Record)->trigger();
        bench.find<QLineEdit>("recordPath")->setText(path);
        bench.click("recordStart");
        QVERIFY(!bench.bench.scope.recording());
        QCOMPARE(QFileInfo(path).size(), qint64(8));
        bench.click("recordStart");
        QTRY_VERIFY(bench.bench.scope.recordingStatus().rows > 0);
        bench.bench.scope.stopRecording();
        QTRY_VERIFY(!bench.bench.scope.recording());
    }

    void whatIsOldLooksOld()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        auto* dial = bench.find<ui::PositionDial>("positionDial");
        QTRY_VERIFY(dial->view().position && !dial->view().old);
        bench.desk().disconnectFrom();
        QTRY_VERIFY(dial->view().old);
        QTRY_VERIFY(bench.find<ui::Pill>("statusMoving")
                        ->accessibleName()
                        .contains(QLatin1String("not known")));
        for (const ui::ServoCard* card : bench.window->findChildren<ui::ServoCard*>())
            QTRY_VERIFY(card->view().old);
    }

    /// The port follows a servo to another baud rate: the others are not read any more, and their
    /// cards must not stay green.
    void aServoThatIsNotReadAnyMoreIsNeutralWithItsAge()
    {
        OperateBench bench;
        QVERIFY(bench.ready(2, QStringLiteral("sim:sts3215@1,sts3215@2")));
        const auto card = [&](int id) {
            for (const ui::ServoCard* one : bench.window->findChildren<ui::ServoCard*>()) {
                if (one->view().title.startsWith(QString::number(id)))
                    return one->view();
            }
            return ui::CardView{};
        };
        auto* link = bench.find<ui::Pill>("statusLink");
        auto* dial = bench.find<ui::PositionDial>("positionDial");
        QTRY_COMPARE(card(1).tone, ui::Tone::Good);
        QCOMPARE(card(1).state, QStringLiteral("fine"));
        QTRY_VERIFY(!dial->view().old);
        const QString fine = link->accessibleName();
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("baud_rate"), 1}}, false, true}); // 500 000
        QVERIFY(bench.settled());
        QTRY_COMPARE_WITH_TIMEOUT(card(1).tone, ui::Tone::Quiet, 30'000);
        QVERIFY(card(1).old);
        QTRY_VERIFY2_WITH_TIMEOUT(card(1).state.contains(QStringLiteral("s ago")),
                                  qPrintable(card(1).state), 30'000);
        QTRY_COMPARE(card(2).tone, ui::Tone::Good);
        for (const session::ServoRef ref : bench.desk().servos()) {
            if (bench.desk().servo(ref)->servo.id == 1)
                bench.selection().select(ref);
        }
        QTRY_VERIFY(dial->view().old);
        QTRY_VERIFY2(link->accessibleName() != fine, qPrintable(fine));
    }

    void aFileThatIsNoRecordingIsNamed()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("letter.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("Dear sir,\n");
        file.close();
        auto* panel = bench.find<ui::TrendPanel>("trendPanel");
        panel->load(path);
        auto* banner = bench.find<QWidget>("trendBanner");
        QTRY_VERIFY(banner->isVisible());
        QVERIFY(!panel->replaying());
    }

    void theTriggerFreezesTheChart()
    {
        OperateBench bench;
        QVERIFY(bench.ready(1));
        auto* chart = bench.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(bench.bench.scope.store().count() > 50);
        bench.click("trendTrigger");
        auto* kind = bench.find<QComboBox>("triggerKind");
        QVERIFY(kind != nullptr);
        kind->setCurrentIndex(7); // something is written
        bench.find<QDoubleSpinBox>("triggerPre")->setValue(0.2);
        bench.find<QDoubleSpinBox>("triggerPost")->setValue(0.1);
        bench.click("triggerArm");
        QCOMPARE(bench.bench.scope.trigger().state(), record::Trigger::State::Armed);
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), 40}}, true, false});
        QTRY_COMPARE(bench.bench.scope.trigger().state(), record::Trigger::State::Complete);
        QVERIFY(!chart->following());
        QCOMPARE(chart->shown(), *bench.bench.scope.trigger().window());
    }
};

QTEST_MAIN(TestOperatePage)
#include "tst_operate_page.moc"
