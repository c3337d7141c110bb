// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_report_text.h"

#include "text/bus_text.h"
#include "text/error_text.h"
#include "text/firmware_text.h"
#include "text/translate.h"

namespace ui {
using base::FirmwareOutcome;
using text::translate;

namespace {
/// The settings that changed: "Protection time: 200 → 250".
QStringList changesOf(const FirmwareUpdate& update)
{
    QStringList lines;
    if (!update.before || !update.report.table || !update.report.servo)
        return lines;
    const device::Servo& servo = *update.report.servo;
    for (const snapshot::CompareRow& row :
         jobs::changedSettings(*update.before, *update.report.table))
        lines << QStringLiteral("%1: %2 → %3")
                     .arg(registerText(servo, row.key), valueText(servo, row.key, row.cells[0].raw),
                          valueText(servo, row.key, row.cells[1].raw));
    return lines;
}

QString savedText()
{
    return translate("ServoTasks", "The old settings are saved; the Snapshots page restores them.");
}

QString versionOf(const FirmwareUpdate& update)
{
    return update.report.servo ? update.report.servo->profile->identity.firmware() : QString();
}

/// Of one that is updated, in a list of servos.
QString lineOf(const FirmwareUpdate& update)
{
    QStringList parts{
        translate("ServoTasks", "ID %1, firmware %2").arg(update.id).arg(versionOf(update))};
    parts += update.report.table ? changesOf(update) : QStringList{text::firmwareTableUnreadText()};
    return parts.join(QStringLiteral(" · "));
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

bool isUpdated(const FirmwareUpdate& update)
{
    return !update.refusal && update.report.outcome == FirmwareOutcome::Updated;
}

TaskText firmwareReportText(const FirmwareUpdate& update)
{
    if (update.refusal)
        return errorText(*update.refusal);
    const jobs::FirmwareReport& report = update.report;
    TaskText result{toneOf(report.outcome), text::firmwareOutcomeText(report.outcome)};
    if (isUpdated(update)) {
        result.details << translate("ServoTasks", "ID %1, firmware %2")
                              .arg(report.servo ? report.servo->id : update.id)
                              .arg(versionOf(update));
        const QStringList changes = changesOf(update);
        if (!report.table)
            result.details << text::firmwareTableUnreadText();
        else if (update.before)
            result.details << text::firmwareChangesText(static_cast<int>(changes.size()))
                           << changes;
        if (!changes.isEmpty())
            result.details << savedText();
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

TaskText firmwareReportText(const std::vector<FirmwareUpdate>& updates,
                            const std::vector<int>& notStarted)
{
    TaskText result;
    QStringList lines;
    bool isAnyChanged = false;
    for (const FirmwareUpdate& update : updates) {
        if (isUpdated(update)) {
            lines << lineOf(update);
            isAnyChanged |= !changesOf(update).isEmpty();
            continue;
        }
        result = firmwareReportText(update);
        if (!update.refusal) // which names its servo
            result.message =
                translate("ServoTasks", "Servo %1: %2").arg(update.id).arg(result.message);
    }
    if (result.message.isEmpty()) {
        result.tone = notStarted.empty() ? Tone::Good : Tone::Warn;
        const int count = static_cast<int>(updates.size());
        result.message =
            translate("ServoTasks", "%n servo(s) run the new firmware.", nullptr, count);
    }
    if (!notStarted.empty())
        result.details << translate("ServoTasks", "Not updated yet: ID %1")
                              .arg(text::idRangesText(notStarted));
    result.details << lines;
    if (isAnyChanged)
        result.details << savedText();
    return result;
}
} // namespace ui
