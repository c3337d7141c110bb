// SPDX-License-Identifier: GPL-3.0-or-later
// An emergency stop whose own frames get lost, held against servos that know only bytes and to
// which a broadcast says nothing: torque is read back and switched off again, and a servo that
// stays on is named.
#include "integration/byte_bus.h"
#include "unit/session/session_bench.h"

#include <limits>

namespace {
constexpr int torqueSwitch = 40;

class StopBench {
public:
    StopBench()
        : servos({1, 2, 3}, std::chrono::milliseconds(1))
        , bench(servos.port())
    {
        QObject::connect(&bench.desk, &Desk::happened, &bench.desk,
                         [this](const session::Event& event) {
                             if (event.kind == session::Event::Kind::StopChecked)
                                 check = event.stop;
                         });
    }
    bool allOn()
    {
        bool on = bench.search({.firstId = 0, .lastId = 5, .bauds = {1'000'000}});
        for (const int id : {1, 2, 3}) {
            on = on && bench.write(bench.at(id), QStringLiteral("torque_switch"), 1);
            on = on && servos.byteAt(id, torqueSwitch) == 1;
        }
        return on;
    }
    bool stop()
    {
        bench.desk.emergencyStop();
        return QTest::qWaitFor([this] { return check.has_value(); }, 30'000);
    }

    bytes::Bus servos;
    Bench bench;
    std::optional<session::StopCheck> check;
};
} // namespace

class TestStopRequestsLost : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void whoMissedTheStopIsToldAgain_data()
    {
        QTest::addColumn<QList<int>>("missed");
        QTest::newRow("one") << QList<int>{2};
        QTest::newRow("all") << QList<int>{1, 2, 3};
    }
    void whoMissedTheStopIsToldAgain()
    {
        QFETCH(QList<int>, missed);
        StopBench stop;
        QVERIFY(stop.allOn());
        for (const int id : missed)
            stop.servos.loseWrites(id, torqueSwitch,
                                   2); // the stop's own, and the first one after it
        QVERIFY(stop.stop());
        QVERIFY(stop.check->good());
        QCOMPARE(stop.check->off.size(), std::size_t(3));
        for (const int id : {1, 2, 3})
            QCOMPARE(stop.servos.byteAt(id, torqueSwitch), 0);
    }

    void whoNeverHearsItIsNamed()
    {
        StopBench stop;
        QVERIFY(stop.allOn());
        stop.servos.loseWrites(2, torqueSwitch, std::numeric_limits<int>::max());
        QVERIFY(stop.stop());
        QVERIFY(!stop.check->good());
        QCOMPARE(stop.check->stillOn, std::vector{stop.bench.at(2)});
        QCOMPARE(stop.check->off.size(), std::size_t(2));
        QCOMPARE(stop.servos.byteAt(1, torqueSwitch), 0);
        QCOMPARE(stop.servos.byteAt(2, torqueSwitch), 1);
        QCOMPARE(stop.servos.byteAt(3, torqueSwitch), 0);
    }
};

QTEST_GUILESS_MAIN(TestStopRequestsLost)
#include "tst_stop_requests_lost.moc"
