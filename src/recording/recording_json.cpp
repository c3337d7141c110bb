// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording's JSON lines. Rows as this program writes them have a parser of their own,
// because there are millions; all other valid JSON is read by the general parser.
#include "files/json_reader.h"
#include "recording/recording_text.h"

#include <QJsonArray>

#include <charconv>
#include <cmath>
#include <limits>

namespace recording {
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

QByteArray bytesOf(std::string_view text)
{
    return QByteArray::fromRawData(text.data(), qsizetype(text.size()));
}

/// Parses a line; after the first mismatch ok() stays false.
class TextScanner {
public:
    explicit TextScanner(std::string_view text)
        : m_text(text)
    {}
    bool ok() const { return m_ok; }
    bool atEnd() const { return m_text.empty(); }

    bool skipText(std::string_view expected)
    {
        if (m_text.substr(0, expected.size()) != expected)
            return false;
        m_text.remove_prefix(expected.size());
        return true;
    }
    void expect(std::string_view expected) { m_ok = skipText(expected) && m_ok; }
    template <typename Number>
    Number number()
    {
        Number number{};
        const auto [end, error] =
            std::from_chars(m_text.data(), m_text.data() + m_text.size(), number);
        m_ok = m_ok && error == std::errc() && std::isfinite(double(number));
        m_text.remove_prefix(std::size_t(end - m_text.data()));
        return number;
    }

private:
    std::string_view m_text;
    bool m_ok = true;
};

class JsonLinesReader final : public RecordingReader {
public:
    tl::expected<HeaderState, QString> parseHeader(std::string_view line) override;
    LineKind take(std::string_view line, RecordingLine& out) override;

private:
    bool parseOwnLine(std::string_view line, RecordingLine& out) const;
    bool parseRow(const files::JsonReader& reader, const QJsonArray& values,
                  RecordingLine& out) const;
};

tl::expected<RecordingReader::HeaderState, QString>
JsonLinesReader::parseHeader(std::string_view line)
{
    const auto object = files::parseJson(bytesOf(line));
    if (!object)
        return tl::unexpected(object.error());
    files::JsonReadError readError;
    const files::JsonReader reader(*object, readError);
    if (reader.text("format") != QLatin1String("servodesk-recording"))
        return tl::unexpected(QStringLiteral("no recording: \"format\" is not "
                                             "\"servodesk-recording\""));
    const int version = reader.smallInteger("version");
    if (version > recordingVersion)
        return tl::unexpected(QStringLiteral("format version %1, this program knows %2")
                                  .arg(version)
                                  .arg(recordingVersion));
    if (!reader.text("started").isEmpty())
        m_head.started = reader.time("started");
    m_head.program = reader.text("program");
    m_head.port = reader.text("port");
    m_head.baud = reader.smallInteger("baud");
    m_head.simulated = reader.flag("simulated");
    for (const files::JsonReader& channel : reader.objects("channels"))
        addChannel({channel.smallInteger("servo"), channel.smallInteger("id"), channel.text("name"),
                    channel.text("protocol"), channel.nonEmptyText("key"), channel.text("unit")});
    if (readError.isSet())
        return tl::unexpected(readError.text());
    if (m_head.channels.empty())
        return tl::unexpected(QStringLiteral("channels: none"));
    return HeaderState::Complete;
}

bool JsonLinesReader::parseOwnLine(std::string_view line, RecordingLine& out) const
{
    TextScanner scan(line);
    scan.expect("{\"t\":");
    const auto at = base::Duration(scan.number<std::int64_t>());
    scan.expect(",\"s\":");
    const auto servo = servoOf(scan.number<int>());
    scan.expect(",\"v\":[");
    if (!scan.ok() || !servo)
        return false;
    out.values.assign(servos()[*servo].size(), nan);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        if (i > 0)
            scan.expect(",");
        if (!scan.skipText("null"))
            out.values[i] = scan.number<double>();
    }
    scan.expect("]}");
    if (!scan.ok() || !scan.atEnd())
        return false;
    out.at = at;
    out.servo = *servo;
    out.isRow = true;
    return true;
}

bool JsonLinesReader::parseRow(const files::JsonReader& reader, const QJsonArray& values,
                               RecordingLine& out) const
{
    const auto servo = servoOf(reader.smallInteger("s"));
    if (!servo || std::size_t(values.size()) != servos()[*servo].size())
        return false;
    out.values.clear();
    for (const QJsonValue& value : values) {
        if (!value.isDouble() && !value.isNull())
            return false;
        out.values.push_back(value.toDouble(nan));
    }
    out.servo = *servo;
    out.isRow = true;
    return true;
}

RecordingReader::LineKind JsonLinesReader::take(std::string_view line, RecordingLine& out)
{
    out.clear();
    if (line.find_first_not_of(" \t") == line.npos)
        return LineKind::Blank;
    if (parseOwnLine(line, out))
        return isValidTime(out.at) ? LineKind::Content : LineKind::Invalid;
    const auto object = files::parseJson(bytesOf(line));
    if (!object)
        return LineKind::Invalid;
    files::JsonReadError readError;
    const files::JsonReader reader(*object, readError);
    out.at = base::Duration(reader.integer("t"));
    if (reader.contains("mark")) {
        const auto kind = markFromName(reader.text("mark"));
        if (!kind)
            return LineKind::Invalid;
        out.mark = Mark{out.at, *kind, reader.smallInteger("id"), reader.text("text")};
    } else if (!parseRow(reader, object->value(QLatin1String("v")).toArray(), out)) {
        return LineKind::Invalid;
    }
    return readError.isSet() || !isValidTime(out.at) ? LineKind::Invalid : LineKind::Content;
}
} // namespace

std::unique_ptr<RecordingReader> makeJsonLinesReader()
{
    return std::make_unique<JsonLinesReader>();
}
} // namespace recording
