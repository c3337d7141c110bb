// SPDX-License-Identifier: GPL-3.0-or-later
// Which values a servo keeps and loses, and the content of its table.
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

using fixture::Servo;

class TestServoMemory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void lockedWriteIsLostUnlockedIsKept_data();
    void lockedWriteIsLostUnlockedIsKept();
    void lockClosesAtPowerOn_data();
    void lockClosesAtPowerOn();
    void lockAddressOfTheOtherFamilyOverwritesData();
    void lockAddressOfStsIsUnusedOnScs();
    void unlockingAfterwardsSavesNothing();
    void readOnlyRegistersIgnoreWrites();
    void undefinedBytesReadZero();
    void oneByteOfAWordCanBeWritten();
    void wordsFollowTheFamilysByteOrder_data();
    void wordsFollowTheFamilysByteOrder();
    void torqueLimitComesFromMaximumTorque();
    void powerOnRestoresRam();
    void turnsAreForgottenAtPowerOff();
    void unresponsiveOnlyDuringEpromWrites_data();
    void unresponsiveOnlyDuringEpromWrites();
    void busyOnlyDuringEpromWrites_data();
    void busyOnlyDuringEpromWrites();
    void leRobotWritesAreAccepted_data();
    void leRobotWritesAreAccepted();
    void identityAndFactoryValues_data();
    void identityAndFactoryValues();
    void imageHasEpromAndBackup();
    void foreignImagesAreRefused_data();
    void foreignImagesAreRefused();
    void restoreReturnsTheBackup();
    void restoreWithoutBackupIsTheFactory();
    void restoreBehindAClosedLockDoesNothing();
};

void TestServoMemory::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

namespace {
void addFamilyRows()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("lockAddress");
    QTest::newRow("STS") << QStringLiteral("STS3215") << 55;
    QTest::newRow("SMS") << QStringLiteral("SM40BLHV") << 55;
    QTest::newRow("SCS") << QStringLiteral("SCS15") << 48;
}
} // namespace

void TestServoMemory::lockedWriteIsLostUnlockedIsKept_data()
{
    addFamilyRows();
}

void TestServoMemory::lockedWriteIsLostUnlockedIsKept()
{
    QFETCH(QString, model);
    QFETCH(int, lockAddress);
    Servo servo(model);
    const int before = servo.at("max_temperature");

    QVERIFY(servo.write({13, 61})); // locked: acknowledged, acts
    QCOMPARE(servo.at("max_temperature"), 61);
    servo.powerCycle();
    QCOMPARE(servo.at("max_temperature"), before);

    QVERIFY(servo.write({std::uint8_t(lockAddress), 0}));
    QVERIFY(servo.write({13, 61}));
    servo.powerCycle();
    QCOMPARE(servo.at("max_temperature"), 61);
}

void TestServoMemory::lockClosesAtPowerOn_data()
{
    addFamilyRows();
}

void TestServoMemory::lockClosesAtPowerOn()
{
    QFETCH(QString, model);
    QFETCH(int, lockAddress);
    Servo servo(model);
    QCOMPARE(servo.read(std::uint8_t(lockAddress), 1), base::Bytes{1});
    servo.write({std::uint8_t(lockAddress), 0});
    QCOMPARE(servo.read(std::uint8_t(lockAddress), 1), base::Bytes{0});
    servo.powerCycle();
    QCOMPARE(servo.read(std::uint8_t(lockAddress), 1), base::Bytes{1});
}

void TestServoMemory::lockAddressOfTheOtherFamilyOverwritesData()
{
    Servo servo(QStringLiteral("STS3215"));
    QCOMPARE(servo.at("torque_limit"), 1000);
    QVERIFY(servo.write({48, 0}));
    QCOMPARE(servo.at("torque_limit"), 768);
    QVERIFY(servo.write({48, 1}));
    QCOMPARE(servo.at("torque_limit"), 769);
    QCOMPARE(servo.at("lock"), 1);
}

void TestServoMemory::lockAddressOfStsIsUnusedOnScs()
{
    Servo servo(QStringLiteral("SCS15"));
    QVERIFY(servo.write({55, 0}));
    QVERIFY(servo.write({13, 61}));
    servo.powerCycle();
    QVERIFY(servo.at("max_temperature") != 61);
}

