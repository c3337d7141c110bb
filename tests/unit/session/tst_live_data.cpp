// SPDX-License-Identifier: GPL-3.0-or-later
// The oscilloscope behind the charts on a simulated bus: what is read becomes curves, silence a
// gap, an alarm a mark; a recording holds what the store has.
#include "session/recording/live_data.h"
#include "session/recording/replay.h"
#include "support/test_main.h"

#include <QSignalSpy>

#include "session_fixture.h"
#include <cmath>

using session::LiveData;

namespace {
/// A bench that reads a servo's position and goal all the time.
struct LiveDataFixture : SessionFixture {
    explicit LiveDataFixture(const QString& port = QStringLiteral("sim:sts3215@1,sts3215@2"))
        : SessionFixture(port)
        , scope(workbench)
    {}
    bool reads(const QStringList& keys)
    {
        if (!search())
            return false;
        for (const ServoRef ref : workbench.registry().order())
            workbench.writes().readTable(ref); // modes and units
        if (!waitUntilIdle())
            return false;
        session::Subscription subscription;
        for (const ServoRef ref : workbench.registry().order())
            subscription.parts.push_back({ref, keys, {}});
        subscription.period = std::chrono::milliseconds(5);
        workbench.polling().subscribe(QStringLiteral("test"), subscription);
        return support::waitFor([&] { return scope.store().count() > 40; });
    }
    LiveData scope;
};
} // namespace

