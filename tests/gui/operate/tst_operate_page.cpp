// SPDX-License-Identifier: GPL-3.0-or-later
// The operate page on the simulated bus: opening it and selecting a servo move nothing; readings
// are shown on dial, gauges, lights, strip and chart; alarms stay until they are acknowledged;
// recordings are made and shown again.
#include "gui/dialogs.h"
#include "gui/main_window_fixture.h"
#include "session/recording/live_data.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_view.h"
#include "ui/operate/servo_card.h"
#include "ui/operate/servo_strip.h"
#include "ui/trends/trend_panel.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/position_dial.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeWidget>

namespace {
struct OperatePageFixture : gui::MainWindowFixture {
    explicit OperatePageFixture(const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("operate");
    }
    template <typename Function>
    void withBus(Function&& function)
    {
        workbench().link().connection()->simulation()->with(std::forward<Function>(function));
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

    void openingThePageMovesNothing_data()
    {
        QTest::addColumn<QString>("port");
        QTest::newRow("STS, SMS, SCS") << "sim:demo";
        QTest::newRow("LX") << "sim:lx";
        QTest::newRow("Modbus") << "sim:modbus";
    }
    void openingThePageMovesNothing()
    {
        QFETCH(QString, port);
        OperatePageFixture fixture;
        QVERIFY(fixture.connectTo(port));
        const auto goals = [&] {
            std::vector<std::int64_t> all;
            for (const session::ServoRef ref : fixture.workbench().registry().order()) {
                const device::Servo& servo = fixture.workbench().registry().servo(ref)->servo;
                const QString key = servo.profile->byRole(catalog::Role::GoalPosition)->key;
                fixture.withBus(
                    [&](sim::VirtualBus& bus) { all.push_back(bus.servo(servo.id)->raw(key)); });
            }
            return all;
        };
        const auto before = goals();
        for (const session::ServoRef ref : fixture.workbench().registry().order()) {
            fixture.selection().select(ref);
            QTRY_VERIFY(fixture.workbench().polling().pollRate(ref).hz > 0);
            const auto& entry = *fixture.workbench().registry().servo(ref);
            QTRY_VERIFY(entry.servo.raw(catalog::Role::TorqueSwitch).has_value());
            // Without torque a goal left from before is not on its way.
            auto* dial = fixture.find<ui::PositionDial>("positionDial");
            QTRY_VERIFY(dial->view().position.has_value());
            QTRY_VERIFY2(!dial->view().subtitle.contains(QChar(0x2192)),
                         qPrintable(dial->view().subtitle));
            QCOMPARE(entry.servo.raw(catalog::Role::TorqueSwitch), std::int64_t(0));
            QVERIFY(entry.writes.empty());
        }
        QCOMPARE(goals(), before);
    }

    /// The first day with a bag of servos.
    void newServosWithOneIdLeadToCommissioning()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.connectTo(QStringLiteral("sim:new-arm")));
        const auto found = fixture.workbench().registry().order();
        QCOMPARE(found.size(), std::size_t(1));
        fixture.selection().select(found.front());
        const auto* why = fixture.find<QLabel>("controlEmpty");
        QTRY_VERIFY(why->isVisible());
        QVERIFY2(why->text().contains(QStringLiteral("one at a time")), qPrintable(why->text()));
        QTRY_COMPARE(fixture.find<ui::Pill>("statusLink")->accessibleName(),
                     QStringLiteral("Unreadable replies"));
        fixture.action(ui::Command::PageMemory)->trigger();
        QTRY_VERIFY(fixture.find<QPushButton>("memoryNothingSetUp")->isVisible());
        fixture.action(ui::Command::PageOperate)->trigger();
        fixture.click("controlEmptySetUp");
        QTRY_VERIFY(fixture.find<QWidget>("commissionPage")->isVisible());
    }

