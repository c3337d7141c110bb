// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated bus as a link, on a clock that jumps and on the real one.
#include "sim/host/sim_link.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;
using base::ErrorCode;

class TestSimLink : public QObject {
    Q_OBJECT

    static std::shared_ptr<sim::SharedBus> shared(const char* list,
                                                  const sim::WireConfig& wire = {})
    {
        return std::make_shared<sim::SharedBus>(wire::bus(list, {}, wire));
    }

    static auto openSimLink(const std::shared_ptr<sim::SharedBus>& bus, base::Clock& clock)
    {
        return sim::makeSimLink(bus, QStringLiteral("sim:test"), clock, 1'000'000);
    }

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void waitingJumpsToTheCompleteReply()
    {
        base::ManualClock clock;
        const auto bus = shared("sts3215@1");
        const auto link = openSimLink(bus, clock);
        const Duration delay = bus->with([](auto& wire) { return wire.servo(1)->replyDelay(); });
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(link->waitForReadyRead(10ms).value());
        QCOMPARE(clock.now(), 120us + delay);
        Bytes reply{0x77};
        QCOMPARE(link->read(reply).value(), std::size_t{6});
        QCOMPARE(int{reply.front()}, 0x77);
        QVERIFY(wire::isStatusOf({reply.begin() + 1, reply.end()}, 1));
        QCOMPARE(link->name(), QStringLiteral("sim:test"));
        QVERIFY(link->canSetBaud());
    }

    // The servo answers after a silence: the clock stops there on its way to the reply.
    void waitingJumpsOverAModbusSilence()
    {
        base::ManualClock clock;
        const auto bus = shared("smsmb@1");
        bus->with([](auto& wire) { wire.servo(1)->poke(QStringLiteral("return_delay"), 0); });
        const auto link = sim::makeSimLink(bus, QStringLiteral("sim:test"), clock, 115'200);
        QVERIFY(link->setBaud(115'200));
        QVERIFY(link->write(Bytes{0x01, 0x11, 0xC0, 0x2C}));
        QVERIFY(link->waitForReadyRead(20ms).value());
        Bytes reply;
        QCOMPARE(link->read(reply).value(), std::size_t{8});
        QCOMPARE(reply, (Bytes{0x01, 0x11, 0x03, 0x01, 0x00, 0x00, 0xAC, 0x4D}));
        const double expected = (4 + 3.5 + 8) * 1e7 / 115'200;
        QVERIFY(std::abs(double(clock.now().count()) - expected) <= 3);
    }

    void waitingWithoutDataEndsAtTheDeadline()
    {
        base::ManualClock clock;
        const auto link = openSimLink(shared("sts3215@1"), clock);
        QVERIFY(!link->waitForReadyRead(7ms).value());
        QCOMPARE(clock.now(), Duration(7ms));
        QVERIFY(link->write(wire::ping(9)));
        QVERIFY(!link->waitForReadyRead(0us).value());
        QCOMPARE(clock.now(), Duration(7ms));
        QVERIFY(!link->waitForReadyRead(25ms).value());
        QCOMPARE(clock.now(), Duration(32ms));
    }

    // A deadline inside the reply: what has come by then is there, the rest follows.
    void aShortWaitSeesPartOfAReply()
    {
        base::ManualClock clock;
        const auto bus = shared("sts3215@1");
        const auto link = openSimLink(bus, clock);
        const Duration delay = bus->with([](auto& wire) { return wire.servo(1)->replyDelay(); });
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(link->waitForReadyRead(60us + delay + 25us).value());
        Bytes reply;
        QCOMPARE(link->read(reply).value(), std::size_t{2});
        QVERIFY(link->waitForReadyRead(1ms).value());
        QVERIFY(link->read(reply));
        QVERIFY(wire::isStatusOf(reply, 1));
    }

    void theRateMatters()
    {
        base::ManualClock clock;
        const auto link = openSimLink(shared("sts3215@1:115200"), clock);
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(!link->waitForReadyRead(50ms).value());
        QVERIFY(link->setBaud(115'200));
        QCOMPARE(link->baud(), 115'200);
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(link->waitForReadyRead(50ms).value());
        QCOMPARE(link->setBaud(0).error().code, ErrorCode::RateUnsupported);
        QCOMPARE(link->baud(), 115'200);
    }

    void aCutLinkStaysLost()
    {
        base::ManualClock clock;
        const auto bus = shared("sts3215@1");
        const auto link = openSimLink(bus, clock);
        bus->with([](auto& wire) { wire.cutLink(); });
        Bytes buffer;
        QCOMPARE(link->waitForReadyRead(10ms).error().code, ErrorCode::LinkLost);
        bus->with([](auto& wire) { wire.restoreLink(); });
        QCOMPARE(link->write(wire::ping(1)).error().code, ErrorCode::LinkLost);
        QCOMPARE(link->read(buffer).error().code, ErrorCode::LinkLost);
        QCOMPARE(link->setBaud(9600).error().code, ErrorCode::LinkLost);
        const auto next = openSimLink(bus, clock);
        QVERIFY(next->write(wire::ping(1)));
        QVERIFY(next->waitForReadyRead(10ms).value());
    }

    void aCuttingWriteIsDetectedByReading()
    {
        base::ManualClock clock;
        const auto bus = shared("sts3215@1");
        const auto link = openSimLink(bus, clock);
        bus->with([](auto& wire) { wire.cutAfterHostBytes(3); });
        QVERIFY(link->write(wire::ping(1)));
        Bytes buffer;
        QCOMPARE(link->read(buffer).error().code, ErrorCode::LinkLost);
    }

    void realTimePassesAsOnTheWire()
    {
        base::SystemClock clock;
        sim::WireConfig config;
        config.adapterLatency = 16ms;
        const auto link = openSimLink(shared("sts3215@1", config), clock);
        const Duration start = clock.now();
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(link->waitForReadyRead(5s).value());
        QVERIFY(clock.now() - start >= 16'120us);
        Bytes reply;
        QCOMPARE(link->read(reply).value(), std::size_t{6});
    }

    void anHourPassesOnTheManualClock()
    {
        base::ManualClock clock;
        const auto bus = shared("sts3215@1");
        const auto link = openSimLink(bus, clock);
        clock.advance(1h);
        QVERIFY(link->write(wire::ping(1)));
        QVERIFY(link->waitForReadyRead(10ms).value());
        QVERIFY(clock.now() < 1h + 1ms);
    }
};

SERVODESK_GUILESS_TEST(TestSimLink)
#include "tst_sim_link.moc"