class TestLiveData : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyReadingBecomesASample()
    {
        LiveDataFixture fixture;
        std::map<ServoRef, std::vector<recording::SamplePoint>> seen;
        connect(&fixture.workbench.polling(), &session::PollController::readingsReceived, this,
                [&](const std::vector<session::Reading>& all) {
                    for (const session::Reading& one : all) {
                        for (const jobs::PollValue& value : one.values) {
                            if (value.reg->key == position)
                                seen[one.servo].push_back({one.at, value.physical});
                        }
                    }
                });
        QVERIFY(fixture.reads({position}));
        for (const ServoRef ref : fixture.workbench.registry().order()) {
            const session::LiveChannel* channel = fixture.scope.find(ref, position);
            QVERIFY(channel != nullptr);
            QCOMPARE(channel->unit, QStringLiteral("deg"));
            const auto span = fixture.scope.store().span(channel->id);
            QVERIFY(span);
            QCOMPARE(fixture.scope.store().points(channel->id, *span), seen[ref]);
        }
    }

    void theErrorIsGoalMinusPosition()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        const QString goal = QStringLiteral("active_goal_position");
        QVERIFY(fixture.reads({position, goal}));
        const ServoRef ref = fixture.at(1);
        const session::LiveChannel* error = fixture.scope.find(ref, session::errorKey);
        QVERIFY(error != nullptr);
        const auto& store = fixture.scope.store();
        const auto at = store.latest(error->id);
        const auto wanted = store.at(fixture.scope.find(ref, goal)->id, at->at);
        const auto is = store.at(fixture.scope.find(ref, position)->id, at->at);
        QVERIFY(at && wanted && is);
        QCOMPARE(at->value, wanted->value - is->value);
    }

    void silenceIsAGapAndAMark()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.reads({position}));
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        const auto marked = [&](recording::MarkKind kind) {
            const auto& marks = fixture.scope.marks();
            return std::any_of(marks.begin(), marks.end(),
                               [kind](const recording::Mark& mark) { return mark.kind == kind; });
        };
        QTRY_VERIFY(marked(recording::MarkKind::LinkError));
        const recording::ChannelId id = fixture.scope.find(fixture.at(1), position)->id;
        const base::Duration last = fixture.scope.store().latest(id)->at;
        fixture.withBus([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(marked(recording::MarkKind::LinkRestored));
        QTRY_VERIFY(fixture.scope.store().latest(id)->at > last);
        // Within the gap nothing is known.
        QVERIFY(!fixture.scope.store().at(id, last + std::chrono::milliseconds(2)));
    }

    /// What is read once a second is a line, not a row of gaps.
    void slowReadingIsNoGap()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.reads({position}));
        session::Subscription slow;
        slow.parts.push_back({fixture.at(1), {position}, {}});
        slow.period = std::chrono::milliseconds(600);
        fixture.workbench.polling().subscribe(QStringLiteral("test"), slow);
        const recording::ChannelId id = fixture.scope.find(fixture.at(1), position)->id;
        const auto& store = fixture.scope.store();
        for (int i = 0; i < 4; ++i) {
            const base::Duration now = store.latest(id)->at;
            QTRY_VERIFY(store.latest(id)->at > now);
        }
        const base::Duration last = store.latest(id)->at;
        QVERIFY(store.at(id, last - std::chrono::milliseconds(100)).has_value());
    }

    void aTriggerIsAtItsTime()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.reads({position}));
        recording::TriggerSpec spec;
        spec.kind = recording::TriggerSpec::Kind::Mark;
        spec.mark = recording::MarkKind::Write;
        spec.pre = std::chrono::milliseconds(50);
        spec.post = std::chrono::milliseconds(50);
        fixture.scope.armTrigger(spec);
        fixture.workbench.writes().write(fixture.at(1),
                                         {{{QStringLiteral("position_p"), 40}}, true, {}});
        QTRY_COMPARE(fixture.scope.trigger().state(), recording::Trigger::State::Complete);
        const auto& marks = fixture.scope.marks();
        const auto write =
            std::find_if(marks.begin(), marks.end(), [](const recording::Mark& mark) {
                return mark.kind == recording::MarkKind::Write;
            });
        QVERIFY(write != marks.end());
        QVERIFY(write->text.contains(QLatin1String("position_p")));
        QCOMPARE(fixture.scope.trigger().window()->from, write->at - spec.pre);
        QCOMPARE(fixture.scope.trigger().window()->to, write->at + spec.post);
    }

    void aRecordingMatchesTheStore_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("CSV") << "run.csv";
        QTest::newRow("JSON lines") << "run.jsonl";
    }
    void aRecordingMatchesTheStore()
    {
        QFETCH(QString, name);
        LiveDataFixture fixture;
        QVERIFY(fixture.reads({position, QStringLiteral("present_voltage")}));
        const QTemporaryDir folder;
        const QString path = folder.filePath(name);
        QSignalSpy ended(&fixture.scope.recording(), &session::LiveRecording::ended);
        QVERIFY(fixture.scope.recording().start({.path = path}));
        QVERIFY(!fixture.scope.recording().start({.path = path})); // one at a time
        QTRY_VERIFY(fixture.scope.recording().status().rows > 60);
        fixture.workbench.writes().write(fixture.at(1),
                                         {{{QStringLiteral("position_p"), 41}}, true, {}});
        QTRY_VERIFY(!fixture.workbench.tasks().isBusy());
        fixture.scope.recording().stop();
        QTRY_COMPARE(ended.size(), 1);
        QVERIFY(!fixture.scope.recording().status().error);
        QCOMPARE(fixture.scope.recording().status().lost, std::uint64_t(0));

        session::Replay replay;
        std::shared_ptr<session::ReplayData> back;
        connect(&replay, &session::Replay::loaded, this,
                [&](const std::shared_ptr<session::ReplayData>& loaded) { back = loaded; });
        replay.load(path);
        QTRY_VERIFY(back != nullptr);
        QCOMPARE(back->content.report.rows, fixture.scope.recording().status().rows);
        QCOMPARE(back->content.report.badLines, std::uint64_t(0));
        QCOMPARE(back->content.head.channels.size(), std::size_t(4));
        QVERIFY(back->content.head.simulated);
        QCOMPARE(back->content.marks.size(), std::size_t(1));
        for (std::size_t i = 0; i < back->content.ids.size(); ++i) {
            const recording::RecordingChannel& column = back->content.head.channels[i];
            const auto& source = *fixture.scope.find(column.servo, column.key);
            const auto got =
                back->store.points(back->content.ids[i], *back->store.span(back->content.ids[i]));
            QVERIFY(got.size() > 20);
            const auto all =
                fixture.scope.store().points(source.id, *fixture.scope.store().span(source.id));
            // The same values in the same order, somewhere in what was read.
            const auto place =
                std::search(all.begin(), all.end(), got.begin(), got.end(),
                            [](const recording::SamplePoint& a, const recording::SamplePoint& b) {
                                return a.value == b.value;
                            });
            QVERIFY(place != all.end());
        }
    }

    void anEmptyStoreCannotBeRecorded()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.search());
        const QTemporaryDir folder;
        const auto begun =
            fixture.scope.recording().start({.path = folder.filePath(QStringLiteral("a.csv"))});
        QVERIFY(!begun);
        QCOMPARE(begun.error().code, base::ErrorCode::BadArgument);
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("a.csv"))));
    }

    void aRemovedFolderEndsTheRecordingWithAReason()
    {
        LiveDataFixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.reads({position}));
        auto folder = std::make_unique<QTemporaryDir>();
        QSignalSpy ended(&fixture.scope.recording(), &session::LiveRecording::ended);
        QVERIFY(
            fixture.scope.recording().start({.path = folder->filePath(QStringLiteral("a.csv"))}));
        QTRY_VERIFY(fixture.scope.recording().status().rows > 5);
        folder.reset(); // deleted
        QTRY_COMPARE(ended.size(), 1);
        QVERIFY(fixture.scope.recording().status().error);
        QVERIFY(!fixture.scope.recording().isRunning());
        // The measuring goes on.
        const auto count = fixture.scope.store().count();
        QTRY_VERIFY(fixture.scope.store().count() > count);
    }

    void anotherBusStartsOver()
    {
        LiveDataFixture fixture;
        QVERIFY(fixture.reads({position}));
        fixture.workbench.link().connectTo({.name = QStringLiteral("sim:lx")});
        QTRY_COMPARE(fixture.scope.channels().size(), std::size_t(0));
        QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
        QVERIFY(!fixture.scope.store().span());
    }
};

SERVODESK_GUILESS_TEST(TestLiveData)
#include "tst_live_data.moc"
