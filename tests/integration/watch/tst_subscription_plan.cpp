// SPDX-License-Identifier: GPL-3.0-or-later
// From wishes to polls: one union, one packet for those that are read alike, nothing read that
// nobody needs.
#include "bus/poll_planner.h"
#include "session/polling/subscription_plan.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using session::ServoEntry;
using session::Subscription;
using session::SubscriptionPlan;
using namespace std::chrono_literals;

namespace {
const QStringList feedback{QStringLiteral("present_position"), QStringLiteral("present_speed"),
                           QStringLiteral("present_load"), QStringLiteral("present_voltage"),
                           QStringLiteral("moving")};
const QString position = feedback.front();
constexpr int fastBaud = 1'000'000;

struct FeedFixture {
    explicit FeedFixture(const QString& list, const std::vector<int>& ids,
                         base::Protocol protocol = base::Protocol::Feetech)
        : fixture(list, {protocol == base::Protocol::Feetech ? fastBaud : 115'200})
    {
        for (const int id : ids) {
            ServoEntry entry;
            entry.ref = 100 + id;
            entry.servo = fixture.servo(id, protocol);
            entries.push_back(entry);
        }
    }
    SubscriptionPlan plan(const std::vector<Subscription>& subscriptions) const
    {
        std::vector<const ServoEntry*> present;
        for (const ServoEntry& entry : entries)
            present.push_back(&entry);
        return session::planSubscriptions(subscriptions, present, fixture.bus().baud());
    }
    mutable support::SimFixture fixture;
    std::vector<ServoEntry> entries;
};

int fastPollBytes(const std::vector<bus::PollSpan>& spans)
{
    int bytes = 0;
    for (const bus::PollSpan& span : spans)
        bytes += span.every == 1 ? span.count : 0;
    return bytes;
}
} // namespace

class TestSubscriptionPlan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void noSubscriptionReadsNothing()
    {
        const FeedFixture present(QStringLiteral("sts3215@1"), {1});
        QVERIFY(present.plan({}).targets.empty());
        QVERIFY(present.plan({{{{999, feedback}}, {}}}).primary.servos.empty());
        QVERIFY(present.plan({{{{101, {QStringLiteral("no_such_thing")}}}, {}}}).targets.empty());
    }

    void aFamilySharesOneSyncRead()
    {
        const FeedFixture present(QStringLiteral("sts3215@1,sts3215@2,sts3250@3"), {1, 2, 3});
        const SubscriptionPlan plan =
            present.plan({{{{101, feedback}, {102, feedback}, {103, feedback}}, {}}});
        const auto groups = bus::planGroups(plan.primary);
        QCOMPARE(groups.size(), std::size_t(1));
        QVERIFY(groups.front().sync);
        QCOMPARE(groups.front().ids.size(), std::size_t(3));
        QCOMPARE(groups.front().blocks.size(), std::size_t(1));
        QVERIFY(plan.secondary.servos.empty());
    }

    /// One register more of one of them costs less than a packet of its own.
    void extraRegistersAreReadOfAll()
    {
        const FeedFixture present(QStringLiteral("sts3215@1,sts3215@2"), {1, 2});
        const SubscriptionPlan plan = present.plan(
            {{{{101, feedback}, {102, feedback}}, {}},
             {{{102, {QStringLiteral("present_temperature"), QStringLiteral("goal_position")}}},
              20ms}});
        const auto groups = bus::planGroups(plan.primary);
        QCOMPARE(groups.size(), std::size_t(1));
        QCOMPARE(groups.front().ids.size(), std::size_t(2));
        QVERIFY(plan.primary.period == 0us); // the shortest of all wishes
    }

