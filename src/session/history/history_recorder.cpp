// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_recorder.h"

#include <QFileInfo>

namespace session {
namespace {
constexpr auto checkInterval = std::chrono::seconds(1);
}

HistoryRecorder::HistoryRecorder(Desk& desk, LiveData& liveData, HistoryService& historyService,
                                 QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_liveData(liveData)
    , m_historyService(historyService)
{
    m_checkTimer.setInterval(checkInterval);
    connect(&m_checkTimer, &QTimer::timeout, this, &HistoryRecorder::checkNow);
    m_checkTimer.start();
    connect(&desk, &Desk::servoRemoved, this, [this](ServoRef ref) { m_reported.erase(ref); });
    connect(&desk, &Desk::servosCleared, this, [this] { m_reported.clear(); });
    connect(&liveData, &LiveData::recordingBegan, this, [this] {
        m_recordedAt = QDateTime::currentDateTimeUtc();
        m_recorded.clear();
        for (const ServoRef ref : m_liveData.recordedServos()) {
            if (const ServoEntry* entry = m_desk.servo(ref))
                m_recorded.push_back(entry->servo.identity());
        }
    });
    connect(&liveData, &LiveData::recordingEnded, this, &HistoryRecorder::recorded);
}

void HistoryRecorder::checkNow()
{
    for (const ServoRef ref : m_desk.servos()) {
        const ServoEntry* entry = m_desk.servo(ref);
        if (entry->servo.profile)
            checkServo(*entry);
    }
}

/// The latch keeps what has come until somebody has seen it, so that one of a tenth of a second is
/// not missed here.
void HistoryRecorder::checkServo(const ServoEntry& entry)
{
    auto& reported = m_reported[entry.ref];
    const base::ServoIdentity identity = entry.servo.identity();
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const auto keep = [&](const QString& key, bool derived, bool raised, const QDateTime& at) {
        m_historyService.saveAlarm(identity, key, derived, raised, at);
    };
    std::set<QString> present;
    for (const Alarm& alarm : entry.alarms.alarms()) {
        present.insert(alarm.what.key);
        ReportedAlarm& known = reported[alarm.what.key];
        if (alarm.count != known.times) {
            const bool first = known.times == 0;
            if (known.active)
                keep(alarm.what.key, alarm.what.derived, false, now); // it went in between
            keep(alarm.what.key, alarm.what.derived, true,
                 first && alarm.firstSeen.isValid() ? alarm.firstSeen.toUTC() : now);
            known = {alarm.count, true};
        }
        if (known.active && !alarm.active) {
            keep(alarm.what.key, alarm.what.derived, false, now);
            known.active = false;
        }
    }
    for (auto known = reported.begin(); known != reported.end();) {
        if (present.count(known->first) > 0) {
            ++known;
            continue;
        }
        if (known->second.active) // acknowledged and over before the next look
            keep(known->first, false, false, now);
        known = reported.erase(known);
    }
}

void HistoryRecorder::recorded(const record::RecorderStatus& status, const QString& path)
{
    if (status.rows == 0)
        return;
    record::HistoryRecording recording;
    recording.at = m_recordedAt;
    recording.length = status.elapsed;
    recording.file = QFileInfo(path).absoluteFilePath();
    recording.rows = qint64(status.rows);
    recording.port = m_desk.lastRequest().name;
    recording.simulated = m_desk.isSimulated();
    m_historyService.saveRecording(recording, m_recorded);
}
} // namespace session
