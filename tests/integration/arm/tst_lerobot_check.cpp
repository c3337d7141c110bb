// SPDX-License-Identifier: GPL-3.0-or-later
// What LeRobot finds at its next start: other models and firmware, open locks, settings that it
// would write, and a file that differs. Its settings stand here as its source has them; once they
// are written, nothing is left to be written.
#include "jobs/arm/joint_access.h"
#include "jobs/arm/lerobot_check.h"
#include "jobs/arm/lerobot_settings.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QtTest>

using base::ArmRemarkKind;
using base::JointKind;
using support::SimFixture;

namespace {
/// The joints 1, 2 … of a bus, as read; 0 stands for one that does not reply.
class Arm {
public:
    Arm(SimFixture& fixture, const std::vector<JointKind>& kinds)
    {
        m_servos.reserve(kinds.size());
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            m_servos.push_back(fixture.servo(int(i) + 1));
            if (!jobs::readJoint(fixture.context(), m_servos.back()))
                qFatal("not readable");
            joints.push_back({{QStringLiteral("joint%1").arg(i + 1), int(i) + 1,
                               QStringLiteral("STS3215"), kinds[i], false},
                              &m_servos.back()});
        }
    }
    std::vector<jobs::JointServo> joints;

private:
    std::vector<device::Servo> m_servos;
};

QList<ArmRemarkKind> kindsOf(const std::vector<base::ArmRemark>& remarks)
{
    QList<ArmRemarkKind> kinds;
    for (const base::ArmRemark& one : remarks)
        kinds << one.kind;
    return kinds;
}

void prepare(SimFixture& fixture, const Arm& arm)
{
    std::vector<snapshot::Snapshot> templates;
    for (const jobs::JointServo& one : arm.joints)
        templates.push_back(
            jobs::jointTemplate(*one.servo, one.lerobotSettings(), QStringLiteral("test")));
    for (const jobs::ApplyResult& one : jobs::writeJoints(fixture.context(), templates, {}))
        QVERIFY(one.verdict == jobs::ApplyVerdict::Done);
}
} // namespace