void TestServoMemory::unlockingAfterwardsSavesNothing()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.write({13, 61});
    servo.write({55, 0});
    servo.write({55, 1});
    QCOMPARE(servo.at("max_temperature"), 61);
    servo.powerCycle();
    QCOMPARE(servo.at("max_temperature"), 70);
}

void TestServoMemory::readOnlyRegistersIgnoreWrites()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.write({55, 0});
    QVERIFY(servo.write({3, 77}));
    QVERIFY(!servo.isDeaf());
    QCOMPARE(servo.at("model_major"), 9);
    QVERIFY(servo.write({63, 99}));
    QCOMPARE(servo.at("present_temperature"), 25);
}

void TestServoMemory::undefinedBytesReadZero()
{
    Servo servo(QStringLiteral("STS3215"));
    QVERIFY(servo.write({50, 9, 9, 9, 9, 9}));
    QCOMPARE(servo.read(50, 5), base::Bytes(5, 0));
    // A read across defined and undefined addresses: torque limit, gap, lock.
    QCOMPARE(servo.read(48, 8), (base::Bytes{0xE8, 0x03, 0, 0, 0, 0, 0, 1}));
}

void TestServoMemory::oneByteOfAWordCanBeWritten()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.write({12, 0x0E});
    QCOMPARE(servo.at("max_angle_limit"), 0x0EFF);
}

void TestServoMemory::wordsFollowTheFamilysByteOrder_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("value");
    QTest::newRow("STS low byte first") << QStringLiteral("STS3215") << 0x0102;
    QTest::newRow("SMS low byte first") << QStringLiteral("SM40BLHV") << 0x0102;
    QTest::newRow("SCS high byte first") << QStringLiteral("SCS15") << 0x0201;
}

void TestServoMemory::wordsFollowTheFamilysByteOrder()
{
    QFETCH(QString, model);
    QFETCH(int, value);
    Servo servo(model);
    servo.write({9, 0x02, 0x01});
    QCOMPARE(servo.at("min_angle_limit"), value);
    QCOMPARE(servo.read(9, 2), (base::Bytes{0x02, 0x01}));
}

void TestServoMemory::torqueLimitComesFromMaximumTorque()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("max_torque", 400);
    QCOMPARE(servo.at("torque_limit"), 1000);
    servo.powerCycle();
    QCOMPARE(servo.at("torque_limit"), 400);

    Servo scs(QStringLiteral("SCS15"));
    scs.keep("max_torque", 400);
    scs.powerCycle();
    QCOMPARE(scs.at("lock"), 1); // 48 is the lock there, and stays it
}

void TestServoMemory::powerOnRestoresRam()
{
    Servo servo(QStringLiteral("STS3215"));
    const int fastest = servo.at("goal_speed");
    QVERIFY(fastest > 0);
    servo.write({41, 50, 0x00, 0x0C, 0, 0, 0x64, 0x00});
    servo.run(100);
    QCOMPARE(servo.at("torque_switch"), 1);
    servo.powerCycle();
    QCOMPARE(servo.at("torque_switch"), 0);
    QCOMPARE(servo.at("acceleration"), 0);
    QCOMPARE(servo.at("goal_position"), 0);
    QCOMPARE(servo.at("goal_speed"), fastest);
}

void TestServoMemory::turnsAreForgottenAtPowerOff()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", 12 + 16); // full angle in 56
    servo.write({9, 0, 0, 0, 0});
    servo.set("goal_position", 10000);
    servo.run(4000);
    QVERIFY(std::abs(servo.at("present_position") - 10000) <= 8);
    servo.powerCycle();
    servo.set("phase", 12 + 16);
    QVERIFY(std::abs(servo.at("present_position") - 10000 % 4096) <= 8);
}

