// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/commission_report.h"

#include "report/bilingual.h"
#include "report/commission_text.h"
#include "report/report_file.h"
#include "report/sweep_text.h"

#include <algorithm>

namespace report {
using results::CommissionBatch;
using results::CommissionRow;
using results::CommissionVerdict;

namespace {
QString verdictClass(CommissionVerdict verdict)
{
    switch (verdict) {
    case CommissionVerdict::Good:
        return QStringLiteral("pass");
    case CommissionVerdict::Remark:
        return QStringLiteral("warn");
    case CommissionVerdict::Failed:
        return QStringLiteral("fail");
    case CommissionVerdict::Skipped:
        break;
    }
    return QStringLiteral("none");
}

QString verdictCell(const HtmlWriter& htmlWriter, CommissionVerdict verdict)
{
    return QStringLiteral("<span class=\"verdict %1\">%2 %3</span>")
        .arg(verdictClass(verdict), commissionVerdictSign(verdict),
             htmlWriter.htmlText(commissionVerdictText(verdict)));
}

/// "11 · 500 k"
QString location(int id, int baud)
{
    if (id < 0)
        return QStringLiteral("–");
    return baud > 0 ? QStringLiteral("%1 · %2").arg(id).arg(results::rateLabel(baud))
                    : QString::number(id);
}

QString reading(std::optional<double> value, const char* unit)
{
    return value ? figure(*value) + QString::fromUtf8(unit) : QStringLiteral("–");
}

QString servosTable(const HtmlWriter& htmlWriter, const CommissionBatch& batch)
{
    const SweepTexts& words = sweepTexts();
    std::vector<QStringList> rows;
    for (const CommissionRow& row : batch.rows) {
        const QString settings =
            row.templateName.isEmpty() ? QStringLiteral("–") : QString::number(row.written);
        rows.push_back({QString::number(rows.size() + 1), verdictCell(htmlWriter, row.verdict),
                        userText(row.label), escaped(row.servo.model), escaped(row.servo.firmware),
                        location(row.servo.id, row.oldBaud), location(row.newId, row.newBaud),
                        settings, reading(row.volts, " V"), reading(row.celsius, " °C"),
                        htmlWriter.htmlText(commissionIssuesText(row.issues))});
    }
    return table({QStringLiteral("#"), htmlWriter.htmlText(words.verdict),
                  htmlWriter.htmlText(words.label), htmlWriter.htmlText(words.model),
                  htmlWriter.htmlText(words.firmware),
                  htmlWriter.htmlText(translate("CommissionText", "Before")),
                  htmlWriter.htmlText(translate("CommissionText", "Now")),
                  htmlWriter.htmlText(translate("CommissionText", "Settings written")),
                  htmlWriter.htmlText(translate("CommissionText", "Voltage")),
                  htmlWriter.htmlText(translate("CommissionText", "Temperature")),
                  htmlWriter.htmlText(words.remarks)},
                 rows, true);
}

QString unfinishedTable(const HtmlWriter& htmlWriter, const CommissionBatch& batch)
{
    const SweepTexts& words = sweepTexts();
    if (batch.pending.empty())
        return {};
    std::vector<QStringList> rows;
    for (const results::PendingCommission& one : batch.pending)
        rows.push_back({escaped(one.servo.model), location(one.servo.id, one.oldBaud),
                        location(one.newId, one.newBaud),
                        htmlWriter.htmlText(commissionIssuesText(results::unfinishedIssues(one)))});
    return htmlWriter.heading(2, translate("CommissionText", "Unfinished servos")) +
           table({htmlWriter.htmlText(words.model),
                  htmlWriter.htmlText(translate("CommissionText", "Before")),
                  htmlWriter.htmlText(translate("CommissionText", "Planned")),
                  htmlWriter.htmlText(words.remarks)},
                 rows);
}

/// Not to be taken for a batch that has left the bench.
QString simulatedNote(const HtmlWriter& htmlWriter, const CommissionBatch& batch)
{
    const auto isSimulated = [](const auto& servo) { return servo.simulated; };
    const auto count = std::count_if(batch.rows.begin(), batch.rows.end(), isSimulated) +
                       std::count_if(batch.pending.begin(), batch.pending.end(), isSimulated);
    if (count == 0)
        return {};
    const bool all = count == std::ssize(batch.rows) + std::ssize(batch.pending);
    return QStringLiteral("<p class=\"simulated\">%1</p>\n")
        .arg(htmlWriter.htmlText(
            all ? translate("CommissionText", "SIMULATED: not real servos")
                : translate("CommissionText", "Some of these servos were SIMULATED")));
}

/// What there is none of is left out, except what is done.
QString summary(const HtmlWriter& htmlWriter, const CommissionBatch& batch, const QString& name)
{
    const SweepTexts& words = sweepTexts();
    std::vector<QStringList> left{
        {htmlWriter.htmlText(translate("CommissionText", "Batch")), userText(name)}};
    if (!batch.rows.empty()) {
        left.push_back({htmlWriter.htmlText(translate("CommissionText", "First servo")),
                        localTime(batch.rows.front().at)});
        left.push_back({htmlWriter.htmlText(translate("CommissionText", "Last servo")),
                        localTime(batch.rows.back().at)});
    }
    left.push_back({htmlWriter.htmlText(words.program), escaped(batch.program)});
    std::vector<QStringList> right{
        {htmlWriter.htmlText(translate("CommissionText", "Done")), QString::number(batch.done())}};
    const auto add = [&](const Text& what, int count) {
        if (count > 0)
            right.push_back({htmlWriter.htmlText(what), QString::number(count)});
    };
    add(translate("CommissionText", "With remarks"), batch.count(CommissionVerdict::Remark));
    add(commissionVerdictText(CommissionVerdict::Failed), batch.count(CommissionVerdict::Failed));
    add(commissionVerdictText(CommissionVerdict::Skipped), batch.count(CommissionVerdict::Skipped));
    add(translate("CommissionText", "Unfinished"), int(batch.pending.size()));
    return sideBySide(htmlWriter, keyValueTable(left), keyValueTable(right));
}
} // namespace

base::Result<void> saveCommissionReport(const CommissionBatch& batch, const QString& name,
                                        bool chinese, const QString& path)
{
    const Text title = translate("CommissionText", "Commissioning report");
    const QDateTime at = batch.rows.empty() ? QDateTime::currentDateTime() : batch.rows.back().at;
    return saveReport(
        {title, batch.program, at},
        [&](const HtmlWriter& htmlWriter, const EmbedChart&) {
            return htmlWriter.heading(1, title) + simulatedNote(htmlWriter, batch) +
                   summary(htmlWriter, batch, name) + servosTable(htmlWriter, batch) +
                   unfinishedTable(htmlWriter, batch);
        },
        chinese, path);
}
} // namespace report
