// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep page on the simulated bus: opening it moves nothing, it proposes a range and a delay
// that fit, tells when the delay is too short, asks before the first move, shows what is measured
// while it runs, ends by Stop and by Esc, and writes its report.
#include "device/motion.h"
#include "gui/dialogs.h"
#include "gui/window_bench.h"
#include "record/sweep_json.h"
#include "sim/sim_link.h"
#include "ui/charts/trend_chart.h"
#include "ui/dialogs/limits_dialog.h"
#include "ui/pages/sweep_results.h"
#include "ui/pages/sweep_servos.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/pill.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

namespace {
constexpr int testTime = 40'000;

struct SweepBench : gui::WindowBench {
    explicit SweepBench(const QString& language = QStringLiteral("en"))
        : WindowBench(language)
    {
        page = QStringLiteral("sweep");
    }
    session::SweepTest& test() { return bench.sweep; }
    QString text(const char* name) { return find<QLabel>(name)->text(); }
    void click(const char* name)
    {
        auto* button = find<QAbstractButton>(name);
        QVERIFY2(button != nullptr, name);
        QTRY_VERIFY2(button->isEnabled(), name);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const char* name, const QString& words)
    {
        auto* edit = find<QLineEdit>(name);
        QVERIFY2(edit != nullptr, name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, words);
    }
    bool proposed()
    {
        return QTest::qWaitFor(
            [this] { return text("sweepOutlook").contains(QLatin1String(" s")); }, 10000);
    }
    /// A short one: a few hundred steps to and fro.
    void prepare(int cycles = 2, int delay = 700)
    {
        QVERIFY(proposed());
        type("sweepStart", QStringLiteral("1800"));
        type("sweepEnd", QStringLiteral("2200"));
        find<QSpinBox>("sweepCycles")->setValue(cycles);
        find<QSpinBox>("sweepPause")->setValue(delay);
    }
    void torqueOn()
    {
        session::Task task;
        task.name = QStringLiteral("torque");
        task.effect = session::Effect::Energises;
        task.work = [](session::TaskContext& context) {
            return device::setTorque(context.device, context.servo, device::Torque::On);
        };
        desk().perform(selection().current(), std::move(task));
        QVERIFY(QTest::qWaitFor([this] { return !entry().stopped; }));
    }
    /// Presses Run, and agrees to the question of the first time.
    void run()
    {
        click("sweepRun");
        if (auto* yes = find<QPushButton>("questionYes"))
            QTest::mouseClick(yes, Qt::LeftButton);
        QTRY_VERIFY(test().running());
    }
    bool begun()
    {
        return QTest::qWaitFor(
            [this] { return test().run() != nullptr && !test().run()->servos[0].legs.empty(); },
            testTime);
    }
    bool over()
    {
        return QTest::qWaitFor([this] { return !test().running(); }, testTime);
    }
    std::int64_t now(const char* key)
    {
        (void)settled();
        desk().readTable(selection().current());
        (void)settled();
        return raw(key).value_or(-1);
    }
};

class TestSweepPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void openingMovesNothingAndProposesWhatFits()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(bench.proposed());
        const int from = bench.find<QLineEdit>("sweepStart")->text().toInt();
        const int to = bench.find<QLineEdit>("sweepEnd")->text().toInt();
        QVERIFY(from > *bench.raw("min_angle_limit"));
        QVERIFY(to < *bench.raw("max_angle_limit"));
        QVERIFY(to - from > 3000);
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QLatin1String("long enough")));
        QCOMPARE(bench.now("torque_switch"), 0);
        QVERIFY(bench.find<QLabel>("sweepNothing")->isVisible());
        QVERIFY(!bench.find<QPushButton>("sweepStop")->isEnabled());
        QVERIFY(!bench.find<QPushButton>("sweepReport_html")->isEnabled());
    }

    void aDelayShorterThanTheMoveIsTold()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(bench.proposed());
        bench.find<QSpinBox>("sweepPause")->setValue(200);
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QLatin1String("turn round")));
        // One click takes the time that is enough.
        Q_EMIT bench.find<QLabel>("sweepOutlook")->linkActivated(QStringLiteral("enough"));
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QLatin1String("long enough")));
        QVERIFY(bench.find<QSpinBox>("sweepPause")->value() > 1000);
    }

    void whatCannotRunIsSaidBeforehand_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("words");
        QTest::newRow("same") << "1000"
                              << "1000"
                              << "same place";
        QTest::newRow("outside") << "100"
                                 << "9000"
                                 << "outside";
        QTest::newRow("no number") << "abc"
                                   << "2000"
                                   << "understood";
    }
    void whatCannotRunIsSaidBeforehand()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, words);
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(bench.proposed());
        bench.type("sweepStart", from);
        bench.type("sweepEnd", to);
        QTRY_VERIFY2(bench.text("sweepOutlook").contains(words),
                     qPrintable(bench.text("sweepOutlook")));
        QVERIFY(!bench.find<QPushButton>("sweepRun")->isEnabled());
    }

    void theFirstRunAsksAndNoMeansNothing()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare();
        bench.click("sweepRun");
        QDialog* question = bench.question();
        QVERIFY(question != nullptr);
        const QString said = gui::labelsOf(question);
        QVERIFY2(said.contains(QStringLiteral("hold their position with torque on")),
                 qPrintable(said));
        gui::click(question, "questionNo");
        QVERIFY(!bench.test().running());
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    void runsShowsAndSaves()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare();
        bench.run();
        QVERIFY(!bench.find<QLineEdit>("sweepStart")->isEnabled());
        QVERIFY(bench.begun());
        QTRY_VERIFY(bench.test().store().count() > 50);
        QVERIFY(bench.over());
        const record::SweepRun& run = *bench.test().run();
        QCOMPARE(run.end, record::SweepEnd::Finished);
        QCOMPARE(int(run.servos[0].legs.size()), 4);
        QCOMPARE(bench.find<QTableView>("sweepLegsTable")->model()->rowCount(), 4);
        QVERIFY(bench.find<ui::ErrorHistogram>("sweepHistogram")->count() >= 3);
        QVERIFY(bench.find<QTableView>("sweepVerdictTable")->model()->rowCount() > 5);
        QVERIFY(bench.find<ui::Pill>("sweepVerdict")->words().contains(QLatin1String("ass")) ||
                bench.find<ui::Pill>("sweepVerdict")->words().contains(QLatin1String("arn")));
        QCOMPARE(bench.find<ui::TrendChart>("sweepChart")->channels().size(), std::size_t(2));
        QVERIFY(QFileInfo(bench.test().readingsPath()).size() > 1000);
        QVERIFY(bench.find<QLineEdit>("sweepStart")->isEnabled());
        QTemporaryDir place;
        for (const char* ending : {"json", "html", "csv", "pdf"}) {
            bench.click(qPrintable(QStringLiteral("sweepReport_") + QLatin1String(ending)));
            auto* dialog = bench.find<QFileDialog>("sweepReportDialog");
            QVERIFY(dialog != nullptr);
            const QString path = place.filePath(QStringLiteral("r.") + QLatin1String(ending));
            QSignalSpy saved(&bench.test(), &session::SweepTest::saved);
            Q_EMIT dialog->fileSelected(path);
            dialog->close();
            QVERIFY(saved.wait(10000));
            QVERIFY(QFileInfo(path).size() > 100);
            const QString readings = place.filePath(QStringLiteral("r.readings.csv"));
            QVERIFY2(QFileInfo(readings).size() > 1000, ending);
            QVERIFY(QFile::remove(readings));
            QTRY_VERIFY(bench.find<QFileDialog>("sweepReportDialog") == nullptr);
        }
        const auto read = record::loadSweepRun(place.filePath(QStringLiteral("r.json")));
        QVERIFY(read.has_value());
        QCOMPARE(read->servos[0].legs.size(), run.servos[0].legs.size());
        // A report that cannot be written is told, and the test is not lost.
        QSignalSpy failed(&bench.test(), &session::SweepTest::saveFailed);
        bench.test().save(QStringLiteral("/proc/none/r.html"), false);
        QVERIFY(failed.wait(10000));
        QVERIFY(bench.find<QLabel>("sweepSaved")->isVisible());
    }

    void stopHoldsOrReleases_data()
    {
        QTest::addColumn<int>("choice");
        QTest::addColumn<int>("torque");
        QTest::newRow("hold") << 0 << 1;
        QTest::newRow("release") << 1 << 0;
    }
    void stopHoldsOrReleases()
    {
        QFETCH(int, choice);
        QFETCH(int, torque);
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(50);
        bench.find<QComboBox>("sweepAfterwards")->setCurrentIndex(choice);
        bench.run();
        QVERIFY(bench.begun());
        bench.click("sweepStop");
        QVERIFY(bench.over());
        QCOMPARE(bench.test().run()->end, record::SweepEnd::Stopped);
        QVERIFY(!bench.test().run()->servos[0].legs.empty());
        QVERIFY(bench.find<QLabel>("sweepEnd")->isVisible());
        QCOMPARE(bench.test().run()->servos[0].verdict, record::Grade::NotMeasured);
        QCOMPARE(bench.find<ui::Pill>("sweepVerdict")->words(), QStringLiteral("– No verdict"));
        QCOMPARE(int(bench.now("torque_switch")), torque);
    }

    void escTakesTorqueOffAndEndsTheTest()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(50);
        bench.run();
        QVERIFY(bench.begun());
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QVERIFY(bench.over());
        QCOMPARE(bench.test().run()->end, record::SweepEnd::Emergency);
        QCOMPARE(bench.now("torque_switch"), 0);
        QVERIFY(!bench.test().run()->servos[0].legs.empty());
        // Until torque has been switched on again nothing moves, and it says so.
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QStringLiteral("emergency stop: ID 1.")));
        QVERIFY(!bench.find<QPushButton>("sweepRun")->isEnabled());
        QCOMPARE(bench.now("torque_switch"), 0);
        // Nor when it is asked to in another way; then the banner says so.
        session::SweepTestOrder order;
        order.spec = bench.test().run()->spec;
        order.servos = bench.test().servos();
        order.limits = {bench.test().run()->servos[0].limits};
        QVERIFY(bench.test().start(order));
        QTRY_VERIFY(!bench.test().running());
        QVERIFY(bench.find<QWidget>("sweepBanner")->isVisible());
        QCOMPARE(bench.now("torque_switch"), 0);
        bench.torqueOn();
        QTRY_VERIFY(bench.find<QPushButton>("sweepRun")->isEnabled());
    }

    /// What is looked at elsewhere is not what is tested.
    void ticksStayWhenAnotherServoIsSelected()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
        QTRY_COMPARE(bench.desk().servos().size(), std::size_t(3));
        auto* table = bench.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 3);
        const auto ticks = [table] {
            QList<bool> ticked;
            for (int row = 0; row < table->rowCount(); ++row)
                ticked.append(table->item(row, 0)->checkState() == Qt::Checked);
            return ticked;
        };
        QTRY_COMPARE(ticks(), (QList<bool>{true, false, false}));
        table->item(2, 0)->setCheckState(Qt::Checked);
        bench.selection().select(bench.desk().servos()[1]);
        QTest::qWait(100); // a tick that must not change announces nothing to wait for
        QCOMPARE(ticks(), (QList<bool>{true, false, true}));
        // Without a tick of the user's own the selection is what is tested.
        table->item(0, 0)->setCheckState(Qt::Unchecked);
        table->item(2, 0)->setCheckState(Qt::Unchecked);
        bench.selection().select(bench.desk().servos()[2]);
        QTRY_COMPARE(ticks(), (QList<bool>{false, false, true}));
    }

    /// The plug is out when the key is pressed: the stop waits for it, and is proved like any.
    void escWhileThePlugIsOutIsProvedToo()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(50);
        bench.run();
        QVERIFY(bench.begun());
        bool proved = false;
        QObject::connect(&bench.desk(), &session::Desk::happened, &bench.desk(),
                         [&](const session::Event& event) {
                             proved |= event.kind == session::Event::Kind::StopChecked &&
                                       !event.stop.off.empty();
                         });
        const auto wire = bench.desk().connection()->simulation();
        wire->with([](sim::VirtualBus& bus) { bus.cutLink(); });
        QTRY_VERIFY(bench.desk().connection()->bus().away());
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        wire->with([](sim::VirtualBus& bus) { bus.restoreLink(); });
        QVERIFY(bench.over());
        QTRY_VERIFY_WITH_TIMEOUT(proved, 15000);
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    /// While the test waits, in words and in the list; once the line is back Run can be used again.
    void aSilentLineIsReported()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(50);
        bench.run();
        QVERIFY(bench.begun());
        const auto lose = [&bench](double share) {
            bench.desk().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_COMPARE_WITH_TIMEOUT(bench.find<ui::Pill>("sweepVerdict")->words(),
                                  QStringLiteral("no answer"), 10000);
        QVERIFY(bench.test().running());
        QVERIFY2(bench.text("sweepProgressWords").startsWith(QLatin1String("No answer from ID 1")),
                 qPrintable(bench.text("sweepProgressWords")));
        QTRY_VERIFY_WITH_TIMEOUT(bench.entry().silent, 10000);
        QVERIFY(bench.over());
        QCOMPARE(bench.test().run()->end, record::SweepEnd::LinkLost);
        QTRY_VERIFY(bench.find<QWidget>("sweepBanner")->isVisible());
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QLatin1String("no answer")));
        QVERIFY(!bench.find<QPushButton>("sweepRun")->isEnabled());
        lose(0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.entry().silent, testTime);
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("sweepRun")->isEnabled(), testTime);
        QVERIFY(!bench.text("sweepOutlook").contains(QLatin1String("no answer")));
        QCOMPARE(bench.find<QLineEdit>("sweepStart")->text(), QStringLiteral("1800"));
    }

    /// Torque is switched off first, then the mode put back where interrupted writes are settled.
    static void isNotNamedOnceItIsPutBack(SweepBench& bench)
    {
        auto* banner = bench.find<QWidget>("sweepBanner");
        const auto says = [banner](const char* words) {
            return gui::labelsOf(banner).contains(QLatin1String(words));
        };
        QVERIFY(banner->isVisible() && says("Torque could not be switched off"));
        QString uuid;
        QObject::connect(&bench.desk(), &session::Desk::openIntents, banner,
                         [&uuid](const std::vector<jobs::Recovered>& found) {
                             if (!found.empty())
                                 uuid = found.front().before.intent.uuid;
                         });
        const auto search = [&bench] {
            bench.desk().search(bench.desk().lastSearchSpec());
            QTRY_VERIFY_WITH_TIMEOUT(!bench.desk().searching(), testTime);
        };
        search();
        QVERIFY(bench.desk().servos().empty());
        bench.desk().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.config().faults.dropRequest = 0;
            bus.servo(1)->poke(QStringLiteral("torque_switch"), 0);
        });
        search(); // it enters the list anew
        QTRY_VERIFY_WITH_TIMEOUT(!says("Torque could not be switched off"), testTime);
        QVERIFY(banner->isVisible() && says("Settings of the test still in the servo"));
        bench.desk().lookForIntents();
        QTRY_VERIFY_WITH_TIMEOUT(!uuid.isEmpty(), testTime);
        bench.desk().settleIntent(uuid, jobs::RecoverAction::Undo);
        QTRY_VERIFY_WITH_TIMEOUT(!banner->isVisible(), testTime);
    }

    /// The test had switched the mode, and the link is lost before it could be put back.
    void aModeThatIsNotPutBackIsNamed()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.bench.drive.setServos({bench.selection().current()});
        bench.bench.drive.switchMode(QStringLiteral("speed"));
        auto* tick = bench.find<QCheckBox>("sweepSwitchMode");
        QTRY_VERIFY_WITH_TIMEOUT(tick->isVisible(), testTime);
        tick->setChecked(true);
        bench.type("sweepStart", QStringLiteral("1800"));
        bench.type("sweepEnd", QStringLiteral("2200"));
        bench.find<QSpinBox>("sweepCycles")->setValue(50);
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("sweepRun")->isEnabled(), testTime);
        bench.run();
        QVERIFY(bench.begun());
        bench.desk().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        QVERIFY(bench.over());
        QCOMPARE(bench.test().run()->end, record::SweepEnd::LinkLost);
        QString said;
        for (const QLabel* label : bench.find<QWidget>("sweepBanner")->findChildren<QLabel*>())
            said += label->text();
        for (const char* part : {"Settings of the test still in the servo: ID 1: ", "(own value 1)",
                                 "Interrupted writes", "Torque could not be switched off: ID 1"})
            QVERIFY2(said.contains(QLatin1String(part)), qPrintable(said));
        isNotNamedOnceItIsPutBack(bench);
    }

    /// However often its servos are read meanwhile, and also if nothing reads them.
    void aLineThatIsWholeAgainIsNoticed_data()
    {
        QTest::addColumn<bool>("polled");
        QTest::newRow("read all the time") << true;
        QTest::newRow("read by nothing else") << false;
    }
    void aLineThatIsWholeAgainIsNoticed()
    {
        QFETCH(const bool, polled);
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        bench.prepare();
        auto* table = bench.find<QTableWidget>("sweepServos");
        table->item(1, 0)->setCheckState(Qt::Checked);
        QTRY_VERIFY(bench.find<QPushButton>("sweepRun")->isEnabled());
        if (polled) {
            bench.desk().wish(
                QStringLiteral("test"),
                {{{bench.selection().current(), {QStringLiteral("present_position")}}}, {}});
        }
        const auto lose = [&bench](double share) {
            bench.desk().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        if (polled)
            QTRY_VERIFY_WITH_TIMEOUT(bench.entry().silent, testTime);
        else
            bench.find<QSpinBox>("sweepCycles")->setValue(3); // the test is looked at anew
        QTRY_VERIFY_WITH_TIMEOUT(bench.text("sweepOutlook").contains(QLatin1String("no answer")),
                                 testTime);
        QVERIFY(!bench.find<QPushButton>("sweepRun")->isEnabled());
        lose(0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("sweepRun")->isEnabled(), testTime);
        QVERIFY(!bench.text("sweepOutlook").contains(QLatin1String("no answer")));
    }

    /// Run is blocked with the first word of it, not only once the silent servos have been read.
    void silentServosBlockRun()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        bench.prepare();
        bench.find<QTableWidget>("sweepServos")->item(1, 0)->setCheckState(Qt::Checked);
        auto* run = bench.find<QPushButton>("sweepRun");
        QTRY_VERIFY(run->isEnabled());
        session::FeedWish wish;
        const auto servos = bench.desk().servos();
        for (const session::ServoRef ref : servos)
            wish.parts.push_back({ref, {QStringLiteral("present_position")}});
        bench.desk().wish(QStringLiteral("test"), wish);
        const auto silent = [&] {
            return std::any_of(servos.begin(), servos.end(), [&](session::ServoRef ref) {
                return bench.desk().servo(ref)->silent;
            });
        };
        bool blocked = true;
        int seen = 0;
        QObject::connect(
            &bench.desk(), &session::Desk::servoChanged, run, [&](session::ServoRef ref) {
                if (!bench.desk().servo(ref)->silent)
                    return;
                ++seen;
                blocked = blocked && !run->isEnabled() &&
                          bench.text("sweepOutlook").contains(QLatin1String("no answer"));
            });
        const auto lose = [&bench](double share) {
            bench.desk().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_VERIFY_WITH_TIMEOUT(seen > 0 && silent(), testTime);
        QVERIFY(blocked);
        QVERIFY(!run->isEnabled());
        lose(0);
        QTRY_VERIFY_WITH_TIMEOUT(run->isEnabled() && !silent(), testTime);
        QVERIFY(blocked);
    }

    void whatWasTypedForAServoComesBackWithIt()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        bench.prepare(2, 900);
        QVERIFY(bench.choose(2));
        auto* start = bench.find<QLineEdit>("sweepStart");
        QTRY_VERIFY(start->text() != QLatin1String("1800")); // its own proposal
        const QString proposed = start->text();
        QVERIFY(bench.choose(1));
        QTRY_COMPARE(start->text(), QStringLiteral("1800"));
        QCOMPARE(bench.find<QLineEdit>("sweepEnd")->text(), QStringLiteral("2200"));
        QCOMPARE(bench.find<QSpinBox>("sweepPause")->value(), 900);
        bench.click("sweepRun");
        QDialog* question = bench.question();
        QVERIFY(question != nullptr);
        const QString said = gui::labelsOf(question);
        QVERIFY2(said.contains(QStringLiteral("1800 … 2200")), qPrintable(said));
        gui::click(question, "questionNo");
        QVERIFY(bench.choose(2));
        QTRY_COMPARE(start->text(), proposed);
    }

    void closingThePortEndsTheTestAndKeepsIt()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(5000);
        bench.run();
        QVERIFY(bench.begun());
        QSignalSpy kept(&bench.bench.archive, &session::Archive::kept);
        const auto answer = [&bench](const char* button) {
            bench.action(ui::Command::Disconnect)->trigger();
            auto* choice = bench.find<QPushButton>(button);
            QVERIFY(choice != nullptr);
            QPointer<QWidget> dialog = choice->window();
            QTest::mouseClick(choice, Qt::LeftButton);
            QTRY_VERIFY(dialog == nullptr);
        };
        answer("questionNo");
        QVERIFY(bench.test().running());
        QCOMPARE(bench.desk().state(), session::LinkState::Open);
        answer("questionYes");
        QTRY_COMPARE_WITH_TIMEOUT(bench.desk().state(), session::LinkState::Off, testTime);
        QVERIFY(!bench.test().running());
        QCOMPARE(bench.test().run()->end, record::SweepEnd::Stopped);
        QTRY_COMPARE(kept.size(), 1);
    }

    void aTestThatCannotBeginLeavesTheOneBeforeToBeSaved()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(1);
        bench.run();
        QVERIFY(bench.begun());
        QVERIFY(bench.over());
        session::SweepTestOrder wrong;
        wrong.spec.range = {QStringLiteral("1000"), QStringLiteral("1000")};
        wrong.servos = {bench.selection().current()};
        wrong.limits.resize(1);
        QSignalSpy failed(&bench.test(), &session::SweepTest::failed);
        QVERIFY(bench.test().start(wrong));
        QVERIFY(failed.wait(10000));
        QTemporaryDir place;
        QSignalSpy saved(&bench.test(), &session::SweepTest::saved);
        bench.test().save(place.filePath(QStringLiteral("r.csv")), false);
        QVERIFY(saved.wait(10000));
        QVERIFY(QFileInfo::exists(place.filePath(QStringLiteral("r.readings.csv"))));
    }

    void theTestHasTheBusToItself()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(50);
        bench.run();
        QVERIFY(bench.begun());
        QVERIFY(!bench.action(ui::Command::Search)->isEnabled());
        QVERIFY(!bench.action(ui::Command::SetId)->isEnabled());
        QSignalSpy told(&bench.desk(), &session::Desk::happened);
        bench.desk().write(bench.selection().current(), {{{QStringLiteral("position_p"), 20}}});
        QTRY_VERIFY(!told.empty());
        bench.desk().search({});
        QVERIFY(!bench.desk().searching());
        bench.click("sweepStop");
        QVERIFY(bench.over());
        QTRY_VERIFY(bench.action(ui::Command::Search)->isEnabled());
        QCOMPARE(bench.now("position_p"), 32);
    }

    void severalServosEachWithItsRange()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(1);
        auto* table = bench.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 3);
        table->item(1, 0)->setCheckState(Qt::Checked);
        table->item(1, 1)->setText(QStringLiteral("1000"));
        table->item(1, 2)->setText(QStringLiteral("1300"));
        bench.run();
        QVERIFY(bench.begun());
        QVERIFY(bench.over());
        const record::SweepRun& run = *bench.test().run();
        QCOMPARE(int(run.servos.size()), 2);
        QCOMPARE(run.servos[0].axis.from, 1800.0);
        QCOMPARE(run.servos[1].axis.from, 1000.0);
        QCOMPARE(run.servos[1].axis.to, 1300.0);
        auto* shown = bench.find<QComboBox>("sweepShownServo");
        QVERIFY(shown->isVisible());
        QCOMPARE(shown->count(), 2);
        shown->setCurrentIndex(1);
        Q_EMIT shown->activated(1);
        QCOMPARE(int(bench.find<ui::SweepResults>("sweepResults")->shownServo()), 1);
    }

    /// Of two servos only the second one fails: the chip says so whichever is shown.
    void theWorstOfSeveralCounts()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2+overshoot=12")));
        bench.prepare(1, 1500);
        auto* table = bench.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 2);
        QVERIFY(table->isColumnHidden(3)); // nothing has been tested
        table->item(1, 0)->setCheckState(Qt::Checked);
        bench.run();
        QVERIFY(bench.begun());
        // While it runs a click shows a servo, but takes none out of the test or gives it a range.
        auto* results = bench.find<ui::SweepResults>("sweepResults");
        for (const int row : {1, 0}) {
            const QRect servo = table->visualItemRect(table->item(row, 0));
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, servo.center());
            QCOMPARE(int(results->shownServo()), row);
            QTest::keyClick(table, Qt::Key_Space);
            QCOMPARE(table->item(row, 0)->checkState(), Qt::Checked);
            QTest::mouseDClick(table->viewport(), Qt::LeftButton, {},
                               table->visualItemRect(table->item(row, 1)).center());
            QVERIFY(table->viewport()->findChild<QLineEdit*>() == nullptr);
        }
        QVERIFY(!bench.find<QWidget>("sweepCycles")->isEnabled());
        QVERIFY(!bench.find<QWidget>("sweepLimits")->isEnabled());
        QVERIFY(bench.test().running());
        QVERIFY(bench.over());
        QTRY_VERIFY(bench.find<QWidget>("sweepCycles")->isEnabled());
        const record::SweepRun& run = *bench.test().run();
        QCOMPARE(int(run.servos.size()), 2);
        QVERIFY(run.servos[0].verdict != record::Grade::Fail);
        QCOMPARE(run.servos[1].verdict, record::Grade::Fail);
        auto* verdict = bench.find<ui::Pill>("sweepVerdict");
        QCOMPARE(int(results->shownServo()), 0);
        QCOMPARE(verdict->words(), QStringLiteral("✘ Failed: ID 2"));
        QVERIFY(!table->isColumnHidden(3));
        QVERIFY(!table->item(0, 3)->text().contains(QLatin1String("Failed")));
        QCOMPARE(table->item(1, 3)->text(), QStringLiteral("✘ Failed"));
        const auto cell = [&](int row) { return table->visualItemRect(table->item(row, 3)); };
        for (const int row : {1, 0}) {
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell(row).center());
            QCOMPARE(int(results->shownServo()), row);
            QCOMPARE(verdict->words(), QStringLiteral("✘ Failed: ID 2"));
        }
        auto* shown = bench.find<QComboBox>("sweepShownServo");
        QVERIFY(shown->itemText(1).contains(QLatin1String("Failed")));
        Q_EMIT shown->activated(1);
        QCOMPARE(table->currentRow(), 1);
    }

    void wheelModeIsOfferedToBeSwitched()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("operating_mode"), 1}}, true, true});
        QVERIFY(bench.settled());
        bench.find<QSpinBox>("sweepPause")->setValue(700);
        auto* tick = bench.find<QCheckBox>("sweepSwitchMode");
        QTRY_VERIFY(tick->isVisible());
        QVERIFY(!bench.find<QPushButton>("sweepRun")->isEnabled());
        tick->click();
        bench.type("sweepStart", QStringLiteral("1800"));
        bench.type("sweepEnd", QStringLiteral("2200"));
        bench.find<QSpinBox>("sweepCycles")->setValue(1);
        bench.click("sweepRun");
        QDialog* question = bench.question();
        QVERIFY(question != nullptr);
        const QString said = gui::labelsOf(question);
        QVERIFY2(said.contains(QLatin1String("have their torque off afterwards")),
                 qPrintable(said));
        gui::click(question, "questionYes");
        QVERIFY(bench.begun());
        QVERIFY(bench.over());
        QVERIFY(bench.test().run() != nullptr);
        QCOMPARE(bench.test().run()->end, record::SweepEnd::Finished);
        QCOMPARE(bench.now("operating_mode"), 1);
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    void limitsAreEditedForTheModel()
    {
        SweepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        bench.prepare(1);
        bench.click("sweepLimits");
        auto* dialog = bench.window->findChild<ui::LimitsDialog*>();
        QVERIFY(dialog != nullptr);
        record::SweepLimits strict = dialog->limits();
        strict.name = QStringLiteral("strict");
        strict.lines = {{QStringLiteral("time_to_target"), QStringLiteral("ms"), {}, 1.0}};
        Q_EMIT dialog->chosen(strict);
        dialog->close();
        QVERIFY(bench.text("sweepLimitsName").contains(QLatin1String("strict")));
        // The next start of the program knows them, too.
        ui::SweepServos later(bench.desk(), bench.selection(), bench.settings, nullptr);
        QCOMPARE(later.limits(bench.selection().current()), strict);
        bench.run();
        QVERIFY(bench.begun());
        QVERIFY(bench.over());
        QCOMPARE(bench.test().run()->servos[0].verdict, record::Grade::Fail);
        QVERIFY(bench.find<ui::Pill>("sweepVerdict")->words().contains(QLatin1String("ime")));
    }

    void speaksChinese()
    {
        SweepBench bench(QStringLiteral("zh_CN"));
        QVERIFY(bench.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(bench.find<QPushButton>("sweepRun")->text().contains(QChar(0x8fd0)));
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QStringLiteral("延时")));
        bench.speak(QStringLiteral("en"));
        QTRY_VERIFY(bench.text("sweepOutlook").contains(QLatin1String("delay")));
    }
};
} // namespace

QTEST_MAIN(TestSweepPage)
#include "tst_sweep_page.moc"
