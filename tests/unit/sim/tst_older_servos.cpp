// SPDX-License-Identifier: GPL-3.0-or-later
// SMCL and SCS-2: the lock at 48, registers at addresses of their own, what they lack, and byte
// order. Addresses are written out from the sheets.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "servo_fixture.h"

using base::Bytes;

namespace {
class OlderServo : public fixture::Servo {
public:
    explicit OlderServo(const QString& model, const sim::ServoConfig& config)
        : Servo(model, config)
    {}
    explicit OlderServo(const QString& model)
        : OlderServo(model, withSupply(model))
    {}

    static sim::ServoConfig withSupply(const QString& model)
    {
        sim::ServoConfig config;
        config.environment.supplyVolts = model.startsWith(QLatin1String("SM")) ? 12.0 : 7.4;
        return config;
    }
    void write(const Bytes& params)
    {
        handle({false, 0x03, params, -1});
        run(10);
    }
};
const QString smcl = QStringLiteral("SM60-360M");
const QString scs2 = QStringLiteral("SCS15-2");
} // namespace

class TestOlderServos : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theLockIsAtFortyEight_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<int>("lock");
        QTest::addColumn<bool>("kept");
        for (const QString& model : {smcl, scs2}) {
            QTest::addRow("%s open", qPrintable(model)) << model << 48 << true;
            QTest::addRow("%s, the other family's", qPrintable(model)) << model << 55 << false;
        }
    }
    void theLockIsAtFortyEight()
    {
        QFETCH(QString, model);
        QFETCH(int, lock);
        QFETCH(bool, kept);
        OlderServo servo(model);
        servo.write({std::uint8_t(lock), 0});
        servo.write({13, 66});
        QCOMPARE(servo.read(13, 1), Bytes{66});
        servo.powerCycle();
        QCOMPARE(servo.read(13, 1) == Bytes{66}, kept);
        QCOMPARE(servo.read(48, 1), Bytes{1});
    }

    void startsWithoutAnAlarm_data()
    {
        QTest::addColumn<QString>("model");
        for (const auto& entry : fixture::models().models()) {
            if (entry.series == QLatin1String("SMCL") || entry.series == QLatin1String("SCS2")) {
                QTest::addRow("%s %d.%d", qPrintable(entry.name), entry.major, entry.minor)
                    << entry.name;
            }
        }
    }
    void startsWithoutAnAlarm()
    {
        QFETCH(QString, model);
        OlderServo servo(model);
        servo.set("goal_position", servo.profile().stepsPerTurn * 5 / 8);
        servo.run(3000);
        QCOMPARE(servo.at("servo_status"), 0);
        QVERIFY(std::abs(servo.at("present_position") - servo.profile().stepsPerTurn * 5 / 8) <=
                12);
    }

    void movesInItsOwnByteOrder_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<Bytes>("goal");
        QTest::addColumn<int>("reached");
        QTest::newRow("SMCL") << smcl << Bytes{42, 0xB8, 0x0B} << 3000;
        QTest::newRow("SCS2") << scs2 << Bytes{42, 0x02, 0xBC} << 700;
    }
    void movesInItsOwnByteOrder()
    {
        QFETCH(QString, model);
        QFETCH(Bytes, goal);
        QFETCH(int, reached);
        OlderServo servo(model);
        servo.write(goal);
        servo.run(4000);
        QVERIFY(std::abs(servo.at("present_position") - reached) <= 12);
    }

    void anOffsetShiftsThePosition_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<Bytes>("offset");
        QTest::addColumn<int>("shift");
        QTest::newRow("SMCL 100") << smcl << Bytes{33, 100, 0} << -100;
        QTest::newRow("SMCL -100") << smcl << Bytes{33, 100, 0x08} << 100;
        QTest::newRow("SCS2 20") << scs2 << Bytes{34, 20} << -20;
        QTest::newRow("SCS2 -20") << scs2 << Bytes{34, 0x80 | 20} << 20;
    }
    void anOffsetShiftsThePosition()
    {
        QFETCH(QString, model);
        QFETCH(Bytes, offset);
        QFETCH(int, shift);
        OlderServo servo(model);
        const int before = servo.at("present_position");
        servo.write(offset);
        QVERIFY(std::abs(servo.at("present_position") - before - shift) <= 1);
    }

    void smclKeepsItsModeAtThirtyFive()
    {
        OlderServo servo(smcl);
        servo.write({35, 1});
        servo.write({46, 0xE8, 0x03});
        servo.run(1500);
        QVERIFY(std::abs(servo.at("present_speed") - 1000) <= 60);
        servo.write({35, 2});
        servo.write({44, 0x2C, 0x05}); // −300
        servo.run(1000);
        QCOMPARE(servo.at("present_load"), -300);
    }

    void smclTurnsManyTimes()
    {
        OlderServo servo(smcl);
        servo.write({9, 0, 0, 0, 0});
        const double before = servo.shaftSteps();
        servo.write({42, 0x00, 0x28}); // 10240
        servo.run(9000);
        QVERIFY(std::abs(servo.shaftSteps() - before - 8192) < 16);
    }

    void smclTakesItsTorqueFromTheEprom()
    {
        OlderServo servo(smcl);
        servo.write({35, 2});
        servo.write({16, 0x2C, 0x01}); // 30 %
        servo.write({44, 0x58, 0x02}); // 600
        servo.run(500);
        QCOMPARE(servo.at("present_load"), 300);
    }

    void smclWaitsItsReplyDelay()
    {
        OlderServo servo(smcl);
        QCOMPARE(servo.baud(), 115200);
        QCOMPARE(servo.replyDelay(), base::Duration(500));
        servo.write({7, 10});
        QCOMPARE(servo.replyDelay(), base::Duration(100));
    }

    void scs2DrivesAsAMotor_data()
    {
        QTest::addColumn<Bytes>("word");
        QTest::addColumn<int>("load");
        QTest::newRow("200") << Bytes{44, 0x00, 0xC8} << 200;
        QTest::newRow("-200") << Bytes{44, 0x04, 0xC8} << -200;
    }
    void scs2DrivesAsAMotor()
    {
        QFETCH(Bytes, word);
        QFETCH(int, load);
        OlderServo servo(scs2);
        servo.write({9, 0, 0, 0, 0});
        servo.write(word);
        servo.run(1000);
        QCOMPARE(servo.at("present_load"), load);
        QVERIFY(servo.at("present_speed") * load < 0);
    }

    void undocumentedFeaturesAreMissing_data()
    {
        QTest::addColumn<QString>("model");
        QTest::newRow("SMCL") << smcl;
        QTest::newRow("SCS2") << scs2;
    }
    void undocumentedFeaturesAreMissing()
    {
        QFETCH(QString, model);
        OlderServo servo(model);
        const int before = servo.at("present_position");
        QVERIFY(!servo.handle({true, 0x82, {56, 2, 1}, 0}));
        QVERIFY(!servo.ask(0x0B));
        servo.write({40, 128});
        QCOMPARE(servo.at("present_position"), before);
        QCOMPARE(servo.at("position_offset"), 0);
        QCOMPARE(servo.at("torque_switch"), 0);
    }

    void overloadReducesTorque_data()
    {
        QTest::addColumn<QString>("model");
        QTest::newRow("SMCL") << smcl;
        QTest::newRow("SCS2") << scs2;
    }
    void overloadReducesTorque()
    {
        QFETCH(QString, model);
        sim::ServoConfig config = OlderServo::withSupply(model);
        config.load.stopHigh = 3.3;
        OlderServo servo(model, config);
        servo.set("goal_position", servo.profile().stepsPerTurn * 3 / 4);
        servo.run(5000);
        QCOMPARE(servo.at("servo_status") & 32, 32);
        QCOMPARE(std::abs(servo.at("present_load")), 10 * servo.at("protection_torque"));
        servo.set("goal_position", servo.profile().stepsPerTurn / 4);
        servo.run(100);
        QCOMPARE(servo.at("servo_status"), 0);
    }
};

SERVODESK_GUILESS_TEST(TestOlderServos)
#include "tst_older_servos.moc"
