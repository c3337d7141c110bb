// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/commission_batch.h"

#include "base/enum_names.h"
#include "files/csv_text.h"
#include "files/text_file.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace results {
namespace {
constexpr base::EnumName<CommissionVerdict> commissionVerdictNames[]{
    {CommissionVerdict::Good, "good"},
    {CommissionVerdict::Remark, "remark"},
    {CommissionVerdict::Failed, "failed"},
    {CommissionVerdict::Skipped, "set-aside"},
};

QString known(int number, int none)
{
    return number == none ? QString() : QString::number(number);
}

QString numberOrEmpty(std::optional<double> value)
{
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

QString issuesCell(const std::vector<CommissionIssue>& issues)
{
    QStringList words;
    for (const CommissionIssue& issue : issues)
        words.append(issue.detail.isEmpty()
                         ? issue.word
                         : QStringLiteral("%1 (%2)").arg(issue.word, issue.detail));
    return words.join(QStringLiteral("; "));
}

QString timeText(const QDateTime& at)
{
    return at.toUTC().toString(Qt::ISODate);
}
} // namespace

QString verdictName(CommissionVerdict verdict)
{
    return base::nameOf(commissionVerdictNames, verdict);
}

std::optional<CommissionVerdict> commissionVerdictFromName(const QString& name)
{
    return base::valueOf(commissionVerdictNames, name);
}

bool CommissionBatch::isIdTaken(int id) const
{
    return std::any_of(rows.begin(), rows.end(),
                       [id](const CommissionRow& row) { return row.newId == id; }) ||
           std::any_of(pending.begin(), pending.end(), [id](const PendingCommission& one) {
               return one.isIdSent && one.newId == id;
           });
}

int CommissionBatch::count(CommissionVerdict verdict) const
{
    return int(std::count_if(rows.begin(), rows.end(), [verdict](const CommissionRow& row) {
        return row.verdict == verdict;
    }));
}

int CommissionBatch::done() const
{
    return count(CommissionVerdict::Good) + count(CommissionVerdict::Remark);
}

std::vector<CommissionIssue> unfinishedIssues(const PendingCommission& pending)
{
    std::vector<CommissionIssue> issues;
    if (pending.isIdConfirmed)
        issues.push_back({QStringLiteral("unfinished-id"), QString::number(pending.newId)});
    else if (pending.isIdSent && pending.newId != pending.servo.id)
        issues.push_back({QStringLiteral("unfinished-ids"),
                          QStringLiteral("%1, %2").arg(pending.servo.id).arg(pending.newId)});
    if (pending.lockOpen)
        issues.push_back({QStringLiteral("unfinished-lock")});
    return issues;
}

QByteArray encodeCommissionCsv(const CommissionBatch& batch)
{
    QByteArray text = files::csvStart(files::CsvReader::Spreadsheet);
    text += "time,verdict,troubles,model,firmware,was_id,was_baud,id,baud,template,"
            "written,centred,volts,celsius,label,snapshot,simulated\n";
    for (const CommissionRow& row : batch.rows)
        text += files::csvLine(
            {timeText(row.at), verdictName(row.verdict), issuesCell(row.issues), row.servo.model,
             row.servo.firmware, QString::number(row.servo.id), known(row.oldBaud, 0),
             known(row.newId, -1), known(row.newBaud, 0), row.templateName,
             QString::number(row.written), row.centered ? QStringLiteral("1") : QStringLiteral("0"),
             numberOrEmpty(row.volts), numberOrEmpty(row.celsius), row.label, row.snapshot,
             row.simulated ? QStringLiteral("1") : QStringLiteral("0")});
    return text;
}

QString commissionStatePath(const QString& csvPath)
{
    const bool csv = csvPath.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    return (csv ? csvPath.chopped(4) : csvPath) + QStringLiteral(".commission.json");
}

base::Result<CommissionBatch> openCommissionBatch(const QString& csvPath)
{
    constexpr qint64 maxFileSize = 64 * 1024 * 1024;
    const QString operation = QStringLiteral("load-batch");
    const QString path = commissionStatePath(csvPath);
    if (!QFileInfo::exists(path)) {
        if (QFileInfo(csvPath).size() > 0)
            return base::fail(
                base::ErrorCode::BadArgument, operation,
                QStringLiteral("%1 is there without %2").arg(csvPath, QFileInfo(path).fileName()));
        return CommissionBatch();
    }
    const auto text = files::readTextFile(operation, path, maxFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto batch = decodeCommissionBatch(*text);
    if (!batch)
        batch.error().detail = path + QStringLiteral(": ") + batch.error().detail;
    return batch;
}

base::Result<void> saveCommissionBatch(const CommissionBatch& batch, const QString& csvPath)
{
    const QString operation = QStringLiteral("save-batch");
    return files::saveTextFile(operation, encodeCommissionBatch(batch),
                               commissionStatePath(csvPath))
        .and_then(
            [&] { return files::saveTextFile(operation, encodeCommissionCsv(batch), csvPath); });
}

QString rateLabel(int baud)
{
    constexpr int million = 1'000'000;
    constexpr int thousand = 1'000;
    if (baud >= million)
        return QStringLiteral("%1 M").arg(QString::number(double(baud) / million));
    if (baud >= thousand)
        return QStringLiteral("%1 k").arg(QString::number(double(baud) / thousand));
    return QString::number(baud);
}

QString commissionLabel(const QString& format, const CommissionRow& row)
{
    const int baud = row.newBaud > 0 ? row.newBaud : row.oldBaud;
    const std::pair<const char*, QString> names[] = {
        {"{model}", row.servo.model},
        {"{id}", QString::number(row.newId)},
        {"{rate}", rateLabel(baud)},
        {"{baud}", QString::number(baud)},
        {"{firmware}", row.servo.firmware},
        {"{date}", row.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd"))},
        {"{was_id}", QString::number(row.servo.id)},
    };
    QString label = format;
    for (const auto& [name, value] : names)
        label.replace(QLatin1String(name), value);
    return label;
}

QString defaultLabelFormat()
{
    return QStringLiteral("{model} · ID {id} · {rate}");
}
} // namespace results
