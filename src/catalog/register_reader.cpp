// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/fields.h"
#include "catalog/place.h"
#include "catalog/raw_range.h"
#include "catalog/readers.h"

#include <algorithm>
#include <cmath>

namespace catalog {
namespace {
constexpr std::int64_t LargestRaw = 0xFFFFFFFFLL;

/// "unsigned", "sign-bit-15", "sign-bit-11-ext-12", "twos-complement", "bits", "enum".
void readEncoding(const QString& word, Encoding& encoding, int& signBit, Fields& fields)
{
    static const QString signBitPrefix = QStringLiteral("sign-bit-");
    signBit = 0;
    if (word == QLatin1String("unsigned"))
        encoding = Encoding::Unsigned;
    else if (word == QLatin1String("sign-bit-11-ext-12"))
        encoding = Encoding::SignBit11Ext12;
    else if (word == QLatin1String("twos-complement"))
        encoding = Encoding::TwosComplement;
    else if (word == QLatin1String("bits"))
        encoding = Encoding::Bits;
    else if (word == QLatin1String("enum"))
        encoding = Encoding::Enum;
    else if (word.startsWith(signBitPrefix)) {
        encoding = Encoding::SignBit;
        signBit = word.mid(signBitPrefix.size()).toInt();
        if (signBit < 1 || signBit > 31)
            fields.complain(QStringLiteral("unknown encoding \"%1\"").arg(word.left(40)));
    } else {
        fields.complain(QStringLiteral("unknown encoding \"%1\"").arg(word.left(40)));
    }
}

/// The sign must lie inside the register.
void checkFits(int size, Encoding encoding, int signBit, Fields& fields)
{
    if ((encoding == Encoding::SignBit && signBit >= size * 8) ||
        (encoding == Encoding::SignBit11Ext12 && size < 2))
        fields.complain(QStringLiteral("the sign bit lies outside the register"));
}

double readScale(Fields& fields, double fallback)
{
    const double scale = fields.number("scale").value_or(fallback);
    if (!(std::abs(scale) > 1e-9 && std::abs(scale) < 1e9))
        fields.complain(QStringLiteral("\"scale\" must not be 0 or absurd"));
    return scale;
}

void checkRange(const std::optional<std::int64_t>& min, const std::optional<std::int64_t>& max,
                RawRange possible, Fields& fields)
{
    if (min && max && *min > *max)
        fields.complain(QStringLiteral("\"min\" is above \"max\""));
    for (const auto& bound : {min, max}) {
        if (bound && (*bound < possible.min || *bound > possible.max))
            fields.complain(QStringLiteral("\"min\" or \"max\" does not fit the register"));
    }
}

void readValues(Fields& fields, RegisterDef& def, RawRange possible)
{
    const bool bits = def.reg.encoding == Encoding::Bits;
    const std::int64_t largest = bits ? def.reg.size * 8 - 1 : possible.max;
    const QJsonArray rows = fields.array("values");
    for (const QJsonValue row : rows) {
        Fields item(row);
        NamedValue value;
        item.require("value");
        value.value = static_cast<int>(
            item.integer("value", 0, std::min<std::int64_t>(largest, 65535)).value_or(0));
        value.key = item.word("key");
        value.name = item.text("name");
        QString problem;
        def.valueOnly.push_back(readConditions(item.array("only"), problem));
        if (!problem.isEmpty())
            item.complain(problem);
        bool number = false;
        const auto asNumber = value.key.toLongLong(&number);
        const std::int64_t largestRaw = def.reg.max.value_or(possible.max);
        if (number && asNumber <= largestRaw && asNumber != value.value)
            item.complain(QStringLiteral("the key \"%1\" is another raw value").arg(value.key));
        for (const NamedValue& other : def.reg.values) {
            if (other.value == value.value || other.key == value.key)
                item.complain(QStringLiteral("value or key occurs twice"));
        }
        if (!item.problem().isEmpty())
            fields.complain(QStringLiteral("\"values\": %1").arg(item.problem()));
        def.reg.values.push_back(value);
    }
}

Variant readVariant(const QJsonValue& row, const Register& reg, QString& problem)
{
    Fields fields(row);
    Variant variant;
    variant.andBothLimitsZero = fields.flag("both_limits_zero");
    if (!variant.andBothLimitsZero) {
        variant.whenKey = fields.word("when");
        fields.require("equals");
    }
    variant.mask = fields.integer("mask", 1, LargestRaw).value_or(-1);
    variant.equals = fields.integer("equals", -LargestRaw, LargestRaw).value_or(0);
    if (fields.has("scale"))
        variant.scale = readScale(fields, 1.0);
    if (fields.has("unit"))
        variant.unit = fields.optionalWord("unit");
    if (fields.has("name"))
        variant.name = fields.text("name");
    Encoding encoding = reg.encoding;
    int signBit = reg.signBit;
    if (fields.has("encoding")) {
        readEncoding(fields.word("encoding"), encoding, signBit, fields);
        variant.encoding = encoding;
        variant.signBit = signBit;
    }
    checkFits(reg.size, encoding, signBit, fields);
    variant.min = fields.integer("min", -LargestRaw, LargestRaw);
    variant.max = fields.integer("max", -LargestRaw, LargestRaw);
    if (fields.complaint().isEmpty())
        checkRange(variant.min ? variant.min : reg.min, variant.max ? variant.max : reg.max,
                   representable(reg.size, encoding, signBit), fields);
    if (problem.isEmpty())
        problem = fields.problem();
    return variant;
}

void readShape(Fields& fields, Register& reg, base::Protocol protocol)
{
    reg.key = fields.word("key");
    readPlace(fields, reg, protocol);
    reg.area = fields.oneOf<Area>("area", {{"EPROM", Area::Eprom},
                                           {"SRAM", Area::Sram},
                                           {"FEEDBACK", Area::Feedback},
                                           {"FACTORY", Area::Factory}});
    reg.access =
        fields.oneOf<Access>("access", {{"ro", Access::ReadOnly}, {"rw", Access::ReadWrite}});
    if (protocol == base::Protocol::Lx && reg.writable() != fields.has("write"))
        fields.complain(QStringLiteral("\"write\" and \"access\" contradict each other"));
    reg.persistence = fields.oneOf<Persistence>("persistence",
                                                {{"kept", Persistence::Kept},
                                                 {"lost", Persistence::Lost},
                                                 {"after_save", Persistence::AfterSave},
                                                 {"not_stated", Persistence::NotStated}},
                                                Persistence::ByArea);
    if ((reg.persistence == Persistence::AfterSave) != (reg.saveOffset >= 0))
        fields.complain(QStringLiteral("\"save\" and \"after_save\" belong together"));
    readEncoding(fields.word("encoding"), reg.encoding, reg.signBit, fields);
    checkFits(reg.size, reg.encoding, reg.signBit, fields);
    bool known = true;
    const QString role = fields.optionalWord("role", QStringLiteral("none"));
    reg.role = roleFromWord(role, known);
    if (!known)
        fields.complain(QStringLiteral("unknown role \"%1\"").arg(role.left(40)));
}

void readNumbers(Fields& fields, Register& reg, RawRange possible)
{
    reg.min = fields.integer("min", -LargestRaw, LargestRaw);
    reg.max = fields.integer("max", -LargestRaw, LargestRaw);
    checkRange(reg.min, reg.max, possible, fields);
    reg.defaultRaw = fields.integer("default", possible.min, possible.max);
    reg.warnAbove = fields.integer("warn_above", possible.min, possible.max);
    reg.unit = fields.optionalWord("unit");
    reg.scale = readScale(fields, 1.0);
    reg.scaleBy = fields.optionalWord("scale_by");
}

void readWords(Fields& fields, Register& reg)
{
    reg.name = fields.text("name");
    if (fields.has("help") || reg.writable())
        reg.help = fields.text("help");
    reg.source = fields.optionalWord("source");
    reg.identity = fields.flag("identity");
    reg.dangerous = fields.flag("dangerous");
    reg.motion = fields.flag("motion");
    reg.torqueOff = fields.oneOf<TorqueOff>(
        "torque_off", {{"needed", TorqueOff::Needed}, {"when_both_zero", TorqueOff::WhenBothZero}},
        TorqueOff::NotNeeded);
}

RegisterDef readPlain(const QJsonObject& row, base::Protocol protocol, QString& problem)
{
    Fields fields(row);
    RegisterDef def;
    readShape(fields, def.reg, protocol);
    const RawRange possible = representable(def.reg.size, def.reg.encoding, def.reg.signBit);
    readNumbers(fields, def.reg, possible);
    readValues(fields, def, possible);
    const QJsonArray variants = fields.array("variants");
    for (const QJsonValue variant : variants) {
        QString wrong;
        def.reg.variants.push_back(readVariant(variant, def.reg, wrong));
        if (!wrong.isEmpty())
            fields.complain(QStringLiteral("\"variants\": %1").arg(wrong));
    }
    def.angular = fields.oneOf<Angular>(
        "angular", {{"position", Angular::Position}, {"speed", Angular::Speed}}, Angular::No);
    readWords(fields, def.reg);
    if (problem.isEmpty())
        problem = fields.problem();
    return def;
}

void readRule(const QJsonValue& rule, const QJsonObject& plain, base::Protocol protocol,
              RegisterRow& row, QString& problem)
{
    QJsonObject change = rule.toObject();
    const Condition when = readCondition(change.take(QStringLiteral("when")), problem);
    for (const char* fixed : {"key", "address", "write", "save", "place"}) {
        if (change.contains(QLatin1String(fixed)) && problem.isEmpty())
            problem = QStringLiteral("\"set\" must not change \"%1\"").arg(QLatin1String(fixed));
    }
    QJsonObject merged = plain;
    for (auto it = change.constBegin(); it != change.constEnd(); ++it)
        merged.insert(it.key(), it.value());
    row.set.emplace_back(when, readPlain(merged, protocol, problem));
}
} // namespace

std::optional<RegisterRow> readRegister(const QJsonValue& value, base::Protocol protocol,
                                        QString& problem)
{
    Fields fields(value);
    QJsonObject plain = value.toObject();
    plain.remove(QStringLiteral("only"));
    plain.remove(QStringLiteral("set"));
    RegisterRow row;
    row.only = readConditions(fields.array("only"), problem);
    const QJsonArray rules = fields.array("set");
    if (problem.isEmpty())
        problem = fields.complaint();
    row.base = readPlain(plain, protocol, problem);
    for (const QJsonValue rule : rules)
        readRule(rule, plain, protocol, row, problem);
    return problem.isEmpty() ? std::optional(row) : std::nullopt;
}
} // namespace catalog
