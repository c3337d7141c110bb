// SPDX-License-Identifier: GPL-3.0-or-later
// Turns are counted through the seam, both ways; and it is said when they are not certain.
#include "device/motion/turn_count.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

using device::TurnBasis;
using device::TurnCounter;
using namespace std::chrono_literals;

namespace {
constexpr int steps = 4096;
const TurnBasis oneTurn{steps, false, QStringLiteral("speed"), 0};

/// Readings every 10 ms from a shaft that is at `place` after each.
void turnTo(TurnCounter& counter, double& place, double target, base::Duration& at)
{
    const double step = target > place ? 200 : -200;
    while (std::abs(target - place) > 0.5) {
        place = std::abs(target - place) < std::abs(step) ? target : place + step;
        at += 10ms;
        const double seen = place - steps * std::floor(place / steps);
        counter.reading(std::llround(seen) % steps, 360.0 * 200 / steps / 0.01, at);
    }
}
} // namespace

class TestTurnCount : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void unknownWithoutReadings()
    {
        TurnCounter counter;
        counter.on(oneTurn);
        QVERIFY(!counter.value());
        counter.reading(1024, 0.0, 1s);
        QCOMPARE(*counter.value(), (device::Turns{0, 90, false, true}));
    }

    void turnsAreCountedAcrossTheWrapBothWays()
    {
        TurnCounter counter;
        counter.on(oneTurn);
        double place = 1024;
        base::Duration at = 1s;
        counter.reading(1024, 0.0, at);
        turnTo(counter, place, 1024 + 3 * steps, at);
        QCOMPARE(counter.value()->turns, 3);
        QCOMPARE(counter.value()->degrees, 3 * 360.0 + 90);
        QVERIFY(counter.value()->isCertain);
        turnTo(counter, place, 1024 - 2 * steps, at);
        QCOMPARE(counter.value()->turns, -2);
        QCOMPARE(counter.value()->degrees, -2 * 360.0 + 90);
        QVERIFY(!counter.value()->absolute);
    }

    void readingsTooFarApartAreUncertain()
    {
        TurnCounter counter;
        counter.on(oneTurn);
        counter.reading(0, 360.0, 1s);
        counter.reading(1500, 360.0, 1400ms); // 144° at 360°/s
        QVERIFY(counter.value()->isCertain);
        counter.reading(100, 360.0, 2s); // 216° or more
        QVERIFY(!counter.value()->isCertain);
        counter.reading(120, 0.0, 2010ms);
        QVERIFY2(!counter.value()->isCertain, "what was missed stays missed");
        counter.reset();
        counter.reading(120, 0.0, 2020ms);
        QVERIFY(counter.value()->isCertain);
    }

    void aServosOwnTurnCountIsUsed()
    {
        TurnCounter counter;
        counter.on({steps, true, QStringLiteral("multiturn"), 0});
        counter.reading(3 * steps + 2048, 0.0, 1s);
        QCOMPARE(*counter.value(), (device::Turns{3, 3 * 360.0 + 180, true, true}));
        counter.reading(-1024, 9999.0, 9s); // however long ago the one before was
        QCOMPARE(*counter.value(), (device::Turns{-1, -90, true, true}));
    }

    void aNewZeroOrMeaningRestartsTheCount()
    {
        TurnCounter counter;
        counter.on(oneTurn);
        counter.reading(4000, 0.0, 1s);
        counter.reading(100, 0.0, 1010ms);
        QCOMPARE(counter.value()->turns, 1);
        TurnBasis same = oneTurn;
        same.mode = QStringLiteral("pwm"); // the encoder shows the same
        counter.on(same);
        QCOMPARE(counter.value()->turns, 1);
        same.offset = 300; // centered
        counter.on(same);
        QVERIFY(!counter.value());
        counter.on({}); // step mode
        counter.reading(100, 0.0, 1020ms);
        QVERIFY(!counter.value());
    }

    /// What registers make of the reading: step mode shows the way left, factor 30 changes nothing.
    void theBaseComesFromTheServo()
    {
        support::SimFixture fixture(QStringLiteral("sts3215@1,scs15@5"));
        device::Servo sts = fixture.servo(1);
        QCOMPARE(device::turnBasis(sts).steps, steps);
        QVERIFY(!device::turnBasis(sts).countsTurns);
        fixture.poke(1, QStringLiteral("lock"), 0);
        fixture.poke(1, QStringLiteral("angle_resolution"), 2);
        QCOMPARE(device::turnBasis(fixture.servo(1)).steps, steps);
        fixture.poke(1, QStringLiteral("phase"), fixture.raw(1, QStringLiteral("phase")) | 1 << 4);
        QVERIFY(device::turnBasis(fixture.servo(1)).countsTurns);
        fixture.poke(1, QStringLiteral("operating_mode"), 3);
        QCOMPARE(device::turnBasis(fixture.servo(1)).steps, 0);
        QCOMPARE(device::turnBasis(fixture.servo(5)).steps, 0); // a potentiometer
    }
};

SERVODESK_GUILESS_TEST(TestTurnCount)
#include "tst_turn_count.moc"