    void readValuesAreShown()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_COMPARE(fixture.gauge(0)->valueText(), QStringLiteral("7.4"));
        QTRY_VERIFY(fixture.find<ui::PositionDial>("positionDial")->view().position.has_value());
        QCOMPARE(fixture.find<ui::Pill>("statusLink")->accessibleName(),
                 QStringLiteral("Communication OK"));
        QTRY_VERIFY(fixture.find<QLabel>("statusAge")->text().contains(QLatin1String("Hz")));
        QTRY_VERIFY(fixture.curve(QStringLiteral("*/@position")) != nullptr);
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        // Goal and position of a servo at rest.
        QCOMPARE(fixture.curve(QStringLiteral("*/@goal"))->unit, QStringLiteral("°"));
    }

    /// Where nothing live is shown, fewer readings keep the curves going.
    void otherPagesReadLessOften()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        const auto hz = [&] {
            return fixture.workbench().polling().pollRate(fixture.selection().current()).hz;
        };
        QTRY_VERIFY(hz() > 20);
        fixture.action(ui::Command::PageSweep)->trigger();
        QTRY_VERIFY(hz() > 0 && hz() < 12);
        // What is waited for is to be seen in full.
        recording::TriggerSpec spec;
        spec.kind = recording::TriggerSpec::Kind::Mark;
        fixture.workbench().liveData().armTrigger(spec);
        QTRY_VERIFY(hz() > 20);
        fixture.workbench().liveData().disarmTrigger();
        QTRY_VERIFY(hz() < 12);
        fixture.action(ui::Command::PageOperate)->trigger();
        QTRY_VERIFY(hz() > 20);
    }

    void theMemoryForReadingsIsChosen()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        const auto choices = [&] { return fixture.find<QMenu>("trendMemories")->actions(); };
        const auto chosen = [&] {
            QStringList names;
            for (const QAction* one : choices()) {
                if (one->isChecked())
                    names << one->text();
            }
            return names;
        };
        QCOMPARE(chosen(), QStringList{QStringLiteral("128 MB")});
        choices().last()->trigger();
        QCOMPARE(chosen(), QStringList{QStringLiteral("1024 MB")});
        QCOMPARE(fixture.settings.pageValue(QStringLiteral("trend/memory_mb"), 0).toInt(), 1024);
    }

    void chineseUsesTechnicalTerms()
    {
        OperatePageFixture fixture(QStringLiteral("zh_CN"));
        QVERIFY(fixture.ready(1));
        auto* link = fixture.find<ui::Pill>("statusLink");
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("通信正常"));
        fixture.withBus(
            [](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = 3.0; });
        QTRY_VERIFY(
            fixture.alarmWords().join(QLatin1Char(' ')).contains(QStringLiteral("过压欠压")));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("通信超时"));
    }

    void anAlarmStaysUntilItIsAcknowledged()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.workbench().polling().pollRate(fixture.selection().current()).hz > 0);
        QVERIFY(fixture.alarmWords().isEmpty());
        fixture.withBus(
            [](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = 3.0; });
        QTRY_COMPARE(fixture.alarmWords(), QStringList{QStringLiteral("✗ Voltage out of range")});
        fixture.withBus(
            [](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = 7.4; });
        QTRY_VERIFY(fixture.alarmWords().join(QString()).contains(QLatin1String("cleared")));
        fixture.click("acknowledge");
        QTRY_VERIFY(fixture.alarmWords().isEmpty());
    }

    /// Garbage is not shown as silence, and no alarm is shown for a servo that cannot be read.
    void unreadValuesAreNotShown()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* link = fixture.find<ui::Pill>("statusLink");
        auto* alarm = fixture.find<ui::Pill>("statusNoAlarm");
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("no alarm"));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 1; });
        QTRY_COMPARE(link->accessibleName(), QStringLiteral("Unreadable replies"));
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("alarms: –"));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.corrupt = 0; });
        QTRY_COMPARE(alarm->accessibleName(), QStringLiteral("no alarm"));
    }

    void unsupportedMeasurementsAreHidden()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:scs15@1")));
        QTRY_VERIFY(fixture.gauge(0)->isVisible());
        QVERIFY(fixture.gauge(3)->isHidden()); // an SCS15 measures no current
        QVERIFY(fixture.curve(QStringLiteral("*/@current")) == nullptr);
        QVERIFY(fixture.curve(QStringLiteral("*/@load")) != nullptr);
    }

    void gaugesGiveWayToTheChart()
    {
        OperatePageFixture fixture;
        fixture.window->resize(1280, 800);
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.gauge(0)->isVisible());
        fixture.click("showGauges");
        QVERIFY(fixture.gauge(0)->isHidden());
        QVERIFY(!fixture.settings.pageValue(QStringLiteral("operate/gauges"), true).toBool());
        fixture.click("showGauges");
        QVERIFY(fixture.gauge(0)->isVisible());
        // The messages take their place, not the chart's.
        fixture.window->resize(1024, 700);
        fixture.context.commands.action(ui::Command::MessageLog)->trigger();
        const auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(fixture.gauge(0)->isHidden());
        QVERIFY(!fixture.find<QToolButton>("showGauges")->isEnabled());
        QTRY_VERIFY(chart->QWidget::height() > 120);
    }

    /// No empty row below the chart.
    void noStripWithoutServos()
    {
        OperatePageFixture fixture;
        QWidget parent;
        const ui::ServoStrip strip(fixture.workbench().registry(), fixture.workbench().link(),
                                   fixture.selection(), &parent);
        QVERIFY(!strip.isVisibleTo(&parent));
    }

    void theStatusStripSelects()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        const auto cards = fixture.window->findChildren<ui::ServoCard*>();
        QCOMPARE(cards.size(), 6);
        QTest::mouseClick(cards[2], Qt::LeftButton);
        QCOMPARE(fixture.selection().current(), fixture.workbench().registry().order()[2]);
        QTest::keyClick(cards[1], Qt::Key_Space);
        QCOMPARE(fixture.selection().current(), fixture.workbench().registry().order()[1]);
        QTest::mouseClick(cards[3], Qt::LeftButton, Qt::ControlModifier);
        QCOMPARE(fixture.selection().selected().size(), std::size_t(2));
        QCOMPARE(fixture.selection().current(), fixture.workbench().registry().order()[1]);
    }

    /// The curves go on while another page is shown.
    void pollingContinuesOnEveryPage()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        fixture.action(ui::Command::PageMemory)->trigger();
        const auto count = fixture.context.workbench.liveData().store().count();
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > count + 50);
    }

    void pauseFreezesAndResumes()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > 50);
        fixture.action(ui::Command::PauseTrend)->trigger();
        QVERIFY(!chart->isFollowing());
        QVERIFY(fixture.find<QToolButton>("trendPause")->isChecked());
        const auto shown = chart->shown();
        const auto count = fixture.context.workbench.liveData().store().count();
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > count + 50);
        QCOMPARE(chart->shown(), shown);
        fixture.action(ui::Command::PauseTrend)->trigger();
        QTRY_VERIFY(chart->shown().to > shown.to);
    }

    void cursorsShowTheirTable()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > 50);
        QVERIFY(!fixture.find<QWidget>("cursorPanel")->isVisible());
        fixture.click("trendCursors");
        QVERIFY(fixture.find<QWidget>("cursorPanel")->isVisible());
        QVERIFY(fixture.find<QTableWidget>("cursorTable")->rowCount() >= 3);
        QVERIFY(fixture.find<QTableWidget>("cursorTable")->height() > 40);
        fixture.click("trendCursors");
        QVERIFY(!fixture.find<QWidget>("cursorPanel")->isVisible());
    }

    void aTickedRegisterIsReadAndShown()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        fixture.click("trendChannels");
        auto* tree = fixture.find<QTreeWidget>("channelTree");
        QTRY_VERIFY(tree != nullptr);
        QTreeWidgetItem* row = nullptr;
        for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it) {
            if ((*it)->data(0, Qt::UserRole).toString() == QLatin1String("2/position_p"))
                row = *it;
        }
        QVERIFY(row != nullptr);
        row->setCheckState(0, Qt::Checked);
        const QString key = QStringLiteral("2/position_p");
        QTRY_VERIFY(fixture.drawn(key));
        const auto latest =
            fixture.context.workbench.liveData().store().latest(fixture.curve(key)->id);
        QCOMPARE(latest->value, 32.0);
        // Remembered for the next start.
        QVERIFY(fixture.settings.pageValue(QStringLiteral("trend/curves"), QStringList())
                    .toStringList()
                    .join(QLatin1Char(' '))
                    .contains(key));
    }

    void aRecordingIsMadeAndReopened()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.csv"));
        fixture.action(ui::Command::Record)->trigger();
        auto* edit = fixture.find<QLineEdit>("recordPath");
        QVERIFY(edit != nullptr);
        edit->setText(folder.filePath(QStringLiteral("nowhere/run.csv")));
        fixture.click("recordStart");
        QTRY_VERIFY(!fixture.find<QLabel>("recordTrouble")->text().isEmpty());
        QVERIFY(!fixture.context.workbench.liveData().recording().isRunning());
        edit->setText(path);
        fixture.click("recordStart");
        QTRY_VERIFY(fixture.find<QLabel>("trendRecordState")->isVisible());
        QTRY_VERIFY(fixture.context.workbench.liveData().recording().status().rows > 100);
        fixture.action(ui::Command::Record)->trigger();
        QTRY_VERIFY(!fixture.context.workbench.liveData().recording().isRunning());
        const auto rows = fixture.context.workbench.liveData().recording().status().rows;

        auto* panel = fixture.find<ui::TrendPanel>("trendPanel");
        panel->load(path);
        QTRY_VERIFY(panel->isReplaying());
        const auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QCOMPARE(chart->shown().from.count() <= 0, true);
        QVERIFY(fixture.find<QSlider>("replaySlider")->isVisible());
        QVERIFY(rows > 0);
        const auto before = chart->shown();
        fixture.find<QSlider>("replaySlider")->setValue(5000);
        QVERIFY(chart->shown().to != before.to);
        fixture.click("replayPlay");
        const auto begun = chart->shown();
        QTRY_VERIFY(chart->shown().to > begun.to);
        fixture.click("trendLive");
        QVERIFY(!panel->isReplaying());
        QVERIFY(chart->isFollowing());
    }

    /// Recorded registers are read further, whatever page is shown and whatever servo is selected.
    void aRecordingContinuesOnOtherPages()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        const session::ServoRef first = fixture.workbench().registry().order().front();
        QTRY_VERIFY(fixture.context.workbench.liveData().find(
                        first, QStringLiteral("present_voltage")) != nullptr);
        const QTemporaryDir folder;
        QVERIFY(fixture.context.workbench.liveData().recording().start(
            {.path = folder.filePath(QStringLiteral("run.csv"))}));
        QTRY_VERIFY(fixture.context.workbench.liveData().recording().status().rows > 20);
        // The channel itself moves when others come.
        const int voltage =
            fixture.context.workbench.liveData().find(first, QStringLiteral("present_voltage"))->id;
        fixture.action(ui::Command::PageMemory)->trigger();
        fixture.selection().select(fixture.workbench().registry().order()[1]);
        const auto& store = fixture.context.workbench.liveData().store();
        const base::Duration then = fixture.workbench().now();
        // In real time: a loaded machine may need more than the usual five seconds.
        QTRY_VERIFY(store.latest(voltage)->at > then + std::chrono::milliseconds(300));
        fixture.context.workbench.liveData().recording().stop();
        QTRY_VERIFY(!fixture.context.workbench.liveData().recording().isRunning());
    }

    void oneRecordingAfterTheOther()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        const QTemporaryDir folder;
        auto* panel = fixture.find<ui::TrendPanel>("trendPanel");
        auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        for (const char* name : {"a.csv", "b.jsonl"}) {
            const QString path = folder.filePath(QString::fromLatin1(name));
            QVERIFY(
                fixture.context.workbench.liveData().recording().start({.path = path}).has_value());
            QTRY_VERIFY(fixture.context.workbench.liveData().recording().status().rows > 50);
            fixture.context.workbench.liveData().recording().stop();
            QTRY_VERIFY(!fixture.context.workbench.liveData().recording().isRunning());
            panel->load(path);
            auto* slider = fixture.find<QSlider>("replaySlider");
            QTRY_VERIFY(panel->isReplaying() && slider->toolTip() == QString::fromLatin1(name));
            chart->flush();
            // "Now" has no meaning in a recording.
            chart->setFollowing(true);
            QVERIFY(!chart->isFollowing());
        }
        fixture.click("trendLive");
        QVERIFY(chart->isFollowing());
        QCOMPARE(chart->width(), base::Duration(std::chrono::seconds(10)));
    }

    void overwritingIsConfirmed()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        QTRY_VERIFY(fixture.drawn(QStringLiteral("*/@position")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("yesterday.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("precious");
        file.close();
        fixture.action(ui::Command::Record)->trigger();
        fixture.find<QLineEdit>("recordPath")->setText(path);
        fixture.click("recordStart");
        QVERIFY(!fixture.context.workbench.liveData().recording().isRunning());
        QCOMPARE(QFileInfo(path).size(), qint64(8));
        fixture.click("recordStart");
        QTRY_VERIFY(fixture.context.workbench.liveData().recording().status().rows > 0);
        fixture.context.workbench.liveData().recording().stop();
        QTRY_VERIFY(!fixture.context.workbench.liveData().recording().isRunning());
    }

    void staleValuesLookStale()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* dial = fixture.find<ui::PositionDial>("positionDial");
        QTRY_VERIFY(dial->view().position && !dial->view().isStale);
        fixture.workbench().closing().disconnectFrom();
        QTRY_VERIFY(dial->view().isStale);
        QTRY_VERIFY(fixture.find<ui::Pill>("statusMoving")
                        ->accessibleName()
                        .contains(QLatin1String("unknown")));
        for (const ui::ServoCard* card : fixture.window->findChildren<ui::ServoCard*>())
            QTRY_VERIFY(card->view().isStale);
    }

    /// After power-on the goal of this family is 0, far from where the servo stands.
    void aGoalWithoutTorqueDoesNotWidenTheScale()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:modbus")));
        auto* plot = fixture.find<ui::TrendView>("trendPlot");
        const auto degrees = [&] {
            return plot->picture().axes().axisOf(QStringLiteral("°")).shown;
        };
        QTRY_VERIFY(fixture.entry().servo.raw(catalog::Role::GoalPosition) == 0);
        QVERIFY(ui::isTorqueOff(fixture.entry()));
        QTRY_VERIFY(degrees().low > 90 && degrees().high < 270);
        fixture.settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
        fixture.click("torqueSwitch");
        QTRY_VERIFY(!ui::isTorqueOff(fixture.entry()));
        auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QVERIFY(chart->width() > std::chrono::seconds(5)); // the old goal is still in view
        const base::Duration before = chart->shown().to;
        QTRY_VERIFY(chart->shown().to > before + std::chrono::milliseconds(300));
        QVERIFY(degrees().low > 90 && degrees().high < 270);
    }

    /// The port follows a servo to another baud rate: the others are not read any more, and their
    /// cards must not stay green.
    void anUnpolledServoIsNeutralWithItsAge()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(2, QStringLiteral("sim:sts3215@1,sts3215@2")));
        const auto card = [&](int id) {
            for (const ui::ServoCard* one : fixture.window->findChildren<ui::ServoCard*>()) {
                if (one->view().title.startsWith(QString::number(id)))
                    return one->view();
            }
            return ui::CardState{};
        };
        auto* link = fixture.find<ui::Pill>("statusLink");
        auto* dial = fixture.find<ui::PositionDial>("positionDial");
        QTRY_COMPARE(card(1).tone, ui::Tone::Good);
        QCOMPARE(card(1).state, QStringLiteral("OK"));
        QTRY_VERIFY(!dial->view().isStale);
        const QString fine = link->accessibleName();
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{QStringLiteral("baud_rate"), 1}}, false, device::Consent::confirmed()}); // 500 000
        QVERIFY(fixture.waitUntilIdle());
        QTRY_COMPARE(card(1).tone, ui::Tone::Quiet);
        QVERIFY(card(1).isStale);
        QTRY_VERIFY2(card(1).state.contains(QStringLiteral("s ago")), qPrintable(card(1).state));
        QTRY_COMPARE(card(2).tone, ui::Tone::Good);
        for (const session::ServoRef ref : fixture.workbench().registry().order()) {
            if (fixture.workbench().registry().servo(ref)->servo.id == 1)
                fixture.selection().select(ref);
        }
        QTRY_VERIFY(dial->view().isStale);
        QTRY_VERIFY2(link->accessibleName() != fine, qPrintable(fine));
    }

    void aFileThatIsNoRecordingIsReported()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("letter.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("Dear sir,\n");
        file.close();
        auto* panel = fixture.find<ui::TrendPanel>("trendPanel");
        panel->load(path);
        auto* banner = fixture.find<QWidget>("trendBanner");
        QTRY_VERIFY(banner->isVisible());
        QVERIFY(!panel->isReplaying());
    }

    /// The menu of the right mouse button; the suffix is the format.
    void theViewIsExported()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > 50);
        auto* plot = chart->findChild<QAbstractScrollArea*>(QStringLiteral("trendPlot"));
        const QPoint middle = plot->viewport()->rect().center();
        QContextMenuEvent click(QContextMenuEvent::Mouse, middle,
                                plot->viewport()->mapToGlobal(middle));
        QCoreApplication::sendEvent(plot->viewport(), &click);
        auto* menu = fixture.find<QMenu>("trendMenu");
        QTRY_VERIFY(menu->isVisible());
        const QTemporaryDir folder;
        auto* banner = fixture.find<ui::Banner>("trendBanner");
        for (const char* name : {"view.csv", "view.png", "view.svg"}) {
            menu->findChild<QAction*>(QStringLiteral("trendExport"))->trigger();
            auto* dialog = fixture.find<QFileDialog>("exportViewDialog");
            QVERIFY(dialog != nullptr);
            const QString path = folder.filePath(QLatin1String(name));
            Q_EMIT dialog->fileSelected(path);
            dialog->close();
            QTRY_VERIFY(QFileInfo(path).size() > 100);
            QTRY_VERIFY(banner->isVisible() && gui::labelsOf(banner).contains(path));
            QTRY_VERIFY(fixture.find<QFileDialog>("exportViewDialog") == nullptr);
        }
        QFile table(folder.filePath(QStringLiteral("view.csv")));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QString header = QString::fromUtf8(table.readLine());
        for (const ui::TrendChannel& channel : chart->channels())
            QCOMPARE(header.contains(channel.name), channel.visible);
        menu->close();
    }

    /// In one row on the smallest window too; what is not there is in the menu.
    void theTrendsButtonsAreInOneRow()
    {
        for (const QString& language : {QStringLiteral("en"), QStringLiteral("zh_CN")}) {
            OperatePageFixture fixture(language);
            QVERIFY(fixture.ready(1));
            auto* more = fixture.find<QToolButton>("trendMore");
            auto* pause = fixture.find<QToolButton>("trendPause");
            auto* fit = fixture.find<QToolButton>("trendFit");
            auto* record = fixture.find<QToolButton>("trendRecord");
            for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
                fixture.window->resize(size);
                QTRY_COMPARE(fixture.window->size(), size);
                QTRY_VERIFY(more->y() == pause->y() &&
                            more->geometry().right() <= more->parentWidget()->width());
                QTRY_COMPARE(record->toolButtonStyle() == Qt::ToolButtonTextBesideIcon,
                             fit->isVisible());
                QTRY_VERIFY(fit->isVisible() || size.width() == 1024);
            }
            fixture.click("trendLanes");
            QVERIFY(fixture.find<ui::TrendChart>("trendChart")->hasLanes());
            QVERIFY(fixture.settings.pageValue(QStringLiteral("trend/lanes"), false).toBool());
        }
    }

    void theTriggerFreezesTheChart()
    {
        OperatePageFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* chart = fixture.find<ui::TrendChart>("trendChart");
        QTRY_VERIFY(fixture.context.workbench.liveData().store().count() > 50);
        fixture.find<QAction>("trendTriggerMenu")->trigger();
        auto* kind = fixture.find<QComboBox>("triggerKind");
        QVERIFY(kind != nullptr);
        kind->setCurrentIndex(7); // something is written
        fixture.find<QDoubleSpinBox>("triggerPre")->setValue(0.2);
        fixture.find<QDoubleSpinBox>("triggerPost")->setValue(0.1);
        fixture.click("triggerArm");
        QCOMPARE(fixture.context.workbench.liveData().trigger().state(),
                 recording::Trigger::State::Armed);
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 40}}, true, {}});
        QTRY_COMPARE(fixture.context.workbench.liveData().trigger().state(),
                     recording::Trigger::State::Complete);
        QVERIFY(!chart->isFollowing());
        QCOMPARE(chart->shown(), *fixture.context.workbench.liveData().trigger().window());
    }
};

SERVODESK_TEST(TestOperatePage)
#include "tst_operate_page.moc"
