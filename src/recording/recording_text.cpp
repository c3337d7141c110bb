// SPDX-License-Identifier: GPL-3.0-or-later
// The writing half, and what both readers share.
#include "recording/recording_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace recording {
namespace {
constexpr base::Duration maxTextTime = std::chrono::hours(24 * 366 * 10);

template <typename Number>
void appendNumber(std::string& out, Number number)
{
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    out.append(digits.data(), end);
}

/// A '#' line is one line, even if the name of a port contains line breaks.
std::string simplifiedText(const QString& text)
{
    return text.simplified().toStdString();
}

/// Quoted where it must be; a line feed within would split the line for simple readers.
std::string cell(const QString& text)
{
    QString plain = text;
    plain.replace(QLatin1Char('\\'), QLatin1String("\\\\"));
    plain.replace(QLatin1Char('\n'), QLatin1String("\\n"));
    plain.replace(QLatin1Char('\r'), QLatin1String("\\r"));
    if (plain.contains(QLatin1Char(',')) || plain.contains(QLatin1Char('"')))
        plain = QLatin1Char('"') + plain.replace(QLatin1Char('"'), QLatin1String("\"\"")) +
                QLatin1Char('"');
    return plain.toStdString();
}

std::string json(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString() + '\n';
}

QString isoTime(const QDateTime& time)
{
    return time.toUTC().toString(Qt::ISODateWithMs);
}
} // namespace

RecordingFormatter::RecordingFormatter(RecordingFormat format, const RecordingHeader& head)
    : m_format(format)
    , m_head(head)
{
    for (std::size_t i = 0; i < head.channels.size(); ++i) {
        const RecordingChannel& channel = head.channels[i];
        auto servo = std::find_if(m_servos.begin(), m_servos.end(), [&channel](const Servo& one) {
            return one.number == channel.servo;
        });
        if (servo == m_servos.end())
            servo = m_servos.insert(servo, {channel.servo, uniqueLabel(channel.servoId), {}});
        servo->cells.push_back(i);
    }
}

std::string RecordingFormatter::uniqueLabel(int servoId) const
{
    std::string label = std::to_string(servoId);
    const auto taken = [&label](const Servo& servo) { return servo.label == label; };
    while (std::any_of(m_servos.begin(), m_servos.end(), taken))
        label += '\'';
    return label;
}

const RecordingFormatter::Servo* RecordingFormatter::servoOf(int number) const
{
    for (const Servo& servo : m_servos) {
        if (servo.number == number)
            return &servo;
    }
    return nullptr;
}

std::string RecordingFormatter::head() const
{
    return m_format == RecordingFormat::Csv ? csvHeader() : jsonHeader();
}

std::string RecordingFormatter::csvHeader() const
{
    std::string text = "# ServoDesk recording " + std::to_string(recordingVersion) + '\n';
    text += "# started " + isoTime(m_head.started).toStdString() + '\n';
    text += "# program " + simplifiedText(m_head.program) + '\n';
    text += "# port " + simplifiedText(m_head.port) + '\n';
    text += "# baud " + std::to_string(m_head.baud) + '\n';
    text += std::string("# simulated ") + (m_head.simulated ? "yes" : "no") + '\n';
    for (const Servo& servo : m_servos) {
        const RecordingChannel& channel = m_head.channels[servo.cells.front()];
        text += "# servo " + servo.label + ' ' + std::to_string(servo.number) + ' ' +
                std::to_string(channel.servoId) + ' ' + simplifiedText(channel.protocol) + ' ' +
                simplifiedText(channel.servoName) + '\n';
    }
    text += "time_us,servo";
    for (const RecordingChannel& channel : m_head.channels) {
        const QString label = QString::fromStdString(servoOf(channel.servo)->label);
        text += ',' + cell(QStringLiteral("%1.%2[%3]").arg(label, channel.key, channel.unit));
    }
    return text + ",marks\n";
}