class TestLerobotCheck : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /// so_follower.py, lekiwi.py and feetech.py, by register.
    void theSettingsAreThoseThatLerobotWrites_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QMap<QString, int>>("registers");
        QMap<QString, int> joint{
            {QStringLiteral("return_delay"), 0}, {QStringLiteral("operating_mode"), 0},
            {QStringLiteral("position_p"), 16},  {QStringLiteral("position_i"), 0},
            {QStringLiteral("position_d"), 32},  {QStringLiteral("phase"), 12}};
        QTest::newRow("joint") << int(JointKind::Limited) << joint;
        QTest::newRow("continuous") << int(JointKind::Continuous) << joint;
        QMap<QString, int> gripper = joint;
        gripper[QStringLiteral("max_torque")] = 500;
        gripper[QStringLiteral("protection_current")] = 250;
        gripper[QStringLiteral("overload_torque")] = 25;
        QTest::newRow("gripper") << int(JointKind::Gripper) << gripper;
        QTest::newRow("wheel") << int(JointKind::Wheel)
                               << QMap<QString, int>{{QStringLiteral("return_delay"), 0},
                                                     {QStringLiteral("operating_mode"), 1},
                                                     {QStringLiteral("phase"), 12}};
    }
    void theSettingsAreThoseThatLerobotWrites()
    {
        QFETCH(int, kind);
        using Registers = QMap<QString, int>;
        QFETCH(Registers, registers);
        SimFixture fixture(QStringLiteral("sts3215@1"));
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("return_delay"), 250);
        fixture.poke(1, QStringLiteral("position_i"), 9);
        fixture.poke(1, QStringLiteral("phase"), 12 | 16);
        const Arm arm(fixture, {JointKind(kind)});
        QCOMPARE(kindsOf(jobs::lerobotRemarks(arm.joints)),
                 (QList{ArmRemarkKind::OpenLock, ArmRemarkKind::OtherSettings}));
        const int untouchedI = kind == int(JointKind::Wheel) ? 9 : 0;
        prepare(fixture, arm);
        for (auto one = registers.cbegin(); one != registers.cend(); ++one)
            QCOMPARE(fixture.raw(1, one.key()), std::int64_t(one.value()));
        QCOMPARE(fixture.raw(1, QStringLiteral("position_i")), std::int64_t(untouchedI));
        if (kind != int(JointKind::Gripper))
            QCOMPARE(fixture.raw(1, QStringLiteral("max_torque")), std::int64_t(1000));
        QVERIFY(jobs::lerobotRemarks(Arm(fixture, {JointKind(kind)}).joints).empty());
    }

    /// so_leader.py: neither gains nor gripper limits.
    void aLeaderKeepsItsGains()
    {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        Arm arm(fixture, {JointKind::Gripper});
        arm.joints.front().isLeader = true;
        QVERIFY(jobs::lerobotRemarks(arm.joints).empty());
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("operating_mode"), 3);
        Arm inStepMode(fixture, {JointKind::Gripper});
        inStepMode.joints.front().isLeader = true;
        QVERIFY(!jobs::lerobotRemarks(inStepMode.joints).empty());
    }

    void jointsWithTheLimitsOfTheWholeTurnAreNamed()
    {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2,sts3215@3"));
        fixture.poke(3, QStringLiteral("lock"), 0);
        fixture.poke(3, QStringLiteral("max_angle_limit"), 4000);
        const Arm arm(fixture, {JointKind::Limited, JointKind::Continuous, JointKind::Limited});
        QCOMPARE(jobs::uncalibratedJoints(arm.joints), QStringList(QStringLiteral("joint1")));
    }

    void otherModelsFirmwareAndSilenceAreNamed()
    {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2+firmware-minor=9,sts3250@3"));
        Arm arm(fixture, {JointKind::Limited, JointKind::Limited, JointKind::Limited});
        prepare(fixture, arm);
        Arm now(fixture, {JointKind::Limited, JointKind::Limited, JointKind::Limited});
        now.joints.push_back({{QStringLiteral("gripper"), 6}, nullptr});
        const auto remarks = jobs::lerobotRemarks(now.joints);
        QCOMPARE(kindsOf(remarks), (QList{ArmRemarkKind::OtherModel, ArmRemarkKind::NoReply,
                                          ArmRemarkKind::OtherFirmware}));
        QCOMPARE(remarks[0].joints, QStringList(QStringLiteral("joint3 (ID 3)")));
        QCOMPARE(remarks[0].model, QStringLiteral("STS3250"));
        QCOMPARE(remarks[1].joints, QStringList(QStringLiteral("gripper (ID 6)")));
    }

    /// It has no table for them.
    void otherFamiliesHaveNoSettings()
    {
        SimFixture fixture(QStringLiteral("hls3625@1,scs15@2"));
        const Arm arm(fixture, {JointKind::Limited, JointKind::Gripper});
        for (const jobs::JointServo& one : arm.joints)
            QVERIFY(one.lerobotSettings().empty());
    }

    void aFileIsComparedByNameAndId()
    {
        SimFixture fixture(QStringLiteral("sts3215@1,sts3215@2,sts3215@3"));
        const Arm arm(fixture, {JointKind::Limited, JointKind::Limited, JointKind::Limited});
        jobs::LerobotFile file;
        file.joints = {{QStringLiteral("joint1"), 1, 0, {0, 0, 4095}},
                       {QStringLiteral("joint2"), 2, 0, {-5, 0, 4000}},
                       {QStringLiteral("joint3"), 7, 0, {0, 0, 4095}},
                       {QStringLiteral("other"), 9, 0, {0, 0, 4095}}};
        const auto found = jobs::differences(arm.joints, file);
        QCOMPARE(found.size(), std::size_t(4));
        const auto isEqual = [&](std::size_t row, const char* joint, const char* key,
                                 std::optional<int> inFile, std::optional<int> inServo) {
            return found[row].joint == QLatin1String(joint) &&
                   found[row].key == QLatin1String(key) && found[row].inFile == inFile &&
                   found[row].inServo == inServo;
        };
        QVERIFY(isEqual(0, "joint2", "homing_offset", -5, 0));
        QVERIFY(isEqual(1, "joint2", "range_max", 4000, 4095));
        QVERIFY(isEqual(2, "joint3", "id", 7, 3));
        QVERIFY(isEqual(3, "other", "id", 9, {}));
    }
};

SERVODESK_GUILESS_TEST(TestLerobotCheck)
#include "tst_lerobot_check.moc"
