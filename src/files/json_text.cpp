// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>

#include <cmath>

namespace files {
QByteArray jsonText(const QString& text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.sliced(1, list.size() - 2);
}

QByteArray jsonText(const QStringList& texts)
{
    QByteArray list = "[";
    for (const QString& text : texts)
        list += (list.size() > 1 ? ", " : "") + jsonText(text);
    return list + ']';
}

QByteArray jsonFlag(bool value)
{
    return value ? "true" : "false";
}

QByteArray jsonInteger(std::optional<std::int64_t> value)
{
    return value ? QByteArray::number(qint64(*value)) : QByteArray("null");
}

QByteArray jsonNumber(std::optional<double> value, std::optional<int> digits)
{
    if (!value || !std::isfinite(*value))
        return "null";
    return QByteArray::number(*value, 'g', digits.value_or(QLocale::FloatingPointShortest));
}

JsonObjectWriter& JsonObjectWriter::raw(const char* key, const QByteArray& value)
{
    m_text += (m_text.size() > 1 ? ", \"" : "\"") + QByteArray(key) + "\": " + value;
    return *this;
}
} // namespace files
