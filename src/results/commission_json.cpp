// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a batch as JSON, one servo per line.
#include "files/json_duplicates.h"
#include "files/json_format.h"
#include "files/json_text.h"
#include "results/commission_batch.h"

namespace results {
namespace {
const QLatin1String commissionFormat("servodesk-commission");
constexpr int commissionVersion = 1;

QByteArray servoText(const snapshot::SnapshotServo& servo)
{
    return files::JsonObjectWriter()
        .integer("id", servo.id)
        .text("model", servo.model)
        .text("model_id", servo.modelId)
        .text("firmware", servo.firmware)
        .text("map", servo.map)
        .text("protocol", servo.protocol)
        .done();
}

QByteArray issuesText(const std::vector<CommissionIssue>& issues)
{
    QByteArray text;
    for (const CommissionIssue& issue : issues)
        text +=
            (text.isEmpty() ? "" : ", ") +
            files::JsonObjectWriter().text("word", issue.word).text("detail", issue.detail).done();
    return '[' + text + ']';
}

QByteArray rowText(const CommissionRow& row)
{
    return files::JsonObjectWriter()
        .text("time", row.at.toUTC().toString(Qt::ISODate))
        .raw("servo", servoText(row.servo))
        .integer("was_baud", row.oldBaud)
        .integer("id", row.newId)
        .integer("baud", row.newBaud)
        .text("template", row.templateName)
        .integer("written", row.written)
        .raw("centred", files::jsonFlag(row.centered))
        .raw("volts", files::jsonNumber(row.volts))
        .raw("celsius", files::jsonNumber(row.celsius))
        .text("verdict", verdictName(row.verdict))
        .raw("troubles", issuesText(row.issues))
        .text("label", row.label)
        .text("snapshot", row.snapshot)
        .raw("simulated", files::jsonFlag(row.simulated))
        .done();
}

QByteArray pendingText(const PendingCommission& one)
{
    return files::JsonObjectWriter()
        .text("time", one.at.toUTC().toString(Qt::ISODateWithMs))
        .raw("servo", servoText(one.servo))
        .integer("was_baud", one.oldBaud)
        .integer("id", one.newId)
        .integer("baud", one.newBaud)
        .raw("id_sent", files::jsonFlag(one.isIdSent))
        .text("snapshot", one.snapshot)
        .raw("id_read", files::jsonFlag(one.isIdConfirmed))
        .raw("lock_open", files::jsonFlag(one.lockOpen))
        .raw("simulated", files::jsonFlag(one.simulated))
        .done();
}

snapshot::SnapshotServo readCommissionServo(const files::JsonReader& json)
{
    snapshot::SnapshotServo servo;
    servo.id = json.smallInteger("id");
    servo.model = json.text("model");
    servo.modelId = json.text("model_id");
    servo.firmware = json.text("firmware");
    servo.map = json.text("map");
    servo.protocol = json.text("protocol");
    return servo;
}

/// Files of an earlier version do not have it.
bool readSimulated(const files::JsonReader& json)
{
    return json.contains("simulated") && json.flag("simulated");
}

CommissionRow readRow(const files::JsonReader& json)
{
    CommissionRow row;
    row.at = json.time("time");
    row.servo = readCommissionServo(json.object("servo"));
    row.oldBaud = json.smallInteger("was_baud");
    row.newId = json.smallInteger("id");
    row.newBaud = json.smallInteger("baud");
    row.templateName = json.text("template");
    row.written = json.smallInteger("written");
    row.centered = json.flag("centred");
    row.volts = json.numberOrNull("volts");
    row.celsius = json.numberOrNull("celsius");
    row.verdict = json.enumValue("verdict", commissionVerdictFromName);
    for (const files::JsonReader& issue : json.objects("troubles"))
        row.issues.push_back({issue.nonEmptyText("word"), issue.text("detail")});
    row.label = json.text("label");
    row.snapshot = json.text("snapshot");
    row.simulated = readSimulated(json);
    return row;
}

PendingCommission readPending(const files::JsonReader& json)
{
    PendingCommission one;
    one.at = json.time("time");
    one.servo = readCommissionServo(json.object("servo"));
    one.oldBaud = json.smallInteger("was_baud");
    one.newId = json.smallInteger("id");
    one.newBaud = json.smallInteger("baud");
    one.isIdSent = json.flag("id_sent");
    one.snapshot = json.text("snapshot");
    one.isIdConfirmed = json.flag("id_read");
    one.lockOpen = json.flag("lock_open");
    one.simulated = readSimulated(json);
    return one;
}

base::Result<CommissionBatch> fail(const QString& detail)
{
    return base::fail(base::ErrorCode::FileFormat, QStringLiteral("load-batch"), detail);
}
} // namespace

QByteArray encodeCommissionBatch(const CommissionBatch& batch)
{
    QByteArray text = "{\n  \"format\": " + files::jsonText(commissionFormat) +
                      ",\n  \"version\": " + QByteArray::number(commissionVersion) +
                      ",\n  \"program\": " + files::jsonText(batch.program) +
                      ",\n  \"servos\": " + files::jsonLines(batch.rows, "  ", rowText) +
                      ",\n  \"unfinished\": " + files::jsonLines(batch.pending, "  ", pendingText);
    if (batch.attachedServo)
        text += ",\n  \"on_wire\": " + files::JsonObjectWriter()
                                           .text("protocol", batch.attachedServo->protocol)
                                           .integer("id", batch.attachedServo->id)
                                           .integer("baud", batch.attachedServo->baud)
                                           .done();
    return text + "\n}\n";
}

base::Result<CommissionBatch> decodeCommissionBatch(const QByteArray& text)
{
    const auto document = files::parseJson(text);
    if (!document)
        return fail(document.error());
    if (const QString twice = files::findDuplicateKey(text); !twice.isEmpty())
        return fail(twice);
    files::JsonReadError readError;
    const files::JsonReader json(*document, readError);
    files::checkFormat(json, commissionFormat, commissionVersion,
                       QStringLiteral("not the state of a commissioning batch of ServoDesk"));
    CommissionBatch batch;
    batch.program = json.text("program");
    for (const files::JsonReader& row : json.objects("servos"))
        batch.rows.push_back(readRow(row));
    for (const files::JsonReader& one : json.objects("unfinished"))
        batch.pending.push_back(readPending(one));
    if (json.contains("on_wire")) {
        const files::JsonReader place = json.object("on_wire");
        batch.attachedServo = ServoLocation{place.text("protocol"), place.smallInteger("id"),
                                            place.smallInteger("baud")};
    }
    if (readError.isSet())
        return fail(readError.text());
    return batch;
}
} // namespace results
