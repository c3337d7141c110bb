// SPDX-License-Identifier: GPL-3.0-or-later
// The bench behind the window on a simulated bus: everything asked for returns at once and comes
// back as a signal; what is in the list was really read; writes end in one of the six words.
#include "history/history.h"
#include "session/motion/motion_tasks.h"
#include "session/paths.h"
#include "snapshot/snapshot.h"
#include "support/real_time.h"
#include "support/test_main.h"

#include <QDir>
#include <QSignalSpy>

#include "session_fixture.h"
#include <atomic>
#include <thread>

class TestWorkbench : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aMissingPortIsReported()
    {
        const support::RealTime realTime; // no simulated port
        session::Session session;
        Workbench workbench(session);
        QSignalSpy failed(&workbench.link(), &session::LinkController::connectFailed);
        workbench.link().connectTo({.name = QStringLiteral("/dev/no-such-port")});
        QVERIFY(failed.wait());
        QCOMPARE(failed.front().front().value<base::Error>().code, base::ErrorCode::PortMissing);
        QCOMPARE(workbench.link().state(), LinkState::Off);
    }

    /// The servos it finds are listed as after a search.
    void aDiagnosisEndsWithACause()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.opened);
        session::SearchService& search = fixture.workbench.search();
        QSignalSpy evidence(&search, &session::SearchService::evidenceFound);
        search.diagnose();
        QVERIFY(search.isDiagnosing());
        QTRY_VERIFY_WITH_TIMEOUT(!search.isSearching(), 60'000);
        QVERIFY(!search.diagnosisError());
        QCOMPARE(search.diagnosis().cause, base::Cause::Found);
        QVERIFY(evidence.count() > 3);
        QVERIFY(fixture.at(1) != 0);
        search.diagnose();
        fixture.lose();
        QTRY_VERIFY_WITH_TIMEOUT(!search.isSearching(), 60'000);
        QVERIFY(search.diagnosisError() || search.diagnosis().stopped);
    }

    /// Whatever is asked while a port is still being opened, the latest wish is what happens.
    void theLastRequestedPortOpens()
    {
        support::TemporaryDataFolder dataFolder;
        session::Session session;
        Workbench workbench(session);
        QStringList connected;
        connect(&workbench, &Workbench::eventOccurred, &workbench,
                [&](const session::Event& event) {
                    if (event.kind == session::Event::Kind::Connected)
                        connected << event.task;
                });
        workbench.link().connectTo({.name = QStringLiteral("sim:modbus")});
        workbench.link().connectTo({.name = QStringLiteral("sim:lx")});
        workbench.link().connectTo({.name = QStringLiteral("sim:demo")});
        QTRY_COMPARE(workbench.link().state(), LinkState::Open);
        QCOMPARE(connected, QStringList{QStringLiteral("sim:demo")});
        workbench.closing().disconnectFrom();
        QTRY_COMPARE(workbench.link().state(), LinkState::Off);
        workbench.link().connectTo({.name = QStringLiteral("sim:lx")});
        workbench.closing().disconnectFrom();
        workbench.closing().disconnectFrom();
        QCOMPARE(workbench.link().state(),
                 LinkState::Closing); // what is being opened is waited for
        QTRY_COMPARE(workbench.link().state(), LinkState::Off);
        QVERIFY(workbench.link().connection() == nullptr);
        QCOMPARE(connected.size(), 1);
    }

    void closingIsSignaledOnceAndQueued()
    {
        SessionFixture fixture;
        QVERIFY(fixture.opened);
        QSignalSpy closed(&fixture.workbench.closing(), &session::CloseSequence::closed);
        fixture.workbench.closing().closeForExit();
        QCOMPARE(closed.size(), 0);
        QTRY_COMPARE(closed.size(), 1);
        QCoreApplication::processEvents();
        QCOMPARE(closed.size(), 1);
        QCOMPARE(fixture.workbench.link().state(), LinkState::Off);
    }

    void servosAppearWhileTheSearchRuns()
    {
        SessionFixture fixture;
        QVERIFY(fixture.opened);
        bool foundDuring = false;
        connect(&fixture.workbench.registry(), &session::ServoRegistry::servoAdded, this,
                [&](ServoRef) {
                    foundDuring = foundDuring || fixture.workbench.search().isSearching();
                });
        QVERIFY(fixture.search());
        QVERIFY(foundDuring);
        QCOMPARE(fixture.workbench.registry().order().size(), std::size_t(6));
        QVERIFY(fixture.workbench.search().lastReport());
        QCOMPARE(fixture.entry(fixture.at(1)).servo.profile->modelName, QStringLiteral("STS3215"));
    }

    void aMissingServoIsRemovedByTheNextSearch()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef second = fixture.at(2);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        QSignalSpy removed(&fixture.workbench.registry(), &session::ServoRegistry::servoRemoved);
        QVERIFY(fixture.search());
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed.front().front().value<ServoRef>(), second);
        QVERIFY(fixture.workbench.registry().servo(second) == nullptr);
        QVERIFY(fixture.at(1) != 0);
    }

    void stoppingASearchEndsItSoon()
    {
        SessionFixture fixture;
        jobs::ScanSpec all;
        all.bauds = {1'000'000, 500'000, 115'200, 57'600, 38'400};
        fixture.workbench.search().start(all);
        QVERIFY(fixture.workbench.search().isSearching());
        QSignalSpy progress(&fixture.workbench.search(), &session::SearchService::searchProgress);
        QVERIFY(progress.wait());
        fixture.workbench.search().stop();
        QTRY_VERIFY(!fixture.workbench.search().isSearching());
        QVERIFY(fixture.workbench.search().lastReport()->stopped);
        QCOMPARE(fixture.workbench.link().baud(), 1'000'000);
    }

    /// What is read beside it waits while a search is at other rates, and goes to its own rate.
    void aSearchAtAnotherRateIsNotDisturbed()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        fixture.workbench.search().start({.firstId = 0, .lastId = 100, .bauds = {500'000}});
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.workbench.search().isSearching());
        QVERIFY(fixture.entry(ref).isReadingTable);
        QTRY_VERIFY(!fixture.workbench.search().isSearching());
        for (const ServoRef other : fixture.workbench.registry().order())
            QCOMPARE(fixture.entry(other).servo.baud, 1'000'000);
        QVERIFY(!fixture.entry(ref).hasFullTable); // it has waited
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry(ref).readError);
        QVERIFY(fixture.entry(ref).hasFullTable);
    }

    /// It was asked for while something else ran, and a slow search waited for that too.
    void aQueuedReadRunsDuringTheSearch()
    {
        SessionFixture fixture(QStringLiteral("sim:lx"));
        QVERIFY(fixture.search({.firstId = 0, .lastId = 10, .bauds = {}}));
        QVERIFY(!fixture.workbench.registry().order().empty());
        const ServoRef ref = fixture.workbench.registry().order().front();
        const ServoRef other = fixture.workbench.registry().order().back();
        QVERIFY(ref != other);
        fixture.workbench.writes().readTable(ref);
        fixture.workbench.search().start({});
        fixture.workbench.writes().readTable(other);
        QTRY_VERIFY(fixture.entry(other).hasFullTable);
        QVERIFY(fixture.workbench.search().isSearching());
        fixture.workbench.search().stop();
        QTRY_VERIFY(!fixture.workbench.search().isSearching());
    }

    /// Nothing tells a servo from another one put in its place with the same ID.
    void aServoFoundAgainIsReread()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, positionP, 40));
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.entry(ref).hasFullTable);
        const auto profile = fixture.entry(ref).servo.profile;
        QVERIFY(fixture.search());
        QVERIFY(!fixture.entry(ref).hasFullTable);
        QVERIFY(!fixture.raw(ref, positionP));
        QCOMPARE(fixture.entry(ref).servo.profile, profile);
        QVERIFY(fixture.write(ref, positionP, 41)); // and saved anew
        const QFileInfo saved(fixture.entry(ref).snapshotPath);
        QCOMPARE(saved.dir().entryList(QDir::Files).size(), 2);
    }

    void aTaskForARemovedServoEnds()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QVERIFY(fixture.search());
        const ServoRef second = fixture.at(2);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {2}; });
        bool busy = true;
        connect(&fixture.workbench.tasks(), &session::TaskQueue::taskChanged, &fixture.workbench,
                [&] { busy = fixture.workbench.tasks().isBusy(); });
        std::optional<session::TaskCompletion> end;
        session::Task task;
        task.name = QStringLiteral("nothing");
        task.guard = &fixture.workbench;
        task.work = [](session::TaskContext&) -> base::Result<void> { return {}; };
        task.done = [&](const session::TaskCompletion& how) { end = how; };
        fixture.workbench.search().start(
            {.firstId = 0, .lastId = 10, .bauds = {500'000, 1'000'000}});
        fixture.workbench.tasks().perform(second, task);
        QTRY_VERIFY(end);
        QVERIFY(fixture.workbench.registry().servo(second) == nullptr);
        QCOMPARE(end->error->code, base::ErrorCode::NoReply);
        QVERIFY(!busy);
    }

    /// A slow search must not keep the technician from a servo that was found already.
    void aServoCanBeReadDuringTheSearch()
    {
        SessionFixture fixture(QStringLiteral("sim:lx"));
        fixture.workbench.search().start({});
        QTRY_VERIFY(!fixture.workbench.registry().order().empty());
        QVERIFY(fixture.workbench.search().isSearching());
        const ServoRef ref = fixture.workbench.registry().order().front();
        fixture.workbench.writes().readTable(ref);
        QTRY_VERIFY(fixture.entry(ref).hasFullTable);
        QVERIFY(fixture.workbench.search().isSearching());
        fixture.workbench.search().stop();
        QTRY_VERIFY(!fixture.workbench.search().isSearching());
    }

    void readingATableWritesNothing()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.entry(ref).isReadingTable);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.entry(ref).hasFullTable);
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(32));
        QVERIFY(fixture.entry(ref).writes.empty());
        QVERIFY(fixture.session.journal().entries()->empty());
    }

    void aFailedReadShowsNoValue()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        const catalog::Register& reg = *fixture.entry(ref).servo.profile->find(positionP);
        QVERIFY(fixture.entry(ref).displayedRaw(reg));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry(ref).displayedRaw(reg));
        QVERIFY(fixture.entry(ref).silent);
        QCOMPARE(fixture.entry(ref).readError->code, base::ErrorCode::NoReply);
    }

    void savedSurvivesPowerOffAndTemporaryDoesNot()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, positionP, 40));
        QCOMPARE(fixture.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(fixture.write(ref, minAngle, 100, true));
        QCOMPARE(fixture.outcome(ref, minAngle), std::optional(device::WriteOutcome::Temporary));
        QCOMPARE(fixture.raw(ref, minAngle), std::optional<std::int64_t>(100));
        fixture.workbench.link().powerCycle();
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(40));
        QCOMPARE(fixture.raw(ref, minAngle), std::optional<std::int64_t>(0));
    }

    void theSnapshotIsSavedOnceBeforeTheFirstWrite()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, positionP, 40));
        const QString path = fixture.entry(ref).snapshotPath;
        QVERIFY(QFile::exists(path));
        const auto saved = snapshot::loadSnapshot(path);
        QVERIFY(saved);
        const auto row = std::find_if(
            saved->registers.begin(), saved->registers.end(),
            [](const snapshot::SnapshotRegister& one) { return one.key == positionP; });
        QCOMPARE(row->raw, std::optional<std::int64_t>(32));
        QVERIFY(fixture.write(ref, positionP, 41));
        QCOMPARE(fixture.entry(ref).snapshotPath, path);
        QCOMPARE(QFileInfo(path).dir().entryList(QDir::Files).size(), 1);
    }

    void twoQuickWritesOfOneRowBothHappenInOrder()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QSignalSpy happened(&fixture.workbench, &Workbench::eventOccurred);
        fixture.workbench.writes().write(ref, {{{positionP, 40}}, false, {}});
        fixture.workbench.writes().write(ref, {{{positionP, 50}}, false, {}});
        QCOMPARE(fixture.entry(ref).writes.at(positionP).pending, 2);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.entry(ref).writes.at(positionP).pending, 0);
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(50));
        QCOMPARE(fixture.session.journal().entries()->size(), std::size_t(2));
    }

    void undoAndRedoWriteOldAndNewValue()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.workbench.writes().undoStep() == nullptr);
        QVERIFY(fixture.write(ref, positionP, 40));
        QVERIFY(fixture.workbench.writes().undoStep() != nullptr);
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(32));
        QCOMPARE(fixture.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QVERIFY(fixture.workbench.writes().undoStep() == nullptr);
        fixture.workbench.writes().redo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(40));
        QVERIFY(fixture.workbench.writes().redoStep() == nullptr);
    }

    /// A write to a dangerous register is neither undone nor done again without consent.
    void undoAndRedoNeedConsentAgain()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const QString condition = QStringLiteral("unload_condition");
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        const auto before = fixture.raw(ref, condition);
        QVERIFY(before);
        std::vector<session::Event> written;
        connect(&fixture.workbench, &Workbench::eventOccurred, &fixture.workbench,
                [&](const session::Event& event) {
                    if (event.kind == session::Event::Kind::Written)
                        written.push_back(event);
                });
        QVERIFY(fixture.write(ref, condition, *before ^ 1));
        QCOMPARE(fixture.raw(ref, condition), std::optional<std::int64_t>(*before ^ 1));
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, condition), std::optional<std::int64_t>(*before ^ 1));
        QVERIFY(fixture.workbench.writes().undoStep() != nullptr);
        fixture.workbench.writes().undo(device::Consent::confirmed());
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, condition), before);
        fixture.workbench.writes().redo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, condition), before);
        QVERIFY(fixture.workbench.writes().redoStep() != nullptr);
        fixture.workbench.writes().redo(device::Consent::confirmed());
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, condition), std::optional<std::int64_t>(*before ^ 1));
        QCOMPARE(written.size(), std::size_t(5));
        QVERIFY(!written[0].isUndo && !written[0].isRedo);
        QVERIFY(written[2].isUndo && !written[2].isRedo);
        QVERIFY(written[4].isRedo && !written[4].isUndo);
    }

    /// Writes of every task, through a change of ID, and nothing of another simulated bus.
    void theHistoryFollowsTheServo()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const auto writes = [&](ServoRef servo) {
            QStringList all;
            for (const base::JournalEntry& one : fixture.entry(servo).history) {
                for (const base::JournalItem& item : one.intent.items)
                    all << item.key;
            }
            return all;
        };
        QVERIFY(fixture.write(ref, positionP, 40));
        QTRY_COMPARE(writes(ref), QStringList{positionP});
        bool done = false;
        session::Task task;
        task.name = QStringLiteral("mode");
        task.work = [](session::TaskContext& context) {
            return session::switchModeAll(context, {QStringLiteral("speed"), {std::nullopt}});
        };
        task.guard = &fixture.workbench;
        task.done = [&](const session::TaskCompletion& end) { done = !end.error; };
        fixture.workbench.tasks().perform(ref, std::move(task));
        QTRY_VERIFY(done);
        QTRY_VERIFY2(writes(ref).contains(QStringLiteral("operating_mode")),
                     qPrintable(writes(ref).join(QLatin1Char(' '))));
        const QStringList before = writes(ref);
        QVERIFY(fixture.write(ref, QStringLiteral("id"), 77));
        QTRY_COMPARE(writes(ref), before + QStringList{QStringLiteral("id")});
        QVERIFY(fixture.write(ref, positionP, 41));
        QTRY_COMPARE(writes(ref), before + (QStringList{QStringLiteral("id"), positionP}));
        QVERIFY(fixture.write(ref, QStringLiteral("id"), 1));
        QTRY_COMPARE(writes(ref).size(), before.size() + 3);

        fixture.workbench.closing().disconnectFrom();
        QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Off);
        QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
        QVERIFY(fixture.search());
        const ServoRef other = fixture.at(1);
        QVERIFY(other != 0);
        QVERIFY(fixture.write(other, positionP, 50));
        QTRY_COMPARE(writes(other), QStringList{positionP});
    }

    void anUndoIsMarkedInTheJournal()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        QVERIFY(fixture.write(fixture.at(1), positionP, 40));
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        const auto entries = fixture.session.journal().entries().value();
        QCOMPARE(entries.size(), std::size_t(2));
        QCOMPARE(int(entries[0].intent.kind), int(base::IntentKind::Write));
        QCOMPARE(int(entries[1].intent.kind), int(base::IntentKind::Undo));
    }

    void aRefusedWriteLeavesNoSnapshot()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const QDir folder(fixture.dataFolder.folder.filePath(QStringLiteral("snapshots")));
        const auto files = [&] { return folder.entryList(QDir::Files).size(); };
        QVERIFY(fixture.write(ref, QStringLiteral("max_temperature"), 250));
        QVERIFY(fixture.outcome(ref, QStringLiteral("max_temperature")) !=
                std::optional(device::WriteOutcome::Kept));
        QCOMPARE(files(), qsizetype(0));
        QVERIFY(fixture.entry(ref).snapshotPath.isEmpty());
        QVERIFY(fixture.write(ref, positionP, 40)); // saved before this one, which is done
        QCOMPARE(files(), qsizetype(1));
        QVERIFY(!fixture.entry(ref).snapshotPath.isEmpty());
        const auto history = history::History::open(session::historyFile()).value();
        QCOMPARE(history->log().snapshots().value().size(), std::size_t(1));
    }

    void undoAcceptsAlreadyMatchingValues()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, minAngle, 100));
        QVERIFY(fixture.write(ref, positionP, 40, true));
        fixture.workbench.link().powerCycle(); // takes the temporary value back by itself
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(32));
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, minAngle), std::optional<std::int64_t>(0));
    }

    void aFailedUndoCanBeRetried()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, positionP, 40));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QVERIFY(fixture.workbench.writes().undoStep() != nullptr);
        fixture.workbench.writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw(ref, positionP), std::optional<std::int64_t>(32));
    }

    void aNewIdKeepsTheServoAndUndoRestoresTheOldId()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, QStringLiteral("id"), 77));
        QCOMPARE(fixture.entry(ref).servo.id, 77);
        QCOMPARE(fixture.outcome(ref, QStringLiteral("id")),
                 std::optional(device::WriteOutcome::Kept));
        QCOMPARE(fixture.workbench.registry().order().back(), ref);
        fixture.workbench.writes().undo(device::Consent::confirmed());
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.entry(ref).servo.id, 1);
    }

    void aTakenIdIsRefusedAndNothingChanges()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, QStringLiteral("id"), 2));
        QCOMPARE(fixture.entry(ref).servo.id, 1);
        QCOMPARE(fixture.entry(ref).writes.at(QStringLiteral("id")).error->code,
                 base::ErrorCode::IdInUse);
    }

    void aNewRateIsFollowedAndOthersStayReachable()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const catalog::Register& rate =
            *fixture.entry(ref).servo.profile->byRole(catalog::Role::BaudRate);
        const auto slow =
            std::find_if(rate.values.begin(), rate.values.end(),
                         [](const auto& value) { return value.key == QLatin1String("115200"); });
        QVERIFY(fixture.write(ref, rate.key, slow->value));
        QCOMPARE(fixture.entry(ref).servo.baud, 115'200);
        fixture.workbench.writes().readTable(fixture.at(2));
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry(fixture.at(2)).readError);
        fixture.workbench.writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry(ref).readError);
    }

    void pollingFollowsTheServo()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        const QString position = QStringLiteral("present_position");
        fixture.workbench.polling().subscribe(user, {{{ref, {position}}}, {}});
        const catalog::Register& reg = *fixture.entry(ref).servo.profile->find(position);
        QTRY_VERIFY(fixture.entry(ref).servo.image.readAt(reg.offset).has_value());
        const auto first = *fixture.entry(ref).servo.image.readAt(reg.offset);
        QTRY_VERIFY(*fixture.entry(ref).servo.image.readAt(reg.offset) > first);
        QVERIFY(fixture.write(ref, QStringLiteral("id"), 70));
        const auto moved = fixture.workbench.now();
        QTRY_VERIFY(*fixture.entry(ref).servo.image.readAt(reg.offset) > moved);
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {70}; });
        QTRY_VERIFY(!fixture.entry(ref).displayedRaw(reg));
        fixture.workbench.polling().subscribe(user, {});
    }

    /// The stored move of an LX-16A never answers; the rest of the table does.
    void oneSilentRegisterDoesNotHideTheOthers()
    {
        SessionFixture fixture(QStringLiteral("sim:lx16a@1"));
        QVERIFY(fixture.search(
            {.firstId = 1, .lastId = 3, .bauds = {}, .protocols = {base::Protocol::Lx}}));
        const ServoRef ref = fixture.at(1, base::Protocol::Lx);
        QStringList all;
        for (const catalog::Register& reg : fixture.entry(ref).servo.profile->registers)
            all << reg.key;
        fixture.workbench.polling().subscribe(user, {{{ref, all}}, {}});
        const QString silent = QStringLiteral("wait_angle");
        QTRY_VERIFY(fixture.entry(ref).unreadable.count(silent) > 0);
        const auto& profile = *fixture.entry(ref).servo.profile;
        QTRY_VERIFY(fixture.entry(ref).displayedRaw(*profile.find(QStringLiteral("vin"))));
        QTRY_VERIFY(fixture.entry(ref).displayedRaw(*profile.find(QStringLiteral("temp_limit"))));
        QVERIFY(!fixture.entry(ref).displayedRaw(*profile.find(silent)));
    }

    void aLostLinkEndsEverythingAndIsReported()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        fixture.workbench.writes().write(ref, {{{positionP, 40}}, false, {}});
        fixture.workbench.writes().write(ref, {{{positionP, 41}}, false, {}});
        fixture.withBus([](sim::VirtualBus& bus) { bus.cutLink(); });
        QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Lost);
        QTRY_VERIFY(!fixture.entry(ref).writing());
        QCOMPARE(fixture.outcome(ref, positionP), std::optional(device::WriteOutcome::NotSent));
        QVERIFY(fixture.open(QStringLiteral("sim:demo"))); // and on it goes
        QVERIFY(fixture.search());
        QCOMPARE(fixture.at(1), ref);
    }

    /// No search: strangers on the bus are not asked by a program that reconnects by itself.
    void reconnectingAsksOnlyTheServosOfTheList()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@7"));
        QVERIFY(fixture.search({.firstId = 1, .lastId = 2, .bauds = {}}));
        const std::vector<ServoRef> known = fixture.workbench.registry().order();
        QCOMPARE(known.size(), std::size_t(2));
        session::LinkController& link = fixture.workbench.link();
        link.reconnect(link.lastRequest().name); // it is open: nothing is to be done
        QVERIFY(!link.isReconnect());
        QVERIFY(fixture.lose());
        std::set<ServoRef> doubted; // until it has replied
        connect(&fixture.workbench.registry(), &session::ServoRegistry::servoChanged,
                &fixture.workbench, [&](ServoRef ref) {
                    if (link.connection() != nullptr && fixture.entry(ref).silent)
                        doubted.insert(ref);
                });
        link.reconnect(link.lastRequest().name + QStringLiteral(",sts3215@9"));
        QCOMPARE(link.state(), LinkState::Lost); // until it is open
        QTRY_COMPARE(link.state(), LinkState::Open);
        QVERIFY(link.isReconnect());
        QCOMPARE(fixture.workbench.registry().order(), known);
        for (const ServoRef ref : known) {
            QTRY_VERIFY(!fixture.entry(ref).silent);
            QVERIFY(!fixture.entry(ref).hasFullTable); // another one may be in its place
        }
        QCOMPARE(doubted.size(), known.size());
        for (const auto& [id, counters] : link.statistics().byId)
            QVERIFY2(id == 1 || id == 2, qPrintable(QString::number(id)));
        QVERIFY(!fixture.workbench.search().isSearching());
        QCOMPARE(fixture.entry(known.front()).servo.id, 1);
        QCOMPARE(fixture.entry(known.front()).servo.port, link.portName()); // for the journal
        QVERIFY(fixture.open(QStringLiteral("sim:demo"))); // as the user asks for it
        QVERIFY(!link.isReconnect());
    }

    /// A task may have changed it since the port was opened, for servos of another rate.
    void reconnectingKeepsTheRate()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search({.firstId = 1, .lastId = 2, .bauds = {}}));
        session::LinkController& link = fixture.workbench.link();
        QVERIFY(link.connection()->bus().setBaud(500'000));
        QVERIFY(fixture.lose());
        link.reconnect(link.lastRequest().name);
        QTRY_COMPARE(link.state(), LinkState::Open);
        QCOMPARE(link.baud(), 500'000);
        QVERIFY(!link.lastRequest().baud);            // still "auto"
        QVERIFY(fixture.entry(fixture.at(1)).silent); // at 1 M: not asked
    }

    /// The adapter is back before the supply of the servos is.
    void aReconnectedServoMayReplyLater()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search({.firstId = 1, .lastId = 2, .bauds = {}}));
        session::LinkController& link = fixture.workbench.link();
        QVERIFY(fixture.lose());
        connect(&link, &session::LinkController::linkChanged, &fixture.workbench, [&] {
            if (link.connection() != nullptr)
                fixture.withBus([](sim::VirtualBus& bus) { bus.unplug(0); });
        });
        link.reconnect(link.lastRequest().name);
        QTRY_COMPARE(link.state(), LinkState::Open);
        QTRY_VERIFY(link.statistics().byId[1].timeouts > 0);
        QVERIFY(fixture.entry(fixture.at(1)).silent);
        fixture.withBus([](sim::VirtualBus& bus) { bus.plug(0); });
        QTRY_VERIFY(!fixture.entry(fixture.at(1)).silent); // nothing else asks
    }

    void aFailedReconnectLeavesThePortLost()
    {
        SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search({.firstId = 1, .lastId = 2, .bauds = {}}));
        session::LinkController& link = fixture.workbench.link();
        QVERIFY(fixture.lose());
        QSignalSpy failed(&link, &session::LinkController::connectFailed);
        link.reconnect(QStringLiteral("/dev/ttyUSB77"));
        QTRY_COMPARE(failed.count(), 1);
        QCOMPARE(link.state(), LinkState::Lost);
        QVERIFY(fixture.at(1) != 0);
        link.reconnect(QStringLiteral("sim:sts3215@1"));
        link.cancelReconnect();
        QTRY_VERIFY(!link.isOpening());
        QCOMPARE(link.state(), LinkState::Lost);
        // Closing in the middle of an attempt waits for it, and opens nothing.
        link.reconnect(QStringLiteral("sim:sts3215@1"));
        fixture.workbench.closing().disconnectFrom();
        QTRY_COMPARE(link.state(), LinkState::Off);
        QVERIFY(link.connection() == nullptr && !link.isOpening());
    }

    /// Wherever in the write the cable is pulled: a servo that was not reached has refused nothing.
    void aLostLinkIsNoRefusal()
    {
        for (const std::size_t bytes : {0, 10, 20, 30, 40}) {
            SessionFixture fixture(QStringLiteral("sim:sts3215@1"));
            QVERIFY(fixture.search({.firstId = 1, .lastId = 2, .bauds = {}}));
            const ServoRef ref = fixture.at(1);
            QVERIFY(fixture.write(ref, positionP, 33)); // and the table is saved
            fixture.withBus([&](sim::VirtualBus& bus) { bus.cutAfterHostBytes(bytes); });
            fixture.workbench.writes().write(ref, {{{positionP, 40}}, false, {}});
            QTRY_VERIFY(!fixture.entry(ref).writing());
            const auto outcome = fixture.outcome(ref, positionP);
            QVERIFY(outcome);
            QVERIFY(*outcome != device::WriteOutcome::Refused);
            QVERIFY(*outcome != device::WriteOutcome::Kept);
        }
    }

    void closingFinishesPendingWrites()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QSignalSpy closed(&fixture.workbench.closing(), &session::CloseSequence::closed);
        fixture.workbench.writes().write(ref, {{{positionP, 40}}, false, {}});
        fixture.workbench.writes().write(ref, {{{minAngle, 50}}, false, {}});
        fixture.workbench.closing().closeForExit();
        QVERIFY(closed.wait());
        QCOMPARE(fixture.workbench.link().state(), LinkState::Off);
        QVERIFY(fixture.session.journal().open()->empty());
        QCOMPARE(fixture.troubles(), QByteArray());
        QCOMPARE(fixture.outcome(ref, positionP), std::optional(device::WriteOutcome::Kept));
        QCOMPARE(fixture.outcome(ref, minAngle), std::optional(device::WriteOutcome::Kept));
    }

    /// Between saving the table and switching torque on there is nothing on the wire to preempt.
    void aStartedTaskDoesNothingAfterAnEmergencyStop()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        std::atomic<bool> begun = false;
        std::optional<session::TaskCompletion> end;
        session::Task task;
        task.name = QStringLiteral("between");
        task.guard = &fixture.workbench;
        task.work = [&](session::TaskContext& context) -> base::Result<void> {
            begun = true;
            while (!context.stop.isRequested())
                std::this_thread::yield();
            return base::fail(base::ErrorCode::Stopped);
        };
        task.done = [&](const session::TaskCompletion& how) { end = how; };
        fixture.workbench.tasks().perform(ref, task);
        QTRY_VERIFY(begun);
        fixture.workbench.emergencyStop().trigger();
        QTRY_VERIFY(end);
        QCOMPARE(end->error->code, base::ErrorCode::Stopped);
    }

    void theEmergencyStopTakesTorqueOff()
    {
        SessionFixture fixture;
        QVERIFY(fixture.search());
        const ServoRef ref = fixture.at(1);
        QVERIFY(fixture.write(ref, QStringLiteral("torque_switch"), 1));
        QCOMPARE(fixture.troubles(), QByteArray());
        QCOMPARE(fixture.raw(ref, QStringLiteral("torque_switch")), std::optional<std::int64_t>(1));
        QVERIFY(fixture.workbench.writes().undoStep() == nullptr); // undoing must not turn a shaft
        fixture.workbench.emergencyStop().trigger();
        QTRY_VERIFY([&] {
            fixture.workbench.writes().readTable(ref);
            return fixture.waitUntilIdle() &&
                   fixture.raw(ref, QStringLiteral("torque_switch")) == 0;
        }());
    }
};

SERVODESK_GUILESS_TEST(TestWorkbench)

#include "tst_workbench.moc"
