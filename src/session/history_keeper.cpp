// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_keeper.h"

#include <QFileInfo>

namespace session {
namespace {
constexpr auto lookEvery = std::chrono::seconds(1);
}

HistoryKeeper::HistoryKeeper(Desk& desk, Scope& scope, Archive& archive, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_scope(scope)
    , m_archive(archive)
{
    m_look.setInterval(lookEvery);
    connect(&m_look, &QTimer::timeout, this, &HistoryKeeper::look);
    m_look.start();
    connect(&desk, &Desk::servoRemoved, this, [this](ServoRef ref) { m_told.erase(ref); });
    connect(&desk, &Desk::servosCleared, this, [this] { m_told.clear(); });
    connect(&scope, &Scope::recordingBegan, this, [this] {
        m_recordedAt = QDateTime::currentDateTimeUtc();
        m_recorded.clear();
        for (const ServoRef ref : m_scope.recordedServos()) {
            if (const ServoEntry* entry = m_desk.servo(ref))
                m_recorded.push_back(entry->servo.identity());
        }
    });
    connect(&scope, &Scope::recordingEnded, this, &HistoryKeeper::recorded);
}

void HistoryKeeper::look()
{
    for (const ServoRef ref : m_desk.servos()) {
        const ServoEntry* entry = m_desk.servo(ref);
        if (entry->servo.profile)
            lookAt(*entry);
    }
}

/// The latch keeps what has come until somebody has seen it, so that one of a tenth of a second is
/// not missed here.
void HistoryKeeper::lookAt(const ServoEntry& entry)
{
    auto& told = m_told[entry.ref];
    const base::ServoIdentity who = entry.servo.identity();
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const auto keep = [&](const QString& key, bool derived, bool came, const QDateTime& at) {
        m_archive.keepAlarm(who, key, derived, came, at);
    };
    std::set<QString> present;
    for (const Alarm& alarm : entry.alarms.alarms()) {
        present.insert(alarm.what.key);
        Told& known = told[alarm.what.key];
        if (alarm.times != known.times) {
            const bool first = known.times == 0;
            if (known.active)
                keep(alarm.what.key, alarm.what.derived, false, now); // it went in between
            keep(alarm.what.key, alarm.what.derived, true,
                 first && alarm.firstSeen.isValid() ? alarm.firstSeen.toUTC() : now);
            known = {alarm.times, true};
        }
        if (known.active && !alarm.active) {
            keep(alarm.what.key, alarm.what.derived, false, now);
            known.active = false;
        }
    }
    for (auto known = told.begin(); known != told.end();) {
        if (present.count(known->first) > 0) {
            ++known;
            continue;
        }
        if (known->second.active) // acknowledged and over before the next look
            keep(known->first, false, false, now);
        known = told.erase(known);
    }
}

void HistoryKeeper::recorded(const record::RecorderStatus& status, const QString& path)
{
    if (status.rows == 0)
        return;
    record::HistoryRecording recording;
    recording.at = m_recordedAt;
    recording.length = status.elapsed;
    recording.file = QFileInfo(path).absoluteFilePath();
    recording.rows = qint64(status.rows);
    recording.port = m_desk.lastRequest().name;
    recording.simulated = m_desk.simulated();
    m_archive.keepRecording(recording, m_recorded);
}
} // namespace session
