// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the window at work: the operate page in every mode of every family, sweep tests while
// they run and when they have ended, moved through the window's own parts, in both languages and
// themes. Usage: bench_scenes FOLDER [FILTER]; packaging/pictures.sh
// takes the best for README and help. It measures nothing; it stands here because it drives the
// window as the benches do.
#include "gui/five_register_write.h"
#include "gui/main_window_fixture.h"
#include "gui/servo_tasks_fixture.h"
#include "session/arm/arm_calibration.h"
#include "session/motion/motion_controller.h"
#include "session/sweep/sweep_test.h"
#include "sim/host/sim_link.h"
#include "ui/charts/trend_chart.h"
#include "ui/connect/find_servos_dialog.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTextStream>
#include <QTreeWidget>

using namespace std::chrono_literals;

namespace {
struct ServoList {
    const char* name;
    const char* port;
    int id;
    const char* mode;     ///< empty: as it is
    const char* goals[3]; ///< one after the other
    const char* speed;    ///< empty: as it is
    bool lanes = false;   ///< of the trend chart
};
constexpr ServoList scenes[] = {
    {"sts-position", "sim:demo", 1, "", {"1200", "2900", "1800"}, "1500"},
    {"sts-lanes", "sim:demo", 1, "", {"1200", "2900", "1800"}, "1500", true},
    {"sts-multiturn", "sim:sts3215@1,sts3215@2", 1, "multiturn", {"8192", "0", "4096"}, ""},
    {"sts-speed", "sim:sts3215@1,sts3215@2", 1, "speed", {"15rpm", "-15rpm", "10rpm"}, ""},
    {"sts-pwm", "sim:sts3215@1", 1, "pwm", {"20%", "-20%", "30%"}, ""},
    {"sts-step", "sim:sts3215@1", 1, "step", {"1024", "1024", "-512"}, ""},
    {"scs-position", "sim:scs15@1,scs15@2", 1, "", {"300", "800", "500"}, ""},
    {"scs-motor", "sim:scs15@1", 1, "motor", {"-20%", "30%", "-40%"}, ""},
    {"hls-current", "sim:hls3625@1", 1, "current", {"200mA", "-200mA", "150mA"}, ""},
    {"lx-position", "sim:lx", 1, "", {"300", "700", "450"}, ""},
    {"lx-motor", "sim:lx", 3, "motor", {"300", "-300", "200"}, ""},
    {"modbus-position", "sim:modbus", 1, "", {"1200", "2900", "1800"}, ""},
};

struct SweepScene {
    const char* name;
    const char* port;
    int id;
    int shape;            ///< place of its button
    bool whole;           ///< to its end; else in the middle of it
    bool several = false; ///< the second servo of the list takes part
};
constexpr SweepScene sweepScenes[] = {
    {"sweep-running", "sim:sweep", 1, 0, false},
    {"sweep-good", "sim:sts3215@1", 1, 0, true},
    {"sweep-bad", "sim:sts3215@1+rest-hysteresis=14+overshoot=6+noise=1", 1, 2, true},
    {"sweep-sine", "sim:sts3215@1", 1, 3, true},
    {"sweep-several", "sim:sts3215@1,sts3215@2+overshoot=12", 1, 0, true, true},
    {"sweep-scs", "sim:scs15@1,scs15@2", 1, 1, true},
    {"sweep-lx", "sim:lx", 1, 0, true},
};

void runEventLoop(int ms)
{
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

void show(const ServoList& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.page = QStringLiteral("operate");
    fixture.window->resize(size);
    if (!fixture.ready(scene.id, QString::fromLatin1(scene.port))) {
        QTextStream(stderr) << scene.name << ": no servo\n";
        return;
    }
    session::MotionController& drive = fixture.context.workbench.motion();
    const auto waitForServos = [&] {
        return QTest::qWaitFor(
            [&] { return !drive.isBusy() && !fixture.workbench().tasks().isBusy(); }, 5000);
    };
    QObject::connect(&drive, &session::MotionController::failed, &drive,
                     [&](const base::Error& error) {
                         QTextStream(stderr) << scene.name << ": " << base::errorName(error.code)
                                             << ' ' << error.detail << '\n';
                     });
    fixture.find<ui::TrendChart>("trendChart")->setLanes(scene.lanes);
    if (*scene.mode != '\0') {
        drive.switchMode(QString::fromLatin1(scene.mode));
        waitForServos();
    }
    drive.setTorque(device::Torque::On);
    waitForServos();
    for (const char* goal : scene.goals) {
        session::MoveRequest wish;
        wish.goal = QString::fromLatin1(goal);
        if (*scene.speed != '\0')
            wish.speed = QString::fromLatin1(scene.speed);
        drive.move(wish);
        waitForServos();
        runEventLoop(1500);
    }
    if (size.width() > 1500)
        fixture.find<ui::TrendChart>("trendChart")->setCursorsShown(true);
    runEventLoop(300);
    if (!fixture.window->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": cannot be written\n";
}

void show(const SweepScene& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.page = QStringLiteral("sweep");
    fixture.window->resize(size);
    if (!fixture.ready(scene.id, QString::fromLatin1(scene.port))) {
        QTextStream(stderr) << scene.name << ": no servo\n";
        return;
    }
    session::SweepTest& test = fixture.context.workbench.sweepTest();
    static const char* const shapes[] = {"sweep", "stairs", "both-sides", "sine"};
    fixture
        .find<QAbstractButton>(
            qPrintable(QStringLiteral("sweepShape_") + QLatin1String(shapes[scene.shape])))
        ->click();
    fixture.find<QSpinBox>("sweepCycles")->setValue(scene.whole ? 2 : 20);
    if (scene.several)
        fixture.find<QTableWidget>("sweepServos")->item(1, 0)->setCheckState(Qt::Checked);
    auto* run = fixture.find<QAbstractButton>("sweepRun");
    runEventLoop(1500); // range and delay are proposed
    if (!QTest::qWaitFor([&] { return run->isEnabled(); }, 10000)) {
        QTextStream(stderr) << scene.name << ": cannot be run\n";
    } else {
        run->click();
        if (auto* yes = fixture.find<QAbstractButton>("questionYes"))
            yes->click();
        (void)QTest::qWaitFor([&] { return scene.whole ? !test.isRunning() : false; },
                              scene.whole ? 90'000 : 12'000);
    }
    runEventLoop(300);
    if (!fixture.window->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": cannot be written\n";
    test.stop();
    (void)QTest::qWaitFor([&] { return !test.isRunning(); }, 5000);
}

/// The step-response lab after a run and a trial.
struct StepScene {
    const char* name;
    const char* port;
    int id;
    int trial; ///< P
};
constexpr StepScene stepScenes[] = {{"step-trial", "sim:sts3215@1", 1, 80},
                                    {"step-scs", "sim:scs15@1", 1, 60}};

void show(const StepScene& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.page = QStringLiteral("step");
    fixture.window->resize(size);
    if (!fixture.ready(scene.id, QString::fromLatin1(scene.port))) {
        QTextStream(stderr) << scene.name << ": no servo\n";
        return;
    }
    const auto press = [&](const char* name) {
        auto* button = fixture.find<QAbstractButton>(name);
        if (!QTest::qWaitFor([&] { return button->isEnabled(); }, 20'000))
            QTextStream(stderr) << scene.name << ": " << name << " cannot be pressed\n";
        button->click();
        if (auto* yes = fixture.find<QAbstractButton>("questionYes"))
            yes->click();
        runEventLoop(500);
    };
    press("stepRun");
    (void)QTest::qWaitFor([&] { return fixture.find<QAbstractButton>("stepRun")->isEnabled(); },
                          30'000);
    fixture.find<QSpinBox>("stepTry_position_p")->setValue(scene.trial);
    press("stepTry");
    (void)QTest::qWaitFor([&] { return fixture.find<QAbstractButton>("stepRun")->isEnabled(); },
                          30'000);
    runEventLoop(500);
    if (!fixture.window->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": cannot be written\n";
}

/// A servo that was changed beside the table before, several tables side by side, and what the
/// history tells of it; the page itself, or a dialog over it.
struct ChangeScene {
    const char* name;
    const char* page;
    const char* press; ///< empty: nothing
};
constexpr ChangeScene changeScenes[] = {{"snapshots-compare", "snapshots", ""},
                                        {"snapshots-dry-run", "snapshots", "restoreDryRun"},
                                        {"snapshots-several", "snapshots", "restoreSeveral"},
                                        {"snapshots-template", "snapshots", "restoreTemplate"},
                                        {"history-writes", "history", ""},
                                        {"history-server", "history", "historyServer"}};

void show(const ChangeScene& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.page = QString::fromLatin1(scene.page);
    fixture.window->resize(size);
    if (!fixture.ready(1, QStringLiteral("sim:demo"))) {
        QTextStream(stderr) << scene.name << ": no servo\n";
        return;
    }
    const auto write = [&](const char* key, std::int64_t raw) {
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QString::fromLatin1(key), raw}}});
        fixture.waitUntilIdle();
    };
    if (auto* take = fixture.find<QAbstractButton>("snapshotTake"))
        take->click();
    fixture.waitUntilIdle();
    write("position_p", 40);
    write("min_angle_limit", 300);
    write("max_angle_limit", 3800);
    write("position_d", 48);
    runEventLoop(1200);
    if (auto* tree = fixture.find<QTreeWidget>("shelfTree"); tree->topLevelItemCount() > 0)
        tree->setCurrentItem(tree->topLevelItem(tree->topLevelItemCount() - 1));
    runEventLoop(800);
    QWidget* shown = fixture.window.get();
    if (*scene.press != '\0') {
        fixture.find<QAbstractButton>(scene.press)->click();
        runEventLoop(400);
        for (QDialog* dialog : fixture.window->findChildren<QDialog*>()) {
            if (dialog->isVisible())
                shown = dialog;
        }
    }
    if (!shown->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": cannot be written\n";
}

/// A bag of servos on the commissioning line: two are set up, the third waits for the click, or is
/// just done.
struct CommissionScene {
    const char* name;
    int clicks;
};
constexpr CommissionScene lineScenes[] = {{"commission-asks", 2}, {"commission-done", 3}};

void show(const CommissionScene& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.page = QStringLiteral("commission");
    fixture.window->resize(size);
    const QTemporaryDir files; // the batch, another one for each picture
    const auto press = [&](const char* name) {
        auto* button = fixture.find<QAbstractButton>(name);
        if (!QTest::qWaitFor([&] { return button->isVisible() && button->isEnabled(); }, 20'000))
            QTextStream(stderr) << scene.name << ": " << name << " cannot be pressed\n";
        button->click();
    };
    if (!fixture.connectTo(QStringLiteral("sim:line")))
        return;
    fixture.find<QLineEdit>("commissionBatch")->setText(files.filePath(QStringLiteral("gate.csv")));
    fixture.find<QSpinBox>("commissionFirstId")->setValue(11);
    press("commissionStart");
    auto* rows = fixture.find<QTableView>("commissionTable")->model();
    for (int done = 0; done < 3; ++done) {
        press("commissionPlug");
        if (done == scene.clicks) {
            (void)QTest::qWaitFor(
                [&] { return fixture.find<QAbstractButton>("commissionContinue")->isVisible(); },
                20'000);
            break;
        }
        press("commissionContinue");
        (void)QTest::qWaitFor([&] { return rows->rowCount() > done; }, 20'000);
        if (done + 1 < scene.clicks || scene.clicks < 3)
            press("commissionUnplug");
    }
    runEventLoop(1500);
    if (!fixture.window->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": cannot be written\n";
}

/// What stands in the window's way or is told when something went wrong: the question itself, or
/// the window with its banner.
struct ErrorScene {
    const char* name;
    const char* port;
    void (*happen)(gui::MainWindowFixture& fixture);
    const char* dialog; ///< empty: the window
};

template <typename Action>
void onTheWire(gui::MainWindowFixture& fixture, Action&& action)
{
    fixture.workbench().link().connection()->simulation()->with(std::forward<Action>(action));
}

void leaveServoTurning(gui::MainWindowFixture& fixture)
{
    session::MotionController& drive = fixture.context.workbench.motion();
    const auto waitForServos = [&] {
        return QTest::qWaitFor(
            [&] { return !drive.isBusy() && !fixture.workbench().tasks().isBusy(); }, 5000);
    };
    drive.setServos({fixture.selection().current()});
    drive.switchMode(QStringLiteral("speed"));
    waitForServos();
    drive.setTorque(device::Torque::On);
    waitForServos();
    drive.move({.goal = QStringLiteral("15rpm")});
    waitForServos();
    fixture.window->close();
}

/// The servo falls silent in the middle of a write of five rows.
void interruptWrite(gui::MainWindowFixture& fixture)
{
    fixture.workbench().writes().write(fixture.selection().current(), gui::fiveRegisterWrite());
    const auto mute = [&](std::vector<int> ids) {
        onTheWire(fixture, [&](sim::VirtualBus& wire) { wire.config().faults.muteIds = ids; });
    };
    (void)QTest::qWaitFor(
        [&] {
            bool open = false;
            onTheWire(fixture, [&](sim::VirtualBus& wire) {
                open = wire.servo(1)->raw(QStringLiteral("lock")) == 0;
            });
            return open;
        },
        10'000);
    mute({1});
    fixture.waitUntilIdle();
    mute({});
    runEventLoop(500);
}

void leaveLockOpen(gui::MainWindowFixture& fixture)
{
    interruptWrite(fixture);
    fixture.window->close();
}

void listInterrupted(gui::MainWindowFixture& fixture)
{
    interruptWrite(fixture);
    fixture.action(ui::Command::OpenIntents)->trigger();
}

void exchange(gui::MainWindowFixture& fixture)
{
    onTheWire(fixture, [](sim::VirtualBus& wire) {
        wire.unplug(0);
        wire.plug(1);
    });
    fixture.workbench().writes().write(fixture.selection().current(),
                                       {{{QStringLiteral("max_voltage"), 100}}});
    fixture.waitUntilIdle();
}

/// Two ports with servos, one that cannot be opened.
void findServos(gui::MainWindowFixture& fixture)
{
    fixture.workbench().closing().disconnectFrom();
    auto* ports = new session::PortWatcher(fixture.window.get(), [] {
        session::PortWatcher::PortList list;
        for (const char* port : {"sim:sts3215@1,sts3215@2,sts3215@3", "sim:lx", "sim:no-such-bus"})
            list.ports.emplace_back().path = QString::fromLatin1(port);
        return list;
    });
    (void)QTest::qWaitFor([&] { return ports->isReady(); }, 10'000);
    auto* dialog =
        new ui::FindServosDialog(fixture.workbench().session(), *ports, fixture.window.get());
    dialog->show();
    (void)QTest::qWaitFor(
        [&] { return !dialog->findChild<QWidget*>(QStringLiteral("findProgress"))->isVisible(); },
        60'000);
}

void diagnose(gui::MainWindowFixture& fixture)
{
    fixture.action(ui::Command::Diagnose)->trigger();
    (void)QTest::qWaitFor([&] { return !fixture.workbench().search().isDiagnosing(); }, 120'000);
}

void chooseFirmware(QDialog* dialog)
{
    QFile image(QDir::temp().filePath(QStringLiteral("SCServo21-GD32-485-250306.bin")));
    if (!image.open(QIODevice::WriteOnly) || image.write(QByteArray(29'000, 'x')) < 0)
        return;
    image.close();
    dialog->findChild<QPushButton*>(QStringLiteral("firmwareChoose"))->click();
    auto* files = dialog->findChild<QFileDialog*>(QStringLiteral("firmwareFileDialog"));
    Q_EMIT files->fileSelected(image.fileName());
    files->close();
}

QDialog* checkFirmware(gui::MainWindowFixture& fixture)
{
    fixture.action(ui::Command::PageFirmware)->trigger();
    fixture.action(ui::Command::UpdateFirmware)->trigger();
    auto* dialog = fixture.find<QDialog>("firmwareUpdateDialog");
    chooseFirmware(dialog);
    dialog->findChild<QPushButton*>(QStringLiteral("taskAction"))->click();
    fixture.waitUntilIdle();
    runEventLoop(300);
    return dialog;
}

void checkFirmwareScene(gui::MainWindowFixture& fixture)
{
    fixture.choose(1);
    checkFirmware(fixture);
}

void updateFirmware(gui::MainWindowFixture& fixture)
{
    QDialog* dialog = checkFirmware(fixture);
    for (QCheckBox* accept : dialog->findChildren<QCheckBox*>())
        accept->click();
    dialog->findChild<QPushButton*>(QStringLiteral("taskAction"))->click();
    (void)support::waitFor([dialog] { return !gui::resultOf(dialog).isEmpty(); });
    runEventLoop(300);
}

void updateFirmwareOfList(gui::MainWindowFixture& fixture)
{
    fixture.selection().setSelected(fixture.workbench().registry().order());
    updateFirmware(fixture);
}

void rescueFirmware(gui::MainWindowFixture& fixture)
{
    onTheWire(fixture, [](sim::VirtualBus& wire) { wire.unplugAll(); });
    fixture.action(ui::Command::RescueFirmware)->trigger();
    auto* dialog = fixture.find<QDialog>("firmwareRescueDialog");
    chooseFirmware(dialog);
    dialog->findChild<QPushButton*>(QStringLiteral("taskAction"))->click();
    runEventLoop(4000);
}

void openArmPage(gui::MainWindowFixture& fixture)
{
    onTheWire(fixture, [](sim::VirtualBus& wire) { wire.plug(1); }); // all joints
    fixture.action(ui::Command::Search)->trigger();
    fixture.action(ui::Command::PageArm)->trigger();
    runEventLoop(2500);
}

void recordArm(gui::MainWindowFixture& fixture)
{
    openArmPage(fixture);
    fixture.workbench().armCalibration().startRecording();
    runEventLoop(700);
}

void planArm(gui::MainWindowFixture& fixture)
{
    recordArm(fixture);
    runEventLoop(4000);
    fixture.workbench().armCalibration().finishRecording(false);
    fixture.waitUntilIdle();
    runEventLoop(500);
}

void clickOnArmPage(gui::MainWindowFixture& fixture, const char* button)
{
    openArmPage(fixture);
    fixture.find<QPushButton>(button)->click();
    runEventLoop(300);
}

void editArm(gui::MainWindowFixture& fixture)
{
    clickOnArmPage(fixture, "armEdit");
}

void prepareArm(gui::MainWindowFixture& fixture)
{
    clickOnArmPage(fixture, "armPrepare");
}

void askToTestArm(gui::MainWindowFixture& fixture)
{
    clickOnArmPage(fixture, "armTest");
}

/// With the limits as from the factory, behind the joints' stops.
void testArm(gui::MainWindowFixture& fixture)
{
    askToTestArm(fixture);
    fixture.find<QPushButton>("questionYes")->click();
    fixture.waitUntilIdle();
    runEventLoop(500);
}

constexpr ErrorScene troubleScenes[] = {
    {"arm-edit", "sim:so101", editArm, "armDialog"},
    {"arm-prepare", "sim:so101", prepareArm, "question"},
    {"arm-test-question", "sim:so101", askToTestArm, "question"},
    {"arm-tested", "sim:so101", testArm, ""},
    {"arm-recording", "sim:so101", recordArm, ""},
    {"arm-plan", "sim:so101", planArm, ""},
    {"firmware-checks", "sim:sts3215@1,sts3215@2,scs15@3", checkFirmwareScene,
     "firmwareUpdateDialog"},
    {"firmware-updated", "sim:sts3215@1", updateFirmware, "firmwareUpdateDialog"},
    {"firmware-list", "sim:sts3215@1,sts3215@2,sts3215@3,sts3215@4", updateFirmwareOfList,
     "firmwareUpdateDialog"},
    {"firmware-rescue", "sim:sts3215@1", rescueFirmware, "firmwareRescueDialog"},
    {"find-servos", "sim:sts3215@1", findServos, "findServosDialog"},
    {"diagnosis-rate", "sim:sts3215@1:500000,sts3215@2", diagnose, "diagnosisDialog"},
    {"diagnosis-bootloader", "sim:sts3215@1+firmware-lost=1", diagnose, "diagnosisDialog"},
    {"diagnosis-twins", "sim:new-arm", diagnose, "diagnosisDialog"},
    {"leave-turning", "sim:sts3215@1", leaveServoTurning, "question"},
    {"leave-unlocked", "sim:sts3215@1", leaveLockOpen, "question"},
    {"interrupted-write", "sim:sts3215@1", interruptWrite, ""},
    {"interrupted-list", "sim:sts3215@1", listInterrupted, "intentsDialog"},
    {"exchanged-servo", "sim:sts3215@1,scs15@1", exchange, ""}};

void show(const ErrorScene& scene, const QString& language, session::Theme look, QSize size,
          const QString& path)
{
    gui::MainWindowFixture fixture(language, look);
    fixture.window->resize(size);
    if (!fixture.connectTo(QString::fromLatin1(scene.port)))
        return;
    onTheWire(fixture, [](sim::VirtualBus& wire) {
        if (wire.servos().size() > 1)
            wire.unplug(1); // a spare one
    });
    fixture.action(ui::Command::Search)->trigger();
    (void)QTest::qWaitFor([&] { return !fixture.workbench().search().isSearching(); }, 20'000);
    if (!fixture.choose(1))
        QTextStream(stderr) << scene.name << ": no servo\n";
    scene.happen(fixture);
    runEventLoop(1000);
    QWidget* shown = fixture.window.get();
    if (*scene.dialog != '\0')
        shown = fixture.find<QDialog>(scene.dialog);
    if (shown == nullptr || !shown->grab().save(path, "PNG"))
        QTextStream(stderr) << path << ": nothing to be shown, or cannot be written\n";
}

/// Those whose names the filter lets through, in every language, theme and size.
template <typename List>
void showAll(const List& list, const QDir& folder, const QRegularExpression& filter)
{
    for (const auto& scene : list) {
        for (const char* language : {"en", "zh_CN"}) {
            for (const auto look : {session::Theme::Light, session::Theme::Dark}) {
                for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
                    const QString name =
                        QStringLiteral("%1-%2-%3-%4.png")
                            .arg(QLatin1String(scene.name), QLatin1String(language),
                                 look == session::Theme::Dark ? QStringLiteral("dark")
                                                              : QStringLiteral("light"))
                            .arg(size.width());
                    if (name.contains(filter))
                        show(scene, QString::fromLatin1(language), look, size,
                             folder.filePath(name));
                }
            }
        }
    }
}
} // namespace

int main(int argc, char* argv[])
{
    const QTemporaryDir place; // the user's settings and journal are nobody's business here
    qputenv("SERVODESK_DATA_DIR", place.path().toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", place.path().toLocal8Bit());
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("servodesk-scenes"));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        QTextStream(stderr) << "usage: bench_scenes FOLDER [FILTER]\n";
        return 2;
    }
    const QDir folder(arguments[1]);
    const QRegularExpression filter(arguments.value(2));
    showAll(scenes, folder, filter);
    showAll(sweepScenes, folder, filter);
    showAll(stepScenes, folder, filter);
    showAll(changeScenes, folder, filter);
    showAll(lineScenes, folder, filter);
    showAll(troubleScenes, folder, filter);
    return 0;
}
