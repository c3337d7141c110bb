// SPDX-License-Identifier: GPL-3.0-or-later
// What the history learns of the bench by itself: alarms with their beginning and end, recordings
// with the servos they are about. On a simulated bus, in the real database.
#include "gui/workbench_fixture.h"
#include "session/connection.h"
#include "session/history/history_recorder.h"
#include "session/history/history_service.h"
#include "session/recording/live_data.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"

namespace {
struct HistoryRecorderFixture : gui::WorkbenchFixture {
    session::LiveData& scope = workbench.liveData();
    session::HistoryService& historyService = workbench.history();
    session::HistoryRecorder& keeper = workbench.historyRecorder();

    template <typename T>
    T asked(const std::function<base::Result<T>(history::History&)>& question)
    {
        std::optional<T> found;
        historyService.query<T>(question, &historyService, [&](const base::Result<T>& answer) {
            found = answer.value_or(T());
        });
        (void)support::waitFor([&] { return found.has_value(); });
        return found.value_or(T());
    }
    std::vector<history::HistoryAlarm> alarms()
    {
        return asked<std::vector<history::HistoryAlarm>>(
            [](history::History& history) { return history.log().alarms(); });
    }
    std::vector<history::HistoryRecording> recordings()
    {
        return asked<std::vector<history::HistoryRecording>>(
            [](history::History& history) { return history.log().recordings(); });
    }
    void watch(int id)
    {
        session::Subscription subscription;
        subscription.parts.push_back(
            {ref(id), {QStringLiteral("present_position"), QStringLiteral("present_voltage")}});
        workbench.polling().subscribe(QStringLiteral("operate"), subscription);
    }
    template <typename Action>
    void withBus(Action action)
    {
        workbench.link().connection()->simulation()->with(action);
    }
};
} // namespace

class TestHistoryRecorder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void anAlarmHasAStartAndAnEnd()
    {
        HistoryRecorderFixture fixture;
        QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
        QVERIFY(fixture.search());
        fixture.workbench.writes().readTable(fixture.ref(1));
        QTRY_VERIFY(!fixture.workbench.tasks().isBusy());
        fixture.watch(1);
        QVERIFY(fixture.alarms().empty());
        fixture.withBus(
            [](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = 3.0; });
        QTRY_VERIFY(fixture.workbench.registry().servo(fixture.ref(1))->alarms.hasActive());
        QTRY_COMPARE(fixture.alarms().size(), std::size_t(1));
        const auto alarm = fixture.alarms().front();
        QCOMPARE(alarm.key, QStringLiteral("voltage"));
        QCOMPARE(alarm.servoId, 1);
        QVERIFY(alarm.at.isValid() && !alarm.clearedAt.isValid());

        fixture.withBus(
            [](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = 7.4; });
        QTRY_VERIFY(!fixture.workbench.registry().servo(fixture.ref(1))->alarms.hasActive());
        QTRY_VERIFY(fixture.alarms().front().clearedAt.isValid());
        QCOMPARE(fixture.alarms().size(), std::size_t(1));
    }

    void aRecordingIsListedWithItsServos()
    {
        HistoryRecorderFixture fixture;
        QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1,sts3215@2")));
        QVERIFY(fixture.search());
        fixture.watch(2);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.csv"));
        QTRY_VERIFY(fixture.scope.store().count() > 20);
        QVERIFY(fixture.scope.recording().start({.path = path}));
        QTRY_VERIFY(fixture.scope.recording().status().rows > 20);
        fixture.scope.recording().stop();
        QTRY_COMPARE(fixture.recordings().size(), std::size_t(1));
        const auto kept = fixture.recordings().front();
        QCOMPARE(kept.file, path);
        QVERIFY(kept.rows > 20 && kept.length.count() > 0 && kept.simulated);
        QCOMPARE(kept.servos.size(), std::size_t(1));
        QCOMPARE(kept.servos.front().id, 2);
    }
};

SERVODESK_TEST(TestHistoryRecorder)
#include "tst_history_recorder.moc"
