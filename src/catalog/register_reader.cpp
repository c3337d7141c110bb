// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/definition_readers.h"
#include "catalog/json_fields.h"
#include "catalog/raw_range.h"
#include "catalog/register_location.h"

#include <algorithm>
#include <cmath>

namespace catalog {
namespace {
constexpr std::int64_t maxRawValue = 0xFFFFFFFFLL;

/// "unsigned", "sign-bit-15", "sign-bit-11-ext-12", "twos-complement", "bits", "enum".
void readEncoding(const QString& string, Encoding& encoding, int& signBit, JsonFields& fields)
{
    static const QString signBitPrefix = QStringLiteral("sign-bit-");
    signBit = 0;
    if (string == QLatin1String("unsigned"))
        encoding = Encoding::Unsigned;
    else if (string == QLatin1String("sign-bit-11-ext-12"))
        encoding = Encoding::SignBit11Ext12;
    else if (string == QLatin1String("twos-complement"))
        encoding = Encoding::TwosComplement;
    else if (string == QLatin1String("bits"))
        encoding = Encoding::Bits;
    else if (string == QLatin1String("enum"))
        encoding = Encoding::Enum;
    else if (string.startsWith(signBitPrefix)) {
        encoding = Encoding::SignBit;
        signBit = string.mid(signBitPrefix.size()).toInt();
        if (signBit < 1 || signBit > 31)
            fields.addError(QStringLiteral("unknown encoding \"%1\"").arg(string.left(40)));
    } else {
        fields.addError(QStringLiteral("unknown encoding \"%1\"").arg(string.left(40)));
    }
}

/// The sign must lie inside the register.
void checkFits(int size, Encoding encoding, int signBit, JsonFields& fields)
{
    if ((encoding == Encoding::SignBit && signBit >= size * 8) ||
        (encoding == Encoding::SignBit11Ext12 && size < 2))
        fields.addError(QStringLiteral("the sign bit lies outside the register"));
}

double readScale(JsonFields& fields, double fallback)
{
    const double scale = fields.number("scale").value_or(fallback);
    if (!(std::abs(scale) > 1e-9 && std::abs(scale) < 1e9))
        fields.addError(QStringLiteral("\"scale\" must not be 0 or absurd"));
    return scale;
}

void checkRange(const std::optional<std::int64_t>& min, const std::optional<std::int64_t>& max,
                RawRange rawRange, JsonFields& fields)
{
    if (min && max && *min > *max)
        fields.addError(QStringLiteral("\"min\" is above \"max\""));
    for (const auto& bound : {min, max}) {
        if (bound && (*bound < rawRange.min || *bound > rawRange.max))
            fields.addError(QStringLiteral("\"min\" or \"max\" does not fit the register"));
    }
}

void readValues(JsonFields& fields, RegisterDef& def, RawRange rawRange)
{
    const bool bits = def.reg.encoding == Encoding::Bits;
    const std::int64_t maxValue = bits ? def.reg.size * 8 - 1 : rawRange.max;
    const QJsonArray rows = fields.array("values");
    for (const QJsonValue row : rows) {
        JsonFields item(row);
        NamedValue value;
        item.require("value");
        value.value = static_cast<int>(
            item.integer("value", 0, std::min<std::int64_t>(maxValue, 65535)).value_or(0));
        value.key = item.string("key");
        value.name = item.text("name");
        QString errorText;
        def.valueOnly.push_back(readConditions(item.array("only"), errorText));
        if (!errorText.isEmpty())
            item.addError(errorText);
        bool number = false;
        const auto keyNumber = value.key.toLongLong(&number);
        const std::int64_t maxRaw = def.reg.max.value_or(rawRange.max);
        if (number && keyNumber <= maxRaw && keyNumber != value.value)
            item.addError(QStringLiteral("the key \"%1\" is another raw value").arg(value.key));
        for (const NamedValue& other : def.reg.values) {
            if (other.value == value.value || other.key == value.key)
                item.addError(QStringLiteral("value or key occurs twice"));
        }
        if (!item.errorText().isEmpty())
            fields.addError(QStringLiteral("\"values\": %1").arg(item.errorText()));
        def.reg.values.push_back(value);
    }
}

Variant readVariant(const QJsonValue& row, const Register& reg, QString& errorText)
{
    JsonFields fields(row);
    Variant variant;
    variant.andBothLimitsZero = fields.flag("both_limits_zero");
    if (!variant.andBothLimitsZero) {
        variant.whenKey = fields.string("when");
        fields.require("equals");
    }
    variant.mask = fields.integer("mask", 1, maxRawValue).value_or(-1);
    variant.equals = fields.integer("equals", -maxRawValue, maxRawValue).value_or(0);
    if (fields.has("scale"))
        variant.scale = readScale(fields, 1.0);
    if (fields.has("unit"))
        variant.unit = fields.optionalString("unit");
    if (fields.has("name"))
        variant.name = fields.text("name");
    Encoding encoding = reg.encoding;
    int signBit = reg.signBit;
    if (fields.has("encoding")) {
        readEncoding(fields.string("encoding"), encoding, signBit, fields);
        variant.encoding = encoding;
        variant.signBit = signBit;
    }
    checkFits(reg.size, encoding, signBit, fields);
    variant.min = fields.integer("min", -maxRawValue, maxRawValue);
    variant.max = fields.integer("max", -maxRawValue, maxRawValue);
    if (fields.firstError().isEmpty())
        checkRange(variant.min ? variant.min : reg.min, variant.max ? variant.max : reg.max,
                   representableRange(reg.size, encoding, signBit), fields);
    if (errorText.isEmpty())
        errorText = fields.errorText();
    return variant;
}

void readLayout(JsonFields& fields, Register& reg, base::Protocol protocol)
{
    reg.key = fields.string("key");
    readLocation(fields, reg, protocol);
    reg.area = fields.oneOf<Area>("area", {{"EPROM", Area::Eprom},
                                           {"SRAM", Area::Sram},
                                           {"FEEDBACK", Area::Feedback},
                                           {"FACTORY", Area::Factory}});
    reg.access =
        fields.oneOf<Access>("access", {{"ro", Access::ReadOnly}, {"rw", Access::ReadWrite}});
    if (protocol == base::Protocol::Lx && reg.writable() != fields.has("write"))
        fields.addError(QStringLiteral("\"write\" and \"access\" contradict each other"));
    reg.persistence = fields.oneOf<Persistence>("persistence",
                                                {{"kept", Persistence::Kept},
                                                 {"lost", Persistence::Lost},
                                                 {"after_save", Persistence::AfterSave},
                                                 {"not_stated", Persistence::NotStated}},
                                                Persistence::ByArea);
    if ((reg.persistence == Persistence::AfterSave) != (reg.saveOffset >= 0))
        fields.addError(QStringLiteral("\"save\" and \"after_save\" belong together"));
    readEncoding(fields.string("encoding"), reg.encoding, reg.signBit, fields);
    checkFits(reg.size, reg.encoding, reg.signBit, fields);
    const QString roleName = fields.optionalString("role", QStringLiteral("none"));
    const auto role = roleFromName(roleName);
    if (!role)
        fields.addError(QStringLiteral("unknown role \"%1\"").arg(roleName.left(40)));
    reg.role = role.value_or(Role::None);
}

void readNumbers(JsonFields& fields, Register& reg, RawRange rawRange)
{
    reg.min = fields.integer("min", -maxRawValue, maxRawValue);
    reg.max = fields.integer("max", -maxRawValue, maxRawValue);
    checkRange(reg.min, reg.max, rawRange, fields);
    reg.defaultRaw = fields.integer("default", rawRange.min, rawRange.max);
    reg.warnAbove = fields.integer("warn_above", rawRange.min, rawRange.max);
    reg.unit = fields.optionalString("unit");
    reg.scale = readScale(fields, 1.0);
    reg.scaleBy = fields.optionalString("scale_by");
}

void readTexts(JsonFields& fields, Register& reg)
{
    reg.name = fields.text("name");
    if (fields.has("help") || reg.writable())
        reg.help = fields.text("help");
    reg.source = fields.optionalString("source");
    reg.identity = fields.flag("identity");
    reg.dangerous = fields.flag("dangerous");
    reg.motion = fields.flag("motion");
    reg.torqueOff = fields.oneOf<TorqueOff>(
        "torque_off", {{"needed", TorqueOff::Needed}, {"when_both_zero", TorqueOff::WhenBothZero}},
        TorqueOff::NotNeeded);
}

RegisterDef readDefinition(const QJsonObject& row, base::Protocol protocol, QString& errorText)
{
    JsonFields fields(row);
    RegisterDef def;
    readLayout(fields, def.reg, protocol);
    const RawRange rawRange = representableRange(def.reg.size, def.reg.encoding, def.reg.signBit);
    readNumbers(fields, def.reg, rawRange);
    readValues(fields, def, rawRange);
    const QJsonArray variants = fields.array("variants");
    for (const QJsonValue variant : variants) {
        QString variantError;
        def.reg.variants.push_back(readVariant(variant, def.reg, variantError));
        if (!variantError.isEmpty())
            fields.addError(QStringLiteral("\"variants\": %1").arg(variantError));
    }
    def.angular = fields.oneOf<Angular>(
        "angular", {{"position", Angular::Position}, {"speed", Angular::Speed}}, Angular::No);
    readTexts(fields, def.reg);
    if (errorText.isEmpty())
        errorText = fields.errorText();
    return def;
}

void readOverride(const QJsonValue& rule, const QJsonObject& plain, base::Protocol protocol,
                  RegisterRow& row, QString& errorText)
{
    QJsonObject change = rule.toObject();
    const Condition when = readCondition(change.take(QStringLiteral("when")), errorText);
    for (const char* fixed : {"key", "address", "write", "save", "place"}) {
        if (change.contains(QLatin1String(fixed)) && errorText.isEmpty())
            errorText = QStringLiteral("\"set\" must not change \"%1\"").arg(QLatin1String(fixed));
    }
    QJsonObject merged = plain;
    for (auto it = change.constBegin(); it != change.constEnd(); ++it)
        merged.insert(it.key(), it.value());
    row.set.emplace_back(when, readDefinition(merged, protocol, errorText));
}
} // namespace

std::optional<RegisterRow> readRegister(const QJsonValue& value, base::Protocol protocol,
                                        QString& errorText)
{
    JsonFields fields(value);
    QJsonObject plain = value.toObject();
    plain.remove(QStringLiteral("only"));
    plain.remove(QStringLiteral("set"));
    RegisterRow row;
    row.only = readConditions(fields.array("only"), errorText);
    const QJsonArray rules = fields.array("set");
    if (errorText.isEmpty())
        errorText = fields.firstError();
    row.base = readDefinition(plain, protocol, errorText);
    for (const QJsonValue rule : rules)
        readOverride(rule, plain, protocol, row, errorText);
    return errorText.isEmpty() ? std::optional(row) : std::nullopt;
}
} // namespace catalog
