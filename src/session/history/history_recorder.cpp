// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_recorder.h"

#include "session/step/step_test.h"
#include "session/sweep/sweep_test.h"

#include <QFileInfo>

namespace session {
namespace {
constexpr auto checkInterval = std::chrono::seconds(1);
}

HistoryRecorder::HistoryRecorder(Workbench& workbench)
    : m_workbench(workbench)
    , m_liveData(workbench.liveData())
    , m_historyService(workbench.history())
{
    m_checkTimer.setInterval(checkInterval);
    connect(&m_checkTimer, &QTimer::timeout, this, &HistoryRecorder::checkNow);
    m_checkTimer.start();
    connect(&workbench.registry(), &ServoRegistry::servoRemoved, this,
            [this](ServoRef ref) { m_reported.erase(ref); });
    connect(&workbench.registry(), &ServoRegistry::servosCleared, this,
            [this] { m_reported.clear(); });
    connect(&m_liveData.recording(), &LiveRecording::began, this, [this] {
        m_recordedAt = QDateTime::currentDateTimeUtc();
        m_recorded.clear();
        for (const ServoRef ref : m_liveData.recording().servos()) {
            if (const ServoEntry* entry = m_workbench.registry().servo(ref))
                m_recorded.push_back(entry->servo.identity());
        }
    });
    connect(&m_liveData.recording(), &LiveRecording::ended, this, &HistoryRecorder::recorded);
    connect(&workbench.sweepTest(), &SweepTest::finished, this, [this] {
        const SweepTest& test = m_workbench.sweepTest();
        m_historyService.saveRun(std::make_shared<const results::SweepRun>(*test.run()),
                                 {test.readingsPath()});
    });
    connect(&workbench.stepTest(), &StepTest::finished, this, [this] {
        const results::StepRun& run = m_workbench.stepTest().runs().back();
        m_historyService.saveRun(std::make_shared<const results::StepRun>(run));
    });
}

void HistoryRecorder::checkNow()
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    for (const ServoRef ref : m_workbench.registry().order()) {
        const ServoEntry* entry = m_workbench.registry().servo(ref);
        if (!entry->servo.profile)
            continue;
        for (const auto& change : m_reported[ref].update(entry->alarms.alarms(), now))
            m_historyService.saveAlarm(entry->servo.identity(), change);
    }
}

void HistoryRecorder::recorded(const recording::RecorderStatus& status, const QString& path)
{
    if (status.rows == 0)
        return;
    history::HistoryRecording recording;
    recording.at = m_recordedAt;
    recording.length = status.elapsed;
    recording.file = QFileInfo(path).absoluteFilePath();
    recording.rows = qint64(status.rows);
    recording.port = m_workbench.link().lastRequest().name;
    recording.simulated = m_workbench.link().isSimulated();
    m_historyService.saveRecording(recording, m_recorded);
}
} // namespace session
