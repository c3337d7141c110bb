// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the members of one JSON object and remembers the first thing that is wrong with it: a
// missing or mistyped member, a number out of bounds, an unknown word, a member that was not asked
// for (a typing slip in "max" must not silently lift a limit). One thread.
#pragma once

#include "catalog/definition.h"

#include <QJsonArray>
#include <QJsonObject>

#include <initializer_list>
#include <utility>

namespace catalog {
class JsonFields {
public:
    explicit JsonFields(const QJsonValue& value);

    bool has(const char* name) const;
    QString string(const char* name); ///< required, not empty
    QString optionalString(const char* name, const QString& fallback = {});
    std::optional<std::int64_t> integer(const char* name, std::int64_t min, std::int64_t max);
    std::optional<double> number(const char* name);
    bool flag(const char* name, bool fallback = false);
    Text text(const char* name);                      ///< {"en", "zh"}; required
    std::optional<Version> version(const char* name); ///< "2.48"
    QJsonArray array(const char* name);
    QJsonValue value(const char* name);

    template <typename T>
    T oneOf(const char* name, std::initializer_list<std::pair<const char*, T>> names,
            std::optional<T> fallback = std::nullopt)
    {
        const QString member = fallback ? optionalString(name) : string(name);
        if (member.isEmpty() && fallback)
            return *fallback;
        for (const auto& [key, result] : names) {
            if (member == QLatin1String(key))
                return result;
        }
        addError(QStringLiteral("\"%1\": unknown word \"%2\"").arg(QLatin1String(name), member));
        return fallback.value_or(T{});
    }

    void addError(const QString& errorText);
    void require(const char* name); ///< an error if the member is missing

    /// The first error so far, while members are still to be read.
    const QString& firstError() const { return m_errorText; }

    /// The first error, or a member that was not read; empty if the object is valid.
    QString errorText() const;

private:
    QJsonValue readMember(const char* name);

    QJsonObject m_object;
    QStringList m_readNames;
    QString m_errorText;
};

/// "3.10" → {3, 10}; nullopt if it is not two numbers 0–255.
std::optional<Version> parseVersion(const QString& text);

/// A condition object: series, firmware_from, firmware_to.
Condition readCondition(const QJsonValue& value, QString& errorText);
std::vector<Condition> readConditions(const QJsonArray& array, QString& errorText);

/// "protocol"; Feetech if left out.
base::Protocol readProtocol(JsonFields& fields);

std::optional<Role> roleFromName(const QString& name);
} // namespace catalog