std::string RecordingFormatter::jsonHeader() const
{
    QJsonArray channels;
    for (const RecordingChannel& channel : m_head.channels)
        channels.append(QJsonObject{{QStringLiteral("servo"), channel.servo},
                                    {QStringLiteral("id"), channel.servoId},
                                    {QStringLiteral("protocol"), channel.protocol},
                                    {QStringLiteral("name"), channel.servoName},
                                    {QStringLiteral("key"), channel.key},
                                    {QStringLiteral("unit"), channel.unit}});
    return json({{QStringLiteral("format"), QStringLiteral("servodesk-recording")},
                 {QStringLiteral("version"), recordingVersion},
                 {QStringLiteral("started"), isoTime(m_head.started)},
                 {QStringLiteral("program"), m_head.program},
                 {QStringLiteral("port"), m_head.port},
                 {QStringLiteral("baud"), m_head.baud},
                 {QStringLiteral("simulated"), m_head.simulated},
                 {QStringLiteral("channels"), channels}});
}

bool RecordingFormatter::row(base::Duration at, const RecordingRow& row, std::string& out) const
{
    const Servo* servo = servoOf(row.servo);
    if (!servo)
        return false;
    const auto value = [&row](std::size_t i) {
        return i < row.values.size() ? row.values[i] : std::numeric_limits<double>::quiet_NaN();
    };
    if (m_format == RecordingFormat::JsonLines) {
        out += "{\"t\":";
        appendNumber(out, at.count());
        out += ",\"s\":";
        appendNumber(out, servo->number);
        out += ",\"v\":[";
        for (std::size_t i = 0; i < servo->cells.size(); ++i) {
            if (i > 0)
                out += ',';
            if (std::isfinite(value(i)))
                appendNumber(out, value(i));
            else
                out += "null";
        }
        out += "]}\n";
        return true;
    }
    appendNumber(out, at.count());
    out += ',';
    out += servo->label;
    std::size_t column = 0;
    for (std::size_t i = 0; i < servo->cells.size(); ++i) {
        out.append(servo->cells[i] + 1 - column, ',');
        column = servo->cells[i] + 1;
        if (std::isfinite(value(i)))
            appendNumber(out, value(i));
    }
    out.append(m_head.channels.size() + 1 - column, ',');
    out += '\n';
    return true;
}

void RecordingFormatter::mark(base::Duration at, const Mark& mark, std::string& out) const
{
    if (m_format == RecordingFormat::JsonLines) {
        out += json({{QStringLiteral("t"), qint64(at.count())},
                     {QStringLiteral("mark"), markName(mark.kind)},
                     {QStringLiteral("id"), mark.servoId},
                     {QStringLiteral("text"), mark.text}});
        return;
    }
    appendNumber(out, at.count());
    out.append(m_head.channels.size() + 2, ',');
    const QString id = mark.servoId < 0 ? QStringLiteral("-") : QString::number(mark.servoId);
    out += cell(QStringLiteral("%1 %2 ").arg(markName(mark.kind), id) + mark.text);
    out += '\n';
}

void RecordingLine::clear()
{
    isRow = false;
    mark.reset();
}

std::pair<std::size_t, std::size_t> RecordingReader::addChannel(const RecordingChannel& channel)
{
    auto servo = servoOf(channel.servo);
    if (!servo) {
        servo = m_numbers.size();
        m_numbers.push_back(channel.servo);
        m_servos.emplace_back();
    }
    auto& its = m_servos[*servo];
    its.push_back(m_head.channels.size());
    m_head.channels.push_back(channel);
    return {*servo, its.size() - 1};
}

std::optional<std::size_t> RecordingReader::servoOf(int number) const
{
    const auto found = std::find(m_numbers.begin(), m_numbers.end(), number);
    if (found == m_numbers.end())
        return std::nullopt;
    return std::size_t(found - m_numbers.begin());
}

std::optional<double> parseNumber(std::string_view text)
{
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::optional<base::Duration> parseInstant(std::string_view text)
{
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() ||
        !isValidTime(base::Duration(number)))
        return std::nullopt;
    return base::Duration(number);
}

bool isValidTime(base::Duration at)
{
    return at >= -maxTextTime && at <= maxTextTime;
}
} // namespace recording
