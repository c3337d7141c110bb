// SPDX-License-Identifier: GPL-3.0-or-later
// The oscilloscope behind the charts on a simulated bus: what is read becomes curves, silence a
// gap, an alarm a mark; a recording holds what the store has.
#include "session/replay.h"
#include "session/scope.h"

#include <QSignalSpy>

#include "session_bench.h"
#include <cmath>

using session::Scope;

namespace {
const QString position = QStringLiteral("present_position");

/// A bench that reads a servo's position and goal all the time.
struct ScopeBench : Bench {
    explicit ScopeBench(const QString& port = QStringLiteral("sim:sts3215@1,sts3215@2"))
        : Bench(port)
        , scope(desk)
    {}
    bool reads(const QStringList& keys)
    {
        if (!search())
            return false;
        for (const ServoRef ref : desk.servos())
            desk.readTable(ref); // modes and units
        if (!settle())
            return false;
        session::FeedWish wish;
        for (const ServoRef ref : desk.servos())
            wish.parts.push_back({ref, keys, {}});
        wish.period = std::chrono::milliseconds(5);
        desk.wish(QStringLiteral("test"), wish);
        return QTest::qWaitFor([&] { return scope.store().count() > 40; });
    }
    Scope scope;
};
} // namespace

class TestScope : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyReadingBecomesASampleOfItsCurve()
    {
        ScopeBench bench;
        std::map<ServoRef, std::vector<record::SamplePoint>> seen;
        connect(&bench.desk, &Desk::readings, this, [&](const std::vector<session::Reading>& all) {
            for (const session::Reading& one : all) {
                for (const session::ReadValue& value : one.values) {
                    if (value.reg->key == position)
                        seen[one.servo].push_back({one.at, value.physical});
                }
            }
        });
        QVERIFY(bench.reads({position}));
        for (const ServoRef ref : bench.desk.servos()) {
            const session::ScopeChannel* channel = bench.scope.find(ref, position);
            QVERIFY(channel != nullptr);
            QCOMPARE(channel->unit, QStringLiteral("deg"));
            const auto span = bench.scope.store().span(channel->id);
            QVERIFY(span);
            QCOMPARE(bench.scope.store().points(channel->id, *span), seen[ref]);
        }
    }

    void theErrorIsGoalLessPosition()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        const QString goal = QStringLiteral("active_goal_position");
        QVERIFY(bench.reads({position, goal}));
        const ServoRef ref = bench.at(1);
        const session::ScopeChannel* error = bench.scope.find(ref, session::errorKey);
        QVERIFY(error != nullptr);
        const auto& store = bench.scope.store();
        const auto at = store.latest(error->id);
        const auto wanted = store.at(bench.scope.find(ref, goal)->id, at->at);
        const auto is = store.at(bench.scope.find(ref, position)->id, at->at);
        QVERIFY(at && wanted && is);
        QCOMPARE(at->value, wanted->value - is->value);
    }

    void silenceIsAGapAndAMark()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.reads({position}));
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        const auto marked = [&](record::MarkKind kind) {
            const auto& marks = bench.scope.marks();
            return std::any_of(marks.begin(), marks.end(),
                               [kind](const record::Mark& mark) { return mark.kind == kind; });
        };
        QTRY_VERIFY(marked(record::MarkKind::LinkError));
        const record::ChannelId id = bench.scope.find(bench.at(1), position)->id;
        const base::Duration last = bench.scope.store().latest(id)->at;
        bench.withWire([](sim::VirtualBus& bus) { bus.config().faults.muteIds = {}; });
        QTRY_VERIFY(marked(record::MarkKind::LinkBack));
        QTRY_VERIFY(bench.scope.store().latest(id)->at > last);
        // Within the gap nothing is known.
        QVERIFY(!bench.scope.store().at(id, last + std::chrono::milliseconds(2)));
    }

    /// What is read once a second is a line, not a row of gaps.
    void slowReadingIsNoGap()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.reads({position}));
        session::FeedWish slow;
        slow.parts.push_back({bench.at(1), {position}, {}});
        slow.period = std::chrono::milliseconds(600);
        bench.desk.wish(QStringLiteral("test"), slow);
        const record::ChannelId id = bench.scope.find(bench.at(1), position)->id;
        const auto& store = bench.scope.store();
        for (int i = 0; i < 4; ++i) {
            const base::Duration now = store.latest(id)->at;
            QTRY_VERIFY(store.latest(id)->at > now);
        }
        const base::Duration last = store.latest(id)->at;
        QVERIFY(store.at(id, last - std::chrono::milliseconds(100)).has_value());
    }

    void aTriggerStandsAtItsMoment()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.reads({position}));
        record::TriggerSpec spec;
        spec.kind = record::TriggerSpec::Kind::Mark;
        spec.mark = record::MarkKind::Write;
        spec.pre = std::chrono::milliseconds(50);
        spec.post = std::chrono::milliseconds(50);
        bench.scope.arm(spec);
        bench.desk.write(bench.at(1), {{{QStringLiteral("position_p"), 40}}, true, false});
        QTRY_COMPARE(bench.scope.trigger().state(), record::Trigger::State::Complete);
        const auto& marks = bench.scope.marks();
        const auto write = std::find_if(marks.begin(), marks.end(), [](const record::Mark& mark) {
            return mark.kind == record::MarkKind::Write;
        });
        QVERIFY(write != marks.end());
        QVERIFY(write->text.contains(QLatin1String("position_p")));
        QCOMPARE(bench.scope.trigger().window()->from, write->at - spec.pre);
        QCOMPARE(bench.scope.trigger().window()->to, write->at + spec.post);
    }

    void aRecordingHoldsWhatTheStoreHas_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("CSV") << "run.csv";
        QTest::newRow("JSON lines") << "run.jsonl";
    }
    void aRecordingHoldsWhatTheStoreHas()
    {
        QFETCH(QString, name);
        ScopeBench bench;
        QVERIFY(bench.reads({position, QStringLiteral("present_voltage")}));
        const QTemporaryDir folder;
        const QString path = folder.filePath(name);
        QSignalSpy ended(&bench.scope, &Scope::recordingEnded);
        QVERIFY(bench.scope.record({.path = path}));
        QVERIFY(!bench.scope.record({.path = path})); // one at a time
        QTRY_VERIFY(bench.scope.recordingStatus().rows > 60);
        bench.desk.write(bench.at(1), {{{QStringLiteral("position_p"), 41}}, true, false});
        QTRY_VERIFY(!bench.desk.busy());
        bench.scope.stopRecording();
        QTRY_COMPARE(ended.size(), 1);
        QVERIFY(!bench.scope.recordingStatus().error);
        QCOMPARE(bench.scope.recordingStatus().lost, std::uint64_t(0));

        session::Replay replay;
        std::shared_ptr<session::Replayed> back;
        connect(&replay, &session::Replay::loaded, this,
                [&](const std::shared_ptr<session::Replayed>& loaded) { back = loaded; });
        replay.load(path);
        QTRY_VERIFY(back != nullptr);
        QCOMPARE(back->content.report.rows, bench.scope.recordingStatus().rows);
        QCOMPARE(back->content.report.badLines, std::uint64_t(0));
        QCOMPARE(back->content.head.channels.size(), std::size_t(4));
        QVERIFY(back->content.head.simulated);
        QCOMPARE(back->content.marks.size(), std::size_t(1));
        for (std::size_t i = 0; i < back->content.ids.size(); ++i) {
            const record::RecordingChannel& column = back->content.head.channels[i];
            const auto& source = *bench.scope.find(column.servo, column.key);
            const auto got =
                back->store.points(back->content.ids[i], *back->store.span(back->content.ids[i]));
            QVERIFY(got.size() > 20);
            const auto all =
                bench.scope.store().points(source.id, *bench.scope.store().span(source.id));
            // The same values in the same order, somewhere in what was read.
            const auto place =
                std::search(all.begin(), all.end(), got.begin(), got.end(),
                            [](const record::SamplePoint& a, const record::SamplePoint& b) {
                                return a.value == b.value;
                            });
            QVERIFY(place != all.end());
        }
    }

    void nothingReadCannotBeRecorded()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.search());
        const QTemporaryDir folder;
        const auto begun = bench.scope.record({.path = folder.filePath(QStringLiteral("a.csv"))});
        QVERIFY(!begun);
        QCOMPARE(begun.error().code, base::ErrorCode::BadArgument);
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("a.csv"))));
    }

    void aFolderThatGoesEndsTheRecordingWithItsReason()
    {
        ScopeBench bench(QStringLiteral("sim:sts3215@1"));
        QVERIFY(bench.reads({position}));
        auto folder = std::make_unique<QTemporaryDir>();
        QSignalSpy ended(&bench.scope, &Scope::recordingEnded);
        QVERIFY(bench.scope.record({.path = folder->filePath(QStringLiteral("a.csv"))}));
        QTRY_VERIFY(bench.scope.recordingStatus().rows > 5);
        folder.reset(); // deleted
        QTRY_COMPARE(ended.size(), 1);
        QVERIFY(bench.scope.recordingStatus().error);
        QVERIFY(!bench.scope.recording());
        // The measuring goes on.
        const auto count = bench.scope.store().count();
        QTRY_VERIFY(bench.scope.store().count() > count);
    }

    void anotherBusBeginsAnew()
    {
        ScopeBench bench;
        QVERIFY(bench.reads({position}));
        bench.desk.connectTo({.name = QStringLiteral("sim:lx")});
        QTRY_COMPARE(bench.scope.channels().size(), std::size_t(0));
        QTRY_COMPARE(bench.desk.state(), LinkState::Open);
        QVERIFY(!bench.scope.store().span());
    }
};

QTEST_GUILESS_MAIN(TestScope)
#include "tst_scope.moc"
