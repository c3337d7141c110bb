// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_reader.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>
#include <limits>

namespace files {
namespace {
// JSON numbers beyond this are not exact in every program that reads them.
constexpr double exactLimit = 9007199254740992.0;

QString indexed(const QString& path, qsizetype index)
{
    return QStringLiteral("%1[%2]").arg(path).arg(index);
}
} // namespace

tl::expected<QJsonObject, QString> parseJson(const QByteArray& text)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        const auto line = text.left(error.offset).count('\n') + 1;
        return tl::unexpected(QStringLiteral("line %1: %2").arg(line).arg(error.errorString()));
    }
    if (!document.isObject())
        return tl::unexpected(QStringLiteral("line 1: expected an object"));
    return document.object();
}

void JsonReadError::set(const QString& path, const QString& what)
{
    if (!isSet())
        m_text = path + QStringLiteral(": ") + what;
}

bool JsonReader::contains(const char* key) const
{
    return m_object.contains(QLatin1String(key));
}

QString JsonReader::text(const char* key) const
{
    const QJsonValue found = value(key);
    if (!found.isString())
        reportError(key, QStringLiteral("expected a text"));
    return found.toString();
}

QString JsonReader::nonEmptyText(const char* key) const
{
    const QString found = text(key);
    if (found.isEmpty())
        reportError(key, QStringLiteral("must not be empty"));
    return found;
}

bool JsonReader::flag(const char* key) const
{
    const QJsonValue found = value(key);
    if (!found.isBool())
        reportError(key, QStringLiteral("expected true or false"));
    return found.toBool();
}

int JsonReader::smallInteger(const char* key) const
{
    const std::int64_t found = integer(key);
    if (found < std::numeric_limits<int>::min() || found > std::numeric_limits<int>::max()) {
        reportError(key, QStringLiteral("number too large"));
        return 0;
    }
    return int(found);
}

std::int64_t JsonReader::integer(const char* key) const
{
    return integerAt(value(key), pathOf(key));
}

std::optional<std::int64_t> JsonReader::integerOrNull(const char* key) const
{
    if (value(key).isNull())
        return std::nullopt;
    return integer(key);
}

double JsonReader::number(const char* key) const
{
    const auto found = numberOrNull(key);
    if (!found)
        reportError(key, QStringLiteral("expected a number"));
    return found.value_or(0);
}

std::optional<double> JsonReader::numberOrNull(const char* key) const
{
    const QJsonValue found = value(key);
    if (found.isNull())
        return std::nullopt;
    if (!found.isDouble())
        reportError(key, QStringLiteral("expected a number or null"));
    return found.toDouble();
}

std::vector<std::int64_t> JsonReader::integers(const char* key) const
{
    std::vector<std::int64_t> numbers;
    const QJsonValue found = value(key);
    if (!found.isArray())
        reportError(key, QStringLiteral("expected a list"));
    for (const QJsonValue item : found.toArray())
        numbers.push_back(integerAt(item, indexed(pathOf(key), qsizetype(numbers.size()))));
    return numbers;
}

std::vector<double> JsonReader::numbers(const char* key) const
{
    std::vector<double> numbers;
    const QJsonValue found = value(key);
    if (!found.isArray())
        reportError(key, QStringLiteral("expected a list"));
    for (const QJsonValue item : found.toArray()) {
        if (!item.isDouble())
            m_readError->set(indexed(pathOf(key), qsizetype(numbers.size())),
                             QStringLiteral("expected a number"));
        numbers.push_back(item.toDouble());
    }
    return numbers;
}

QStringList JsonReader::texts(const char* key) const
{
    QStringList texts;
    const QJsonValue found = value(key);
    if (!found.isArray())
        reportError(key, QStringLiteral("expected a list"));
    for (const QJsonValue item : found.toArray()) {
        if (!item.isString())
            m_readError->set(indexed(pathOf(key), texts.size()), QStringLiteral("expected a text"));
        texts.append(item.toString());
    }
    return texts;
}

QDateTime JsonReader::time(const char* key) const
{
    const QDateTime found = QDateTime::fromString(text(key), Qt::ISODateWithMs);
    if (!found.isValid())
        reportError(key, QStringLiteral("expected a time like 2025-01-31T12:00:00Z"));
    return found.toUTC();
}

JsonReader JsonReader::object(const char* key) const
{
    const QJsonValue found = value(key);
    if (!found.isObject())
        reportError(key, QStringLiteral("expected an object"));
    return {found.toObject(), *m_readError, pathOf(key)};
}

std::vector<JsonReader> JsonReader::objects(const char* key) const
{
    std::vector<JsonReader> readers;
    const QJsonValue found = value(key);
    if (!found.isArray())
        reportError(key, QStringLiteral("expected a list"));
    for (const QJsonValue item : found.toArray()) {
        const QString path = indexed(pathOf(key), qsizetype(readers.size()));
        if (!item.isObject())
            m_readError->set(path, QStringLiteral("expected an object"));
        readers.emplace_back(item.toObject(), *m_readError, path);
    }
    return readers;
}

void JsonReader::reportError(const char* key, const QString& what) const
{
    m_readError->set(pathOf(key), what);
}

void JsonReader::rejectUnknownKeys(const QStringList& known) const
{
    for (auto it = m_object.begin(); it != m_object.end(); ++it) {
        if (!known.contains(it.key()))
            reportError(qUtf8Printable(it.key()), QStringLiteral("unknown name"));
    }
}

QJsonValue JsonReader::value(const char* key) const
{
    return m_object.value(QLatin1String(key));
}

QString JsonReader::pathOf(const char* key) const
{
    const QString name = QString::fromUtf8(key);
    return m_path.isEmpty() ? name : m_path + QLatin1Char('.') + name;
}

std::int64_t JsonReader::integerAt(const QJsonValue& value, const QString& path) const
{
    const double number = value.toDouble(0.5);
    if (!value.isDouble() || std::abs(number) > exactLimit || number != std::floor(number)) {
        m_readError->set(path, QStringLiteral("expected a whole number"));
        return 0;
    }
    return value.toInteger();
}
} // namespace files
