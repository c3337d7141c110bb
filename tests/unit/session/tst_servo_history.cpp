// SPDX-License-Identifier: GPL-3.0-or-later
// What the list keeps of the journal for each servo: every write of every task, also of those that
// change the mode or the ID, and nothing of another bus.
#include "device/motion/motion.h"
#include "jobs/change/change.h"
#include "session/history/servo_history.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>

#include "session_fixture.h"

using support::utf8;

namespace {
QStringList keysOf(const std::vector<base::JournalEntry>& entries)
{
    QStringList keys;
    for (const base::JournalEntry& entry : entries) {
        for (const base::JournalItem& item : entry.intent.items)
            keys << item.key;
    }
    return keys;
}
} // namespace

class TestServoHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void modeSwitchesAreIncluded();
    void followsTheServoToItsNewId();
    void anotherSimulatedBusIsExcluded();
};

void TestServoHistory::modeSwitchesAreIncluded()
{
    SessionFixture fixture(utf8("sim:sts3215@1"));
    QVERIFY(fixture.opened && fixture.search());
    const ServoRef ref = fixture.at(1);
    session::Task task;
    task.name = utf8("mode");
    task.savesTable = true;
    task.work = [](session::TaskContext& context) -> base::Result<void> {
        const auto done = device::switchMode(context.device, context.servo, utf8("speed"));
        return done ? base::Result<void>() : tl::unexpected(done.error());
    };
    fixture.workbench.tasks().perform(ref, std::move(task));
    QVERIFY(fixture.waitUntilIdle());
    QTRY_VERIFY(keysOf(fixture.entry(ref).history).contains(utf8("operating_mode")));
}

void TestServoHistory::followsTheServoToItsNewId()
{
    SessionFixture fixture(utf8("sim:sts3215@1,sts3215@2"));
    QVERIFY(fixture.opened && fixture.search());
    const ServoRef first = fixture.at(1);
    const ServoRef second = fixture.at(2);
    QVERIFY(fixture.write(first, positionP, 40));
    QVERIFY(fixture.write(second, utf8("position_d"), 20));
    const auto change = [&](ServoRef ref, int id) {
        session::Task task;
        task.name = utf8("set-id");
        task.savesTable = true;
        task.work = [id](session::TaskContext& context) -> base::Result<void> {
            const auto done = jobs::changeId(context.device, context.servo, id);
            return done ? base::Result<void>() : tl::unexpected(done.error());
        };
        fixture.workbench.tasks().perform(ref, std::move(task));
        return fixture.waitUntilIdle();
    };
    QVERIFY(change(first, 7));
    QCOMPARE(fixture.entry(first).servo.id, 7);
    QTRY_COMPARE(keysOf(fixture.entry(first).history), QStringList({positionP, utf8("id")}));
    // The other one takes the ID that has become free, not what was written to it before.
    QVERIFY(change(second, 1));
    QTRY_COMPARE(keysOf(fixture.entry(second).history),
                 QStringList({utf8("position_d"), utf8("id")}));
    QVERIFY(fixture.write(first, positionP, 41));
    QTRY_COMPARE(keysOf(fixture.entry(first).history),
                 QStringList({positionP, utf8("id"), positionP}));
    QVERIFY(change(first, 8));
    QTRY_COMPARE(keysOf(fixture.entry(first).history),
                 QStringList({positionP, utf8("id"), positionP, utf8("id")}));
}

void TestServoHistory::anotherSimulatedBusIsExcluded()
{
    SessionFixture fixture(utf8("sim:sts3215@1"));
    QVERIFY(fixture.opened && fixture.search());
    QVERIFY(fixture.write(fixture.at(1), positionP, 40));
    QTRY_COMPARE(fixture.entry(fixture.at(1)).history.size(), std::size_t(1));
    fixture.workbench.closing().disconnectFrom();
    QVERIFY(support::waitFor([&] { return fixture.workbench.link().state() == LinkState::Off; }));
    QVERIFY(fixture.open(utf8("sim:sts3215@1,sts3215@9")) && fixture.search());
    const ServoRef other = fixture.at(1);
    fixture.workbench.writes().loadHistory(other);
    QVERIFY(fixture.write(other, utf8("position_d"), 20)); // behind it
    QTRY_COMPARE(keysOf(fixture.entry(other).history), QStringList(utf8("position_d")));
}

SERVODESK_GUILESS_TEST(TestServoHistory)
#include "tst_servo_history.moc"
