// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/restore_result.h"

#include "files/json_text.h"
#include "files/text_file.h"

namespace snapshot {
namespace {
const QLatin1String restoreFormat("servodesk-restore");
constexpr int restoreVersion = 1;

QString cell(std::optional<std::int64_t> raw)
{
    return raw ? QString::number(*raw) : QString();
}

QByteArray rowLine(const RestoreResultRow& row)
{
    return "        {\"key\": " + files::jsonText(row.key) +
           ", \"address\": " + QByteArray::number(row.address) +
           ", \"before\": " + files::jsonInteger(row.before) +
           ", \"wanted\": " + files::jsonInteger(row.newRaw) +
           ", \"value\": " + files::jsonNumber(row.newValue, files::registerValueDigits) +
           ", \"unit\": " + files::jsonText(row.unit) +
           ", \"read_back\": " + files::jsonInteger(row.readBack) +
           ", \"outcome\": " + files::jsonText(row.outcome) +
           ", \"error\": " + files::jsonText(row.error) +
           ", \"rolled_back\": " + files::jsonFlag(row.rolledBack) + '}';
}

QByteArray servoBlock(const RestoreResult& result)
{
    const SnapshotServo& servo = result.servo;
    QByteArray text =
        "    {\n      \"id\": " + QByteArray::number(servo.id) +
        ",\n      \"model\": " + files::jsonText(servo.model) +
        ",\n      \"model_id\": " + files::jsonText(servo.modelId) +
        ",\n      \"firmware\": " + files::jsonText(servo.firmware) +
        ",\n      \"map\": " + files::jsonText(servo.map) +
        ",\n      \"protocol\": " + files::jsonText(servo.protocol) +
        ",\n      \"program\": " + files::jsonText(result.program) +
        ",\n      \"time\": " + files::jsonText(result.at.toUTC().toString(Qt::ISODate)) +
        ",\n      \"source\": " + files::jsonText(result.source) +
        ",\n      \"port\": " + files::jsonText(result.port) +
        ",\n      \"baud\": " + QByteArray::number(result.baud) +
        ",\n      \"verdict\": " + files::jsonText(result.verdict) +
        ",\n      \"lock\": " + files::jsonText(result.lock) + ",\n      \"rows\": [";
    const char* separator = "\n";
    for (const RestoreResultRow& row : result.rows) {
        text += separator + rowLine(row);
        separator = ",\n";
    }
    return text + "\n      ]\n    }";
}
} // namespace

QByteArray encodeRestoreResults(const std::vector<RestoreResult>& results)
{
    QByteArray text = "{\n  \"format\": " + files::jsonText(restoreFormat) +
                      ",\n  \"version\": " + QByteArray::number(restoreVersion) +
                      ",\n  \"servos\": [";
    const char* separator = "\n";
    for (const RestoreResult& result : results) {
        text += separator + servoBlock(result);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

QByteArray encodeRestoreResultsCsv(const std::vector<RestoreResult>& results)
{
    QByteArray text = "id,model,firmware,time,source,verdict,lock,key,address,before,wanted,value,"
                      "unit,read_back,outcome,error,rolled_back\n";
    for (const RestoreResult& result : results) {
        const QStringList head{QString::number(result.servo.id),
                               result.servo.model,
                               result.servo.firmware,
                               result.at.toUTC().toString(Qt::ISODate),
                               result.source,
                               result.verdict,
                               result.lock};
        // A servo that needed no write, or did not reply, also has a line.
        if (result.rows.empty())
            text += files::csvLine(head + QStringList(10, QString()));
        for (const RestoreResultRow& row : result.rows) {
            text += files::csvLine(
                head + QStringList{row.key, QString::number(row.address), cell(row.before),
                                   QString::number(row.newRaw),
                                   row.newValue ? QString::number(*row.newValue, 'g',
                                                                  files::registerValueDigits)
                                                : QString(),
                                   row.unit, cell(row.readBack), row.outcome, row.error,
                                   row.rolledBack ? QStringLiteral("1") : QStringLiteral("0")});
        }
    }
    return text;
}

base::Result<void> saveRestoreResults(const std::vector<RestoreResult>& results,
                                      const QString& path, files::CsvReader reader)
{
    const bool csv = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
    return files::saveTextFile(QStringLiteral("save-result"),
                               csv ? files::csvStart(reader) + encodeRestoreResultsCsv(results)
                                   : encodeRestoreResults(results),
                               path);
}
} // namespace snapshot
