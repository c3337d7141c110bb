// SPDX-License-Identifier: GPL-3.0-or-later
// A restore of twenty rows, ended at every single frame: the link is cut, or the servo loses its
// supply. Afterwards nothing is misreported, the journal knows everything that is owed, no lock
// stays open once the servo is reachable and recovery has been asked, and continuing, in either
// way, completes it.
#include "integration/twenty_registers.h"
#include "jobs/recover/recover.h"
#include "jobs/restore/restore.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using device::WriteOutcome;
using jobs::RecoveryAction;
using jobs::RestoreVerdict;
using support::SimFixture;
using support::TableValues;
using support::utf8;

namespace {
enum class Failure { LinkCut, PowerLost };
enum class FollowUp { Finish, Undo, Again };

/// Nullopt: it ended with an error.
std::optional<jobs::RestoreOutcome> restoreOn(SimFixture& fixture,
                                              const snapshot::Snapshot& snapshot)
{
    const std::vector<base::Protocol> feetech{base::Protocol::Feetech};
    auto servo = device::identifyAmong(fixture.context(), 1, feetech);
    if (!servo || !device::readAll(fixture.context(), *servo))
        return std::nullopt;
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    jobs::RestoreOptions options;
    options.consent = device::Consent::confirmed();
    const auto plan = jobs::planRestore(*servo, snapshot, choice);
    const auto outcome = jobs::restore(fixture.context(), *servo, plan, options);
    return outcome ? std::optional(*outcome) : std::nullopt;
}

/// Ends it when this many frames have gone out.
void arm(SimFixture& fixture, Failure trouble, std::size_t frame, bool& fired)
{
    fixture.clearFrames();
    fixture.tap().onWrite = [&fixture, trouble, frame, &fired](const base::Bytes&) {
        if (fired || fixture.frameCount() < frame)
            return;
        fired = true;
        if (trouble == Failure::LinkCut)
            fixture.cutLink();
        else
            fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    };
}

struct RestoreFrames {
    std::size_t all = 0;
    std::size_t firstWrite = 0; ///< number of the frame that begins the change
};

RestoreFrames fullRestoreFrames(const snapshot::Snapshot& snapshot)
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.clearFrames();
    const auto outcome = restoreOn(fixture, snapshot);
    if (!outcome || outcome->verdict != RestoreVerdict::Done || outcome->rows.size() != 20)
        qFatal("the restore does not work on a whole line");
    RestoreFrames frames;
    const auto& written = fixture.tap().written;
    frames.all = written.size();
    while (frames.firstWrite < written.size() && written[frames.firstWrite][4] != support::Write)
        ++frames.firstWrite;
    return frames;
}

/// What the report claims of each row is so.
QString reportErrors(SimFixture& fixture, const jobs::RestoreOutcome& outcome)
{
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        const std::int64_t now = fixture.raw(1, row.write.key);
        const bool claimed = row.write.outcome == WriteOutcome::Kept;
        const bool denied = device::isUntouched(row.write.outcome);
        if ((claimed && now != row.write.newRaw) || (denied && now != row.write.oldRaw))
            return QStringLiteral("%1 %2, but it is %3")
                .arg(row.write.key, device::outcomeName(row.write.outcome))
                .arg(now);
    }
    return {};
}
} // namespace

class TestRestoreInterrupted : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }
    void interruptedAtEveryFrame_data();
    void interruptedAtEveryFrame();
};

void TestRestoreInterrupted::interruptedAtEveryFrame_data()
{
    QTest::addColumn<int>("trouble");
    QTest::addColumn<int>("then");
    QTest::newRow("link cut, finished") << int(Failure::LinkCut) << int(FollowUp::Finish);
    QTest::newRow("link cut, undone") << int(Failure::LinkCut) << int(FollowUp::Undo);
    QTest::newRow("link cut, restored again") << int(Failure::LinkCut) << int(FollowUp::Again);
    QTest::newRow("power lost, finished") << int(Failure::PowerLost) << int(FollowUp::Finish);
    QTest::newRow("power lost, undone") << int(Failure::PowerLost) << int(FollowUp::Undo);
    QTest::newRow("power lost, restored again") << int(Failure::PowerLost) << int(FollowUp::Again);
}

