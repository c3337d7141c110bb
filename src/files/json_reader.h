// SPDX-License-Identifier: GPL-3.0-or-later
// Strict reading of JSON from files that may have been edited by hand: each value is read with its
// type; the first one that does not fit is remembered with its path, and reading continues with
// harmless values until the caller checks the error. Other fields are ignored. Values; one thread.
#pragma once

#include "base/error.h"

#include <QDateTime>
#include <QJsonObject>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace files {
/// The top object, or what is wrong with the text and in which line.
tl::expected<QJsonObject, QString> parseJson(const QByteArray& text);

/// The first thing that was wrong: "registers[12].raw: expected a whole number".
class JsonReadError {
public:
    bool isSet() const { return !m_text.isEmpty(); }
    const QString& text() const { return m_text; }
    void set(const QString& path, const QString& what);

private:
    QString m_text;
};

class JsonReader {
public:
    JsonReader(QJsonObject object, JsonReadError& readError, QString path = {})
        : m_object(std::move(object))
        , m_readError(&readError)
        , m_path(std::move(path))
    {}

    const QJsonObject& content() const { return m_object; }
    const QString& path() const { return m_path; } ///< "registers[12]"; empty: the top

    bool contains(const char* key) const;
    QString text(const char* key) const;
    QString nonEmptyText(const char* key) const; ///< not empty
    bool flag(const char* key) const;
    int smallInteger(const char* key) const; ///< fits an int
    std::int64_t integer(const char* key) const;
    std::optional<std::int64_t> integerOrNull(const char* key) const;
    double number(const char* key) const;
    std::optional<double> numberOrNull(const char* key) const;
    std::vector<std::int64_t> integers(const char* key) const;
    std::vector<double> numbers(const char* key) const;
    QStringList texts(const char* key) const;
    QDateTime time(const char* key) const; ///< ISO 8601; answers UTC
    template <typename Enum>               ///< by its name; an unknown one is reported
    Enum enumValue(const char* key, std::optional<Enum> (*fromName)(const QString&)) const
    {
        const QString name = text(key);
        const auto value = fromName(name);
        if (!value)
            reportError(key, QStringLiteral("unknown word \"%1\"").arg(name));
        return value.value_or(Enum());
    }
    JsonReader object(const char* key) const;
    std::vector<JsonReader> objects(const char* key) const;

    void reportError(const char* key, const QString& what) const;

    /// For files where a slip in a name must not go unnoticed.
    void rejectUnknownKeys(const QStringList& known) const;

private:
    QJsonValue value(const char* key) const;
    QString pathOf(const char* key) const;
    std::int64_t integerAt(const QJsonValue& value, const QString& path) const;

    QJsonObject m_object;
    JsonReadError* m_readError;
    QString m_path;
};
} // namespace files
