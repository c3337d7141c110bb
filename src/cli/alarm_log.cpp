// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/alarm_log.h"

#include "cli/translate.h"
#include "history/history.h"
#include "session/paths.h"
#include "text/error_text.h"
#include "text/notice_text.h"

namespace cli {
namespace {
constexpr qint64 writeIntervalMs = 1000;
} // namespace

AlarmLog::AlarmLog(Console& console, const std::vector<device::Servo>& servos)
    : m_console(console)
{
    for (const device::Servo& servo : servos) {
        if (text::reportsAlarms(servo.profile.get()))
            m_servos[servo.id] = {servo.identity(), servo.profile};
    }
}

void AlarmLog::addStatus(int id, std::uint8_t status, const QDateTime& at)
{
    const auto found = m_servos.find(id);
    if (found == m_servos.end() || m_failed)
        return;
    WatchedServo& servo = found->second;
    servo.at = at;
    if (servo.status != status) {
        servo.status = status;
        servo.now = text::statusKeys(status, servo.profile.get());
        for (const QString& key : std::as_const(servo.now)) {
            if (!servo.recorded.contains(key))
                servo.raised.try_emplace(key, at);
        }
    }
    if (!servo.wrote.isValid() || servo.wrote.msecsTo(at) >= writeIntervalMs)
        write(servo);
}

void AlarmLog::finish()
{
    for (auto& [id, servo] : m_servos)
        write(servo);
}

void AlarmLog::write(WatchedServo& servo)
{
    if (m_failed || (servo.raised.empty() && servo.now == servo.recorded))
        return;
    const auto keep = [&]() -> base::Result<void> {
        const auto history = record::History::open(session::historyFile());
        if (!history)
            return tl::unexpected(history.error());
        const auto log = (*history)->log();
        QStringList active = servo.recorded;
        for (const auto& [key, at] : servo.raised) {
            if (auto raised = log.recordAlarmStart(servo.identity, key, false, at); !raised)
                return raised;
            active += key;
        }
        for (const QString& key : std::as_const(active)) {
            if (servo.now.contains(key))
                continue;
            if (auto went = log.recordAlarmEnd(servo.identity, key, servo.at); !went)
                return went;
        }
        return {};
    };
    if (const auto recorded = keep(); !recorded) {
        m_failed = true;
        m_console.printMessage(
            translate("cli", "The alarms could not be kept in the history: %1 (%2)")
                .arg(text::describe(recorded.error()).message, recorded.error().detail));
    }
    servo.recorded = servo.now;
    servo.raised.clear();
    servo.wrote = servo.at;
}
} // namespace cli
