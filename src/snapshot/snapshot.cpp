// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/snapshot.h"

#include "files/json_duplicates.h"
#include "files/json_format.h"
#include "files/json_text.h"
#include "snapshot/snapshot_json.h"

#include <QSet>

#include <algorithm>
#include <array>

namespace record {
namespace {
const QLatin1String snapshotFormat("servodesk-snapshot");
constexpr int snapshotVersion = 1;
constexpr int maxAddress = 65535;
constexpr int maxId = 255;

QByteArray registerLine(const SnapshotRegister& reg)
{
    return "    {\"key\": " + jsonText(reg.key) +
           ", \"address\": " + QByteArray::number(reg.address) +
           ", \"raw\": " + jsonInteger(reg.raw) +
           ", \"value\": " + jsonNumber(reg.value, registerValueDigits) +
           ", \"unit\": " + jsonText(reg.unit) +
           ", \"area\": " + jsonText(catalog::areaName(reg.area)) +
           ", \"access\": " + jsonText(catalog::accessName(reg.access)) + '}';
}

QByteArray servoLine(const SnapshotServo& servo)
{
    return "{\"id\": " + QByteArray::number(servo.id) + ", \"model\": " + jsonText(servo.model) +
           ", \"model_id\": " + jsonText(servo.modelId) +
           ", \"firmware\": " + jsonText(servo.firmware) + ", \"map\": " + jsonText(servo.map) +
           ", \"protocol\": " + jsonText(servo.protocol) + '}';
}

int readIntInRange(const JsonReader& json, const char* key, int lowest, int highest)
{
    const int found = json.smallInteger(key);
    if (found < lowest || found > highest)
        json.reportError(key, QStringLiteral("expected %1 to %2").arg(lowest).arg(highest));
    return found;
}

template <typename Word, std::size_t Count>
Word readEnum(const JsonReader& json, const char* key, const std::array<Word, Count>& words,
              QString (*nameOf)(Word))
{
    const QString found = json.text(key);
    for (const Word word : words) {
        if (found == nameOf(word))
            return word;
    }
    json.reportError(key, QStringLiteral("unknown word \"%1\"").arg(found));
    return words.front();
}

SnapshotRegister readRegister(const JsonReader& json)
{
    using catalog::Access;
    using catalog::Area;
    SnapshotRegister reg;
    reg.key = json.nonEmptyText("key");
    reg.address = readIntInRange(json, "address", 0, maxAddress);
    reg.raw = json.integerOrNull("raw");
    reg.value = json.numberOrNull("value");
    reg.unit = json.text("unit");
    reg.area =
        readEnum(json, "area", std::array{Area::Eprom, Area::Sram, Area::Feedback, Area::Factory},
                 catalog::areaName);
    reg.access = readEnum(json, "access", std::array{Access::ReadOnly, Access::ReadWrite},
                          catalog::accessName);
    return reg;
}

std::vector<SnapshotRegister> readRegisters(const JsonReader& json)
{
    std::vector<SnapshotRegister> registers;
    QSet<QString> seen;
    for (const JsonReader& line : json.objects("registers")) {
        registers.push_back(readRegister(line));
        const QString& key = registers.back().key;
        if (seen.contains(key))
            line.reportError("key", QStringLiteral("\"%1\" is there twice").arg(key));
        seen.insert(key);
    }
    return registers;
}

SnapshotServo readServo(const JsonReader& json)
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
    QByteArray text = "{\n  \"format\": " + jsonText(snapshotFormat) +
                      ",\n  \"version\": " + QByteArray::number(snapshotVersion) +
                      (snapshot.isTemplate ? ",\n  \"template\": true" : "") +
                      ",\n  \"program\": " + jsonText(snapshot.program) +
                      ",\n  \"time\": " + jsonText(snapshot.at.toUTC().toString(Qt::ISODate)) +
                      ",\n  \"label\": " + jsonText(snapshot.label) +
                      ",\n  \"note\": " + jsonText(snapshot.note) +
                      ",\n  \"port\": " + jsonText(snapshot.port) +
                      ",\n  \"baud\": " + QByteArray::number(snapshot.baud) +
                      ",\n  \"servo\": " + servoLine(snapshot.servo) + ",\n  \"registers\": [";
    const char* separator = "\n";
    for (const SnapshotRegister& reg : registers) {
        text += separator + registerLine(reg);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

Snapshot readSnapshot(const JsonReader& json)
{
    checkFormat(json, snapshotFormat, snapshotVersion, QStringLiteral("not a ServoDesk snapshot"));
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
    const auto document = parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, operation, document.error());
    if (const QString twice = findDuplicateKey(text); !twice.isEmpty())
        return base::fail(base::ErrorCode::FileFormat, operation, twice);
    JsonReadError readError;
    Snapshot snapshot = readSnapshot(JsonReader(*document, readError));
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, operation, readError.text());
    return snapshot;
}
} // namespace record
