// SPDX-License-Identifier: GPL-3.0-or-later
// Named faults, and the ways a link ends. With probability 1 a fault befalls every reply, so each
// can be looked at by itself; the seed makes runs with lesser probabilities repeatable.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"
#include <bit>

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;

namespace {
sim::WireConfig faulty(const char* plan, std::uint64_t seed = 1)
{
    sim::WireConfig config;
    config.faults = sim::parseFaults(QString::fromLatin1(plan)).value();
    config.seed = seed;
    return config;
}

const Bytes question = wire::read(1, 0, 5);
} // namespace

class TestWireFaults : public QObject {
    Q_OBJECT

    /// The answer a servo gives on a good wire.
    static Bytes expectedReply()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 0us;
        bus->hostReads(now);
        return wire::ask(*bus, question, now);
    }

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aDroppedReplyNeverComes()
    {
        const auto bus = wire::bus("sts3215@1", {}, faulty("drop=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::ask(*bus, wire::write(1, 40, 1), now).empty());
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), 1);
    }

    void aDroppedRequestIsNotExecuted()
    {
        const auto bus = wire::bus("sts3215@1", {}, faulty("drop-request=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::ask(*bus, wire::write(1, 40, 1), now).empty());
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), 0);
    }

    void aCorruptReplyDiffersInOneBit()
    {
        const Bytes good = expectedReply();
        const auto bus = wire::bus("sts3215@1", {}, faulty("corrupt=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        for (int round = 0; round < 20; ++round) {
            const Bytes bad = wire::ask(*bus, question, now);
            QCOMPARE(bad.size(), good.size());
            int flipped = 0;
            for (std::size_t i = 0; i < good.size(); ++i)
                flipped += std::popcount(static_cast<unsigned>(bad[i] ^ good[i]));
            QCOMPARE(flipped, 1);
        }
    }

    void garbagePrecedesAGoodReply()
    {
        const Bytes good = expectedReply();
        const auto bus = wire::bus("sts3215@1", {}, faulty("garbage=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        for (int round = 0; round < 20; ++round) {
            const Bytes received = wire::ask(*bus, question, now);
            QVERIFY(received.size() > good.size());
            QVERIFY(std::equal(good.rbegin(), good.rend(), received.rbegin()));
        }
    }

    void aTruncatedReplyEndsEarly()
    {
        const Bytes good = expectedReply();
        const auto bus = wire::bus("sts3215@1", {}, faulty("truncate=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        for (int round = 0; round < 20; ++round) {
            const Bytes received = wire::ask(*bus, question, now);
            QVERIFY(!received.empty());
            QVERIFY(received.size() < good.size());
            QVERIFY(std::equal(received.begin(), received.end(), good.begin()));
        }
    }

    void aLateReplyIsComplete()
    {
        const Bytes good = expectedReply();
        const auto bus = wire::bus("sts3215@1", {}, faulty("late=1,late-ms=40"));
        bus->hostReads(0us);
        bus->hostWrites(question, 1'000'000, 0us);
        QVERIFY(bus->hostReads(40ms).empty());
        QCOMPARE(bus->hostReads(42ms), good);
    }

    void aMutedServoExecutesSilently()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@2", {}, faulty("mute=1"));
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::ask(*bus, wire::write(1, 40, 1), now).empty());
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), 1);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(2), now), 2));
    }

    void probabilitiesHoldAndSeedsRepeat()
    {
        const auto losses = [](std::uint64_t seed) {
            const auto bus = wire::bus("sts3215@1", {}, faulty("drop=0.2", seed));
            Duration now = 1ms;
            bus->hostReads(now);
            std::vector<int> lost;
            for (int i = 0; i < 500; ++i) {
                if (wire::ask(*bus, wire::ping(1), now, 1'000'000, 1ms).empty())
                    lost.push_back(i);
            }
            return lost;
        };
        const auto first = losses(7);
        QVERIFY2(first.size() > 60 && first.size() < 140,
                 qPrintable(QString::number(first.size())));
        QCOMPARE(losses(7), first);
        QVERIFY(losses(8) != first);
    }

    void parsesFaults_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("good");
        QTest::newRow("nothing") << QString() << true;
        QTest::newRow("several") << QStringLiteral("drop=0.01, corrupt=1,mute=3,mute=4") << true;
        QTest::newRow("unknown") << QStringLiteral("melt=0.5") << false;
        QTest::newRow("no value") << QStringLiteral("drop") << false;
        QTest::newRow("no name") << QStringLiteral("=1") << false;
        QTest::newRow("above one") << QStringLiteral("drop=1.5") << false;
        QTest::newRow("below zero") << QStringLiteral("drop=-0.1") << false;
        QTest::newRow("not a number") << QStringLiteral("late=nan") << false;
        QTest::newRow("no number") << QStringLiteral("late=often") << false;
        QTest::newRow("bad ID") << QStringLiteral("mute=254") << false;
        QTest::newRow("bad span") << QStringLiteral("late-ms=-1") << false;
    }
    void parsesFaults()
    {
        QFETCH(QString, text);
        QFETCH(bool, good);
        const auto plan = sim::parseFaults(text);
        QCOMPARE(plan.has_value(), good);
        if (!good) {
            QCOMPARE(plan.error().code, base::ErrorCode::BadArgument);
            QVERIFY2(plan.error().detail.contains(text), qPrintable(plan.error().detail));
        }
    }

    void faultsAreParsedByName()
    {
        const auto plan = sim::parseFaults(
            QStringLiteral("drop=0.1,corrupt=0.2,garbage=0.3,late=0.4,truncate=0.5,"
                           "drop-request=0.6,late-ms=70,mute=3,mute=4"));
        QVERIFY(plan);
        QCOMPARE(plan->drop, 0.1);
        QCOMPARE(plan->corrupt, 0.2);
        QCOMPARE(plan->garbage, 0.3);
        QCOMPARE(plan->late, 0.4);
        QCOMPARE(plan->truncate, 0.5);
        QCOMPARE(plan->dropRequest, 0.6);
        QCOMPARE(plan->lateBy, Duration(70ms));
        QCOMPARE(plan->muteIds, (std::vector<int>{3, 4}));
    }

    // Cut one byte early the request is no request; cut after its last byte it is obeyed.
    void theLinkIsCutAtAnyByte_data()
    {
        QTest::addColumn<int>("count");
        for (int count = 0; count <= 8; ++count)
            QTest::addRow("%d", count) << count;
    }
    void theLinkIsCutAtAnyByte()
    {
        QFETCH(int, count);
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        const Bytes request = wire::write(1, 40, 1);
        QCOMPARE(request.size(), std::size_t{8});
        bus->cutAfterHostBytes(static_cast<std::size_t>(count));
        QVERIFY(wire::ask(*bus, request, now).empty());
        QVERIFY(bus->linkCut());
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), count == 8 ? 1 : 0);
        bus->restoreLink();
        now += 50ms;
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    void theCutCountsOverSeveralWrites()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        bus->cutAfterHostBytes(10);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
        QVERIFY(!bus->linkCut());
        QVERIFY(wire::ask(*bus, wire::ping(1), now).empty());
        QVERIFY(bus->linkCut());
    }

    void aCutLinkLosesDataInTransit()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        bus->hostWrites(wire::write(1, 40, 1), 1'000'000, now);
        bus->hostReads(now + 40us);
        bus->cutLink();
        now += 10ms;
        QVERIFY(bus->hostReads(now).empty());
        QVERIFY(!bus->nextHostByte());
        QVERIFY(wire::ask(*bus, wire::ping(1), now).empty());
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), 0);
    }

    void aPowerCycleEndsAReplyAndClearsTheRam()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::write(1, 40, 1), now), 1));
        bus->hostWrites(wire::read(1, 0, 40), 1'000'000, now);
        now += 200us;
        QVERIFY(!bus->hostReads(now).empty());
        bus->powerCycle();
        now += 10ms;
        QVERIFY(bus->hostReads(now).size() < 46);
        QCOMPARE(bus->servo(1)->raw(QStringLiteral("torque_switch")), 0);
        now += 2s;
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }
};

SERVODESK_GUILESS_TEST(TestWireFaults)
#include "tst_wire_faults.moc"
