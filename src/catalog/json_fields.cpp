// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_fields.h"

#include <cmath>

namespace catalog {
namespace {
constexpr int maxTextLength = 4000;
}

JsonFields::JsonFields(const QJsonValue& value)
    : m_object(value.toObject())
{
    if (!value.isObject())
        addError(QStringLiteral("not an object"));
}

bool JsonFields::has(const char* name) const
{
    return m_object.contains(QLatin1String(name));
}

QJsonValue JsonFields::readMember(const char* name)
{
    m_readNames << QLatin1String(name);
    return m_object.value(QLatin1String(name));
}

QJsonValue JsonFields::value(const char* name)
{
    return readMember(name);
}

void JsonFields::addError(const QString& errorText)
{
    if (m_errorText.isEmpty())
        m_errorText = errorText;
}

void JsonFields::require(const char* name)
{
    if (!has(name))
        addError(QStringLiteral("\"%1\" is missing").arg(QLatin1String(name)));
}

QString JsonFields::string(const char* name)
{
    const QString member = optionalString(name);
    if (member.isEmpty())
        addError(QStringLiteral("\"%1\" is missing").arg(QLatin1String(name)));
    return member;
}

QString JsonFields::optionalString(const char* name, const QString& fallback)
{
    const QJsonValue member = readMember(name);
    if (member.isUndefined())
        return fallback;
    if (!member.isString() || member.toString().size() > maxTextLength)
        addError(
            QStringLiteral("\"%1\" is not a text of reasonable length").arg(QLatin1String(name)));
    return member.toString();
}

std::optional<std::int64_t> JsonFields::integer(const char* name, std::int64_t min,
                                                std::int64_t max)
{
    const QJsonValue member = readMember(name);
    if (member.isUndefined())
        return std::nullopt;
    const double number = member.toDouble(std::nan(""));
    if (!(number >= static_cast<double>(min) && number <= static_cast<double>(max)) ||
        number != std::floor(number)) {
        addError(QStringLiteral("\"%1\" is not a whole number from %2 to %3")
                     .arg(QLatin1String(name))
                     .arg(min)
                     .arg(max));
        return std::nullopt;
    }
    return static_cast<std::int64_t>(number);
}

std::optional<double> JsonFields::number(const char* name)
{
    const QJsonValue member = readMember(name);
    if (member.isUndefined())
        return std::nullopt;
    if (!member.isDouble() || !std::isfinite(member.toDouble()))
        addError(QStringLiteral("\"%1\" is not a number").arg(QLatin1String(name)));
    return member.toDouble();
}

bool JsonFields::flag(const char* name, bool fallback)
{
    const QJsonValue member = readMember(name);
    if (member.isUndefined())
        return fallback;
    if (!member.isBool())
        addError(QStringLiteral("\"%1\" is neither true nor false").arg(QLatin1String(name)));
    return member.toBool();
}

Text JsonFields::text(const char* name)
{
    JsonFields languages(readMember(name));
    const Text text{languages.string("en"), languages.string("zh")};
    if (const QString errorText = languages.errorText(); !errorText.isEmpty())
        addError(QStringLiteral("\"%1\": %2").arg(QLatin1String(name), errorText));
    return text;
}

std::optional<Version> JsonFields::version(const char* name)
{
    if (!has(name)) {
        readMember(name);
        return std::nullopt;
    }
    const auto version = parseVersion(string(name));
    if (!version)
        addError(QStringLiteral("\"%1\" is not a version like \"2.48\"").arg(QLatin1String(name)));
    return version;
}

QJsonArray JsonFields::array(const char* name)
{
    const QJsonValue member = readMember(name);
    if (!member.isUndefined() && !member.isArray())
        addError(QStringLiteral("\"%1\" is not a list").arg(QLatin1String(name)));
    return member.toArray();
}

QString JsonFields::errorText() const
{
    if (!m_errorText.isEmpty())
        return m_errorText;
    const QStringList names = m_object.keys();
    for (const QString& name : names) {
        if (!m_readNames.contains(name) && name != QLatin1String("comment"))
            return QStringLiteral("unknown member \"%1\"").arg(name.left(40));
    }
    return {};
}

std::optional<Version> parseVersion(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('.'));
    if (parts.size() != 2)
        return std::nullopt;
    bool majorOk = false;
    bool minorOk = false;
    const Version version{parts[0].toInt(&majorOk), parts[1].toInt(&minorOk)};
    const auto isByte = [](int number) { return number >= 0 && number <= 255; };
    if (!majorOk || !minorOk || !isByte(version.major) || !isByte(version.minor))
        return std::nullopt;
    return version;
}

base::Protocol readProtocol(JsonFields& fields)
{
    const QString string = fields.optionalString("protocol", base::protocolName({}));
    const auto protocol = base::protocolFromName(string);
    if (!protocol)
        fields.addError(QStringLiteral("unknown protocol \"%1\"").arg(string.left(40)));
    return protocol.value_or(base::Protocol{});
}

Condition readCondition(const QJsonValue& value, QString& errorText)
{
    JsonFields fields(value);
    Condition condition;
    const QJsonArray series = fields.array("series");
    for (const QJsonValue string : series) {
        if (!string.isString())
            fields.addError(QStringLiteral("\"series\" is not a list of words"));
        condition.series << string.toString();
    }
    condition.from = fields.version("firmware_from");
    condition.to = fields.version("firmware_to");
    if (errorText.isEmpty())
        errorText = fields.errorText();
    return condition;
}

std::vector<Condition> readConditions(const QJsonArray& array, QString& errorText)
{
    std::vector<Condition> conditions;
    for (const QJsonValue value : array)
        conditions.push_back(readCondition(value, errorText));
    return conditions;
}
} // namespace catalog
