// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_words.h"
#include "text/notice_words.h"
#include "text/translate.h"
#include "ui/app/theme.h"
#include "ui/models/memory_words.h"

namespace ui {
using text::translate;
namespace {
QString outcome(device::WriteOutcome outcome)
{
    return text::outcomeWord(device::outcomeName(outcome));
}

/// Sign and word, without the age.
QString plainState(const MemoryRow& row)
{
    using device::WriteOutcome;
    switch (row.state) {
    case RowState::NotRead:
        return translate("MemoryTable", "not read");
    case RowState::Read:
        return {};
    case RowState::Unreadable:
        return QStringLiteral("✗ ") + translate("MemoryTable", "not readable");
    case RowState::Pending:
        return QStringLiteral("… ") + translate("MemoryTable", "pending: %1").arg(row.wanted);
    case RowState::Kept:
        return QStringLiteral("✓ ") + outcome(WriteOutcome::Kept);
    case RowState::Temporary:
        return QStringLiteral("◷ ") + outcome(WriteOutcome::Temporary);
    case RowState::Mismatch:
        return QStringLiteral("≠ ") + outcome(WriteOutcome::Mismatch);
    case RowState::Refused:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::Refused);
    case RowState::NoAnswer:
        // The value beside it may have been read since.
        return QStringLiteral("✗ ") + translate("MemoryTable", "write: no answer");
    case RowState::Unknown:
        return QStringLiteral("? ") + outcome(WriteOutcome::Unknown);
    case RowState::NotSent:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::NotSent);
    case RowState::NotWritten:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::Refused);
    case RowState::Superseded:
        return QStringLiteral("≠ ") + translate("MemoryTable", "changed since");
    }
    return {};
}

QString meaningOfState(const MemoryRow& row)
{
    switch (row.state) {
    case RowState::NotRead:
        return translate("MemoryTable", "This register has not been read yet. Choose Read all.");
    case RowState::Read:
        return translate("MemoryTable", "Read from the servo.");
    case RowState::Unreadable:
        return translate("MemoryTable", "The latest reading failed, so no number is shown.");
    case RowState::Pending:
        return translate("MemoryTable", "%1 is being written.").arg(row.wanted);
    case RowState::Kept:
        return translate("MemoryTable", "%1 was written, read back, and is kept at power-off.")
            .arg(row.wanted);
    case RowState::Temporary:
        return translate("MemoryTable", "%1 was written and read back; it is lost at power-off.")
            .arg(row.wanted);
    case RowState::Mismatch:
        return translate("MemoryTable", "%1 was written, but the servo shows another value.")
            .arg(row.wanted);
    case RowState::Refused:
        return translate("MemoryTable", "The servo did not take %1.").arg(row.wanted);
    case RowState::NoAnswer:
        return translate("MemoryTable", "There was no answer while %1 was being written.")
            .arg(row.wanted);
    case RowState::Unknown:
        return translate("MemoryTable",
                         "It is not known what became of writing %1. Read the register again.")
            .arg(row.wanted);
    case RowState::NotSent:
    case RowState::NotWritten:
        return translate("MemoryTable", "%1 was not written; the servo was not touched.")
            .arg(row.wanted);
    case RowState::Superseded:
        return translate("MemoryTable", "%1 was written here, but the servo shows another value "
                                        "since: a temporary value "
                                        "is lost at power-off, or somebody else wrote.")
            .arg(row.wanted);
    }
    return {};
}

bool tellsError(RowState state)
{
    return state == RowState::Mismatch || state == RowState::Refused ||
           state == RowState::NoAnswer || state == RowState::Unknown ||
           state == RowState::NotWritten || state == RowState::NotSent;
}
} // namespace

QString ageWord(RowAge age)
{
    constexpr int minute = 60;
    constexpr int hour = 60 * minute;
    if (age.seconds < 0)
        return {};
    if (age.seconds == 0)
        return translate("MemoryTable", "now");
    if (age.seconds < minute)
        return translate("MemoryTable", "%1 s").arg(age.seconds);
    return age.seconds < hour ? translate("MemoryTable", "%1 min").arg(age.seconds / minute)
                              : translate("MemoryTable", "%1 h").arg(age.seconds / hour);
}

QString stateWord(const MemoryRow& row)
{
    const QString state = plainState(row);
    const QString age = ageWord(row.age);
    if (state.isEmpty() || age.isEmpty())
        return state.isEmpty() ? age : state;
    return QStringLiteral("%1 · %2").arg(state, age);
}

QString stateHelp(const MemoryRow& row)
{
    QStringList lines{meaningOfState(row)};
    if (row.error && tellsError(row.state)) {
        const text::Description words = text::describe(withName(*row.error, row.reg));
        lines << words.what << words.cause << words.remedy;
    }
    if (row.age.seconds == 0)
        lines << translate("MemoryTable", "The value shown is of this moment.");
    else if (row.age.seconds > 0)
        lines << translate("MemoryTable", "The value shown was read %1 ago.").arg(ageWord(row.age));
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

Tone stateTone(RowState state)
{
    switch (state) {
    case RowState::Kept:
        return Tone::Good;
    case RowState::Temporary:
    case RowState::Pending:
    case RowState::Superseded:
        return Tone::Warn;
    case RowState::Unreadable:
    case RowState::Mismatch:
    case RowState::Refused:
    case RowState::NoAnswer:
    case RowState::Unknown:
    case RowState::NotSent:
    case RowState::NotWritten:
        return Tone::Bad;
    case RowState::NotRead:
    case RowState::Read:
        break;
    }
    return Tone::Quiet;
}
} // namespace ui
