// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli arm: an SO-101 calibrated by moving, LeRobot's file compared, written to the servos
// and saved from them, and what LeRobot would refuse. Two calibrations run in real time (9 s).
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

using support::CliProgram;
using support::SimProgram;
using support::words;

namespace {
QJsonObject jointOf(const support::ProgramResult& result, const char* name)
{
    const QJsonArray joints = result.json()[QLatin1String("joints")].toArray();
    for (const QJsonValue& joint : joints) {
        if (joint[QLatin1String("name")].toString() == QLatin1String(name))
            return joint.toObject();
    }
    return {};
}

QString write(const CliProgram& cli, const QJsonObject& calibration)
{
    QFile file(cli.dataFolder() + QStringLiteral("/so101.json"));
    if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(calibration).toJson()) < 0)
        qFatal("no file");
    return file.fileName();
}

QJsonObject joint(int id, int offset, int min, int max)
{
    return {{QStringLiteral("id"), id},
            {QStringLiteral("drive_mode"), 0},
            {QStringLiteral("homing_offset"), offset},
            {QStringLiteral("range_min"), min},
            {QStringLiteral("range_max"), max}};
}

QJsonObject wholeArm()
{
    return {{QStringLiteral("shoulder_pan"), joint(1, 530, 866, 3231)},
            {QStringLiteral("shoulder_lift"), joint(2, -1407, 1000, 3000)},
            {QStringLiteral("elbow_flex"), joint(3, 2047, 900, 3100)},
            {QStringLiteral("wrist_flex"), joint(4, 0, 800, 3200)},
            {QStringLiteral("wrist_roll"), joint(5, 77, 0, 4095)},
            {QStringLiteral("gripper"), joint(6, -2047, 2031, 3476)}};
}

bool isNear(const QJsonValue& value, double expected)
{
    return std::abs(value.toDouble(1e9) - expected) <= 3;
}
} // namespace

