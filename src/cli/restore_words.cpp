// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/restore_words.h"

#include "catalog/units.h"
#include "cli/arguments.h"
#include "cli/report_words.h"
#include "cli/translate.h"
#include "session/safety_snapshot.h"
#include "text/error_words.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "text/restore_words.h"

#include <algorithm>

namespace cli {
namespace {
const QString dash = QStringLiteral("–");

QString shown(const device::Servo& servo, const QString& key, std::optional<std::int64_t> raw)
{
    const catalog::Register* reg = servo.profile->find(key);
    if (!raw || reg == nullptr)
        return raw ? QString::number(*raw) : dash;
    const catalog::Meaning meaning = servo.meaning(*reg);
    const QString value = catalog::formatValue(*raw, *reg, meaning, text::inChinese());
    const QString number = QString::number(*raw);
    return value == number ? number : number + QStringLiteral(" · ") + value;
}

/// Differs, or might, and is not written: by choice or because it cannot be.
std::vector<const jobs::RestoreRow*> leftOut(const jobs::RestorePlan& plan)
{
    std::vector<const jobs::RestoreRow*> left;
    for (const jobs::RestoreRow& row : plan.rows) {
        if (row.mayTick && !row.ticked)
            left.push_back(&row);
    }
    const auto unmapped = plan.unmapped();
    left.insert(left.end(), unmapped.begin(), unmapped.end());
    return left;
}

Json::Array jsonWritesOf(const jobs::RestorePlan& plan)
{
    Json::Array writes;
    for (const jobs::RestoreWrite& write : jobs::writesOf(plan)) {
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
    for (const jobs::RestoreStep& step : jobs::stepsOf(plan)) {
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
    for (const jobs::RestoreRow* row : leftOut(plan)) {
        rows.push_back(Json::object()
                           .add("key", row->key)
                           .add("now", row->now)
                           .add("file", row->fileRaw)
                           .add("reasons", jobs::restoreReasonNames(row->reasons)));
    }
    return rows;
}

QString leftOutText(const jobs::RestorePlan& plan)
{
    const auto left = leftOut(plan);
    if (left.empty())
        return {};
    Table table({translate("cli", "Left out"), translate("cli", "Now"), translate("cli", "File"),
                 translate("cli", "Why")});
    table.right({1, 2});
    for (const jobs::RestoreRow* row : left) {
        table.add({row->key, shown(plan.servo, row->key, row->now),
                   shownNumber(row->fileRaw, row->fileValue, row->fileUnit),
                   text::restoreReasonWords(jobs::restoreReasonNames(row->reasons))});
    }
    return table.text();
}

QString originText(const jobs::RestorePlan& plan)
{
    if (plan.otherModel)
        return translate("cli", "The file is of another model: rows are matched by their key.") +
               QLatin1Char('\n');
    if (plan.otherFirmware)
        return translate("cli", "The file is of another firmware: rows are matched by their "
                                "key.") +
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
        json.add("error", base::errorName(row.write.error->code));
    return json;
}

QString rowState(const jobs::RestoreRowResult& row)
{
    const QString word = text::outcomeWord(device::outcomeName(row.write.outcome));
    return row.rolledBack ? translate("cli", "%1, put back").arg(word) : word;
}

/// The writes and the lock as one report, whose exit code everybody knows.
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

QString shownNumber(std::optional<std::int64_t> raw, std::optional<double> value,
                    const QString& unit)
{
    if (!raw)
        return dash;
    const QString number = QString::number(*raw);
    if (!value || unit.isEmpty())
        return number;
    return QStringLiteral("%1 · %2%3")
        .arg(number, QString::number(*value, 'g', 6), catalog::unitSuffix(unit));
}

std::vector<Option> restoreOptions(std::vector<Option> more)
{
    more.insert(more.end(),
                {{"--only", QT_TRANSLATE_NOOP("cli", "these registers only: KEY,KEY"), "KEYS"},
                 {"--live", QT_TRANSLATE_NOOP("cli", "also what is lost at power-off "
                                                     "(acceleration, torque limit)")},
                 {"--dangerous", QT_TRANSLATE_NOOP("cli", "yes, also registers that can make the "
                                                          "servo unreachable or turn it")},
                 {"--roll-back", QT_TRANSLATE_NOOP("cli", "at the first failure put everything "
                                                          "back; otherwise it stops there")},
                 {"--dry-run", QT_TRANSLATE_NOOP("cli", "show the writes to come, write nothing")},
                 {"--result",
                  QT_TRANSLATE_NOOP("cli", "save what became of each row (.csv or "
                                           ".json)"),
                  "FILE"}});
    return more;
}

jobs::RestoreChoice choiceOf(const Values& values)
{
    jobs::RestoreChoice choice;
    if (const auto only = values.option("--only"))
        choice.only = only->split(QLatin1Char(','), Qt::SkipEmptyParts);
    choice.identity = values.has("--identity");
    choice.dangerous = values.has("--dangerous");
    choice.live = values.has("--live");
    return choice;
}

jobs::RestoreOptions restoreOptionsOf(const Values& values)
{
    jobs::RestoreOptions options;
    options.dangerous = values.has("--dangerous");
    options.onFailure =
        values.has("--roll-back") ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    return options;
}

base::Result<void> checkOnly(const Values& values, const record::Snapshot& snapshot)
{
    const auto only = values.option("--only");
    const QStringList keys = choiceOf(values).only;
    if (only && keys.isEmpty())
        return badArgument(translate("cli", "--only names no register"));
    for (const QString& key : keys) {
        if (snapshot.find(key) != nullptr)
            continue;
        QStringList known;
        for (const record::SnapshotRegister& reg : snapshot.registers)
            known << reg.key;
        base::Error error{base::ErrorCode::UnknownRegister, QStringLiteral("restore"),
                          nearest(key, known).join(QStringLiteral(", "))};
        error.registerKey = key;
        return tl::unexpected(error);
    }
    return {};
}

void addPlan(Json& json, const jobs::RestorePlan& plan)
{
    json.add("other_model", plan.otherModel)
        .add("other_firmware", plan.otherFirmware)
        .add("writes", jsonWritesOf(plan))
        .add("steps", jsonSteps(plan))
        .add("left_out", jsonLeftOut(plan));
}

QString planText(const jobs::RestorePlan& plan)
{
    QString text = originText(plan);
    const auto writes = jobs::writesOf(plan);
    if (writes.empty())
        return text + translate("cli", "Nothing to write.") + QLatin1Char('\n') + leftOutText(plan);
    Table table({translate("cli", "Addr"), translate("cli", "Key"), translate("cli", "Now"),
                 translate("cli", "Will be")});
    table.right({0, 2, 3});
    for (const jobs::RestoreWrite& write : writes)
        table.add({QString::number(write.address), write.key,
                   shown(plan.servo, write.key, write.from),
                   shown(plan.servo, write.key, write.to)});
    return text + table.text() + leftOutText(plan);
}

QString stepsText(const jobs::RestorePlan& plan)
{
    QString text;
    int number = 0;
    for (const jobs::RestoreStep& step : jobs::stepsOf(plan)) {
        QString line = QStringLiteral("%1. %2").arg(++number).arg(
            text::restoreStepWords(jobs::restoreStepName(step.kind)));
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
}

QString outcomeText(const jobs::RestoreOutcome& outcome, const device::Servo& servo)
{
    if (outcome.verdict == jobs::RestoreVerdict::AlreadySo)
        return translate("cli", "Nothing had to be written.") + QLatin1Char('\n');
    Table table({translate("cli", "Addr"), translate("cli", "Key"), translate("cli", "Old"),
                 translate("cli", "New"), translate("cli", "Read back"),
                 translate("cli", "Outcome")});
    table.right({0, 2, 3, 4});
    QString why;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        const device::WriteResult& write = row.write;
        table.add({QString::number(write.address), write.key, shown(servo, write.key, write.oldRaw),
                   shown(servo, write.key, write.newRaw), shown(servo, write.key, write.readBack),
                   rowState(row)});
        if (write.error)
            why += text::describe(*write.error).what + QLatin1Char('\n');
    }
    return table.text() +
           translate("cli", "EPROM lock: %1").arg(text::lockWord(device::lockName(outcome.lock))) +
           QLatin1Char('\n') + why +
           translate("cli", "Result: %1")
               .arg(text::restoreVerdictWords(jobs::verdictName(outcome.verdict))) +
           QLatin1Char('\n');
}

Exit exitCode(const jobs::RestoreOutcome& outcome)
{
    const bool good = outcome.verdict == jobs::RestoreVerdict::AlreadySo ||
                      outcome.verdict == jobs::RestoreVerdict::Done;
    if (good)
        return Exit::Done;
    const Exit code = exitCode(reportOf(outcome));
    return code == Exit::Done ? Exit::NotDone : code;
}

Json jsonApplied(const jobs::Applied& applied)
{
    Json json = Json::object();
    json.add("id", applied.id).add("verdict", jobs::verdictName(applied.verdict));
    if (applied.servo && applied.servo->profile)
        json.add("model", applied.servo->profile->modelName);
    if (applied.plan.servo.profile)
        addPlan(json, applied.plan);
    if (applied.outcome) {
        Json outcome = Json::object();
        addOutcome(outcome, *applied.outcome);
        json.add("outcome", std::move(outcome));
    }
    if (applied.error)
        json.add("error", jsonError(*applied.error));
    return json;
}

QString appliedText(const std::vector<jobs::Applied>& all)
{
    Table table({translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Rows"),
                 translate("cli", "Result"), translate("cli", "Remark")});
    table.right({0, 2});
    for (const jobs::Applied& one : all) {
        QString remark = one.error ? text::describe(*one.error).what : QString();
        if (remark.isEmpty() && one.plan.servo.profile) {
            const auto left = leftOut(one.plan);
            if (!left.empty())
                remark = translate("cli", "rows left out: %1").arg(left.size());
        }
        const bool known = one.servo && one.servo->profile;
        table.add({QString::number(one.id), known ? one.servo->profile->modelName : dash,
                   one.plan.servo.profile ? QString::number(jobs::writesOf(one.plan).size()) : dash,
                   text::restoreVerdictWords(jobs::verdictName(one.verdict)), remark});
    }
    QString text = table.text();
    for (const jobs::Applied& one : all) {
        const bool bad = one.outcome && exitCode(*one.outcome) != Exit::Done;
        if (bad)
            text += translate("cli", "Servo %1").arg(one.id) + QLatin1Char('\n') +
                    outcomeText(*one.outcome, *one.servo);
    }
    return text;
}

Exit exitCode(const std::vector<jobs::Applied>& all)
{
    using jobs::ApplyVerdict;
    const auto every = [&](auto&& fits) { return std::all_of(all.begin(), all.end(), fits); };
    if (every([](const jobs::Applied& one) {
            return one.verdict == ApplyVerdict::AlreadySo || one.verdict == ApplyVerdict::Done ||
                   one.verdict == ApplyVerdict::Planned;
        }))
        return Exit::Done;
    const auto lost = std::find_if(all.begin(), all.end(), [](const jobs::Applied& one) {
        return one.error && exitCode(one.error->code) == Exit::Port;
    });
    if (lost != all.end())
        return Exit::Port;
    if (every([](const jobs::Applied& one) { return one.verdict == ApplyVerdict::NoAnswer; }))
        return Exit::NoAnswer;
    return Exit::NotDone;
}

std::vector<record::RestoreResult> resultsOf(const std::vector<jobs::Applied>& all,
                                             const QString& source)
{
    std::vector<record::RestoreResult> results;
    for (const jobs::Applied& one : all) {
        record::RestoreResult result;
        if (one.outcome && one.servo)
            result = jobs::resultOf(*one.outcome, *one.servo, source, session::programName());
        result.program = session::programName();
        result.at = QDateTime::currentDateTimeUtc();
        result.source = source;
        if (result.servo.id < 0)
            result.servo.id = one.id;
        result.verdict = jobs::verdictName(one.verdict);
        results.push_back(std::move(result));
    }
    return results;
}
} // namespace cli
