// SPDX-License-Identifier: GPL-3.0-or-later
// The bench behind the window on a simulated bus: everything asked for returns at once and comes
// back as a signal; what is in the list was really read; writes end in one of the six words.
#include "record/history.h"
#include "record/snapshot.h"
#include "session/drive_tasks.h"
#include "session/paths.h"

#include <QDir>
#include <QSignalSpy>

#include "session_bench.h"
#include <atomic>
#include <thread>

class TestDesk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aPortThatIsNotThereSaysSo()
    {
        session::Session session;
        Desk desk(session);
        QSignalSpy failed(&desk, &Desk::connectFailed);
        desk.connectTo({.name = QStringLiteral("/dev/no-such-port")});
        QVERIFY(failed.wait());
        QCOMPARE(failed.front().front().value<base::Error>().code, base::ErrorCode::PortMissing);
        QCOMPARE(desk.state(), LinkState::Off);
    }

    /// Whatever is asked while a port is still being opened, the latest wish is what happens.
    void theLatestPortAskedForIsTheOneThatOpens()
    {
        support::OwnDataFolder place;
        session::Session session;
        Desk desk(session);
        QStringList connected;
        connect(&desk, &Desk::happened, &desk, [&](const session::Event& event) {
            if (event.kind == session::Event::Kind::Connected)
                connected << event.task;
        });
        desk.connectTo({.name = QStringLiteral("sim:modbus")});
        desk.connectTo({.name = QStringLiteral("sim:lx")});
        desk.connectTo({.name = QStringLiteral("sim:demo")});
        QTRY_COMPARE(desk.state(), LinkState::Open);
        QCOMPARE(connected, QStringList{QStringLiteral("sim:demo")});
        desk.disconnectFrom();
        QTRY_COMPARE(desk.state(), LinkState::Off);
        desk.connectTo({.name = QStringLiteral("sim:lx")});
        desk.disconnectFrom();
        desk.disconnectFrom();
        QCOMPARE(desk.state(), LinkState::Closing); // what is being opened is waited for
        QTRY_COMPARE(desk.state(), LinkState::Off);
        QVERIFY(desk.connection() == nullptr);
        QCOMPARE(connected.size(), 1);
    }

    void closingIsToldOnceAndNotFromWithin()
    {
        Bench bench;
        QVERIFY(bench.opened);
        QSignalSpy closed(&bench.desk, &Desk::closed);
        bench.desk.close();
        QCOMPARE(closed.size(), 0);
        QTRY_COMPARE(closed.size(), 1);
        QCoreApplication::processEvents();
        QCOMPARE(closed.size(), 1);
        QCOMPARE(bench.desk.state(), LinkState::Off);
    }

    void servosAppearWhileTheSearchRuns()
    {
        Bench bench;
        QVERIFY(bench.opened);
        bool foundDuring = false;
        connect(&bench.desk, &Desk::servoAdded, this,
                [&](ServoRef) { foundDuring = foundDuring || bench.desk.searching(); });
        QVERIFY(bench.search());
        QVERIFY(foundDuring);
        QCOMPARE(bench.desk.servos().size(), std::size_t(6));
        QVERIFY(bench.desk.lastSearch());
        QCOMPARE(bench.entry(bench.at(1)).servo.profile->modelName, QStringLiteral("STS3215"));
    }

    void aServoThatIsGoneLeavesTheListAtTheNextSearch()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef second = bench.at(2);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        QSignalSpy removed(&bench.desk, &Desk::servoRemoved);
        QVERIFY(bench.search());
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed.front().front().value<ServoRef>(), second);
        QVERIFY(bench.desk.servo(second) == nullptr);
        QVERIFY(bench.at(1) != 0);
    }

    void stoppingASearchEndsItSoon()
    {
        Bench bench;
        jobs::ScanSpec all;
        all.bauds = {1'000'000, 500'000, 115'200, 57'600, 38'400};
        bench.desk.search(all);
        QVERIFY(bench.desk.searching());
        QSignalSpy progress(&bench.desk, &Desk::searchProgress);
        QVERIFY(progress.wait());
        bench.desk.stopSearch();
        QTRY_VERIFY(!bench.desk.searching());
        QVERIFY(bench.desk.lastSearch()->stopped);
        QCOMPARE(bench.desk.baud(), 1'000'000);
    }

    /// What is read beside it waits while a search is at other rates, and goes to its own rate.
    void aSearchAtAnotherRateIsNotDisturbed()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        bench.desk.search({.firstId = 0, .lastId = 100, .bauds = {500'000}});
        bench.desk.readTable(ref);
        QVERIFY(bench.desk.searching());
        QVERIFY(bench.entry(ref).reading);
        QTRY_VERIFY(!bench.desk.searching());
        for (const ServoRef other : bench.desk.servos())
            QCOMPARE(bench.entry(other).servo.baud, 1'000'000);
        QVERIFY(!bench.entry(ref).tableRead); // it has waited
        QVERIFY(bench.settle());
        QVERIFY(!bench.entry(ref).readError);
        QVERIFY(bench.entry(ref).tableRead);
    }

    /// It was asked for while something else ran, and a slow search waited for that too.
    void aReadingThatWaitedGoesOnBesideTheSearch()
    {
        Bench bench(QStringLiteral("sim:lx"));
        QVERIFY(bench.search({.firstId = 0, .lastId = 10, .bauds = {}}));
        QVERIFY(!bench.desk.servos().empty());
        const ServoRef ref = bench.desk.servos().front();
        const ServoRef other = bench.desk.servos().back();
        QVERIFY(ref != other);
        bench.desk.readTable(ref);
        bench.desk.search({});
        bench.desk.readTable(other);
        QTRY_VERIFY(bench.entry(other).tableRead);
        QVERIFY(bench.desk.searching());
        bench.desk.stopSearch();
        QTRY_VERIFY(!bench.desk.searching());
    }

    /// Nothing tells a servo from another one put in its place with the same ID.
    void aServoFoundAgainIsReadAnew()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, positionP, 40));
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        QVERIFY(bench.entry(ref).tableRead);
        const auto profile = bench.entry(ref).servo.profile;
        QVERIFY(bench.search());
        QVERIFY(!bench.entry(ref).tableRead);
        QVERIFY(!bench.raw(ref, positionP));
        QCOMPARE(bench.entry(ref).servo.profile, profile);
        QVERIFY(bench.write(ref, positionP, 41)); // and saved anew
        const QFileInfo saved(bench.entry(ref).snapshotPath);
        QCOMPARE(saved.dir().entryList(QDir::Files).size(), 2);
    }

    void aTaskForAServoThatLeftTheListEndsAndNobodyIsBusy()
    {
        Bench bench(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(bench.search());
        const ServoRef second = bench.at(2);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        bool busy = true;
        connect(&bench.desk, &Desk::taskChanged, &bench.desk, [&] { busy = bench.desk.busy(); });
        std::optional<session::TaskEnd> end;
        session::Task task;
        task.name = QStringLiteral("nothing");
        task.guard = &bench.desk;
        task.work = [](session::TaskContext&) -> base::Result<void> { return {}; };
        task.done = [&](const session::TaskEnd& how) { end = how; };
        bench.desk.search({.firstId = 0, .lastId = 10, .bauds = {500'000, 1'000'000}});
        bench.desk.perform(second, task);
        QTRY_VERIFY(end);
        QVERIFY(bench.desk.servo(second) == nullptr);
        QCOMPARE(end->error->code, base::ErrorCode::NoAnswer);
        QVERIFY(!busy);
    }

    /// A slow search must not keep the technician from a servo that was found already.
    void aServoCanBeReadWhileTheSearchGoesOn()
    {
        Bench bench(QStringLiteral("sim:lx"));
        bench.desk.search({});
        QTRY_VERIFY(!bench.desk.servos().empty());
        QVERIFY(bench.desk.searching());
        const ServoRef ref = bench.desk.servos().front();
        bench.desk.readTable(ref);
        QTRY_VERIFY(bench.entry(ref).tableRead);
        QVERIFY(bench.desk.searching());
        bench.desk.stopSearch();
        QTRY_VERIFY(!bench.desk.searching());
    }

    void readingATableWritesNothing()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        bench.desk.readTable(ref);
        QVERIFY(bench.entry(ref).reading);
        QVERIFY(bench.settle());
        QVERIFY(bench.entry(ref).tableRead);
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(32));
        QVERIFY(bench.entry(ref).writes.empty());
        QVERIFY(bench.session.journal().entries()->empty());
    }

    void aFailedReadingShowsNoNumber()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        const catalog::Register& reg = *bench.entry(ref).servo.profile->find(positionP);
        QVERIFY(bench.entry(ref).shown(reg));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        QVERIFY(!bench.entry(ref).shown(reg));
        QVERIFY(bench.entry(ref).silent);
        QCOMPARE(bench.entry(ref).readError->code, base::ErrorCode::NoAnswer);
    }

    void keptSurvivesPowerOffAndTemporaryDoesNot()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, positionP, 40));
        QCOMPARE(bench.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(bench.write(ref, minAngle, 100, true));
        QCOMPARE(bench.outcome(ref, minAngle), std::optional(device::WriteOutcome::Temporary));
        QCOMPARE(bench.raw(ref, minAngle), std::optional<std::int64_t>(100));
        bench.desk.powerCycle();
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(40));
        QCOMPARE(bench.raw(ref, minAngle), std::optional<std::int64_t>(0));
    }

    void theTableIsSavedOnceBeforeTheFirstWrite()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, positionP, 40));
        const QString path = bench.entry(ref).snapshotPath;
        QVERIFY(QFile::exists(path));
        const auto saved = record::loadSnapshot(path);
        QVERIFY(saved);
        const auto row =
            std::find_if(saved->registers.begin(), saved->registers.end(),
                         [](const record::SnapshotRegister& one) { return one.key == positionP; });
        QCOMPARE(row->raw, std::optional<std::int64_t>(32));
        QVERIFY(bench.write(ref, positionP, 41));
        QCOMPARE(bench.entry(ref).snapshotPath, path);
        QCOMPARE(QFileInfo(path).dir().entryList(QDir::Files).size(), 1);
    }

    void twoQuickWritesOfOneRowBothHappenInOrder()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QSignalSpy happened(&bench.desk, &Desk::happened);
        bench.desk.write(ref, {{{positionP, 40}}, false, false});
        bench.desk.write(ref, {{{positionP, 50}}, false, false});
        QCOMPARE(bench.entry(ref).writes.at(positionP).pending, 2);
        QVERIFY(bench.settle());
        QCOMPARE(bench.entry(ref).writes.at(positionP).pending, 0);
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(50));
        QCOMPARE(bench.session.journal().entries()->size(), std::size_t(2));
    }

    void undoAndRedoWriteTheOldAndTheNewValue()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.desk.nextUndo() == nullptr);
        QVERIFY(bench.write(ref, positionP, 40));
        QVERIFY(bench.desk.nextUndo() != nullptr);
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(32));
        QCOMPARE(bench.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(bench.desk.nextUndo() == nullptr);
        bench.desk.redo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(40));
        QVERIFY(bench.desk.nextRedo() == nullptr);
    }

    /// An undone write to a dangerous register is not done again without consent.
    void aRedoAsksForConsentAgain()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const QString condition = QStringLiteral("unload_condition");
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        const auto before = bench.raw(ref, condition);
        QVERIFY(before);
        std::vector<session::Event> written;
        connect(&bench.desk, &Desk::happened, &bench.desk, [&](const session::Event& event) {
            if (event.kind == session::Event::Kind::Written)
                written.push_back(event);
        });
        QVERIFY(bench.write(ref, condition, *before ^ 1));
        QCOMPARE(bench.raw(ref, condition), std::optional<std::int64_t>(*before ^ 1));
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, condition), before);
        bench.desk.redo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, condition), before);
        QVERIFY(bench.desk.nextRedo() != nullptr);
        bench.desk.redo(true);
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, condition), std::optional<std::int64_t>(*before ^ 1));
        QCOMPARE(written.size(), std::size_t(4));
        QVERIFY(!written[0].undone && !written[0].redone);
        QVERIFY(written[1].undone && !written[1].redone);
        QVERIFY(written[3].redone && !written[3].undone);
    }

    /// Writes of every task, through a change of ID, and nothing of another simulated bus.
    void theHistoryFollowsTheServo()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const auto writes = [&](ServoRef servo) {
            QStringList all;
            for (const base::JournalEntry& one : bench.entry(servo).history) {
                for (const base::JournalItem& item : one.intent.items)
                    all << item.key;
            }
            return all;
        };
        QVERIFY(bench.write(ref, positionP, 40));
        QTRY_COMPARE(writes(ref), QStringList{positionP});
        bool done = false;
        session::Task task;
        task.name = QStringLiteral("mode");
        task.work = [](session::TaskContext& context) {
            return session::switchAll(context, {QStringLiteral("speed"), {std::nullopt}});
        };
        task.guard = &bench.desk;
        task.done = [&](const session::TaskEnd& end) { done = !end.error; };
        bench.desk.perform(ref, std::move(task));
        QTRY_VERIFY(done);
        QTRY_VERIFY2(writes(ref).contains(QStringLiteral("operating_mode")),
                     qPrintable(writes(ref).join(QLatin1Char(' '))));
        const QStringList before = writes(ref);
        QVERIFY(bench.write(ref, QStringLiteral("id"), 77));
        QTRY_COMPARE(writes(ref), before + QStringList{QStringLiteral("id")});
        QVERIFY(bench.write(ref, positionP, 41));
        QTRY_COMPARE(writes(ref), before + (QStringList{QStringLiteral("id"), positionP}));
        QVERIFY(bench.write(ref, QStringLiteral("id"), 1));
        QTRY_COMPARE(writes(ref).size(), before.size() + 3);

        bench.desk.disconnectFrom();
        QTRY_COMPARE(bench.desk.state(), LinkState::Off);
        QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
        QVERIFY(bench.search());
        const ServoRef other = bench.at(1);
        QVERIFY(other != 0);
        QVERIFY(bench.write(other, positionP, 50));
        QTRY_COMPARE(writes(other), QStringList{positionP});
    }

    void anUndoIsKnownAsOneInTheJournal()
    {
        Bench bench;
        QVERIFY(bench.search());
        QVERIFY(bench.write(bench.at(1), positionP, 40));
        bench.desk.undo();
        QVERIFY(bench.settle());
        const auto entries = bench.session.journal().entries().value();
        QCOMPARE(entries.size(), std::size_t(2));
        QCOMPARE(int(entries[0].intent.kind), int(base::IntentKind::Write));
        QCOMPARE(int(entries[1].intent.kind), int(base::IntentKind::Undo));
    }

    void aRefusedWriteLeavesNoSnapshot()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const QDir folder(bench.place.folder.filePath(QStringLiteral("snapshots")));
        const auto files = [&] { return folder.entryList(QDir::Files).size(); };
        QVERIFY(bench.write(ref, QStringLiteral("max_temperature"), 250));
        QVERIFY(bench.outcome(ref, QStringLiteral("max_temperature")) !=
                std::optional(device::WriteOutcome::Kept));
        QCOMPARE(files(), qsizetype(0));
        QVERIFY(bench.entry(ref).snapshotPath.isEmpty());
        QVERIFY(bench.write(ref, positionP, 40)); // saved before this one, which is done
        QCOMPARE(files(), qsizetype(1));
        QVERIFY(!bench.entry(ref).snapshotPath.isEmpty());
        const auto history = record::History::open(session::historyFile()).value();
        QCOMPARE(history->log().snapshots().value().size(), std::size_t(1));
    }

    void undoPassesWhatIsSoAlready()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, minAngle, 100));
        QVERIFY(bench.write(ref, positionP, 40, true));
        bench.desk.powerCycle(); // takes the temporary value back by itself
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(32));
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, minAngle), std::optional<std::int64_t>(0));
    }

    void anUndoThatFailsCanBeTriedAgain()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, positionP, 40));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        bench.desk.undo();
        QVERIFY(bench.settle());
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QVERIFY(bench.desk.nextUndo() != nullptr);
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.raw(ref, positionP), std::optional<std::int64_t>(32));
    }

    void aNewIdKeepsTheServoAndUndoGivesTheOldOneBack()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, QStringLiteral("id"), 77));
        QCOMPARE(bench.entry(ref).servo.id, 77);
        QCOMPARE(bench.outcome(ref, QStringLiteral("id")),
                 std::optional(device::WriteOutcome::Kept));
        QCOMPARE(bench.desk.servos().back(), ref);
        bench.desk.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.entry(ref).servo.id, 1);
    }

    void aTakenIdIsRefusedAndNothingChanges()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, QStringLiteral("id"), 2));
        QCOMPARE(bench.entry(ref).servo.id, 1);
        QCOMPARE(bench.entry(ref).writes.at(QStringLiteral("id")).error->code,
                 base::ErrorCode::IdInUse);
    }

    void aNewRateIsFollowedAndTheOthersStayReachable()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const catalog::Register& rate =
            *bench.entry(ref).servo.profile->byRole(catalog::Role::BaudRate);
        const auto slow =
            std::find_if(rate.values.begin(), rate.values.end(),
                         [](const auto& value) { return value.key == QLatin1String("115200"); });
        QVERIFY(bench.write(ref, rate.key, slow->value));
        QCOMPARE(bench.entry(ref).servo.baud, 115'200);
        bench.desk.readTable(bench.at(2));
        QVERIFY(bench.settle());
        QVERIFY(!bench.entry(bench.at(2)).readError);
        bench.desk.readTable(ref);
        QVERIFY(bench.settle());
        QVERIFY(!bench.entry(ref).readError);
    }

    void liveReadingFollowsTheServo()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        const QString position = QStringLiteral("present_position");
        bench.desk.wish(user, {{{ref, {position}}}, {}});
        const catalog::Register& reg = *bench.entry(ref).servo.profile->find(position);
        QTRY_VERIFY(bench.entry(ref).servo.image.readAt(reg.offset).has_value());
        const auto first = *bench.entry(ref).servo.image.readAt(reg.offset);
        QTRY_VERIFY(*bench.entry(ref).servo.image.readAt(reg.offset) > first);
        QVERIFY(bench.write(ref, QStringLiteral("id"), 70));
        const auto moved = bench.desk.now();
        QTRY_VERIFY(*bench.entry(ref).servo.image.readAt(reg.offset) > moved);
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {70}; });
        QTRY_VERIFY(!bench.entry(ref).shown(reg));
        bench.desk.wish(user, {});
    }

    /// The stored move of an LX-16A never answers; the rest of the table does.
    void oneSilentRegisterDoesNotHideTheOthers()
    {
        Bench bench(QStringLiteral("sim:lx16a@1"));
        QVERIFY(bench.search(
            {.firstId = 1, .lastId = 3, .bauds = {}, .protocols = {base::Protocol::Lx}}));
        const ServoRef ref = bench.at(1, base::Protocol::Lx);
        QStringList all;
        for (const catalog::Register& reg : bench.entry(ref).servo.profile->registers)
            all << reg.key;
        bench.desk.wish(user, {{{ref, all}}, {}});
        const QString silent = QStringLiteral("wait_angle");
        QTRY_VERIFY(bench.entry(ref).unreadable.count(silent) > 0);
        const auto& profile = *bench.entry(ref).servo.profile;
        QTRY_VERIFY(bench.entry(ref).shown(*profile.find(QStringLiteral("vin"))));
        QTRY_VERIFY(bench.entry(ref).shown(*profile.find(QStringLiteral("temp_limit"))));
        QVERIFY(!bench.entry(ref).shown(*profile.find(silent)));
    }

    void aCutCableEndsEverythingAndSaysSo()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        bench.desk.write(ref, {{{positionP, 40}}, false, false});
        bench.desk.write(ref, {{{positionP, 41}}, false, false});
        bench.withWire([](sim::VirtualBus& bus) { bus.cutLink(); });
        QTRY_COMPARE(bench.desk.state(), LinkState::Lost);
        QTRY_VERIFY(!bench.entry(ref).writing());
        QCOMPARE(bench.outcome(ref, positionP), std::optional(device::WriteOutcome::NotSent));
        QVERIFY(bench.open(QStringLiteral("sim:demo"))); // and on it goes
        QVERIFY(bench.search());
        QCOMPARE(bench.at(1), ref);
    }

    /// Wherever in the write the cable is pulled: a servo that was not reached has refused nothing.
    void aCutCableIsNoRefusal()
    {
        for (const std::size_t bytes : {0, 10, 20, 30, 40}) {
            Bench bench(QStringLiteral("sim:sts3215@1"));
            QVERIFY(bench.search({.firstId = 1, .lastId = 2, .bauds = {}}));
            const ServoRef ref = bench.at(1);
            QVERIFY(bench.write(ref, positionP, 33)); // and the table is saved
            bench.withWire([&](sim::VirtualBus& bus) { bus.cutAfterHostBytes(bytes); });
            bench.desk.write(ref, {{{positionP, 40}}, false, false});
            QTRY_VERIFY(!bench.entry(ref).writing());
            const auto outcome = bench.outcome(ref, positionP);
            QVERIFY(outcome);
            QVERIFY(*outcome != device::WriteOutcome::Refused);
            QVERIFY(*outcome != device::WriteOutcome::Kept);
        }
    }

    void closingFinishesTheWritesThatWereAskedFor()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QSignalSpy closed(&bench.desk, &Desk::closed);
        bench.desk.write(ref, {{{positionP, 40}}, false, false});
        bench.desk.write(ref, {{{minAngle, 50}}, false, false});
        bench.desk.close();
        QVERIFY(closed.wait());
        QCOMPARE(bench.desk.state(), LinkState::Off);
        QVERIFY(bench.session.journal().open()->empty());
        QCOMPARE(bench.troubles(), QByteArray());
        QCOMPARE(bench.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QCOMPARE(bench.outcome(ref, minAngle), std::optional(device::WriteOutcome::Kept));
    }

    /// Between saving the table and switching torque on there is nothing on the wire to preempt.
    void aTaskThatHasBegunDoesNothingAfterAnEmergencyStop()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        std::atomic<bool> begun = false;
        std::optional<session::TaskEnd> end;
        session::Task task;
        task.name = QStringLiteral("between");
        task.guard = &bench.desk;
        task.work = [&](session::TaskContext& context) -> base::Result<void> {
            begun = true;
            while (!context.stop.requested())
                std::this_thread::yield();
            return base::fail(base::ErrorCode::Stopped);
        };
        task.done = [&](const session::TaskEnd& how) { end = how; };
        bench.desk.perform(ref, task);
        QTRY_VERIFY(begun);
        bench.desk.emergencyStop();
        QTRY_VERIFY(end);
        QCOMPARE(end->error->code, base::ErrorCode::Stopped);
    }

    void theEmergencyStopTakesTorqueOff()
    {
        Bench bench;
        QVERIFY(bench.search());
        const ServoRef ref = bench.at(1);
        QVERIFY(bench.write(ref, QStringLiteral("torque_switch"), 1));
        QCOMPARE(bench.troubles(), QByteArray());
        QCOMPARE(bench.raw(ref, QStringLiteral("torque_switch")), std::optional<std::int64_t>(1));
        QVERIFY(bench.desk.nextUndo() == nullptr); // undoing must not turn a shaft
        bench.desk.emergencyStop();
        QTRY_VERIFY([&] {
            bench.desk.readTable(ref);
            return bench.settle() && bench.raw(ref, QStringLiteral("torque_switch")) == 0;
        }());
    }
};

QTEST_GUILESS_MAIN(TestDesk)

#include "tst_desk.moc"
