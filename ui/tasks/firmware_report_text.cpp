// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_report_text.h"

#include "text/error_text.h"
#include "text/firmware_text.h"
#include "text/translate.h"

namespace ui {
using base::FirmwareOutcome;
using text::translate;

namespace {
QStringList changedLines(const jobs::FirmwareReport& report, const snapshot::Snapshot& before)
{
    const auto changed = jobs::changedSettings(before, *report.table);
    QStringList lines{text::firmwareChangesText(static_cast<int>(changed.size()))};
    if (changed.empty())
        return lines;
    for (const snapshot::CompareRow& row : changed)
        lines << QStringLiteral("%1: %2 → %3")
                     .arg(registerText(*report.servo, row.key),
                          valueText(*report.servo, row.key, row.cells[0].raw),
                          valueText(*report.servo, row.key, row.cells[1].raw));
    lines << translate("ServoTasks", "The old settings are saved; the Snapshots page restores "
                                     "them.");
    return lines;
}

Tone toneOf(FirmwareOutcome outcome)
{
    switch (outcome) {
    case FirmwareOutcome::Updated:
        return Tone::Good;
    case FirmwareOutcome::Unchanged:
        return Tone::Warn;
    case FirmwareOutcome::Incomplete:
    case FirmwareOutcome::Unknown:
        break;
    }
    return Tone::Bad;
}
} // namespace

TaskText firmwareReportText(const jobs::FirmwareReport& report,
                            const std::optional<snapshot::Snapshot>& before)
{
    TaskText result{toneOf(report.outcome), text::firmwareOutcomeText(report.outcome)};
    if (report.outcome == FirmwareOutcome::Updated && report.servo) {
        result.details << translate("ServoTasks", "ID %1, firmware %2")
                              .arg(report.servo->id)
                              .arg(report.servo->profile->identity.firmware());
        if (!report.table)
            result.details << text::firmwareTableUnreadText();
        else if (before)
            result.details += changedLines(report, *before);
        return result;
    }
    result.details << translate("ServoTasks", "%1 of %2 blocks were accepted.")
                          .arg(report.acceptedBlocks)
                          .arg(report.blocks);
    if (report.error)
        result.details << text::describe(*report.error).message;
    result.details << text::firmwareOutcomeRemedy(report.outcome);
    return result;
}
} // namespace ui