void TestServoMemory::unresponsiveOnlyDuringEpromWrites_data()
{
    QTest::addColumn<bool>("unlocked");
    QTest::addColumn<int>("address");
    QTest::addColumn<bool>("deaf");
    QTest::newRow("locked EPROM") << false << 13 << false;
    QTest::newRow("unlocked EPROM") << true << 13 << true;
    QTest::newRow("RAM") << true << 41 << false;
    QTest::newRow("unlocked, read-only") << true << 4 << false;
}

void TestServoMemory::unresponsiveOnlyDuringEpromWrites()
{
    QFETCH(bool, unlocked);
    QFETCH(int, address);
    QFETCH(bool, deaf);
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.epromTime = fixture::milliseconds(15);
    config.behavior.deafWhileWriting = true;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.write({55, std::uint8_t(unlocked ? 0 : 1)});
    QVERIFY(servo.write({std::uint8_t(address), 60})); // acknowledged in any case
    QCOMPARE(servo.isDeaf(), deaf);
    QCOMPARE(servo.ask(0x01).has_value(), !deaf);
    servo.run(14);
    QCOMPARE(servo.isDeaf(), deaf);
    servo.run(3);
    QVERIFY(!servo.isDeaf());
    QVERIFY(servo.ask(0x01));
}

void TestServoMemory::busyOnlyDuringEpromWrites_data()
{
    unresponsiveOnlyDuringEpromWrites_data();
}

void TestServoMemory::busyOnlyDuringEpromWrites()
{
    QFETCH(bool, unlocked);
    QFETCH(int, address);
    QFETCH(bool, deaf);
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.epromTime = fixture::milliseconds(15);
    Servo servo(QStringLiteral("STS3215"), config);
    servo.write({55, std::uint8_t(unlocked ? 0 : 1)});
    QCOMPARE(servo.writeTime(), base::Duration());
    QVERIFY(servo.write({std::uint8_t(address), 60}));
    QCOMPARE(servo.writeTime(), deaf ? config.epromTime : base::Duration());
    QVERIFY(!servo.isDeaf());
    QVERIFY(servo.ask(0x01));
    QCOMPARE(servo.writeTime(), base::Duration());
}

// LeRobot writes both at every set-up. 7 has no function on STS, but is stored; 85 acts as its own
// maximum, and nothing says whether it is kept.
void TestServoMemory::leRobotWritesAreAccepted_data()
{
    QTest::addColumn<QString>("model");
    QTest::newRow("STS") << QStringLiteral("STS3215");
    QTest::newRow("SMS") << QStringLiteral("SM40BLHV");
}

void TestServoMemory::leRobotWritesAreAccepted()
{
    QFETCH(QString, model);
    Servo servo(model);
    QCOMPARE(servo.read(85, 1), base::Bytes{254});
    servo.write({55, 0});
    for (const int value : {254, 0, 17}) {
        QVERIFY(servo.write({7, std::uint8_t(value)}));
        QCOMPARE(servo.read(7, 1), base::Bytes{std::uint8_t(value)});
        QVERIFY(servo.write({85, std::uint8_t(value)}));
        QCOMPARE(servo.read(85, 1), base::Bytes{std::uint8_t(value)});
    }
    servo.powerCycle();
    QCOMPARE(servo.read(7, 1), base::Bytes{17});
    QCOMPARE(servo.profile().find(QStringLiteral("acceleration_limit"))->persistence,
             catalog::Persistence::NotStated);
}

void TestServoMemory::identityAndFactoryValues_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<base::Bytes>("identity");
    QTest::addColumn<int>("baud");
    QTest::newRow("STS3215") << QStringLiteral("STS3215") << base::Bytes{3, 10, 0, 9, 3} << 1000000;
    QTest::newRow("STS3250") << QStringLiteral("STS3250") << base::Bytes{3, 10, 0, 9, 11}
                             << 1000000;
    QTest::newRow("SM40BLHV") << QStringLiteral("SM40BLHV") << base::Bytes{2, 48, 0, 8, 40}
                              << 115200;
    QTest::newRow("SCS15") << QStringLiteral("SCS15") << base::Bytes{0, 4, 1, 5, 15} << 1000000;
    QTest::newRow("SCS0009") << QStringLiteral("SCS0009") << base::Bytes{0, 4, 1, 5, 4} << 1000000;
}

