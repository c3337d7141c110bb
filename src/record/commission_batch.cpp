// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/commission_batch.h"

#include "record/csv_text.h"
#include "record/text_file.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <array>

namespace record {
namespace {
struct VerdictWord {
    CommissionVerdict verdict;
    const char* word;
};
constexpr std::array verdictWords{
    VerdictWord{CommissionVerdict::Good, "good"},
    VerdictWord{CommissionVerdict::Remark, "remark"},
    VerdictWord{CommissionVerdict::Failed, "failed"},
    VerdictWord{CommissionVerdict::Aside, "set-aside"},
};

QString known(int number, int none)
{
    return number == none ? QString() : QString::number(number);
}

QString measured(std::optional<double> value)
{
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

QString troublesCell(const std::vector<CommissionTrouble>& troubles)
{
    QStringList words;
    for (const CommissionTrouble& trouble : troubles)
        words.append(trouble.detail.isEmpty()
                         ? trouble.word
                         : QStringLiteral("%1 (%2)").arg(trouble.word, trouble.detail));
    return words.join(QStringLiteral("; "));
}

QString timeText(const QDateTime& at)
{
    return at.toUTC().toString(Qt::ISODate);
}
} // namespace

QString verdictName(CommissionVerdict verdict)
{
    const auto* found = std::find_if(verdictWords.begin(), verdictWords.end(),
                                     [&](const auto& known) { return known.verdict == verdict; });
    return QString::fromLatin1(found->word);
}

std::optional<CommissionVerdict> commissionVerdictFromName(const QString& name)
{
    const auto* found =
        std::find_if(verdictWords.begin(), verdictWords.end(),
                     [&](const auto& known) { return name == QLatin1String(known.word); });
    return found == verdictWords.end() ? std::nullopt : std::optional(found->verdict);
}

bool CommissionBatch::idTaken(int id) const
{
    return std::any_of(rows.begin(), rows.end(),
                       [id](const CommissionRow& row) { return row.newId == id; }) ||
           std::any_of(pending.begin(), pending.end(), [id](const CommissionPending& one) {
               return one.idSent && one.newId == id;
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

std::vector<CommissionTrouble> unfinishedTroubles(const CommissionPending& pending)
{
    std::vector<CommissionTrouble> troubles;
    if (pending.idRead)
        troubles.push_back({QStringLiteral("unfinished-id"), QString::number(pending.newId)});
    else if (pending.idSent && pending.newId != pending.servo.id)
        troubles.push_back({QStringLiteral("unfinished-ids"),
                            QStringLiteral("%1, %2").arg(pending.servo.id).arg(pending.newId)});
    if (pending.lockOpen)
        troubles.push_back({QStringLiteral("unfinished-lock")});
    return troubles;
}

QByteArray encodeCommissionCsv(const CommissionBatch& batch)
{
    QByteArray text = "time,verdict,troubles,model,firmware,was_id,was_baud,id,baud,template,"
                      "written,centred,volts,celsius,label,snapshot\n";
    for (const CommissionRow& row : batch.rows)
        text += csvLine({timeText(row.at), verdictName(row.verdict), troublesCell(row.troubles),
                         row.servo.model, row.servo.firmware, QString::number(row.servo.id),
                         known(row.oldBaud, 0), known(row.newId, -1), known(row.newBaud, 0),
                         row.templateName, QString::number(row.written),
                         row.centred ? QStringLiteral("1") : QStringLiteral("0"),
                         measured(row.volts), measured(row.celsius), row.label, row.snapshot});
    return text;
}

QString commissionStatePath(const QString& csvPath)
{
    const bool csv = csvPath.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    return (csv ? csvPath.chopped(4) : csvPath) + QStringLiteral(".commission.json");
}

base::Result<CommissionBatch> openCommissionBatch(const QString& csvPath)
{
    constexpr qint64 largestFile = 64 * 1024 * 1024;
    const QString operation = QStringLiteral("load-batch");
    const QString path = commissionStatePath(csvPath);
    if (!QFileInfo::exists(path)) {
        if (QFileInfo(csvPath).size() > 0)
            return base::fail(
                base::ErrorCode::BadArgument, operation,
                QStringLiteral("%1 is there without %2").arg(csvPath, QFileInfo(path).fileName()));
        return CommissionBatch();
    }
    const auto text = readTextFile(operation, path, largestFile);
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
    return saveTextFile(operation, encodeCommissionBatch(batch), commissionStatePath(csvPath))
        .and_then([&] { return saveTextFile(operation, encodeCommissionCsv(batch), csvPath); });
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

QString usualLabelFormat()
{
    return QStringLiteral("{model} · ID {id} · {rate}");
}
} // namespace record
