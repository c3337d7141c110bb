// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/json.h"

#include "cli/output/terminal_text.h"

#include <cmath>

namespace cli {
namespace {
/// Levels of nesting whose elements are on separate lines.
constexpr int openLevels = 2;

QByteArray quoted(const QString& text)
{
    QString out(QLatin1Char('"'));
    for (const QChar c : text) {
        if (isTerminalControl(c)) {
            out += QStringLiteral("\\u%1").arg(int(c.unicode()), 4, 16, QLatin1Char('0'));
            continue;
        }
        if (c == QLatin1Char('"') || c == QLatin1Char('\\'))
            out += QLatin1Char('\\');
        out += c;
    }
    return (out + QLatin1Char('"')).toUtf8();
}

/// The shortest text for this number, without the rounding errors of scales like 0.1 after the
/// ninth decimal.
QByteArray numbered(double value)
{
    if (!std::isfinite(value))
        return "null";
    constexpr double decimals = 1e9;
    const double rounded = std::abs(value) < 1e6 ? std::round(value * decimals) / decimals : value;
    return QByteArray::number(rounded == 0.0 ? 0.0 : rounded, 'g', 15);
}
} // namespace

Json::Json() = default;
Json::Json(bool value)
    : m_value(value)
{}
Json::Json(int value)
    : m_value(std::int64_t{value})
{}
Json::Json(std::int64_t value)
    : m_value(value)
{}
Json::Json(double value)
    : m_value(value)
{}
Json::Json(QString value)
    : m_value(std::move(value))
{}
Json::Json(Array values)
    : m_value(std::move(values))
{}
Json::Json(Object members)
    : m_value(std::move(members))
{}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json::Json(const QStringList& values)
{
    Array array;
    for (const QString& value : values)
        array.emplace_back(value);
    m_value = std::move(array);
}

Json& Json::add(const char* name, Json value)
{
    std::get<Object>(m_value).emplace_back(QString::fromLatin1(name), std::move(value));
    return *this;
}

template <typename Parts, typename WritePart>
void Json::writeParts(QByteArray& out, char open, char close, const Parts& parts, int depth,
                      const WritePart& writePart) const
{
    const bool lines = depth < openLevels && !parts.empty();
    const QByteArray indent(2 * depth, ' ');
    out += open;
    bool first = true;
    for (const auto& part : parts) {
        if (!first)
            out += lines ? "," : ", ";
        first = false;
        if (lines)
            out += '\n' + indent + "  ";
        writePart(part);
    }
    if (lines)
        out += '\n' + indent;
    out += close;
}

void Json::write(QByteArray& out, int depth) const
{
    if (const auto* object = std::get_if<Object>(&m_value)) {
        writeParts(out, '{', '}', *object, depth, [&](const auto& member) {
            out += quoted(member.first) + ": ";
            member.second.write(out, depth + 1);
        });
    } else if (const auto* array = std::get_if<Array>(&m_value)) {
        writeParts(out, '[', ']', *array, depth,
                   [&](const Json& element) { element.write(out, depth + 1); });
    } else if (const auto* text = std::get_if<QString>(&m_value)) {
        out += quoted(*text);
    } else if (const auto* number = std::get_if<double>(&m_value)) {
        out += numbered(*number);
    } else if (const auto* whole = std::get_if<std::int64_t>(&m_value)) {
        out += QByteArray::number(qlonglong(*whole));
    } else if (const auto* flag = std::get_if<bool>(&m_value)) {
        out += *flag ? "true" : "false";
    } else {
        out += "null";
    }
}

QByteArray Json::text() const
{
    QByteArray out;
    write(out, 0);
    return out + '\n';
}

QByteArray Json::compact() const
{
    QByteArray out;
    write(out, openLevels);
    return out;
}
} // namespace cli
