// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/snapshot_json_reader.h"

#include "files/json_duplicates.h"
#include "files/json_format.h"
#include "files/json_text.h"
#include "snapshot/snapshot.h"

#include <QSet>

#include <algorithm>
#include <array>

namespace snapshot {
namespace {
const QLatin1String snapshotFormat("servodesk-snapshot");
constexpr int snapshotVersion = 1;
constexpr int maxAddress = 65535;
constexpr int maxId = 255;

QByteArray registerLine(const SnapshotRegister& reg)
{
    return "    {\"key\": " + files::jsonText(reg.key) +
           ", \"address\": " + QByteArray::number(reg.address) +
           ", \"raw\": " + files::jsonInteger(reg.raw) +
           ", \"value\": " + files::jsonNumber(reg.value, files::registerValueDigits) +
           ", \"unit\": " + files::jsonText(reg.unit) +
           ", \"area\": " + files::jsonText(catalog::areaName(reg.area)) +
           ", \"access\": " + files::jsonText(catalog::accessName(reg.access)) + '}';
}

QByteArray servoLine(const SnapshotServo& servo)
{
    return "{\"id\": " + QByteArray::number(servo.id) +
           ", \"model\": " + files::jsonText(servo.model) +
           ", \"model_id\": " + files::jsonText(servo.modelId) +
           ", \"firmware\": " + files::jsonText(servo.firmware) +
           ", \"map\": " + files::jsonText(servo.map) +
           ", \"protocol\": " + files::jsonText(servo.protocol) + '}';
}

int readIntInRange(const files::JsonReader& json, const char* key, int lowest, int highest)
{
    const int found = json.smallInteger(key);
    if (found < lowest || found > highest)
        json.reportError(key, QStringLiteral("expected %1 to %2").arg(lowest).arg(highest));
    return found;
}

SnapshotRegister readRegister(const files::JsonReader& json)
{
    SnapshotRegister reg;
    reg.key = json.nonEmptyText("key");
    reg.address = readIntInRange(json, "address", 0, maxAddress);
    reg.raw = json.integerOrNull("raw");
    reg.value = json.numberOrNull("value");
    reg.unit = json.text("unit");
    reg.area = json.enumValue("area", catalog::areaFromName);
    reg.access = json.enumValue("access", catalog::accessFromName);
    return reg;
}

std::vector<SnapshotRegister> readRegisters(const files::JsonReader& json)
{
    std::vector<SnapshotRegister> registers;
    QSet<QString> seen;
    for (const files::JsonReader& line : json.objects("registers")) {
        registers.push_back(readRegister(line));
        const QString& key = registers.back().key;
        if (seen.contains(key))
            line.reportError("key", QStringLiteral("\"%1\" is there twice").arg(key));
        seen.insert(key);
    }
    return registers;
}

SnapshotServo readServo(const files::JsonReader& json)
{
    return {
        readIntInRange(json, "id", 0, maxId),
        json.text("model"),
        json.text("model_id"),
        json.text("firmware"),
        json.nonEmptyText("map"),
        json.text("protocol"),
    };
}

} // namespace

const SnapshotRegister* Snapshot::find(const QString& key) const
{
    const auto found = std::find_if(registers.begin(), registers.end(),
                                    [&](const auto& reg) { return reg.key == key; });
    return found == registers.end() ? nullptr : &*found;
}

QByteArray encodeSnapshot(const Snapshot& snapshot)
{
    std::vector<SnapshotRegister> registers = snapshot.registers;
    std::sort(registers.begin(), registers.end(), [](const auto& left, const auto& right) {
        return std::tie(left.address, left.key) < std::tie(right.address, right.key);
    });
    QByteArray text = "{\n  \"format\": " + files::jsonText(snapshotFormat) +
                      ",\n  \"version\": " + QByteArray::number(snapshotVersion) +
                      (snapshot.isTemplate ? ",\n  \"template\": true" : "") +
                      ",\n  \"program\": " + files::jsonText(snapshot.program) + ",\n  \"time\": " +
                      files::jsonText(snapshot.at.toUTC().toString(Qt::ISODate)) +
                      ",\n  \"label\": " + files::jsonText(snapshot.label) +
                      ",\n  \"note\": " + files::jsonText(snapshot.note) +
                      ",\n  \"port\": " + files::jsonText(snapshot.port) +
                      ",\n  \"baud\": " + QByteArray::number(snapshot.baud) +
                      ",\n  \"servo\": " + servoLine(snapshot.servo) + ",\n  \"registers\": [";
    const char* separator = "\n";
    for (const SnapshotRegister& reg : registers) {
        text += separator + registerLine(reg);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

Snapshot readSnapshot(const files::JsonReader& json)
{
    files::checkFormat(json, snapshotFormat, snapshotVersion,
                       QStringLiteral("not a ServoDesk snapshot"));
    Snapshot snapshot;
    snapshot.isTemplate = json.contains("template") && json.flag("template");
    snapshot.program = json.text("program");
    snapshot.at = json.time("time");
    snapshot.label = json.text("label");
    snapshot.note = json.text("note");
    snapshot.port = json.text("port");
    snapshot.baud = readIntInRange(json, "baud", 0, std::numeric_limits<int>::max());
    snapshot.servo = readServo(json.object("servo"));
    snapshot.registers = readRegisters(json);
    return snapshot;
}

base::Result<Snapshot> decodeSnapshot(const QByteArray& text)
{
    const QString operation = QStringLiteral("load-snapshot");
    const auto document = files::parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, operation, document.error());
    if (const QString twice = files::findDuplicateKey(text); !twice.isEmpty())
        return base::fail(base::ErrorCode::FileFormat, operation, twice);
    files::JsonReadError readError;
    Snapshot snapshot = readSnapshot(files::JsonReader(*document, readError));
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, operation, readError.text());
    return snapshot;
}
} // namespace snapshot
