// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_text.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/common/theme.h"
#include "ui/memory/memory_text.h"

namespace ui {
using text::translate;
namespace {
QString outcome(device::WriteOutcome outcome)
{
    return text::outcomeLabel(device::outcomeName(outcome));
}

/// Sign and word, without the age.
QString stateName(const MemoryRow& row)
{
    using device::WriteOutcome;
    switch (row.state) {
    case RowState::NotRead:
        return translate("MemoryTable", "not read");
    case RowState::Read:
        return {};
    case RowState::Unreadable:
        return QStringLiteral("✗ ") + translate("MemoryTable", "could not be read");
    case RowState::Pending:
        return QStringLiteral("… ") + translate("MemoryTable", "pending: %1").arg(row.requestedRaw);
    case RowState::Kept:
        return QStringLiteral("✓ ") + outcome(WriteOutcome::Kept);
    case RowState::Temporary:
        return QStringLiteral("◷ ") + outcome(WriteOutcome::Temporary);
    case RowState::Mismatch:
        return QStringLiteral("≠ ") + outcome(WriteOutcome::Mismatch);
    case RowState::Refused:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::Refused);
    case RowState::NoReply:
        // The value beside it may have been read since.
        return QStringLiteral("✗ ") + translate("MemoryTable", "write: no reply");
    case RowState::Unknown:
        return QStringLiteral("? ") + outcome(WriteOutcome::Unknown);
    case RowState::NotSent:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::NotSent);
    case RowState::NotWritten:
        return QStringLiteral("✗ ") + outcome(WriteOutcome::Refused);
    case RowState::Superseded:
        return QStringLiteral("≠ ") + translate("MemoryTable", "changed since the write");
    }
    return {};
}

QString stateDescription(const MemoryRow& row)
{
    switch (row.state) {
    case RowState::NotRead:
        return translate("MemoryTable", "This register has not been read yet. Choose Read all.");
    case RowState::Read:
        return translate("MemoryTable", "The value was read from the servo.");
    case RowState::Unreadable:
        return translate("MemoryTable", "The last read failed, so no value is shown.");
    case RowState::Pending:
        return translate("MemoryTable", "%1 is being written.").arg(row.requestedRaw);
    case RowState::Kept:
        return translate("MemoryTable", "%1 was written and read back; it is kept after "
                                        "power-off.")
            .arg(row.requestedRaw);
    case RowState::Temporary:
        return translate("MemoryTable", "%1 was written and read back; it is lost at power-off.")
            .arg(row.requestedRaw);
    case RowState::Mismatch:
        return translate("MemoryTable", "%1 was written, but the servo reports a different value.")
            .arg(row.requestedRaw);
    case RowState::Refused:
        return translate("MemoryTable", "The servo did not accept %1.").arg(row.requestedRaw);
    case RowState::NoReply:
        return translate("MemoryTable", "No reply while writing %1.").arg(row.requestedRaw);
    case RowState::Unknown:
        return translate("MemoryTable",
                         "The result of writing %1 is unknown. Read the register again.")
            .arg(row.requestedRaw);
    case RowState::NotSent:
    case RowState::NotWritten:
        return translate("MemoryTable", "%1 was not written. The servo was not changed.")
            .arg(row.requestedRaw);
    case RowState::Superseded:
        return translate(
                   "MemoryTable",
                   "%1 was written, but the servo has since reported a different value. Either a "
                   "temporary value was lost at power-off, or another program wrote to the servo.")
            .arg(row.requestedRaw);
    }
    return {};
}

bool showsError(RowState state)
{
    return state == RowState::Mismatch || state == RowState::Refused ||
           state == RowState::NoReply || state == RowState::Unknown ||
           state == RowState::NotWritten || state == RowState::NotSent;
}
} // namespace

QString ageText(RowAge age)
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

QString stateText(const MemoryRow& row)
{
    const QString state = stateName(row);
    const QString age = ageText(row.age);
    if (state.isEmpty() || age.isEmpty())
        return state.isEmpty() ? age : state;
    return QStringLiteral("%1 · %2").arg(state, age);
}

QString stateHelp(const MemoryRow& row)
{
    QStringList lines{stateDescription(row)};
    if (row.error && showsError(row.state)) {
        const text::Description description = text::describe(withName(*row.error, row.reg));
        lines << description.message << description.cause << description.remedy;
    }
    if (row.age.seconds == 0)
        lines << translate("MemoryTable", "The value shown was read just now.");
    else if (row.age.seconds > 0)
        lines << translate("MemoryTable", "The value shown was read %1 ago.").arg(ageText(row.age));
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
    case RowState::NoReply:
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
