// SPDX-License-Identifier: GPL-3.0-or-later
// The results of several servos: one line each, then the rows that failed or were not written.
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/error_text.h"
#include "text/restore_text.h"

#include <algorithm>

namespace cli {
Json jsonApplied(const jobs::ApplyResult& applied)
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

QString appliedText(const std::vector<jobs::ApplyResult>& all)
{
    Table table({translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Rows"),
                 translate("cli", "Result"), translate("cli", "Note")});
    table.alignRight({0, 2});
    for (const jobs::ApplyResult& one : all) {
        QString remark = one.error ? text::describe(*one.error).message : QString();
        if (remark.isEmpty() && one.plan.servo.profile) {
            const auto left = jobs::omittedRows(one.plan);
            if (!left.empty())
                remark = translate("cli", "%n row(s) skipped", nullptr, int(left.size()));
        }
        const bool known = one.servo && one.servo->profile;
        table.add({QString::number(one.id), known ? one.servo->profile->modelName : noValue(),
                   one.plan.servo.profile ? QString::number(jobs::plannedWrites(one.plan).size())
                                          : noValue(),
                   text::restoreVerdictText(jobs::verdictName(one.verdict)), remark});
    }
    QString text = table.text();
    for (const jobs::ApplyResult& one : all) {
        QString more;
        if (one.outcome && !isSuccess(*one.outcome))
            more += outcomeText(*one.outcome, *one.servo);
        if (one.plan.servo.profile)
            more += leftOutText(one.plan) + alarmsText(one.plan);
        if (!more.isEmpty())
            text += translate("cli", "Servo %1").arg(one.id) + QLatin1Char('\n') + more;
    }
    return text;
}

Exit exitCode(const std::vector<jobs::ApplyResult>& all)
{
    using jobs::ApplyVerdict;
    const auto every = [&](auto&& fits) { return std::all_of(all.begin(), all.end(), fits); };
    if (every([](const jobs::ApplyResult& one) {
            return one.verdict == ApplyVerdict::AlreadySet || one.verdict == ApplyVerdict::Done ||
                   one.verdict == ApplyVerdict::Planned;
        })) {
        const bool misses = std::any_of(all.begin(), all.end(), [](const jobs::ApplyResult& one) {
            return one.outcome && hasUnwrittenRequest(one.plan); // a dry run is complete
        });
        return misses ? Exit::Failed : Exit::Success;
    }
    const auto lost = std::find_if(all.begin(), all.end(), [](const jobs::ApplyResult& one) {
        return one.error && exitCode(one.error->code) == Exit::Port;
    });
    if (lost != all.end())
        return Exit::Port;
    if (every([](const jobs::ApplyResult& one) { return one.verdict == ApplyVerdict::NoReply; }))
        return Exit::NoReply;
    return Exit::Failed;
}

std::vector<snapshot::RestoreResult> resultsOf(const std::vector<jobs::ApplyResult>& all,
                                               const QString& source)
{
    std::vector<snapshot::RestoreResult> results;
    for (const jobs::ApplyResult& one : all) {
        snapshot::RestoreResult result;
        if (one.outcome && one.servo)
            result =
                jobs::toRestoreResult(*one.outcome, *one.servo, source, session::programName());
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
