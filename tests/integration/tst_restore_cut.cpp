// SPDX-License-Identifier: GPL-3.0-or-later
// A restore of twenty rows, ended at every single frame: the link is cut, or the servo loses its
// supply. Afterwards nothing is misreported, the journal knows everything that is owed, no lock
// stays open once the servo is reachable and recovery has been asked, and continuing, in either
// way, completes it.
#include "integration/restore_rows.h"
#include "jobs/recover.h"
#include "jobs/restore.h"

#include <QRegularExpression>
#include <QTest>

using device::WriteOutcome;
using jobs::RecoverAction;
using jobs::RestoreVerdict;
using support::SimBench;
using support::TableValues;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

enum class Trouble { LinkCut, PowerLost };
enum class Then { Finish, Undo, Again };

/// Nullopt: it ended with an error.
std::optional<jobs::RestoreOutcome> restoreOn(SimBench& bench, const record::Snapshot& snapshot)
{
    const std::vector<base::Protocol> feetech{base::Protocol::Feetech};
    auto servo = device::identifyAmong(bench.context(), 1, feetech);
    if (!servo || !device::readAll(bench.context(), *servo))
        return std::nullopt;
    jobs::RestoreChoice choice;
    choice.dangerous = true;
    jobs::RestoreOptions options;
    options.dangerous = true;
    const auto plan = jobs::planRestore(*servo, snapshot, choice);
    const auto outcome = jobs::restore(bench.context(), *servo, plan, options);
    return outcome ? std::optional(*outcome) : std::nullopt;
}

/// Ends it when this many frames have gone out.
void arm(SimBench& bench, Trouble trouble, std::size_t frame, bool& fired)
{
    bench.forgetFrames();
    bench.tap().onWrite = [&bench, trouble, frame, &fired](const base::Bytes&) {
        if (fired || bench.frameCount() < frame)
            return;
        fired = true;
        if (trouble == Trouble::LinkCut)
            bench.cutLink();
        else
            bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    };
}

struct Frames {
    std::size_t all = 0;
    std::size_t firstWrite = 0; ///< number of the frame that begins the change
};

Frames framesOfWholeRestore(const record::Snapshot& snapshot)
{
    SimBench bench(text("sts3215@1"));
    bench.forgetFrames();
    const auto outcome = restoreOn(bench, snapshot);
    if (!outcome || outcome->verdict != RestoreVerdict::Done || outcome->rows.size() != 20)
        qFatal("the restore does not work on a whole line");
    Frames frames;
    const auto& written = bench.tap().written;
    frames.all = written.size();
    while (frames.firstWrite < written.size() && written[frames.firstWrite][4] != support::Write)
        ++frames.firstWrite;
    return frames;
}

/// What the report claims of each row is so.
QString lies(SimBench& bench, const jobs::RestoreOutcome& outcome)
{
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        const std::int64_t now = bench.raw(1, row.write.key);
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

class TestRestoreCut : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }
    void endedAtEveryFrame_data();
    void endedAtEveryFrame();
};

void TestRestoreCut::endedAtEveryFrame_data()
{
    QTest::addColumn<int>("trouble");
    QTest::addColumn<int>("then");
    QTest::newRow("link cut, finished") << int(Trouble::LinkCut) << int(Then::Finish);
    QTest::newRow("link cut, undone") << int(Trouble::LinkCut) << int(Then::Undo);
    QTest::newRow("link cut, restored again") << int(Trouble::LinkCut) << int(Then::Again);
    QTest::newRow("power lost, finished") << int(Trouble::PowerLost) << int(Then::Finish);
    QTest::newRow("power lost, undone") << int(Trouble::PowerLost) << int(Then::Undo);
    QTest::newRow("power lost, restored again") << int(Trouble::PowerLost) << int(Then::Again);
}

void TestRestoreCut::endedAtEveryFrame()
{
    QFETCH(int, trouble);
    QFETCH(int, then);
    const record::Snapshot snapshot = support::snapshotOfTwentyRows();
    const Frames frames = framesOfWholeRestore(snapshot);
    int interrupted = 0;
    for (std::size_t frame = 1; frame <= frames.all; ++frame) {
        const QByteArray where = QByteArray::number(qulonglong(frame));
        SimBench bench(text("sts3215@1"));
        const TableValues before = support::held(bench);
        TableValues after = before;
        for (const auto& [key, raw] : support::twentyRows())
            after[key] = raw;
        bool fired = false;
        arm(bench, Trouble(trouble), frame, fired);
        const auto outcome = restoreOn(bench, snapshot);
        bench.tap().onWrite = nullptr;
        QVERIFY2(fired, where.constData());
        const auto open = *bench.journal().open();

        // What is claimed, before anybody looks again.
        if (outcome && outcome->verdict == RestoreVerdict::Done) {
            QVERIFY2(open.empty(), where.constData());
            QVERIFY2(frame >= frames.all - 1, where.constData());
        }
        bench.withWire([](sim::VirtualBus& wire) { wire.servos().front()->powerOn(); });
        bench.letTimePass(std::chrono::seconds(3));
        if (outcome) {
            const QString lie = lies(bench, *outcome);
            QVERIFY2(lie.isEmpty(), where + ": " + lie.toUtf8());
        }
        if (support::lockIsOpen(bench))
            QVERIFY2(!open.empty(), where.constData());
        for (const base::Intent& intent : open) {
            QCOMPARE(intent.kind, base::IntentKind::Restore);
            QCOMPARE(intent.items.size(), std::size_t(20));
        }
        interrupted += open.empty() ? 0 : 1;

        bench.reconnect(1'000'000);
        if (Then(then) == Then::Again) {
            const auto again = restoreOn(bench, snapshot);
            QVERIFY2(again.has_value(), where.constData());
            QVERIFY2(again->verdict == RestoreVerdict::Done ||
                         again->verdict == RestoreVerdict::AlreadySo,
                     where.constData());
        } else {
            const auto action =
                Then(then) == Then::Finish ? RecoverAction::Finish : RecoverAction::Undo;
            const auto recovered = jobs::recover(bench.context(), action);
            QVERIFY2(recovered.has_value(), where.constData());
            QCOMPARE(recovered->size(), open.size());
            for (const jobs::Recovered& one : *recovered)
                QVERIFY2(one.done, where.constData());
        }
        QVERIFY2(!support::lockIsOpen(bench), where.constData());
        QVERIFY2(bench.journal().open()->empty(), where.constData());
        const TableValues now = support::held(bench);
        const bool asWanted = open.empty() && Then(then) != Then::Again
                                  ? now == before || now == after
                                  : now == (Then(then) == Then::Undo ? before : after);
        QVERIFY2(asWanted, where.constData());
        bench.powerCycle();
        bench.letTimePass(std::chrono::seconds(3));
        QVERIFY2(support::held(bench) == now, where.constData());
        QVERIFY2(!support::lockIsOpen(bench), where.constData());

        bench.reconnect(1'000'000);
        if (Then(then) == Then::Again) {
            const auto third = restoreOn(bench, snapshot);
            QVERIFY2(third && third->verdict == RestoreVerdict::AlreadySo, where.constData());
            QVERIFY2(bench.onlyAsked(), where.constData());
        }
    }
    QVERIFY(interrupted > 15);
}

QTEST_GUILESS_MAIN(TestRestoreCut)
#include "tst_restore_cut.moc"