void TestServoMemory::identityAndFactoryValues()
{
    QFETCH(QString, model);
    QFETCH(base::Bytes, identity);
    QFETCH(int, baud);
    auto config = fixture::configOf(model);
    config.id = 7;
    Servo servo(model, config);
    QCOMPARE(servo.read(0, 5), identity);
    QCOMPARE(servo.id(), 7);
    QCOMPARE(servo.baud(), baud);
    // What the sheet knows is what leaves the factory.
    for (const catalog::Register& reg : servo.profile().registers) {
        if (reg.defaultRaw && reg.writable() && reg.role != catalog::Role::Id &&
            reg.role != catalog::Role::BaudRate) {
            QVERIFY2(servo.raw(reg.key) == *reg.defaultRaw, qPrintable(reg.key));
        }
    }
    QVERIFY(servo.at("present_voltage") >= servo.at("min_voltage"));
    QVERIFY(servo.at("present_voltage") <= servo.at("max_voltage"));
    QCOMPARE(servo.at("servo_status"), 0);
}

void TestServoMemory::imageHasEpromAndBackup()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("position_p", 50);
    servo.set("lock", 0);
    servo.ask(0x09);
    servo.run(20);
    servo.keep("position_p", 60);
    servo.set("position_p", 70); // locked: not part of what survives

    Servo again(QStringLiteral("STS3215"));
    QVERIFY(again.setEpromImage(servo.epromImage()));
    QCOMPARE(again.at("position_p"), 60);
    again.set("lock", 0);
    again.ask(0x06);
    QCOMPARE(again.at("position_p"), 50);
}

void TestServoMemory::foreignImagesAreRefused_data()
{
    QTest::addColumn<base::Bytes>("image");
    const base::Bytes good = Servo(QStringLiteral("STS3215")).epromImage();
    QTest::newRow("empty") << base::Bytes{};
    QTest::newRow("short") << base::Bytes(good.begin(), good.end() - 1);
    base::Bytes changed = good;
    changed.push_back(0);
    QTest::newRow("long") << changed;
    changed = good;
    changed[0] ^= 1;
    QTest::newRow("not ours") << changed;
    changed = good;
    changed[3] += 1;
    QTest::newRow("other version") << changed;
    QTest::newRow("other model") << Servo(QStringLiteral("STS3250")).epromImage();
    QTest::newRow("other family") << Servo(QStringLiteral("SCS15")).epromImage();
}

void TestServoMemory::foreignImagesAreRefused()
{
    QFETCH(base::Bytes, image);
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("position_p", 50);
    QVERIFY(!servo.setEpromImage(image));
    QCOMPARE(servo.at("position_p"), 50);
}

void TestServoMemory::restoreReturnsTheBackup()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("position_p", 50);
    servo.set("lock", 0);
    QVERIFY(servo.ask(0x09));
    servo.run(20);
    servo.set("position_p", 60);
    servo.set("id", 9);
    servo.set("baud_rate", 4);
    QVERIFY(servo.ask(0x06));
    QCOMPARE(servo.at("position_p"), 50);
    QCOMPARE(servo.id(), 9); // everything but the ID
    QCOMPARE(servo.baud(), 1000000);
    servo.powerCycle();
    QCOMPARE(servo.at("position_p"), 50);
    QCOMPARE(servo.id(), 9);
}

void TestServoMemory::restoreWithoutBackupIsTheFactory()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("position_p", 50);
    servo.set("lock", 0);
    servo.ask(0x06);
    QCOMPARE(servo.at("position_p"), 32);
}

void TestServoMemory::restoreBehindAClosedLockDoesNothing()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.keep("position_p", 50);
    QVERIFY(servo.ask(0x09));
    QVERIFY(servo.ask(0x06));
    QVERIFY(!servo.isDeaf());
    QCOMPARE(servo.at("position_p"), 50);
    servo.set("lock", 0);
    servo.ask(0x06);
    QCOMPARE(servo.at("position_p"), 32); // the closed lock had kept 0x09 away as well
}

SERVODESK_GUILESS_TEST(TestServoMemory)
#include "tst_servo_memory.moc"
