// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of JSON text, for files whose order of lines matters to readers and version control.
// Pure; any thread. What is no number (NaN, infinity) is null.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace files {
QByteArray jsonText(const QString& text);
QByteArray jsonText(const QStringList& texts);
QByteArray jsonFlag(bool value);

/// The shortest text that reads as the same number again; with `digits`, not more of them.
QByteArray jsonNumber(std::optional<double> value, std::optional<int> digits = {});
/// Significant digits of a register's value in its unit: enough for every register, and without the
/// noise of raw × scale.
inline constexpr int registerValueDigits = 12;
/// An integer, or null.
QByteArray jsonInteger(std::optional<std::int64_t> value);

/// A list on one line; `write` makes the JSON of an item.
template <typename Items, typename Write>
QByteArray jsonList(const Items& items, const Write& write)
{
    QByteArray text = "[";
    for (const auto& item : items)
        text += (text.size() > 1 ? ", " : "") + write(item);
    return text + ']';
}

/// A list with an item per line; `indent` is that of the line it begins on.
template <typename Items, typename Write>
QByteArray jsonLines(const Items& items, const QByteArray& indent, const Write& write)
{
    QByteArray text;
    for (const auto& item : items)
        text += (text.isEmpty() ? "\n" : ",\n") + indent + "  " + write(item);
    return text.isEmpty() ? QByteArray("[]") : '[' + text + '\n' + indent + ']';
}

/// One object on one line, its members in the order they are added.
class JsonObjectWriter {
public:
    JsonObjectWriter& raw(const char* key, const QByteArray& value);
    JsonObjectWriter& text(const char* key, const QString& value)
    {
        return raw(key, jsonText(value));
    }
    JsonObjectWriter& flag(const char* key, bool value) { return raw(key, jsonFlag(value)); }
    JsonObjectWriter& number(const char* key, std::optional<double> value)
    {
        return raw(key, jsonNumber(value));
    }
    JsonObjectWriter& integer(const char* key, std::int64_t value)
    {
        return raw(key, QByteArray::number(qint64(value)));
    }
    QByteArray done() const { return m_text + '}'; }

private:
    QByteArray m_text = "{";
};
} // namespace files
