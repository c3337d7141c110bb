// SPDX-License-Identifier: GPL-3.0-or-later
// SYNC READ on the wire: one ordinary reply from each listed servo, in the order of the list, each
// after the one before; the time of a missing one passes unused.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;

namespace {
struct Reply {
    Bytes bytes;
    Duration complete{};
};

/// SYNC READ of 56, 15 bytes; what comes run by run.
std::vector<Reply> syncRead(sim::VirtualBus& bus, const Bytes& ids)
{
    Bytes params{56, 15};
    params.insert(params.end(), ids.begin(), ids.end());
    bus.hostReads(0us);
    bus.hostWrites(wire::frame(0xFE, 0x82, params), 1'000'000, 0us);
    std::vector<Reply> replies;
    while (const auto at = bus.nextHostRun(1s))
        replies.push_back({bus.hostReads(*at), *at});
    return replies;
}
} // namespace

class TestWireSyncRead : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void repliesComeInTheOrderOfTheList()
    {
        const auto bus = wire::bus("sts3215@1,sts3250@2,sts3215@3");
        const auto replies = syncRead(*bus, {3, 1, 2});
        QCOMPARE(replies.size(), std::size_t{3});
        QVERIFY(wire::isStatusOf(replies[0].bytes, 3));
        QVERIFY(wire::isStatusOf(replies[1].bytes, 1));
        QVERIFY(wire::isStatusOf(replies[2].bytes, 2));
        for (const Reply& reply : replies)
            QCOMPARE(reply.bytes.size(), std::size_t{21});
    }

    // Measured on hardware: 16 servos, 15 bytes each at 1 Mbaud, 0.295 ms apart, all in by 4.9 ms.
    void sixteenServosTakeTheMeasuredTime()
    {
        QByteArray list;
        Bytes ids;
        for (std::uint8_t id = 1; id <= 16; ++id) {
            list += (list.isEmpty() ? "" : ",") + QByteArray("sts3215@") + QByteArray::number(id);
            ids.push_back(id);
        }
        const auto bus = wire::bus(list.constData());
        const auto replies = syncRead(*bus, ids);
        QCOMPARE(replies.size(), std::size_t{16});
        for (std::size_t i = 1; i < replies.size(); ++i)
            QCOMPARE(replies[i].complete - replies[i - 1].complete, 295us);
        QVERIFY(replies.back().complete <= 5000us);
        QVERIFY(replies.back().complete >= 4600us);
    }

    void aMissingServoLeavesAGap()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@3");
        const auto replies = syncRead(*bus, {1, 2, 3});
        QCOMPARE(replies.size(), std::size_t{2});
        QVERIFY(wire::isStatusOf(replies[0].bytes, 1));
        QVERIFY(wire::isStatusOf(replies[1].bytes, 3));
        QCOMPARE(replies[1].complete - replies[0].complete, 2 * 295us);
    }

    void theFirstMayBeMissing()
    {
        const auto bus = wire::bus("sts3215@2");
        const auto replies = syncRead(*bus, {1, 2});
        QCOMPARE(replies.size(), std::size_t{1});
        QVERIFY(wire::isStatusOf(replies[0].bytes, 2));
    }

    void aSlowServoDelaysTheOthers()
    {
        const auto bus = wire::bus("sm40blhv@1,sts3215@2", 1'000'000);
        bus->servo(1)->poke(QStringLiteral("return_delay"), 250);
        const auto replies = syncRead(*bus, {1, 2});
        QCOMPARE(replies.size(), std::size_t{2});
        QVERIFY(wire::isStatusOf(replies[0].bytes, 1));
        QVERIFY(wire::isStatusOf(replies[1].bytes, 2));
        QCOMPARE(replies[1].complete - replies[0].complete, 295us);
    }

    // SCS servos do not have the instruction.
    void scsServosStaySilent()
    {
        const auto bus = wire::bus("sts3215@1,scs15@2");
        const auto replies = syncRead(*bus, {2, 1});
        QCOMPARE(replies.size(), std::size_t{1});
        QVERIFY(wire::isStatusOf(replies[0].bytes, 1));
    }

    void anEmptyListGetsNoReply()
    {
        const auto bus = wire::bus("sts3215@1");
        QVERIFY(syncRead(*bus, {}).empty());
    }
};

SERVODESK_GUILESS_TEST(TestWireSyncRead)
#include "tst_wire_sync_read.moc"