    /// The table of one servo does not swell what is read of the others.
    void aTableIsReadAlongside()
    {
        const FeedFixture present(QStringLiteral("sts3215@1,sts3215@2"), {1, 2});
        QStringList table;
        for (const catalog::Register& reg : present.entries[0].servo.profile->registers)
            table << reg.key;
        const SubscriptionPlan alone = present.plan({{{{101, feedback}, {102, feedback}}, {}}});
        const SubscriptionPlan plan =
            present.plan({{{{101, feedback}, {102, feedback}}, {}}, {{{101, table}}, {}}});
        QCOMPARE(plan.primary.servos[1].spans, alone.primary.servos[1].spans);
        QCOMPARE(plan.primary.servos[0].spans, plan.primary.servos[1].spans);
        QCOMPARE(plan.secondary.servos.size(), std::size_t(1));
        QCOMPARE(plan.secondary.servos.front().id, 1);
        // And nothing of it is left out.
        const session::PollTarget& target = plan.targets.front();
        for (const QString& key : table) {
            const catalog::Register* reg = target.profile->find(key);
            if (!present.entries[0].servo.measures(*reg))
                continue;
            const auto covers = [&](const bus::PollSpan& span) {
                return reg->offset >= span.address &&
                       reg->offset + reg->size <= span.address + span.count;
            };
            QVERIFY2(std::any_of(target.primary.begin(), target.primary.end(), covers) ||
                         std::any_of(target.secondary.begin(), target.secondary.end(), covers),
                     qPrintable(key));
        }
    }

    void familiesWithoutSyncReadAreReadSingly()
    {
        const FeedFixture present(QStringLiteral("sts3215@1,scs15@5,scs15@6"), {1, 5, 6});
        const SubscriptionPlan plan =
            present.plan({{{{101, {position}}, {105, {position}}, {106, {position}}}, {}}});
        const auto groups = bus::planGroups(plan.primary);
        QCOMPARE(groups.size(), std::size_t(3));
    }

    void slowSubscriptionsAreReadSlowly()
    {
        const FeedFixture present(QStringLiteral("sts3215@1,sts3215@2"), {1, 2});
        const QString mode = QStringLiteral("operating_mode");
        const SubscriptionPlan plan =
            present.plan({{{{101, {position}, {mode}}, {102, {position}}}, 10ms}});
        QCOMPARE(bus::planGroups(plan.primary).size(), std::size_t(1)); // still one packet
        const auto& spans = plan.targets.front().primary;
        QCOMPARE(fastPollBytes(spans), 2);
        const auto slow = std::find_if(spans.begin(), spans.end(),
                                       [](const bus::PollSpan& span) { return span.every > 1; });
        QVERIFY(slow != spans.end());
        QCOMPARE(slow->every, 50); // twice a second
        // What is read fast anyway is not read slowly too.
        const SubscriptionPlan both = present.plan({{{{101, {position, mode}, {mode}}}, 10ms}});
        QCOMPARE(bus::planGroups(both.primary).front().blocks.size(),
                 both.targets.front().primary.size());
        for (const bus::PollSpan& span : both.targets.front().primary)
            QCOMPARE(span.every, 1);
        // Somebody has to set the pace.
        const SubscriptionPlan onlySlow = present.plan({{{{101, {}, {mode}}}, {}}});
        QVERIFY(onlySlow.primary.period >= 100ms);
        QCOMPARE(onlySlow.targets.front().primary.front().every, 1);
    }

    /// LX tells neither faults nor several registers at once.
    void alarmsAreAlwaysPolled()
    {
        const FeedFixture present(QStringLiteral("lx224@1"), {1}, base::Protocol::Lx);
        const QString here =
            present.entries[0].servo.profile->byRole(catalog::Role::PresentPosition)->key;
        const SubscriptionPlan plan = present.plan({{{{101, {here}}}, {}}});
        QCOMPARE(plan.targets.size(), std::size_t(1));
        int slow = 0;
        for (const bus::PollSpan& span : plan.targets.front().primary)
            slow += span.every > 1 ? 1 : 0;
        QCOMPARE(slow, 2); // temperature and voltage, now and then
    }
};

SERVODESK_GUILESS_TEST(TestSubscriptionPlan)
#include "tst_subscription_plan.moc"
