// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/definition_readers.h"
#include "catalog/json_fields.h"

namespace catalog {
namespace {
base::ByteOrder readByteOrder(JsonFields& fields)
{
    return fields.oneOf<base::ByteOrder>(
        "byte_order", {{"little", base::ByteOrder::Little}, {"big", base::ByteOrder::Big}});
}

std::optional<int> optionalInt(JsonFields& fields, const char* name, int min, int max)
{
    const auto value = fields.integer(name, min, max);
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::optional<double> boundedNumber(JsonFields& fields, const char* name, double maxValue)
{
    const auto value = fields.number(name);
    if (value && !(*value > 0 && *value <= maxValue))
        fields.addError(QStringLiteral("\"%1\" is absurd").arg(QLatin1String(name)));
    return value;
}

std::optional<double> readAngleRange(JsonFields& fields)
{
    return boundedNumber(fields, "angle_range_deg", 3600.0);
}

int readSteps(JsonFields& fields, int fallback)
{
    return optionalInt(fields, "steps_per_turn", 2, 1 << 20).value_or(fallback);
}

Mode readMode(const QJsonValue& row, JsonFields& owner)
{
    JsonFields fields(row);
    Mode mode;
    mode.key = fields.string("key");
    mode.name = fields.text("name");
    mode.operatingMode = optionalInt(fields, "operating_mode", 0, 255);
    mode.limitsZero = fields.flag("limits_zero");
    const QString command = fields.string("command");
    mode.command = roleFromName(command).value_or(Role::None);
    if (mode.command == Role::None)
        fields.addError(QStringLiteral("unknown role \"%1\"").arg(command.left(40)));
    if (!fields.errorText().isEmpty())
        owner.addError(QStringLiteral("\"modes\": %1").arg(fields.errorText()));
    return mode;
}

void readFirmwareRange(JsonFields& fields, SeriesDef& series)
{
    if (!fields.has("firmware")) {
        fields.array("firmware");
        return;
    }
    const QJsonArray range = fields.array("firmware");
    const auto from = parseVersion(range.at(0).toString());
    const auto to = parseVersion(range.at(1).toString());
    if (range.size() != 2 || !from || !to || *from > *to)
        fields.addError(QStringLiteral("\"firmware\" is not a range like [\"3.0\", \"3.39\"]"));
    series.from = from;
    series.to = to;
}

void readModelNumber(JsonFields& fields, ModelEntry& model)
{
    const auto number = fields.version("id");
    if (!number)
        return;
    model.major = number->major;
    model.minor = number->minor;
}
} // namespace

std::optional<SeriesDef> readSeries(const QJsonValue& row, QString& errorText)
{
    JsonFields fields(row);
    SeriesDef series;
    series.key = fields.string("key");
    series.map = fields.optionalString("map");
    series.protocol = readProtocol(fields);
    readFirmwareRange(fields, series);
    series.byteOrder = readByteOrder(fields);
    series.line =
        fields.oneOf<Line>("line", {{"ttl", Line::Ttl}, {"rs485", Line::Rs485}}, Line::Unknown);
    series.stepsPerTurn = readSteps(fields, series.stepsPerTurn);
    series.angleRangeDeg = readAngleRange(fields);
    series.defaultBaud = optionalInt(fields, "default_baud", 300, 10000000);
    series.syncRead = fields.flag("sync_read");
    series.damping = fields.flag("damping");
    series.multiTurn = fields.flag("multi_turn");
    series.centering = fields.oneOf<Centering>("centering",
                                               {{"none", Centering::None},
                                                {"write128", Centering::Write128},
                                                {"instruction0B", Centering::Instruction0B},
                                                {"fault_reset4", Centering::FaultReset4}},
                                               Centering::None);
    series.centeringFrom = fields.version("centering_from");
    const QJsonArray modes = fields.array("modes");
    for (const QJsonValue mode : modes)
        series.modes.push_back(readMode(mode, fields));
    errorText = fields.errorText();
    return errorText.isEmpty() ? std::optional(series) : std::nullopt;
}

std::optional<ModelEntry> readModel(const QJsonValue& row, QString& errorText)
{
    JsonFields fields(row);
    ModelEntry model;
    readModelNumber(fields, model);
    model.name = fields.string("name");
    model.series = fields.string("series");
    model.byteOrder = readByteOrder(fields);
    model.stepsPerTurn = readSteps(fields, model.stepsPerTurn);
    model.angleRangeDeg = readAngleRange(fields);
    model.defaultBaud = optionalInt(fields, "default_baud", 300, 10000000);
    model.minVoltage = boundedNumber(fields, "min_voltage", 1000.0);
    model.maxVoltage = boundedNumber(fields, "max_voltage", 1000.0);
    if (model.minVoltage && model.maxVoltage && *model.minVoltage > *model.maxVoltage)
        fields.addError(QStringLiteral("\"min_voltage\" is above \"max_voltage\""));
    model.currentSensing =
        fields.oneOf<CurrentSensing>("current_sensing",
                                     {{"unknown", CurrentSensing::Unknown},
                                      {"no", CurrentSensing::No},
                                      {"yes", CurrentSensing::Yes},
                                      {"phase", CurrentSensing::UnlessPhaseBit5}},
                                     CurrentSensing::Unknown);
    model.supported = fields.flag("supported", true);
    if (fields.has("note"))
        model.note = fields.text("note");
    errorText = fields.errorText();
    return errorText.isEmpty() ? std::optional(model) : std::nullopt;
}

std::optional<FirmwareDef> readFirmware(const QJsonValue& row, QString& errorText)
{
    JsonFields fields(row);
    FirmwareDef firmware;
    firmware.protocol = readProtocol(fields);
    firmware.fromModel = fields.version("from");
    firmware.toModel = fields.version("to");
    if (firmware.fromModel.has_value() != firmware.toModel.has_value() ||
        (firmware.fromModel && *firmware.fromModel > *firmware.toModel))
        fields.addError(QStringLiteral("\"from\" and \"to\" are not a range of models"));
    if (firmware.protocol == base::Protocol::Feetech)
        fields.require("from");
    firmware.byteOrder = readByteOrder(fields);
    fields.require("version");
    firmware.version = fields.version("version").value_or(Version{});
    firmware.date = QDate::fromString(fields.string("date"), Qt::ISODate);
    if (!firmware.date.isValid())
        fields.addError(QStringLiteral("\"date\" is not a date like 2025-03-06"));
    firmware.source = fields.string("source");
    errorText = fields.errorText();
    return errorText.isEmpty() ? std::optional(firmware) : std::nullopt;
}
} // namespace catalog
