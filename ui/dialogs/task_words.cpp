// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/task_words.h"

#include "text/error_words.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "text/translate.h"
#include "ui/models/rate_words.h"

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

QString valueWord(const device::Servo& servo, const QString& key,
                  const std::optional<std::int64_t>& raw)
{
    const catalog::Register* reg = servo.profile ? servo.profile->find(key) : nullptr;
    if (reg == nullptr || !raw)
        return QStringLiteral("–");
    const catalog::Meaning meaning = servo.meaning(*reg);
    const QString shown = catalog::formatValue(*raw, *reg, meaning, text::inChinese());
    return meaning.unit.isEmpty() ? shown : QStringLiteral("%1 (%2)").arg(*raw).arg(shown);
}

QString registerWord(const device::Servo& servo, const QString& key)
{
    const catalog::Register* reg = servo.profile ? servo.profile->find(key) : nullptr;
    return reg != nullptr ? reg->name.in(text::inChinese()) : key;
}

QString lockLine(device::LockState lock)
{
    if (lock == device::LockState::None)
        return {};
    return translate("ServoTasks", "EPROM lock: %1").arg(text::lockWord(device::lockName(lock)));
}

QStringList noticeLines(const device::Notices& notices)
{
    QStringList lines;
    for (const base::Notice& notice : notices) {
        // Where it answers now is said in full.
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

TaskWords errorWords(const base::Error& error)
{
    const text::Description words = text::describe(error);
    TaskWords told{Tone::Bad, words.what};
    if (!words.cause.isEmpty())
        told.more << translate("ServoTasks", "Likely cause: %1").arg(words.cause);
    told.more << translate("ServoTasks", "What to do: %1").arg(words.remedy);
    return told;
}

TaskWords refusedWords(const base::Error& error, const QString& what)
{
    TaskWords told = errorWords(error);
    told.tone = Tone::Warn;
    told.more.prepend(told.what);
    told.what = what;
    return told;
}

namespace {
/// It was heard at the end, by what was read last: the lock, or the register where there is none.
bool answeredAtTheEnd(const device::WriteReport& report)
{
    if (report.lock != device::LockState::None)
        return report.lock != device::LockState::Unknown;
    return std::all_of(report.writes.begin(), report.writes.end(), [](const auto& write) {
        return write.readBack || write.outcome == device::WriteOutcome::Refused;
    });
}

QString answersAt(const device::Servo& servo)
{
    return servo.baud > 0 ? translate("ServoTasks", "The servo answers as ID %1 at %2 baud.")
                                .arg(servo.id)
                                .arg(rateText(servo.baud))
                          : translate("ServoTasks", "The servo answers as ID %1.").arg(servo.id);
}

/// Of a change of its ID or rate that was sent, or may have been: where the servo can be.
QString mayAnswerAt(const session::ServoEntry& entry, const device::WriteResult& write)
{
    const bool sent = !device::isUntouched(write.outcome);
    const catalog::Register* reg =
        entry.servo.profile ? entry.servo.profile->find(write.key) : nullptr;
    if (!sent || reg == nullptr)
        return {};
    const QString before = valueWord(entry.servo, write.key, write.oldRaw);
    const QString after = valueWord(entry.servo, write.key, write.newRaw);
    if (reg->role == catalog::Role::BaudRate)
        return translate("ServoTasks", "It did not answer at the end and may be at either baud "
                                       "rate: %1 or %2. Port → Interrupted writes looks for it at "
                                       "both; so does a search at these rates.")
            .arg(before, after);
    if (reg->role == catalog::Role::Id)
        return translate("ServoTasks", "It did not answer at the end and may have either ID: %1 or "
                                       "%2. Port → Interrupted writes looks for it at both; so "
                                       "does a search.")
            .arg(before, after);
    return {};
}
} // namespace

TaskWords writeWords(const session::ServoEntry& entry, const device::WriteReport& report,
                     const QString& done)
{
    TaskWords told{Tone::Good, done};
    for (const device::WriteResult& write : report.writes) {
        const QString before =
            write.oldRaw ? valueWord(entry.servo, write.key, write.oldRaw) : QStringLiteral("?");
        told.more << QStringLiteral("%1: %2 → %3, %4")
                         .arg(registerWord(entry.servo, write.key), before,
                              valueWord(entry.servo, write.key, write.newRaw),
                              text::outcomeWord(device::outcomeName(write.outcome)));
        if (!write.error)
            continue;
        const TaskWords failed = errorWords(*write.error);
        told.tone = Tone::Bad;
        told.what = failed.what;
        told.more += failed.more;
    }
    if (told.tone == Tone::Good && !report.allGood()) {
        told.tone = Tone::Warn;
        told.what = translate("ServoTasks", "Not everything ended as it should.");
    }
    if (const QString lock = lockLine(report.lock); !lock.isEmpty())
        told.more << lock;
    if (answeredAtTheEnd(report))
        told.more << answersAt(entry.servo);
    for (const device::WriteResult& write : report.writes) {
        if (const QString line = mayAnswerAt(entry, write);
            !answeredAtTheEnd(report) && !line.isEmpty())
            told.more << line;
    }
    return told;
}
} // namespace ui
