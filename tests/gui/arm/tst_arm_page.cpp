// SPDX-License-Identifier: GPL-3.0-or-later
// The arm page as a technician uses it: a simulated SO-101 calibrated by moving, with mouse clicks
// only; nothing is written or moved before the question, and LeRobot's file agrees with the servos
// afterwards.
#include "gui/main_window_fixture.h"
#include "jobs/arm/lerobot_file.h"
#include "session/arm/arm_calibration.h"
#include "sim/host/sim_link.h"
#include "support/real_time.h"
#include "support/test_main.h"
#include "ui/arm/arm_model.h"
#include "ui/arm/arm_page.h"
#include "ui/widgets/banner.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>

#include <map>

using session::ArmCalibration;
using Step = ArmCalibration::Step;
using Column = ui::ArmModel::Column;

namespace {
struct Fixture : gui::MainWindowFixture {
    explicit Fixture(const QString& port, const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("arm");
        if (!connectTo(port))
            qFatal("no bus");
    }
    ArmCalibration& calibration() { return workbench().armCalibration(); }
    QString cell(int row, Column column)
    {
        const QAbstractItemModel* model = find<QTableView>("armTable")->model();
        return model->index(row, column).data().toString();
    }
    bool hasReadAll()
    {
        return support::waitFor(
            [this] { return calibration().heldAsFile().size() == calibration().joints().size(); });
    }
    void click(const char* button)
    {
        QTRY_VERIFY(find<QPushButton>(button)->isEnabled());
        QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton);
    }
    void clickYes()
    {
        QTRY_VERIFY(find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(find<QPushButton>("questionYes"), Qt::LeftButton);
    }
    bool hasRecordedAll()
    {
        return support::waitFor([this] {
            for (const session::ArmJoint& one : calibration().joints()) {
                const double degrees = double(one.range.high - one.range.low) * 360 / 4096;
                // From stop to stop, or through a full turn; the gripper has 120 degrees.
                const std::map<int, double> ranges{{5, 360}, {6, 119}};
                const auto range = ranges.find(one.joint.id);
                if (degrees < (range != ranges.end() ? range->second : 184))
                    return false;
            }
            return true;
        });
    }
    std::int64_t raw(int id, const char* key)
    {
        return workbench().link().connection()->simulation()->with(
            [&](sim::VirtualBus& wire) { return wire.servo(id)->raw(QString::fromLatin1(key)); });
    }
    void chooseFile(const char* button, const char* dialogName, const QString& path)
    {
        click(button);
        auto* dialog = find<QFileDialog>(dialogName);
        QVERIFY(dialog != nullptr);
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
    }
    bool isShown(const char* text)
    {
        const auto shown = window->findChildren<QLabel*>();
        return std::any_of(shown.begin(), shown.end(), [text](const QLabel* label) {
            return label->isVisible() && label->text().contains(QString::fromUtf8(text));
        });
    }
    QString fileState() { return find<QLabel>("armFileState")->text(); }
};

bool questionSays(Fixture& fixture, const char* text)
{
    QDialog* question = fixture.question();
    if (question == nullptr)
        return false;
    const auto words = question->findChildren<QLabel*>();
    return std::any_of(words.begin(), words.end(), [text](const QLabel* label) {
        return label->text().contains(QString::fromUtf8(text));
    });
}

ui::JointBar bar(Fixture& fixture, int row)
{
    const QAbstractItemModel* model = fixture.find<QTableView>("armTable")->model();
    return model->index(row, Column::RangeColumn).data(ui::jointBarRole).value<ui::JointBar>();
}

const QString so101 = QStringLiteral("sim:so101");
} // namespace

class TestArmPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void theArmIsShown()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        QTRY_COMPARE(fixture.cell(2, Column::OffsetColumn), QStringLiteral("850"));
        QCOMPARE(fixture.cell(2, Column::JointColumn), QStringLiteral("elbow_flex"));
        QCOMPARE(fixture.cell(0, Column::MaxColumn), QStringLiteral("4095"));
        QTRY_VERIFY(fixture.find<QPushButton>("armAction")->isEnabled());
        QCOMPARE(fixture.calibration().step(), Step::Idle);
        fixture.setLanguage(QStringLiteral("zh_CN"));
        QCOMPARE(fixture.find<QPushButton>("armAction")->text(), QStringLiteral("采集范围…"));
        QCOMPARE(fixture.find<QComboBox>("armChoice")->currentText(),
                 QStringLiteral("SO-100/SO-101"));
    }

    /// Also what somebody else moves, before anything is started.
    void thePositionsAreLive()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        session::Connection* connection = fixture.workbench().link().connection();
        const QString before = fixture.cell(2, Column::PositionColumn);
        const double shown = bar(fixture, 2).now.value_or(-1);
        connection->moveSimulatedServosByHand(true);
        QTRY_VERIFY(std::abs(fixture.cell(2, Column::PositionColumn).toInt() - before.toInt()) >
                    100);
        QTRY_VERIFY(std::abs(bar(fixture, 2).now.value_or(-1) - shown) > 0.05);
        connection->moveSimulatedServosByHand(false);
        QTRY_COMPARE(fixture.cell(2, Column::PositionColumn).toLongLong(),
                     fixture.raw(3, "present_position"));
        // One that is silent has no position any more.
        connection->simulation()->with([](sim::VirtualBus& wire) { wire.unplug(2); });
        QTRY_COMPARE_WITH_TIMEOUT(fixture.cell(2, Column::StateColumn), QStringLiteral("no reply"),
                                  30'000);
        QTRY_COMPARE(fixture.cell(2, Column::PositionColumn), QStringLiteral("–"));
        QVERIFY(!bar(fixture, 2).now);
        // Its limits are those of the whole turn, and are no recorded range.
        QCOMPARE(fixture.cell(2, Column::DegreesColumn), QStringLiteral("360°"));
        QVERIFY(!bar(fixture, 2).isRecorded);
    }

    void missingJointsAreNamed()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3250@2"));
        QTRY_COMPARE(fixture.cell(2, Column::StateColumn), QStringLiteral("not in the list"));
        QCOMPARE(fixture.cell(1, Column::StateColumn),
                 QStringLiteral("STS3250 instead of STS3215"));
        QVERIFY(fixture.find<QLabel>("armInstruction")
                    ->text()
                    .contains(QStringLiteral("elbow_flex (ID 3)")));
        QVERIFY(!fixture.find<QPushButton>("armAction")->isEnabled());
    }

    void theArmIsCalibrated()
    {
        const support::RealTime realTime; // no reading may be missed
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.click("armAction");
        QCOMPARE(fixture.calibration().step(), Step::Idle); // nothing before the answer
        fixture.clickYes();
        QTRY_COMPARE(fixture.calibration().step(), Step::Recording);
        QVERIFY(fixture.hasRecordedAll());
        fixture.click("armAction");
        QTRY_COMPARE(fixture.calibration().step(), Step::Recorded);
        QCOMPARE(fixture.raw(3, "position_offset"), 850); // nothing is written yet
        QVERIFY2(fixture.cell(2, Column::OffsetColumn).startsWith(QStringLiteral("850 → 14")),
                 qPrintable(fixture.cell(2, Column::OffsetColumn)));
        QCOMPARE(fixture.cell(4, Column::StateColumn), QStringLiteral("turns through a full turn"));
        QVERIFY(std::abs(bar(fixture, 4).now.value_or(-1) -
                         fixture.cell(4, Column::PositionColumn).toInt() / 4096.0) < 0.1);

        // The dot stays within a range of more than half a turn, wherever the recording ended.
        fixture.workbench().link().connection()->moveSimulatedServosByHand(true);
        const auto isAt = [&](double end) {
            return std::abs(bar(fixture, 0).now.value_or(-1) - end) < 0.1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isAt(bar(fixture, 0).low), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(isAt(bar(fixture, 0).high), 30'000);
        fixture.workbench().link().connection()->moveSimulatedServosByHand(false);

        fixture.click("armAction");
        fixture.clickYes();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.calibration().step(), Step::Idle, 60'000);
        // Between its stops at 100 and 285 degrees.
        QVERIFY(std::abs(fixture.raw(3, "position_offset") - 142) <= 3);
        QVERIFY(std::abs(fixture.raw(3, "min_angle_limit") - 996) <= 3);
        QCOMPARE(fixture.raw(3, "lock"), 1);
        QTRY_COMPARE(fixture.cell(2, Column::OffsetColumn),
                     QString::number(fixture.raw(3, "position_offset")));
        QVERIFY(fixture.isShown("6 joints written and read back"));
    }

    /// Before anything is written. A wheel is not calibrated, and need not be there.
    void aJointInAnotherModeIsSaid()
    {
        const support::RealTime realTime; // no reading may be missed
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("arm.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format": "servodesk-arm", "version": 1, "name": "two", "joints": [
                       {"name": "elbow", "id": 3, "kind": "limited"},
                       {"name": "wheel", "id": 9, "kind": "wheel"}]})");
        file.close();
        Fixture fixture(so101);
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& wire) {
            wire.servo(3)->poke(QStringLiteral("lock"), 0);
            wire.servo(3)->poke(QStringLiteral("operating_mode"), 1);
        });
        fixture.calibration().setArm(*jobs::loadArm(file.fileName()));
        fixture.click("armAction");
        fixture.clickYes();
        QTRY_VERIFY_WITH_TIMEOUT(fixture.calibration().joints().front().range.state ==
                                     base::JointState::Recorded,
                                 30'000);
        fixture.click("armAction");
        QTRY_COMPARE(fixture.calibration().step(), Step::Recorded);
        fixture.click("armAction");
        QVERIFY(questionSays(fixture, "elbow: Operating mode"));
        fixture.clickYes();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.raw(3, "operating_mode"), 0, 30'000);
    }

    void aCanceledRecordingChangesNothing()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.click("armAction");
        fixture.clickYes();
        QTRY_COMPARE(fixture.calibration().step(), Step::Recording);
        QTRY_VERIFY(fixture.find<QPushButton>("armCancel")->isVisible());
        QTRY_VERIFY(bar(fixture, 2).isRecorded);
        fixture.click("armCancel");
        QTRY_COMPARE(fixture.calibration().step(), Step::Idle);
        QTRY_VERIFY(!bar(fixture, 2).isRecorded);
        QCOMPARE(fixture.cell(2, Column::StateColumn), QString());
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(3, "position_offset"), 850);
    }

    /// The page comes back, and can begin again.
    void anEmergencyStopEndsIt()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.click("armAction");
        fixture.clickYes();
        QTRY_COMPARE(fixture.calibration().step(), Step::Recording);
        fixture.action(ui::Command::TorqueOffAll)->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.calibration().step(), Step::Idle, 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(fixture.find<QPushButton>("armAction")->isEnabled(), 30'000);
    }

    void lerobotsFileIsSavedComparedAndWritten()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("arm.json"));
        fixture.chooseFile("armFileSave", "armFileSaveDialog", path);
        QTRY_VERIFY(fixture.fileState().contains(QStringLiteral("equals the servos")));
        QVERIFY(!fixture.find<QPushButton>("armFileApply")->isEnabled());

        auto file = jobs::loadLerobotFile(path);
        QVERIFY(file);
        QCOMPARE(file->joints.size(), std::size_t(6));
        file->joints[0].calibration = {530, 866, 3231};
        QVERIFY(jobs::saveLerobotFile(*file, path));
        fixture.chooseFile("armFileSelect", "armFileDialog", path);
        QTRY_VERIFY(fixture.fileState().contains(QStringLiteral("differs from the servos")));
        QVERIFY(fixture.find<QLabel>("armFileDetails")
                    ->text()
                    .contains(QStringLiteral("shoulder_pan: offset is 530 in the file, 0 in the "
                                             "servo")));
        fixture.click("armFileApply");
        fixture.clickYes();
        QTRY_VERIFY_WITH_TIMEOUT(fixture.fileState().contains(QStringLiteral("equals the servos")),
                                 60'000);
        QCOMPARE(fixture.raw(1, "position_offset"), 530);
        QCOMPARE(fixture.raw(1, "max_angle_limit"), 3231);
        QCOMPARE(fixture.raw(3, "position_offset"), 850);
    }

    /// A joint that does not take a value has its old ones again: that is an error, and nothing
    /// is there to be undone.
    void aJointThatIsRolledBackIsAnError()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& wire) {
            sim::VirtualServo* servo = wire.servo(1);
            wire.config().faults.muteWhen = [servo](const sim::VirtualServo& asked) {
                if (&asked == servo && servo->raw(QStringLiteral("position_offset")) != 0)
                    servo->poke(QStringLiteral("position_offset"), 99);
                return false;
            };
        });
        bool hasError = false;
        connect(&fixture.workbench(), &session::Workbench::eventOccurred, this,
                [&](const session::Event& event) {
                    if (event.kind == session::Event::Kind::Written)
                        hasError = event.error.has_value();
                });
        fixture.calibration().writeFile({{QStringLiteral("shoulder_pan"), 1, 0, {530, 866, 3231}}});
        QTRY_COMPARE_WITH_TIMEOUT(fixture.calibration().step(), Step::Idle, 60'000);
        QTRY_VERIFY(fixture.isShown("Not all joints could be written: ID 1"));
        QVERIFY(hasError);
        QVERIFY(fixture.workbench().writes().undoStep() == nullptr);
        QCOMPARE(fixture.raw(1, "position_offset"), 0);
        QCOMPARE(fixture.raw(1, "max_angle_limit"), 4095);
    }

    /// Only this joint loses its torque and is written.
    void oneJointIsCalibratedAgain()
    {
        const support::RealTime realTime; // no reading may be missed
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        for (const int id : {1, 3})
            fixture.workbench().link().connection()->simulation()->with(
                [id](sim::VirtualBus& wire) {
                    wire.servo(id)->poke(QStringLiteral("torque_switch"), 1);
                });
        fixture.find<QTableView>("armTable")->selectRow(2);
        QCOMPARE(fixture.find<QPushButton>("armAction")->text(), QStringLiteral("Record 1 joint…"));
        fixture.click("armAction");
        QVERIFY(questionSays(fixture, "elbow_flex"));
        fixture.clickYes();
        QTRY_VERIFY_WITH_TIMEOUT(
            fixture.calibration().joints()[2].range.state == base::JointState::Recorded, 30'000);
        QCOMPARE(fixture.cell(1, Column::StateColumn), QString()); // it replies, and is left alone
        QCOMPARE(fixture.raw(3, "torque_switch"), 0);
        QCOMPARE(fixture.raw(1, "torque_switch"), 1);
        fixture.click("armAction");
        QTRY_COMPARE(fixture.calibration().step(), Step::Recorded);
        fixture.click("armAction");
        fixture.clickYes();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.calibration().step(), Step::Idle, 60'000);
        QVERIFY(fixture.raw(3, "position_offset") != 850);
        QCOMPARE(fixture.raw(1, "max_angle_limit"), 4095);
        QCOMPARE(fixture.raw(1, "torque_switch"), 1);
        QVERIFY(!bar(fixture, 2).isRecorded);

        QTRY_VERIFY(fixture.action(ui::Command::Undo)->isEnabled());
        fixture.action(ui::Command::Undo)->trigger();
        fixture.clickYes();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.raw(3, "position_offset"), 850, 30'000);
        QTRY_COMPARE(fixture.raw(3, "max_angle_limit"), 4095);
        QTRY_COMPARE(fixture.cell(2, Column::OffsetColumn), QStringLiteral("850"));
    }

    /// Its stops lie within the limits that it comes with; within its range it gets to both ends.
    void aJointIsTested()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.find<QTableView>("armTable")->selectRow(5);
        fixture.click("armTest");
        QCOMPARE(fixture.calibration().step(), Step::Idle); // nothing moves before the answer
        QVERIFY(questionSays(fixture, "Not calibrated, so these run into their mechanical stops: "
                                      "gripper."));
        fixture.clickYes();
        QTRY_COMPARE(fixture.calibration().step(), Step::Testing);
        QTRY_COMPARE_WITH_TIMEOUT(fixture.cell(5, Column::StateColumn),
                                  QStringLiteral("end not reached"), 60'000);
        QTRY_COMPARE(fixture.calibration().step(), Step::Idle);
        QTRY_VERIFY(fixture.isShown("Not at both ends: gripper"));
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& wire) {
            wire.servo(6)->poke(QStringLiteral("lock"), 0);
            wire.servo(6)->poke(QStringLiteral("min_angle_limit"), 2000);
            wire.servo(6)->poke(QStringLiteral("max_angle_limit"), 2400);
        });
        QTRY_COMPARE(fixture.cell(5, Column::MaxColumn), QStringLiteral("2400"));
        fixture.click("armTest");
        QVERIFY(questionSays(fixture, "The arm moves"));
        QVERIFY(!questionSays(fixture, "Not calibrated"));
        fixture.clickYes();
        QTRY_COMPARE_WITH_TIMEOUT(fixture.cell(5, Column::StateColumn),
                                  QStringLiteral("reached both ends"), 60'000);
        QTRY_VERIFY(fixture.isShown("1 joint reached both ends."));
        QCOMPARE(fixture.raw(6, "torque_switch"), 0);
        QCOMPARE(fixture.raw(6, "torque_limit"), 1000);
        QTRY_COMPARE(fixture.cell(5, Column::PositionColumn).toLongLong(),
                     fixture.raw(6, "present_position"));
    }

    /// As with every other motion: torque has to be turned on by the user first.
    void nothingMovesAfterAnEmergencyStop()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.action(ui::Command::TorqueOffAll)->trigger();
        QVERIFY(fixture.waitUntilIdle());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.calibration().canStart(), 30'000);
        const auto before = fixture.raw(6, "goal_position");
        fixture.calibration().startMoveTest(30, {5});
        QTRY_COMPARE_WITH_TIMEOUT(fixture.calibration().step(), Step::Idle, 30'000);
        QCOMPARE(fixture.raw(6, "torque_switch"), 0);
        QCOMPARE(fixture.raw(6, "goal_position"), before);
        QVERIFY(!fixture.calibration().joints()[5].test);
    }

    /// Afterwards LeRobot has nothing to change, and the page says nothing of it.
    void theServosArePreparedForLerobot()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        auto* remarks = fixture.find<QLabel>("armRemarks");
        QTRY_VERIFY(remarks->text().contains(QStringLiteral("at its next start")));
        fixture.click("armPrepare");
        QVERIFY(questionSays(fixture, "gripper: Position loop P 32 → 16, Maximum torque"));
        fixture.clickYes();
        QTRY_VERIFY_WITH_TIMEOUT(!remarks->isVisible(), 60'000);
        QCOMPARE(fixture.raw(6, "max_torque"), 500);
        QCOMPARE(fixture.raw(1, "position_p"), 16);
        QVERIFY(!fixture.find<QPushButton>("armPrepare")->isEnabled());
        QTRY_VERIFY(fixture.isShown("6 joints written and read back."));
    }

    void whatLerobotRefusesIsSaid()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2+firmware-minor=9,sts3250@3"));
        auto* remarks = fixture.find<QLabel>("armRemarks");
        QTRY_VERIFY(remarks->text().contains(QStringLiteral("elbow_flex (ID 3) has the model "
                                                            "STS3250")));
        QVERIFY(remarks->text().contains(QStringLiteral("firmware versions differ")));
    }

    /// What it says about many joints scrolls where there is no room for it: nothing is cut, and
    /// the joints stay in view.
    void manyRemarksScrollBesideTheJoints()
    {
        Fixture fixture(QStringLiteral("sim:demo"));
        fixture.window->resize(1024, 700);
        auto* remarks = fixture.find<QLabel>("armRemarks");
        QTRY_VERIFY(remarks->text().contains(
            QStringLiteral("wrist_roll (ID 5), gripper (ID 6): LeRobot expects other models")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("arm.json"));
        jobs::LerobotFile file;
        for (int id = 1; id <= 6; ++id)
            file.joints.push_back(
                {.name = fixture.calibration().joints()[std::size_t(id) - 1].joint.name,
                 .id = id,
                 .calibration = {500 + id, 800 + id, 3000 + id}});
        QVERIFY(jobs::saveLerobotFile(file, path));
        fixture.chooseFile("armFileSelect", "armFileDialog", path);
        auto* details = fixture.find<QLabel>("armFileDetails");
        QTRY_VERIFY(details->text().count(QLatin1Char('\n')) > 10);
        const auto* table = fixture.find<QTableView>("armTable");
        for (const QLabel* label : {remarks, details})
            QTRY_VERIFY(label->height() >= label->heightForWidth(label->width()));
        QVERIFY(table->viewport()->height() >= 3 * table->rowHeight(0));
        QCOMPARE(fixture.window->size(), QSize(1024, 700));
    }

    /// And is there again at the next start.
    void theArmIsEditedAndRemembered()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("my-arm.json"));
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        fixture.click("armEdit");
        auto* table = fixture.find<QTableWidget>("armDialogTable");
        table->item(5, 0)->setText(QStringLiteral("elbow_flex"));
        QVERIFY(fixture.find<QLabel>("armDialogProblem")
                    ->text()
                    .contains(QStringLiteral("Two joints have the name elbow_flex")));
        QVERIFY(!fixture.find<QPushButton>("armDialogSave")->isEnabled());
        table->item(5, 0)->setText(QStringLiteral("claw"));
        table->item(5, 4)->setCheckState(Qt::Checked);
        fixture.click("armDialogAdd");
        QCOMPARE(table->item(6, 1)->data(Qt::EditRole).toInt(), 7);
        QVERIFY(!fixture.find<QPushButton>("armDialogSave")->isEnabled()); // it has no name yet
        table->setCurrentCell(6, 1);
        fixture.click("armDialogRemove");
        table->selectRow(0);
        fixture.click("armDialogRemove");
        fixture.chooseFile("armDialogSave", "armDialogSaveDialog", path);
        QTRY_COMPARE(fixture.calibration().joints().size(), std::size_t(5));
        const jobs::Joint& claw = fixture.calibration().joints().back().joint;
        QCOMPARE(claw.name, QStringLiteral("claw"));
        QCOMPARE(claw.id, 6);
        QVERIFY(claw.isReversed);
        QCOMPARE(claw.kind, base::JointKind::Gripper);
        QVERIFY(fixture.find<QComboBox>("armChoice")
                    ->currentText()
                    .contains(QStringLiteral("my-arm.json")));
        QCOMPARE(fixture.settings.pageValue(QStringLiteral("arm/arm"), QString()).toString(), path);
        ui::ArmPage again(fixture.context, fixture.settings);
        QCOMPARE(fixture.calibration().joints().size(), std::size_t(5));
        QVERIFY(again.findChild<QComboBox*>(QStringLiteral("armChoice"))
                    ->currentText()
                    .contains(QStringLiteral("my-arm.json")));
    }

    void aNewArmIsMade()
    {
        const QTemporaryDir folder;
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        auto* arms = fixture.find<QComboBox>("armChoice");
        arms->setCurrentIndex(arms->count() - 1);
        Q_EMIT arms->activated(arms->count() - 1);
        QVERIFY(!fixture.find<QPushButton>("armDialogSave")->isEnabled()); // it has no joint
        fixture.click("armDialogAdd");
        fixture.find<QTableWidget>("armDialogTable")->item(0, 0)->setText(QStringLiteral("head"));
        fixture.chooseFile("armDialogSave", "armDialogSaveDialog",
                           folder.filePath(QStringLiteral("head.json")));
        QTRY_COMPARE(fixture.calibration().joints().size(), std::size_t(1));
        QTRY_COMPARE(fixture.cell(0, Column::JointColumn), QStringLiteral("head"));
        QCOMPARE(arms->currentText(), QStringLiteral("head.json"));
        QTRY_COMPARE(fixture.calibration().joints().front().held->rangeMax, 4095);
    }

    /// The page comes with the default one.
    void aLostArmFileIsSaid()
    {
        Fixture fixture(so101);
        fixture.settings.setPageValue(QStringLiteral("arm/arm"),
                                      QStringLiteral("/nowhere/my-arm.json"));
        ui::ArmPage again(fixture.context, fixture.settings);
        QVERIFY(!again.findChildren<ui::Banner*>().front()->isHidden());
        QCOMPARE(again.findChild<QComboBox*>(QStringLiteral("armChoice"))->currentText(),
                 QStringLiteral("SO-100/SO-101"));
    }

    void aBrokenFileIsSaid()
    {
        Fixture fixture(so101);
        QVERIFY(fixture.hasReadAll());
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("broken.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"shoulder_pan\": 3}");
        file.close();
        fixture.chooseFile("armFileSelect", "armFileDialog", file.fileName());
        QVERIFY(fixture.isShown("broken.json"));
    }
};

SERVODESK_TEST(TestArmPage)
#include "tst_arm_page.moc"