class TestCliArm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theArmIsShown()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const auto result = cli.run(words("arm show --json"));
        QCOMPARE(result.exit, 0);
        QCOMPARE(result.json()[QLatin1String("joints")].toArray().size(), 6);
        const QJsonObject elbow = jointOf(result, "elbow_flex");
        QCOMPARE(elbow[QLatin1String("id")].toInt(), 3);
        QCOMPARE(elbow[QLatin1String("homing_offset")].toInt(), 850);
        QCOMPARE(elbow[QLatin1String("range_max")].toInt(), 4095);
        // As new from the factory.
        const QJsonArray remarks = result.json()[QLatin1String("remarks")].toArray();
        QCOMPARE(remarks.size(), 1);
        QVERIFY(remarks[0].toString().contains(QStringLiteral("servodesk-cli arm prepare")));
    }

    /// LeRobot refuses such a bus.
    void whatLerobotRefusesIsNamed()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@2+firmware-minor=9,sts3250@3,sts3215@4,"
                                   "sts3215@5"));
        const auto result = cli.run(words("arm show"));
        QCOMPARE(result.exit, 4);
        for (const char* remark :
             {"elbow_flex (ID 3) has the model STS3250; LeRobot expects STS3215",
              "No reply from gripper (ID 6)", "The firmware versions differ"})
            QVERIFY2(result.out.contains(QLatin1String(remark)), qPrintable(result.out));
        QCOMPARE(cli.run(words("arm calibrate --yes --seconds 1")).exit, 4);
    }

    /// What LeRobot writes at each start; then it has nothing to change.
    void theServosArePrepared()
    {
        CliProgram cli;
        cli.setServos(QStringLiteral("so101"));
        const auto planned = cli.run(words("arm prepare --dry-run"));
        QCOMPARE(planned.exit, 0);
        QVERIFY2(planned.out.contains(QStringLiteral("position_p 32 → 16, max_torque 1000 → 500")),
                 qPrintable(planned.out));
        QVERIFY(cli.run(words("arm prepare")).exit != 0); // without an answer
        QVERIFY(!cli.run(words("arm show --json"))
                     .json()[QLatin1String("remarks")]
                     .toArray()
                     .isEmpty());
        QCOMPARE(cli.run(words("arm prepare --yes")).exit, 0);
        QVERIFY(
            cli.run(words("arm show --json")).json()[QLatin1String("remarks")].toArray().isEmpty());
        const auto again = cli.run(words("arm prepare")); // nothing to ask about
        QVERIFY2(again.exit == 0 && again.out.contains(QStringLiteral("none")),
                 qPrintable(again.out));
    }

    /// Its stops are within the limits 0 to 4095 that it comes with.
    void theJointsAreTested()
    {
        CliProgram cli;
        SimProgram sim(words("--preset so101"));
        cli.setPort(sim.port());
        QVERIFY(cli.run(words("arm test --joint gripper")).exit != 0); // without an answer
        QCOMPARE(cli.run(words("arm test --yes --torque 101")).exit, 2);
        const auto stopped = cli.run(words("arm test --joint gripper --yes --json"));
        QCOMPARE(stopped.exit, 1);
        QCOMPARE(jointOf(stopped, "gripper")[QLatin1String("result")].toString(),
                 QStringLiteral("not-reached"));
        QCOMPARE(cli.run(words("write 6 min_angle_limit=2000 max_angle_limit=2400")).exit, 0);
        const auto reached = cli.run(words("arm test --joint gripper --yes --json"));
        QVERIFY2(reached.exit == 0, qPrintable(reached.out + reached.err));
        QCOMPARE(jointOf(reached, "gripper")[QLatin1String("result")].toString(),
                 QStringLiteral("reached"));
        QCOMPARE(cli.run(words("read 6 torque_switch --json"))
                     .json()[QLatin1String("registers")][0][QLatin1String("raw")]
                     .toInt(),
                 0);
    }

    void whatEndsATestIsNamedWithItsJoint()
    {
        CliProgram cli;
        cli.setServos(QStringLiteral("sts3215@6"));
        QFile arm(cli.dataFolder() + QStringLiteral("/arm.json"));
        QVERIFY(arm.open(QIODevice::WriteOnly));
        arm.write(R"({"format": "servodesk-arm", "version": 1, "name": "claw",
                      "joints": [{"name": "gripper", "id": 6, "kind": "gripper"}]})");
        arm.close();
        QCOMPARE(cli.run(words("mode 6 speed")).exit, 0);
        const QStringList test{QStringLiteral("arm"), QStringLiteral("test"),
                               QStringLiteral("--yes"), QStringLiteral("--arm"), arm.fileName()};
        const auto text = cli.run(test);
        QCOMPARE(text.exit, 2); // as of a sweep test
        QVERIFY2(text.out.contains(QStringLiteral("gripper")) &&
                     text.err.contains(QStringLiteral("position mode")),
                 qPrintable(text.out + text.err));
        const auto json = cli.run(test + words("--json"));
        QCOMPARE(json.exit, 2);
        QCOMPARE(jointOf(json, "gripper")[QLatin1String("error")][QLatin1String("id")].toInt(), 6);
    }

    /// The pose at the end reads 2047, so the range need not lie around it.
    void thePoseAtTheEndBecomesTheMiddle()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const auto result = cli.run(words("arm calibrate --yes --seconds 1.6 --dry-run --json "
                                          "--middle-here --joint gripper"));
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        const QJsonObject gripper = jointOf(result, "gripper");
        const double middle = (gripper[QLatin1String("range_min")].toDouble() +
                               gripper[QLatin1String("range_max")].toDouble()) /
                              2;
        // From 1.5 to 2.4 s the hand is far from the middle.
        QVERIFY2(std::abs(middle - 2047) > 100, QByteArray::number(middle));
        QVERIFY(gripper[QLatin1String("range_min")].toDouble() <= 2047);
        QVERIFY(gripper[QLatin1String("range_max")].toDouble() > 2047);
    }

    /// Stops at 35° and 250°, 250° and 450° (through the seam), 100° and 285° (with an old offset).
    void theMiddlesOfTheRangesAreFound()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const auto result = cli.run(words("arm calibrate --yes --seconds 5 --json"));
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        const auto steps = [](double degrees) { return degrees * 4096 / 360; };
        const QJsonObject pan = jointOf(result, "shoulder_pan");
        QVERIFY(isNear(pan[QLatin1String("homing_offset")], steps(142.5) - 2048));
        QVERIFY(isNear(pan[QLatin1String("range_min")], 2048 - steps(107.5)));
        QVERIFY(isNear(pan[QLatin1String("range_max")], 2048 + steps(107.5)));
        const QJsonObject lift = jointOf(result, "shoulder_lift");
        QVERIFY(isNear(lift[QLatin1String("homing_offset")], steps(350) - 2048));
        QVERIFY(isNear(lift[QLatin1String("range_min")], 2048 - steps(100)));
        const QJsonObject elbow = jointOf(result, "elbow_flex");
        QVERIFY(isNear(elbow[QLatin1String("homing_offset")], steps(192.5) - 2048));
        QCOMPARE(jointOf(result, "wrist_roll")[QLatin1String("state")].toString(),
                 QStringLiteral("full-turn"));
        for (const QJsonValue& servo : result.json()[QLatin1String("servos")].toArray())
            QVERIFY(servo[QLatin1String("verdict")].toString() == QLatin1String("done") ||
                    servo[QLatin1String("id")].toInt() == 5);
    }

    void aDryRunShowsThePlan()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const auto result =
            cli.run(words("arm calibrate --yes --seconds 4 --dry-run --joint elbow_flex"));
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        static const QRegularExpression plan(
            QStringLiteral("elbow_flex +3 +18[45]°, range recorded +850 → 14\\d +0 → 99\\d"));
        QVERIFY2(plan.match(result.out).hasMatch(), qPrintable(result.out));
        QVERIFY(result.out.contains(QStringLiteral("would be written")));
        QVERIFY(!result.out.contains(QStringLiteral("gripper")));
        QCOMPARE(cli.run(words("arm calibrate --yes --seconds 1 --joint knee")).exit, 2);
    }

    /// What was not moved keeps its values, and the command fails.
    void aJointThatWasNotMovedIsNotWritten()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const auto result = cli.run(words("arm calibrate --yes --seconds 0.05 --json"));
        QCOMPARE(result.exit, 1);
        QVERIFY2(result.err.contains(QStringLiteral("range of this joint is not known")),
                 qPrintable(result.err));
        QVERIFY(jointOf(result, "gripper")[QLatin1String("homing_offset")].isNull());
    }

    void nothingHappensWithoutAnswer()
    {
        CliProgram cli;
        SimProgram sim(words("--preset so101"));
        cli.setPort(sim.port());
        QCOMPARE(cli.run(words("torque 1 on")).exit, 0);
        const auto result = cli.run(words("arm calibrate"));
        QVERIFY(result.exit != 0);
        QVERIFY2(result.err.contains(QStringLiteral("hold it")), qPrintable(result.err));
        QCOMPARE(cli.run(words("read 1 torque_switch --json"))
                     .json()[QLatin1String("registers")][0][QLatin1String("raw")]
                     .toInt(),
                 1);
    }

    void aFileIsComparedAndWritten()
    {
        CliProgram cli;
        cli.setServos(QStringLiteral("so101"));
        const QString path = write(cli, wholeArm());
        const QStringList compare = words("arm compare --json") << path;
        const QStringList apply = words("arm apply --yes") << path;
        const auto before = cli.run(compare);
        QCOMPARE(before.exit, 1);
        QCOMPARE(before.json()[QLatin1String("differences")][0][QLatin1String("joint")].toString(),
                 QStringLiteral("shoulder_pan"));
        const auto planned = cli.run(apply + words("--dry-run"));
        QCOMPARE(planned.exit, 0);
        QVERIFY2(planned.out.contains(QStringLiteral("0 → 530")), qPrintable(planned.out));
        QCOMPARE(cli.run(compare).exit, 1);
        const auto applied = cli.run(apply);
        QVERIFY2(applied.exit == 0, qPrintable(applied.out + applied.err));
        const auto after = cli.run(compare);
        QVERIFY2(after.exit == 0, qPrintable(after.out));
        QVERIFY(after.json()[QLatin1String("equal")].toBool());

        // What is exported is what LeRobot finds; keys of others stay.
        QJsonObject foreign = wholeArm();
        QJsonObject pan = joint(1, 1, 2, 3);
        pan[QLatin1String("norm_mode")] = 2;
        pan[QLatin1String("drive_mode")] = 1;
        foreign[QLatin1String("shoulder_pan")] = pan;
        write(cli, foreign);
        QCOMPARE(cli.run(words("arm export") << path).exit, 0);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject exported = QJsonDocument::fromJson(file.readAll()).object();
        const QJsonObject saved = exported[QLatin1String("shoulder_pan")].toObject();
        QCOMPARE(saved[QLatin1String("homing_offset")].toInt(), 530);
        QCOMPARE(saved[QLatin1String("norm_mode")].toInt(), 2);
        QCOMPARE(saved[QLatin1String("drive_mode")].toInt(), 1);
        QCOMPARE(exported[QLatin1String("gripper")], wholeArm()[QLatin1String("gripper")]);
    }

    /// An offset of another kind of servo: nothing at all is written.
    void aValueThatDoesNotFitIsNotWritten()
    {
        CliProgram cli;
        cli.setServos(QStringLiteral("so101"));
        QJsonObject calibration = wholeArm();
        calibration[QLatin1String("gripper")] = joint(6, 30'000, 2031, 3476);
        const auto before = cli.run(words("arm show --json"));
        const auto result = cli.run(words("arm apply --yes") << write(cli, calibration));
        QVERIFY2(result.exit != 0, qPrintable(result.out + result.err));
        QVERIFY2(result.err.contains(QStringLiteral("cannot hold")), qPrintable(result.err));
        QCOMPARE(cli.run(words("arm show --json")).json()[QLatin1String("joints")],
                 before.json()[QLatin1String("joints")]);
        calibration.remove(QLatin1String("gripper"));
        const auto missing = cli.run(words("arm apply --yes") << write(cli, calibration));
        QCOMPARE(missing.exit, 2);
        QVERIFY(missing.err.contains(QStringLiteral("gripper")));
        QCOMPARE(cli.run(words("arm compare nothing.json")).exit, 5);
        // Without an answer nothing is written either.
        QVERIFY(cli.run(words("arm apply") << write(cli, wholeArm())).exit != 0);
        QCOMPARE(cli.run(words("arm show --json")).json()[QLatin1String("joints")],
                 before.json()[QLatin1String("joints")]);
        // LeRobot counts joints of another arm as well.
        QJsonObject more = wholeArm();
        more[QLatin1String("wheel")] = joint(9, 0, 0, 4095);
        QCOMPARE(cli.run(words("arm compare") << write(cli, more)).exit, 1);
        QVERIFY(cli.run(words("arm export") << write(cli, more)).exit != 0);
    }

    void anArmOfOnesOwnIsUsed()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:so101"));
        const QString path = cli.dataFolder() + QStringLiteral("/arm.json");
        QCOMPARE(cli.run(words("arm export --format arm") << path).exit, 0);
        const auto result = cli.run(words("arm show --json --arm") << path);
        QCOMPARE(result.exit, 0);
        QCOMPARE(result.json()[QLatin1String("joints")].toArray().size(), 6);
        QVERIFY(cli.run(words("arm export --format arm") << write(cli, wholeArm())).exit != 0);
        QCOMPARE(cli.run(words("arm show --arm so1000")).exit, 2);
        QCOMPARE(cli.run(words("arm calibrate --yes")).exit, 2); // for how long?
        QCOMPARE(cli.run(words("arm show --arm missing.json")).exit, 5);
    }
};

SERVODESK_GUILESS_TEST(TestCliArm)
#include "tst_cli_arm.moc"
