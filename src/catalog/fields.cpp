// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/fields.h"

#include <cmath>

namespace catalog {
namespace {
constexpr int LongestText = 4000;
}

Fields::Fields(const QJsonValue& value)
    : m_object(value.toObject())
{
    if (!value.isObject())
        complain(QStringLiteral("not an object"));
}

bool Fields::has(const char* name) const
{
    return m_object.contains(QLatin1String(name));
}

QJsonValue Fields::take(const char* name)
{
    m_asked << QLatin1String(name);
    return m_object.value(QLatin1String(name));
}

QJsonValue Fields::value(const char* name)
{
    return take(name);
}

void Fields::complain(const QString& problem)
{
    if (m_problem.isEmpty())
        m_problem = problem;
}

void Fields::require(const char* name)
{
    if (!has(name))
        complain(QStringLiteral("\"%1\" is missing").arg(QLatin1String(name)));
}

QString Fields::word(const char* name)
{
    const QString found = optionalWord(name);
    if (found.isEmpty())
        complain(QStringLiteral("\"%1\" is missing").arg(QLatin1String(name)));
    return found;
}

QString Fields::optionalWord(const char* name, const QString& fallback)
{
    const QJsonValue found = take(name);
    if (found.isUndefined())
        return fallback;
    if (!found.isString() || found.toString().size() > LongestText)
        complain(
            QStringLiteral("\"%1\" is not a text of reasonable length").arg(QLatin1String(name)));
    return found.toString();
}

std::optional<std::int64_t> Fields::integer(const char* name, std::int64_t min, std::int64_t max)
{
    const QJsonValue found = take(name);
    if (found.isUndefined())
        return std::nullopt;
    const double number = found.toDouble(std::nan(""));
    if (!(number >= static_cast<double>(min) && number <= static_cast<double>(max)) ||
        number != std::floor(number)) {
        complain(QStringLiteral("\"%1\" is not a whole number from %2 to %3")
                     .arg(QLatin1String(name))
                     .arg(min)
                     .arg(max));
        return std::nullopt;
    }
    return static_cast<std::int64_t>(number);
}

std::optional<double> Fields::number(const char* name)
{
    const QJsonValue found = take(name);
    if (found.isUndefined())
        return std::nullopt;
    if (!found.isDouble() || !std::isfinite(found.toDouble()))
        complain(QStringLiteral("\"%1\" is not a number").arg(QLatin1String(name)));
    return found.toDouble();
}

bool Fields::flag(const char* name, bool fallback)
{
    const QJsonValue found = take(name);
    if (found.isUndefined())
        return fallback;
    if (!found.isBool())
        complain(QStringLiteral("\"%1\" is neither true nor false").arg(QLatin1String(name)));
    return found.toBool();
}

Text Fields::text(const char* name)
{
    Fields both(take(name));
    const Text text{both.word("en"), both.word("zh")};
    if (const QString problem = both.problem(); !problem.isEmpty())
        complain(QStringLiteral("\"%1\": %2").arg(QLatin1String(name), problem));
    return text;
}

std::optional<Version> Fields::version(const char* name)
{
    if (!has(name)) {
        take(name);
        return std::nullopt;
    }
    const auto version = parseVersion(word(name));
    if (!version)
        complain(QStringLiteral("\"%1\" is not a version like \"2.48\"").arg(QLatin1String(name)));
    return version;
}

QJsonArray Fields::array(const char* name)
{
    const QJsonValue found = take(name);
    if (!found.isUndefined() && !found.isArray())
        complain(QStringLiteral("\"%1\" is not a list").arg(QLatin1String(name)));
    return found.toArray();
}

QString Fields::problem() const
{
    if (!m_problem.isEmpty())
        return m_problem;
    const QStringList names = m_object.keys();
    for (const QString& name : names) {
        if (!m_asked.contains(name) && name != QLatin1String("comment"))
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

base::Protocol readProtocol(Fields& fields)
{
    const QString word = fields.optionalWord("protocol", base::protocolName({}));
    const auto protocol = base::protocolFromName(word);
    if (!protocol)
        fields.complain(QStringLiteral("unknown protocol \"%1\"").arg(word.left(40)));
    return protocol.value_or(base::Protocol{});
}

Condition readCondition(const QJsonValue& value, QString& problem)
{
    Fields fields(value);
    Condition condition;
    const QJsonArray series = fields.array("series");
    for (const QJsonValue word : series) {
        if (!word.isString())
            fields.complain(QStringLiteral("\"series\" is not a list of words"));
        condition.series << word.toString();
    }
    condition.from = fields.version("firmware_from");
    condition.to = fields.version("firmware_to");
    if (problem.isEmpty())
        problem = fields.problem();
    return condition;
}

std::vector<Condition> readConditions(const QJsonArray& array, QString& problem)
{
    std::vector<Condition> conditions;
    for (const QJsonValue value : array)
        conditions.push_back(readCondition(value, problem));
    return conditions;
}
} // namespace catalog
