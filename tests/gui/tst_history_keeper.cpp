// SPDX-License-Identifier: GPL-3.0-or-later
// What the history learns of the bench by itself: alarms with their beginning and end, recordings
// with the servos they are about. On a simulated bus, in the real database.
#include "gui/desk_bench.h"
#include "session/connection.h"
#include "session/history_keeper.h"
#include "sim/sim_link.h"

namespace {
struct KeeperBench : gui::DeskBench {
    session::Scope scope{desk};
    session::Archive archive;
    session::HistoryKeeper keeper{desk, scope, archive};

    template <typename T>
    T asked(const std::function<base::Result<T>(record::History&)>& question)
    {
        std::optional<T> found;
        archive.ask<T>(question, &archive,
                       [&](const base::Result<T>& answer) { found = answer.value_or(T()); });
        (void)QTest::qWaitFor([&] { return found.has_value(); }, 10'000);
        return found.value_or(T());
    }
    std::vector<record::HistoryAlarm> alarms()
    {
        return asked<std::vector<record::HistoryAlarm>>(
            [](record::History& history) { return history.log().alarms(); });
    }
    std::vector<record::HistoryRecording> recordings()
    {
        return asked<std::vector<record::HistoryRecording>>(
            [](record::History& history) { return history.log().recordings(); });
    }
    void watch(int id)
    {
        session::FeedWish wish;
        wish.parts.push_back(
            {ref(id), {QStringLiteral("present_position"), QStringLiteral("present_voltage")}});
        desk.wish(QStringLiteral("operate"), wish);
    }
    template <typename Deed>
    void withBus(Deed deed)
    {
        desk.connection()->simulation()->with(deed);
    }
};
} // namespace

class TestHistoryKeeper : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void anAlarmHasABeginningAndAnEnd()
    {
        KeeperBench bench;
        QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
        QVERIFY(bench.search());
        bench.desk.readTable(bench.ref(1));
        QTRY_VERIFY(!bench.desk.busy());
        bench.watch(1);
        QVERIFY(bench.alarms().empty());
        bench.withBus([](sim::VirtualBus& bus) { bus.servo(1)->surroundings().supplyVolts = 3.0; });
        QTRY_VERIFY(bench.desk.servo(bench.ref(1))->alarms.anyActive());
        QTRY_COMPARE(bench.alarms().size(), std::size_t(1));
        const auto came = bench.alarms().front();
        QCOMPARE(came.key, QStringLiteral("voltage"));
        QCOMPARE(came.servoId, 1);
        QVERIFY(came.at.isValid() && !came.went.isValid());

        bench.withBus([](sim::VirtualBus& bus) { bus.servo(1)->surroundings().supplyVolts = 7.4; });
        QTRY_VERIFY(!bench.desk.servo(bench.ref(1))->alarms.anyActive());
        QTRY_VERIFY(bench.alarms().front().went.isValid());
        QCOMPARE(bench.alarms().size(), std::size_t(1));
    }

    void aRecordingIsListedWithItsServos()
    {
        KeeperBench bench;
        QVERIFY(bench.open(QStringLiteral("sim:sts3215@1,sts3215@2")));
        QVERIFY(bench.search());
        bench.watch(2);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.csv"));
        QTRY_VERIFY(bench.scope.store().count() > 20);
        QVERIFY(bench.scope.record({.path = path}));
        QTRY_VERIFY(bench.scope.recordingStatus().rows > 20);
        bench.scope.stopRecording();
        QTRY_COMPARE(bench.recordings().size(), std::size_t(1));
        const auto kept = bench.recordings().front();
        QCOMPARE(kept.file, path);
        QVERIFY(kept.rows > 20 && kept.length.count() > 0 && kept.simulated);
        QCOMPARE(kept.servos.size(), std::size_t(1));
        QCOMPARE(kept.servos.front().id, 2);
    }
};

QTEST_MAIN(TestHistoryKeeper)
#include "tst_history_keeper.moc"
