// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a bus that need no wire: planning, percentiles, bounded stores, holds.
#include "bus/hold_table.h"
#include "bus/poll_buffer.h"
#include "bus/poll_planner.h"
#include "bus/round_trip_histogram.h"
#include "bus/trace_ring.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using namespace bus;
using base::Bytes;
using base::Duration;
using protocol::Request;
using Access = HoldTable::Access;

namespace {
QString shown(const std::vector<PollSpan>& spans)
{
    QStringList words;
    for (const PollSpan& span : spans)
        words += QStringLiteral("%1+%2").arg(span.address).arg(span.count);
    return words.join(u' ');
}

QString shown(const std::vector<PollGroup>& groups)
{
    QStringList words;
    for (const PollGroup& group : groups) {
        QStringList ids;
        for (const int id : group.ids)
            ids += QString::number(id);
        words += (group.sync ? QStringLiteral("sync ") : QStringLiteral("each ")) + ids.join(u',') +
                 u'@' + shown(group.blocks);
    }
    return words.join(QStringLiteral("; "));
}

std::thread::id otherThread()
{
    std::thread::id id;
    std::thread([&id] { id = std::this_thread::get_id(); }).join();
    return id;
}
} // namespace

class TestBusParts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void spansAreMerged_data()
    {
        QTest::addColumn<std::vector<PollSpan>>("spans");
        QTest::addColumn<QString>("blocks");
        using Spans = std::vector<PollSpan>;
        QTest::newRow("none") << Spans{} << QString();
        QTest::newRow("adjacent") << Spans{{56, 2}, {58, 2}} << QStringLiteral("56+4");
        QTest::newRow("any order") << Spans{{60, 2}, {56, 2}} << QStringLiteral("56+6");
        QTest::newRow("overlap") << Spans{{56, 8}, {60, 10}} << QStringLiteral("56+14");
        QTest::newRow("contained") << Spans{{56, 15}, {60, 2}} << QStringLiteral("56+15");
        QTest::newRow("cheap gap") << Spans{{0, 2}, {14, 1}} << QStringLiteral("0+15");
        QTest::newRow("dear gap") << Spans{{0, 2}, {15, 1}} << QStringLiteral("0+2 15+1");
        QTest::newRow("too long together")
            << Spans{{0, 100}, {100, 29}} << QStringLiteral("0+100 100+29");
        QTest::newRow("just fits") << Spans{{0, 100}, {100, 28}} << QStringLiteral("0+128");
        QTest::newRow("empty span") << Spans{{5, 0}, {7, 1}} << QStringLiteral("7+1");
    }

    void spansAreMerged()
    {
        QFETCH(const std::vector<PollSpan>, spans);
        QFETCH(const QString, blocks);
        QCOMPARE(shown(mergeSpans(spans, 12, 128)), blocks);
    }

    void slowSpansDoNotSplitFastOnes()
    {
        QCOMPARE(shown(mergeSpans({{56, 2, 1}, {58, 2, 5}, {60, 2, 1}, {62, 1, 5}}, 12, 128)),
                 QStringLiteral("56+6 58+5"));
    }

    void mergingCanBeLimited_data()
    {
        QTest::addColumn<std::vector<PollSpan>>("spans");
        QTest::addColumn<int>("gap");
        QTest::addColumn<int>("longest");
        QTest::addColumn<QString>("blocks");
        using Spans = std::vector<PollSpan>;
        QTest::newRow("no gap") << Spans{{512, 4}, {516, 2}, {520, 2}} << 0 << 58
                                << QStringLiteral("512+6 520+2");
        QTest::newRow("no longer than the servo's buffer")
            << Spans{{0, 58}, {58, 2}} << 0 << 58 << QStringLiteral("0+58 58+2");
        QTest::newRow("as they are")
            << Spans{{168, 4}, {172, 4}, {168, 4}} << -1 << 128 << QStringLiteral("168+4 172+4");
    }

    void mergingCanBeLimited()
    {
        QFETCH(const std::vector<PollSpan>, spans);
        QFETCH(const int, gap);
        QFETCH(const int, longest);
        QFETCH(const QString, blocks);
        QCOMPARE(shown(mergeSpans(spans, gap, longest)), blocks);
    }

    void servosAreGrouped_data()
    {
        QTest::addColumn<PollPlan>("plan");
        QTest::addColumn<QString>("groups");
        const std::vector<PollSpan> feedback{{56, 15}};
        QTest::newRow("equal blocks share a packet")
            << PollPlan{{{1, feedback, true, 0}, {2, {{56, 8}, {60, 11}}, true, 0}}, {}}
            << QStringLiteral("sync 1,2@56+15");
        QTest::newRow("families do not")
            << PollPlan{{{1, feedback, true, 0}, {2, feedback, true, 1}}, {}}
            << QStringLiteral("sync 1@56+15; sync 2@56+15");
        QTest::newRow("nor other blocks")
            << PollPlan{{{1, feedback, true, 0}, {2, {{56, 2}}, true, 0}}, {}}
            << QStringLiteral("sync 1@56+15; sync 2@56+2");
        QTest::newRow("nor servos without sync read")
            << PollPlan{{{1, feedback, true, 0}, {2, feedback, false, 0}}, {}}
            << QStringLiteral("sync 1@56+15; each 2@56+15");
        QTest::newRow("named twice")
            << PollPlan{{{1, {{56, 2}}, false, 0}, {1, {{58, 2}}, false, 0}}, {}}
            << QStringLiteral("each 1@56+4");
        QTest::newRow("nothing to read") << PollPlan{{{1, {}, true, 0}}, {}} << QString();
    }

    void servosAreGrouped()
    {
        QFETCH(const PollPlan, plan);
        QFETCH(const QString, groups);
        QCOMPARE(shown(planGroups(plan)), groups);
    }

    void syncGroupsStayWithinThePacketCap()
    {
        PollPlan plan;
        for (int id = 0; id <= 253; ++id)
            plan.servos.push_back({id, {{56, 2}}, true, 0});
        const auto groups = planGroups(plan);
        QCOMPARE(groups.size(), std::size_t(2));
        QVERIFY(8 + groups.front().ids.size() <= 250);
        QCOMPARE(groups[0].ids.size() + groups[1].ids.size(), std::size_t(254));
    }

    void percentiles_data()
    {
        QTest::addColumn<qint64>("step");
        QTest::newRow("exact") << qint64(1);
        QTest::newRow("milliseconds") << qint64(1000);
        QTest::newRow("seconds") << qint64(100'000);
    }

    void percentiles()
    {
        QFETCH(const qint64, step);
        RoundTripHistogram trips;
        QCOMPARE(trips.percentile(0.5), Duration{});
        for (int i = 1; i <= 100; ++i)
            trips.add(Duration(i * step));
        const auto near = [step](Duration value, qint64 wanted) {
            return qAbs(value.count() - wanted * step) <= wanted * step / 64;
        };
        QVERIFY(near(trips.percentile(0.50), 50));
        QVERIFY(near(trips.percentile(0.99), 99));
        QVERIFY(near(trips.percentile(1.00), 100));
    }

    void traceKeepsTheLatest()
    {
        TraceRing ring(3);
        for (std::uint8_t i = 0; i < 5; ++i)
            ring.add(Duration(i), TraceKind::Sent, Bytes{i});
        auto entries = ring.take();
        QCOMPARE(entries.size(), std::size_t(3));
        QCOMPARE(entries.front().dropped, std::uint64_t(2));
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(entries[i].bytes, (Bytes{std::uint8_t(i + 2)}));
        ring.add(Duration(9), TraceKind::Noise, Bytes{9});
        entries = ring.take();
        QCOMPARE(entries.size(), std::size_t(1));
        QCOMPARE(entries.front().dropped, std::uint64_t(0));
        QVERIFY(ring.take().empty());
    }

    void samplesAreBoundedAndCounted()
    {
        PollBuffer store;
        const PollId id = store.open();
        for (std::size_t i = 0; i < PollBuffer::capacity + 5; ++i) {
            Sample sample;
            sample.at = Duration(i);
            store.add(id, sample);
        }
        const auto samples = store.take(id);
        QCOMPARE(samples.size(), PollBuffer::capacity);
        QCOMPARE(samples.front().at, Duration(5));
        QCOMPARE(store.lost(), std::uint64_t(5));
    }

    void samplesOutliveTheirPlanUntilTaken()
    {
        PollBuffer store;
        const PollId id = store.open();
        store.add(id, {});
        store.close(id);
        QCOMPARE(store.take(id).size(), std::size_t(1));
        store.add(id, {});
        QVERIFY(store.take(id).empty());
    }

    void holds_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("withToken");
        QTest::addColumn<int>("ownThread");
        QTest::addColumn<int>("otherThreads");
        const auto row = [](const char* what, Access withToken, Access own, Access other) {
            QTest::newRow(what) << QString::fromLatin1(what) << int(withToken) << int(own)
                                << int(other);
        };
        row("read held", Access::Pass, Access::Refused, Access::Wait);
        row("read free", Access::Pass, Access::Pass, Access::Pass);
        row("broadcast", Access::Pass, Access::Refused, Access::Wait);
        row("raw", Access::Pass, Access::Refused, Access::Wait);
        row("sync with held", Access::Pass, Access::Refused, Access::Wait);
        row("sync of free", Access::Pass, Access::Pass, Access::Pass);
    }

    void holds()
    {
        QFETCH(const QString, what);
        QFETCH(const int, withToken);
        QFETCH(const int, ownThread);
        QFETCH(const int, otherThreads);
        const std::map<QString, Request> requests{
            {QStringLiteral("read held"), Request::read(1, 56, 2)},
            {QStringLiteral("read free"), Request::read(3, 56, 2)},
            {QStringLiteral("broadcast"), Request::action()},
            {QStringLiteral("raw"), Request::raw({0xFF})},
            {QStringLiteral("sync with held"), Request::syncRead(56, 2, {3, 2})},
            {QStringLiteral("sync of free"), Request::syncRead(56, 2, {3, 4})}};
        const auto self = std::this_thread::get_id();
        HoldTable table;
        const auto token = table.take({1, 2}, self);
        QVERIFY(token != 0);
        const Request& request = requests.at(what);
        QCOMPARE(int(table.access(request, token, self)), withToken);
        QCOMPARE(int(table.access(request, 0, self)), ownThread);
        QCOMPARE(int(table.access(request, 0, otherThread())), otherThreads);
        table.release(token);
        QCOMPARE(table.access(request, 0, otherThread()), Access::Pass);
    }

    void holdsExcludeOtherThreads()
    {
        const auto self = std::this_thread::get_id();
        const auto other = otherThread();
        HoldTable table;
        const auto mine = table.take({1}, self);
        QVERIFY(table.take({1, 5}, other) == 0);
        QVERIFY(table.take({}, other) == 0);
        QVERIFY(table.take({5}, other) != 0);
        QVERIFY2(table.take({1, 2}, self) != 0, "the same thread may hold twice");
        QVERIFY2(table.take({}, self) == 0, "servo 5 is the other thread's");
        table.release(mine);
        QVERIFY2(table.isHeld(1), "held twice, released once");
        QVERIFY(!table.isHeld(7));
    }

    void broadcastsRespectEveryHold_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("broadcast") << Request::action();
        QTest::newRow("raw") << Request::raw({0xFF});
    }

    void broadcastsRespectEveryHold()
    {
        QFETCH(const Request, request);
        const auto self = std::this_thread::get_id();
        const auto other = otherThread();
        HoldTable table;
        const auto before = table.take({4}, other);
        const auto mine = table.take({1}, self);
        QVERIFY(table.take({2}, self) != 0);
        const auto after = table.take({5}, other);
        QCOMPARE(table.access(request, mine, self), Access::Wait);
        QCOMPARE(table.access(Request::read(1, 56, 2), mine, self), Access::Pass);
        table.release(before);
        QCOMPARE(table.access(request, mine, self), Access::Wait);
        table.release(after);
        QCOMPARE(table.access(request, mine, self), Access::Pass);
        QCOMPARE(table.access(request, 0, self), Access::Refused);
    }

    void everyHoldIsNotifiedOfAnEmergencyOnce()
    {
        const auto self = std::this_thread::get_id();
        HoldTable table;
        const auto token = table.take({1}, self);
        table.preemptAll();
        const Request read = Request::read(1, 0, 1);
        QCOMPARE(table.access(read, token, self), Access::Preempted);
        QCOMPARE(table.access(read, token, self), Access::Pass);
    }
};

SERVODESK_GUILESS_TEST(TestBusParts)
#include "tst_bus_parts.moc"