void TestRestoreInterrupted::interruptedAtEveryFrame()
{
    QFETCH(int, trouble);
    QFETCH(int, then);
    const snapshot::Snapshot snapshot = support::twentyRegisterSnapshot();
    const RestoreFrames frames = fullRestoreFrames(snapshot);
    int interrupted = 0;
    for (std::size_t frame = 1; frame <= frames.all; ++frame) {
        const QByteArray where = QByteArray::number(qulonglong(frame));
        SimFixture fixture(utf8("sts3215@1"));
        const TableValues before = support::held(fixture);
        TableValues after = before;
        for (const auto& [key, raw] : support::twentyRegisters())
            after[key] = raw;
        bool fired = false;
        arm(fixture, Failure(trouble), frame, fired);
        const auto outcome = restoreOn(fixture, snapshot);
        fixture.tap().onWrite = nullptr;
        QVERIFY2(fired, where.constData());
        const auto open = *fixture.journal().open();

        // The report, before anything is read again.
        if (outcome && outcome->verdict == RestoreVerdict::Done) {
            QVERIFY2(open.empty(), where.constData());
            QVERIFY2(frame >= frames.all - 1, where.constData());
        }
        fixture.withBus([](sim::VirtualBus& wire) { wire.servos().front()->powerOn(); });
        fixture.runFor(std::chrono::seconds(3));
        if (outcome) {
            const QString reportError = reportErrors(fixture, *outcome);
            QVERIFY2(reportError.isEmpty(), where + ": " + reportError.toUtf8());
        }
        if (support::isLockOpen(fixture))
            QVERIFY2(!open.empty(), where.constData());
        for (const base::Intent& intent : open) {
            QCOMPARE(intent.kind, base::IntentKind::Restore);
            QCOMPARE(intent.items.size(), std::size_t(20));
        }
        interrupted += open.empty() ? 0 : 1;

        fixture.reconnect(1'000'000);
        if (FollowUp(then) == FollowUp::Again) {
            const auto again = restoreOn(fixture, snapshot);
            QVERIFY2(again.has_value(), where.constData());
            QVERIFY2(again->verdict == RestoreVerdict::Done ||
                         again->verdict == RestoreVerdict::AlreadySet,
                     where.constData());
        } else {
            const auto action =
                FollowUp(then) == FollowUp::Finish ? RecoveryAction::Finish : RecoveryAction::Undo;
            const auto recovered = jobs::recover(fixture.context(), action);
            QVERIFY2(recovered.has_value(), where.constData());
            QCOMPARE(recovered->size(), open.size());
            for (const jobs::RecoveryResult& one : *recovered)
                QVERIFY2(one.done, where.constData());
        }
        QVERIFY2(!support::isLockOpen(fixture), where.constData());
        QVERIFY2(fixture.journal().open()->empty(), where.constData());
        const TableValues now = support::held(fixture);
        const bool expectedValues =
            open.empty() && FollowUp(then) != FollowUp::Again
                ? now == before || now == after
                : now == (FollowUp(then) == FollowUp::Undo ? before : after);
        QVERIFY2(expectedValues, where.constData());
        fixture.powerCycle();
        fixture.runFor(std::chrono::seconds(3));
        QVERIFY2(support::held(fixture) == now, where.constData());
        QVERIFY2(!support::isLockOpen(fixture), where.constData());

        fixture.reconnect(1'000'000);
        if (FollowUp(then) == FollowUp::Again) {
            const auto third = restoreOn(fixture, snapshot);
            QVERIFY2(third && third->verdict == RestoreVerdict::AlreadySet, where.constData());
            QVERIFY2(fixture.onlyReadsSent(), where.constData());
        }
    }
    QVERIFY(interrupted > 15);
}

SERVODESK_GUILESS_TEST(TestRestoreInterrupted)
#include "tst_restore_interrupted.moc"
