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
            m_servos[servo.id] = {servo};
    }
}

void AlarmLog::addStatus(int id, std::uint8_t status, const QDateTime& at)
{
    const auto found = m_servos.find(id);
    if (found == m_servos.end() || m_failed)
        return;
    WatchedServo& servo = found->second;
    servo.at = at;
    servo.servo.status = status;
    servo.latch.update(session::activeAlarms(servo.servo), {}, at);
    if (!servo.writtenAt.isValid() || servo.writtenAt.msecsTo(at) >= writeIntervalMs)
        write(servo);
}

void AlarmLog::finish()
{
    for (auto& [id, servo] : m_servos)
        write(servo);
}

void AlarmLog::write(WatchedServo& servo)
{
    const auto changes = servo.reported.update(servo.latch.alarms(), servo.at);
    if (m_failed || changes.empty())
        return;
    servo.writtenAt = servo.at;
    const auto save = [&]() -> base::Result<void> {
        const auto history = history::History::open(session::historyFile());
        if (!history)
            return tl::unexpected(history.error());
        for (const session::AlarmChange& change : changes) {
            const auto saved =
                session::recordAlarm((*history)->log(), servo.servo.identity(), change);
            if (!saved)
                return saved;
        }
        return {};
    };
    if (const auto saved = save(); !saved) {
        m_failed = true;
        m_console.printMessage(
            translate("cli", "The alarms could not be saved to the history: %1 (%2)")
                .arg(text::describe(saved.error()).message, saved.error().detail));
    }
}
} // namespace cli
