// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/task_text.h"

#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/widgets/rate_text.h"

#include <algorithm>

namespace ui {
using text::translate;

QString modelName(const session::ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->modelName
                               : translate("ServoTasks", "unknown model");
}

QString servoTitle(const session::ServoEntry& entry)
{
    QStringList parts{translate("ServoTasks", "ID %1").arg(entry.servo.id), modelName(entry)};
    if (entry.servo.profile && entry.servo.profile->identity.firmwareMajor >= 0) {
        parts
            << translate("ServoTasks", "firmware %1").arg(entry.servo.profile->identity.firmware());
    }
    return parts.join(QStringLiteral(" · "));
}

QString valueText(const device::Servo& servo, const QString& key,
                  const std::optional<std::int64_t>& raw)
{
    const catalog::Register* reg = servo.profile ? servo.profile->find(key) : nullptr;
    if (reg == nullptr || !raw)
        return QStringLiteral("–");
    const catalog::ValueFormat meaning = servo.meaning(*reg);
    const QString shown = catalog::formatValue(*raw, *reg, meaning, text::isUiChinese());
    return meaning.unit.isEmpty() ? shown : QStringLiteral("%1 (%2)").arg(*raw).arg(shown);
}

QString registerText(const device::Servo& servo, const QString& key)
{
    return text::registerName(servo.profile.get(), key);
}

QString lockLine(device::LockState lock)
{
    if (lock == device::LockState::None)
        return {};
    return translate("ServoTasks", "EPROM lock: %1").arg(text::lockLabel(device::lockName(lock)));
}

QStringList noticeLines(const device::Notices& notices)
{
    QStringList lines;
    for (const base::Notice& notice : notices) {
        // The ID and baud rate at which it answers now are given in full.
        if (notice.code == base::NoticeCode::IdChanged ||
            notice.code == base::NoticeCode::RateChanged ||
            notice.code == base::NoticeCode::AckFromNewId)
            continue;
        const QString line = text::describe(notice);
        if (!lines.contains(line))
            lines << line;
    }
    return lines;
}

TaskText errorText(const base::Error& error)
{
    const text::Description description = text::describe(error);
    TaskText result{Tone::Bad, description.message};
    if (!description.cause.isEmpty())
        result.details << translate("ServoTasks", "Likely cause: %1").arg(description.cause);
    result.details << translate("ServoTasks", "Remedy: %1").arg(description.remedy);
    return result;
}

TaskText refusedText(const base::Error& error, const QString& what)
{
    TaskText result = errorText(error);
    result.tone = Tone::Warn;
    result.details.prepend(result.message);
    result.message = what;
    return result;
}

namespace {
/// The servo answered at the end: the last reading was the lock, or the register if it has none.
bool isAnswering(const device::WriteReport& report)
{
    if (report.lock != device::LockState::None)
        return report.lock != device::LockState::Unknown;
    return std::all_of(report.writes.begin(), report.writes.end(), [](const auto& write) {
        return write.readBack || write.outcome == device::WriteOutcome::Refused;
    });
}

QString addressText(const device::Servo& servo)
{
    return servo.baud > 0 ? translate("ServoTasks", "The servo replies as ID %1 at %2 baud.")
                                .arg(servo.id)
                                .arg(rateText(servo.baud))
                          : translate("ServoTasks", "The servo replies as ID %1.").arg(servo.id);
}

/// Where the servo can be after a change of ID or baud rate that was, or may have been, sent.
QString possibleAddressText(const session::ServoEntry& entry, const device::WriteResult& write)
{
    const bool sent = !device::isUntouched(write.outcome);
    const catalog::Register* reg =
        entry.servo.profile ? entry.servo.profile->find(write.key) : nullptr;
    if (!sent || reg == nullptr)
        return {};
    const QString before = valueText(entry.servo, write.key, write.oldRaw);
    const QString after = valueText(entry.servo, write.key, write.newRaw);
    if (reg->role == catalog::Role::BaudRate)
        return translate("ServoTasks", "The servo did not reply at the end of the operation, so "
                                       "its baud rate may be %1 or %2. To find the servo, use Port "
                                       "→ Interrupted writes or search at both baud rates.")
            .arg(before, after);
    if (reg->role == catalog::Role::Id)
        return translate(
                   "ServoTasks",
                   "The servo did not reply at the end of the operation, so its ID may be %1 or "
                   "%2. To find the servo, use Port → Interrupted writes or search the bus.")
            .arg(before, after);
    return {};
}
} // namespace

TaskText writeText(const session::ServoEntry& entry, const device::WriteReport& report,
                   const QString& done)
{
    TaskText result{Tone::Good, done};
    for (const device::WriteResult& write : report.writes) {
        const QString before =
            write.oldRaw ? valueText(entry.servo, write.key, write.oldRaw) : QStringLiteral("?");
        result.details << QStringLiteral("%1: %2 → %3, %4")
                              .arg(registerText(entry.servo, write.key), before,
                                   valueText(entry.servo, write.key, write.newRaw),
                                   text::outcomeLabel(device::outcomeName(write.outcome)));
        if (!write.error)
            continue;
        const TaskText failed = errorText(*write.error);
        result.tone = Tone::Bad;
        result.message = failed.message;
        result.details += failed.details;
    }
    if (result.tone == Tone::Good && !report.isSuccessful()) {
        result.tone = Tone::Warn;
        result.message = translate("ServoTasks", "Some steps did not end as expected.");
    }
    if (const QString lock = lockLine(report.lock); !lock.isEmpty())
        result.details << lock;
    if (isAnswering(report))
        result.details << addressText(entry.servo);
    for (const device::WriteResult& write : report.writes) {
        if (const QString line = possibleAddressText(entry, write);
            !isAnswering(report) && !line.isEmpty())
            result.details << line;
    }
    return result;
}
} // namespace ui
