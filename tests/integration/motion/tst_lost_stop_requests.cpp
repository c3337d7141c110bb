// SPDX-License-Identifier: GPL-3.0-or-later
// An emergency stop whose own frames get lost, held against servos that know only bytes and which
// do not take the broadcast: torque is read back and turned off again, and a servo that
// stays on is named.
#include "integration/raw_servo_bus.h"
#include "support/test_main.h"
#include "unit/session/session_fixture.h"

#include <limits>

namespace {
constexpr int torqueSwitch = 40;

class StopFixture {
public:
    StopFixture()
        : servos({1, 2, 3}, std::chrono::milliseconds(1))
        , fixture(servos.port())
    {
        QObject::connect(&fixture.workbench, &Workbench::eventOccurred, &fixture.workbench,
                         [this](const session::Event& event) {
                             if (event.kind == session::Event::Kind::StopVerified)
                                 check = event.stop;
                         });
    }
    bool isTorqueOnForAll()
    {
        bool on = false;
        // On a busy machine an answer may come later than the program waits.
        for (int tries = 0; tries < 5 && !on; ++tries) {
            on = fixture.search({.firstId = 0, .lastId = 5, .bauds = {1'000'000}}) &&
                 fixture.workbench.registry().order().size() == 3;
            for (const int id : {1, 2, 3}) {
                on = on && fixture.write(fixture.at(id), QStringLiteral("torque_switch"), 1);
                on = on && servos.byteAt(id, torqueSwitch) == 1;
            }
        }
        return on;
    }
    bool stop()
    {
        fixture.workbench.emergencyStop().trigger();
        return support::waitFor([this] { return check.has_value(); });
    }

    bytes::Bus servos;
    SessionFixture fixture;
    std::optional<session::StopResult> check;
};
} // namespace

class TestLostStopRequests : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aMissedStopIsResent_data()
    {
        QTest::addColumn<QList<int>>("missed");
        QTest::newRow("one") << QList<int>{2};
        QTest::newRow("all") << QList<int>{1, 2, 3};
    }
    void aMissedStopIsResent()
    {
        QFETCH(QList<int>, missed);
        StopFixture stop;
        QVERIFY(stop.isTorqueOnForAll());
        for (const int id : missed)
            stop.servos.dropWrites(id, torqueSwitch,
                                   2); // the stop's own, and the first one after it
        QVERIFY(stop.stop());
        QVERIFY(stop.check->isConfirmed());
        QCOMPARE(stop.check->off.size(), std::size_t(3));
        for (const int id : {1, 2, 3})
            QCOMPARE(stop.servos.byteAt(id, torqueSwitch), 0);
    }

    void anUnstoppedServoIsReported()
    {
        StopFixture stop;
        QVERIFY(stop.isTorqueOnForAll());
        stop.servos.dropWrites(2, torqueSwitch, std::numeric_limits<int>::max());
        QVERIFY(stop.stop());
        QVERIFY(!stop.check->isConfirmed());
        QCOMPARE(stop.check->stillOn, std::vector{stop.fixture.at(2)});
        QCOMPARE(stop.check->off.size(), std::size_t(2));
        QCOMPARE(stop.servos.byteAt(1, torqueSwitch), 0);
        QCOMPARE(stop.servos.byteAt(2, torqueSwitch), 1);
        QCOMPARE(stop.servos.byteAt(3, torqueSwitch), 0);
    }
};

SERVODESK_GUILESS_TEST(TestLostStopRequests)
#include "tst_lost_stop_requests.moc"
