// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/restore_text.h"

#include "catalog/units.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/restore_text.h"

#include <algorithm>

namespace cli {
namespace {
QString shown(const device::Servo& servo, const QString& key, std::optional<std::int64_t> raw)
{
    const catalog::Register* reg = servo.profile->find(key);
    if (!raw || reg == nullptr)
        return raw ? QString::number(*raw) : noValue();
    const catalog::ValueFormat meaning = servo.meaning(*reg);
    const QString value = catalog::formatValue(*raw, *reg, meaning, text::isUiChinese());
    const QString number = QString::number(*raw);
    return value == number ? number : number + QStringLiteral(" · ") + value;
}

/// The rows that are not selected, have no counterpart, or are omitted (jobs::omittedRows()).
std::vector<const jobs::RestoreRow*> notWritten(const jobs::RestorePlan& plan)
{
    std::vector<const jobs::RestoreRow*> rows;
    const auto take = [&rows](const jobs::RestoreRow* row) {
        if (std::find(rows.begin(), rows.end(), row) == rows.end())
            rows.push_back(row);
    };
    for (const jobs::RestoreRow& row : plan.rows) {
        if (row.isSelectable && !row.selected)
            take(&row);
    }
    for (const auto& more : {plan.unmappedRows(), jobs::omittedRows(plan)})
        std::for_each(more.begin(), more.end(), take);
    return rows;
}

Json::Array jsonWritesOf(const jobs::RestorePlan& plan)
{
    Json::Array writes;
    for (const jobs::RestoreWrite& write : jobs::plannedWrites(plan)) {
        writes.push_back(Json::object()
                             .add("key", write.key)
                             .add("address", write.address)
                             .add("old", write.from)
                             .add("new", write.to));
    }
    return writes;
}

Json::Array jsonSteps(const jobs::RestorePlan& plan)
{
    Json::Array steps;
    for (const jobs::RestoreStep& step : jobs::plannedSteps(plan)) {
        steps.push_back(Json::object()
                            .add("step", jobs::restoreStepName(step.kind))
                            .add("key", step.key)
                            .add("from", step.from)
                            .add("to", step.to));
    }
    return steps;
}

Json::Array jsonLeftOut(const jobs::RestorePlan& plan)
{
    Json::Array rows;
    for (const jobs::RestoreRow* row : notWritten(plan)) {
        rows.push_back(Json::object()
                           .add("key", row->key)
                           .add("now", row->now)
                           .add("file", row->fileRaw)
                           .add("asked", row->isRequested)
                           .add("reasons", jobs::restoreReasonNames(row->reasons)));
    }
    return rows;
}

QString notWrittenTable(const jobs::RestorePlan& plan)
{
    const auto left = notWritten(plan);
    if (left.empty())
        return {};
    Table table({translate("cli", "Skipped"), translate("cli", "Present"), translate("cli", "File"),
                 translate("cli", "Reason")});
    table.alignRight({1, 2});
    for (const jobs::RestoreRow* row : left) {
        table.add({row->key, shown(plan.servo, row->key, row->now),
                   formatNumber(row->fileRaw, row->fileValue, row->fileUnit),
                   text::restoreReasonText(jobs::restoreReasonNames(row->reasons))});
    }
    return table.text();
}

Json::Array jsonAlarms(const jobs::RestorePlan& plan)
{
    Json::Array rows;
    for (const jobs::RestoreRow* row : jobs::predictedAlarms(plan)) {
        rows.push_back(Json::object()
                           .add("key", row->key)
                           .add("alarm", row->alarm)
                           .add("reading", row->reading)
                           .add("unit", row->readingUnit)
                           .add("selected", row->selected));
    }
    return rows;
}

QString originText(const jobs::RestorePlan& plan)
{
    if (plan.otherModel) {
        QString text =
            translate("cli", "The file is from a different model: registers are matched by name.") +
            QLatin1Char('\n');
        if (plan.count(jobs::RestoreReason::OtherModelLimit) > 0)
            text +=
                translate("cli", "Voltage, temperature, current and torque limits are not restored "
                                 "by default; to write one, specify --only KEY --dangerous.") +
                QLatin1Char('\n');
        return text;
    }
    if (plan.otherFirmware)
        return translate("cli", "The file is from a different firmware version: registers are "
                                "matched by name.") +
               QLatin1Char('\n');
    return {};
}

Json jsonRow(const jobs::RestoreRowResult& row)
{
    Json json = Json::object()
                    .add("key", row.write.key)
                    .add("address", row.write.address)
                    .add("old", row.write.oldRaw)
                    .add("new", row.write.newRaw)
                    .add("read_back", row.write.readBack)
                    .add("outcome", device::outcomeName(row.write.outcome));
    if (row.rolledBack)
        json.add("rolled_back", true);
    if (row.write.error)
        json.add("error", jsonError(*row.write.error));
    return json;
}

QString rowState(const jobs::RestoreRowResult& row)
{
    const QString word = text::outcomeLabel(device::outcomeName(row.write.outcome));
    return row.rolledBack ? translate("cli", "%1, old value restored").arg(word) : word;
}

/// Writes and lock as one report, for its exit code.
device::WriteReport reportOf(const jobs::RestoreOutcome& outcome)
{
    device::WriteReport report;
    report.id = outcome.newId;
    report.lock = outcome.lock;
    for (const jobs::RestoreRowResult& row : outcome.rows)
        report.writes.push_back(row.write);
    return report;
}
} // namespace

QString formatNumber(std::optional<std::int64_t> raw, std::optional<double> value,
                     const QString& unit)
{
    if (!raw)
        return noValue();
    const QString number = QString::number(*raw);
    if (!value || unit.isEmpty())
        return number;
    return QStringLiteral("%1 · %2%3")
        .arg(number, QString::number(*value, 'g', 6), catalog::unitSuffix(unit));
}

std::vector<Option> restoreOptions(std::vector<Option> more)
{
    more.insert(
        more.end(),
        {{"--only", QT_TRANSLATE_NOOP("cli", "only these registers: KEY,KEY"), "KEYS"},
         {"--live", QT_TRANSLATE_NOOP("cli", "include values that are lost at power-off "
                                             "(acceleration, torque limit)")},
         {"--dangerous",
          QT_TRANSLATE_NOOP(
              "cli", "allow writing registers that can move the servo or make it unreachable")},
         {"--roll-back",
          QT_TRANSLATE_NOOP(
              "cli", "undo all writes at the first failure (default: stop without undoing)")},
         dryRunOption,
         {"--result", QT_TRANSLATE_NOOP("cli", "save the result of each row (.csv or .json)"),
          "FILE"}});
    return more;
}

jobs::RestoreChoice choiceOf(const Values& values)
{
    jobs::RestoreChoice choice;
    if (const auto only = values.option("--only"))
        choice.only = only->split(QLatin1Char(','), Qt::SkipEmptyParts);
    choice.identity = values.has("--identity");
    choice.consent = device::Consent::byOption(values.has("--dangerous"));
    choice.live = values.has("--live");
    if (choice.consent)
        choice.otherModelLimits = choice.only;
    return choice;
}

jobs::RestoreOptions restoreOptionsOf(const Values& values)
{
    jobs::RestoreOptions options;
    options.consent = device::Consent::byOption(values.has("--dangerous"));
    options.onFailure =
        values.has("--roll-back") ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    return options;
}

base::Result<snapshot::Snapshot> loadToRestore(const Values& values, const QString& file)
{
    auto loaded = snapshot::loadSnapshot(file);
    if (!loaded)
        return loaded;
    const auto only = values.option("--only");
    const QStringList keys = choiceOf(values).only;
    if (only && keys.isEmpty())
        return badArgument(translate("cli", "--only requires at least one register"));
    for (const QString& key : keys) {
        if (loaded->find(key) != nullptr)
            continue;
        QStringList known;
        for (const snapshot::SnapshotRegister& reg : loaded->registers)
            known << reg.key;
        base::Error error{base::ErrorCode::UnknownRegister, QStringLiteral("restore"),
                          text::joinItems(nearest(key, known))};
        error.registerKey = key;
        return tl::unexpected(error);
    }
    return loaded;
}

void addPlan(Json& json, const jobs::RestorePlan& plan)
{
    json.add("other_model", plan.otherModel)
        .add("other_firmware", plan.otherFirmware)
        .add("writes", jsonWritesOf(plan))
        .add("steps", jsonSteps(plan))
        .add("left_out", jsonLeftOut(plan))
        .add("alarms", jsonAlarms(plan));
}

QString alarmsText(const jobs::RestorePlan& plan)
{
    QString text;
    for (const jobs::RestoreRow* row : jobs::predictedAlarms(plan)) {
        const catalog::Register& reg = *plan.servo.profile->find(row->key);
        const QString limit =
            catalog::formatValue(*row->newRaw, reg, plan.servo.meaning(reg), text::isUiChinese());
        const QString reading =
            QString::number(row->reading, 'g', 4) + catalog::unitSuffix(row->readingUnit);
        const QString line = text::restoreAlarmText(row->alarm, limit, reading);
        text += (row->selected ? translate("cli", "! %1: %2").arg(row->key, line)
                               : translate("cli", "! %1, not selected: %2").arg(row->key, line)) +
                QLatin1Char('\n');
    }
    return text;
}

QString planText(const jobs::RestorePlan& plan)
{
    QString text = originText(plan);
    const auto writes = jobs::plannedWrites(plan);
    if (writes.empty())
        return text + translate("cli", "Nothing to write.") + QLatin1Char('\n') +
               notWrittenTable(plan) + alarmsText(plan);
    Table table({translate("cli", "Address"), translate("cli", "Key"), translate("cli", "Present"),
                 translate("cli", "New value")});
    table.alignRight({0, 2, 3});
    for (const jobs::RestoreWrite& write : writes)
        table.add({QString::number(write.address), write.key,
                   shown(plan.servo, write.key, write.from),
                   shown(plan.servo, write.key, write.to)});
    return text + table.text() + notWrittenTable(plan) + alarmsText(plan);
}

QString leftOutText(const jobs::RestorePlan& plan)
{
    QStringList rows;
    for (const jobs::RestoreRow* row : jobs::omittedRows(plan)) {
        const QString why = text::restoreReasonText(jobs::restoreReasonNames(row->reasons));
        rows << (why.isEmpty() ? row->key : QStringLiteral("%1 (%2)").arg(row->key, why));
    }
    if (rows.isEmpty())
        return {};
    const QString all = text::joinItems(rows);
    return translate("cli", "%n row(s) skipped: %1", nullptr, int(rows.size())).arg(all) +
           QLatin1Char('\n');
}

QString stepsText(const jobs::RestorePlan& plan)
{
    QString text;
    int number = 0;
    for (const jobs::RestoreStep& step : jobs::plannedSteps(plan)) {
        QString line = QStringLiteral("%1. %2").arg(++number).arg(
            text::restoreStepText(jobs::restoreStepName(step.kind)));
        if (step.kind != jobs::RestoreStepKind::TorqueOff && step.to)
            line += QStringLiteral(": %1 %2 → %3")
                        .arg(step.key, shown(plan.servo, step.key, step.from),
                             shown(plan.servo, step.key, step.to));
        text += line + QLatin1Char('\n');
    }
    return text;
}

void addOutcome(Json& json, const jobs::RestoreOutcome& outcome)
{
    Json::Array rows;
    for (const jobs::RestoreRowResult& row : outcome.rows)
        rows.push_back(jsonRow(row));
    json.add("verdict", jobs::verdictName(outcome.verdict))
        .add("results", std::move(rows))
        .add("lock", device::lockName(outcome.lock))
        .add("torque_switched_off", outcome.torqueSwitchedOff)
        .add("new_id", outcome.newId)
        .add("new_baud", outcome.newBaud);
    if (!outcome.notReverted.isEmpty())
        json.add("not_put_back", outcome.notReverted);
}

namespace {
QString notPutBackText(const jobs::RestoreOutcome& outcome)
{
    if (outcome.notReverted.isEmpty())
        return {};
    const QString keys = text::joinItems(outcome.notReverted);
    const QString next =
        outcome.isChangeOpen
            ? translate("cli", "The change is still unfinished. To see it: servodesk-cli recover")
            : translate("cli", "The table shows the values now in the servo. The snapshot taken "
                               "before the first write contains the old values.");
    return text::joinSentences({translate("cli", "Could not be restored: %1.").arg(keys), next}) +
           QLatin1Char('\n');
}
} // namespace

QString outcomeText(const jobs::RestoreOutcome& outcome, const device::Servo& servo)
{
    if (outcome.verdict == jobs::RestoreVerdict::AlreadySet)
        return translate("cli", "No changes were necessary.") + QLatin1Char('\n');
    Table table({translate("cli", "Address"), translate("cli", "Key"), translate("cli", "Old"),
                 translate("cli", "New"), translate("cli", "Read back"),
                 translate("cli", "Result")});
    table.alignRight({0, 2, 3, 4});
    QString why;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        const device::WriteResult& write = row.write;
        table.add({QString::number(write.address), write.key, shown(servo, write.key, write.oldRaw),
                   shown(servo, write.key, write.newRaw), shown(servo, write.key, write.readBack),
                   rowState(row)});
        if (write.error)
            why += text::describe(*write.error).message + QLatin1Char('\n');
    }
    return table.text() +
           translate("cli", "EPROM lock: %1").arg(text::lockLabel(device::lockName(outcome.lock))) +
           QLatin1Char('\n') + why +
           translate("cli", "Result: %1")
               .arg(text::restoreVerdictText(jobs::verdictName(outcome.verdict))) +
           QLatin1Char('\n') + notPutBackText(outcome);
}

bool isSuccess(const jobs::RestoreOutcome& outcome)
{
    return outcome.verdict == jobs::RestoreVerdict::AlreadySet ||
           outcome.verdict == jobs::RestoreVerdict::Done;
}

bool hasUnwrittenRequest(const jobs::RestorePlan& plan)
{
    const auto left = jobs::omittedRows(plan);
    return std::any_of(left.begin(), left.end(),
                       [](const jobs::RestoreRow* row) { return row->isRequested; });
}

Exit exitCode(const jobs::RestoreOutcome& outcome, const jobs::RestorePlan& plan)
{
    if (isSuccess(outcome))
        return hasUnwrittenRequest(plan) ? Exit::Failed : Exit::Success;
    const Exit code = exitCode(reportOf(outcome));
    return code == Exit::Success ? Exit::Failed : code;
}

} // namespace cli
