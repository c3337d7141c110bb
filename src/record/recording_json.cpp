// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording's JSON lines. Rows as this program writes them are read by hand, because
// there are millions; whatever else is valid JSON goes the long way.
#include "record/json_reader.h"
#include "record/recording_text.h"

#include <QJsonArray>

#include <charconv>
#include <cmath>
#include <limits>

namespace record {
namespace {
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

QByteArray bytesOf(std::string_view text)
{
    return QByteArray::fromRawData(text.data(), qsizetype(text.size()));
}

/// Walks through a line; once something does not fit, ok() stays false.
class Scan {
public:
    explicit Scan(std::string_view text)
        : m_text(text)
    {}
    bool ok() const { return m_ok; }
    bool atEnd() const { return m_text.empty(); }

    bool skips(std::string_view expected)
    {
        if (m_text.substr(0, expected.size()) != expected)
            return false;
        m_text.remove_prefix(expected.size());
        return true;
    }
    void need(std::string_view expected) { m_ok = skips(expected) && m_ok; }
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
    tl::expected<Head, QString> takeHead(std::string_view line) override;
    Verdict take(std::string_view line, RecordingLine& out) override;

private:
    bool takeOwn(std::string_view line, RecordingLine& out) const;
    bool takeRow(const JsonReader& reader, const QJsonArray& values, RecordingLine& out) const;
};

tl::expected<RecordingReader::Head, QString> JsonLinesReader::takeHead(std::string_view line)
{
    const auto object = parseJson(bytesOf(line));
    if (!object)
        return tl::unexpected(object.error());
    JsonComplaint complaint;
    const JsonReader reader(*object, complaint);
    if (reader.text("format") != QLatin1String("servodesk-recording"))
        return tl::unexpected(QStringLiteral("no recording: \"format\" is not "
                                             "\"servodesk-recording\""));
    const int version = reader.small("version");
    if (version > recordingVersion)
        return tl::unexpected(QStringLiteral("format version %1, this program knows %2")
                                  .arg(version)
                                  .arg(recordingVersion));
    if (!reader.text("started").isEmpty())
        m_head.started = reader.time("started");
    m_head.program = reader.text("program");
    m_head.port = reader.text("port");
    m_head.baud = reader.small("baud");
    m_head.simulated = reader.flag("simulated");
    for (const JsonReader& channel : reader.objects("channels"))
        addChannel({channel.small("servo"), channel.small("id"), channel.text("name"),
                    channel.text("protocol"), channel.filledText("key"), channel.text("unit")});
    if (complaint.made())
        return tl::unexpected(complaint.text());
    if (m_head.channels.empty())
        return tl::unexpected(QStringLiteral("channels: none"));
    return Head::Complete;
}

bool JsonLinesReader::takeOwn(std::string_view line, RecordingLine& out) const
{
    Scan scan(line);
    scan.need("{\"t\":");
    const auto at = base::Duration(scan.number<std::int64_t>());
    scan.need(",\"s\":");
    const auto servo = servoOf(scan.number<int>());
    scan.need(",\"v\":[");
    if (!scan.ok() || !servo)
        return false;
    out.values.assign(servos()[*servo].size(), nothing);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        if (i > 0)
            scan.need(",");
        if (!scan.skips("null"))
            out.values[i] = scan.number<double>();
    }
    scan.need("]}");
    if (!scan.ok() || !scan.atEnd())
        return false;
    out.at = at;
    out.servo = *servo;
    out.isRow = true;
    return true;
}

bool JsonLinesReader::takeRow(const JsonReader& reader, const QJsonArray& values,
                              RecordingLine& out) const
{
    const auto servo = servoOf(reader.small("s"));
    if (!servo || std::size_t(values.size()) != servos()[*servo].size())
        return false;
    out.values.clear();
    for (const QJsonValue& value : values) {
        if (!value.isDouble() && !value.isNull())
            return false;
        out.values.push_back(value.toDouble(nothing));
    }
    out.servo = *servo;
    out.isRow = true;
    return true;
}

RecordingReader::Verdict JsonLinesReader::take(std::string_view line, RecordingLine& out)
{
    out.clear();
    if (line.find_first_not_of(" \t") == line.npos)
        return Verdict::Nothing;
    if (takeOwn(line, out))
        return inTime(out.at) ? Verdict::Content : Verdict::Bad;
    const auto object = parseJson(bytesOf(line));
    if (!object)
        return Verdict::Bad;
    JsonComplaint complaint;
    const JsonReader reader(*object, complaint);
    out.at = base::Duration(reader.integer("t"));
    if (reader.has("mark")) {
        const auto kind = markFromName(reader.text("mark"));
        if (!kind)
            return Verdict::Bad;
        out.mark = Mark{out.at, *kind, reader.small("id"), reader.text("text")};
    } else if (!takeRow(reader, object->value(QLatin1String("v")).toArray(), out)) {
        return Verdict::Bad;
    }
    return complaint.made() || !inTime(out.at) ? Verdict::Bad : Verdict::Content;
}
} // namespace

std::unique_ptr<RecordingReader> makeJsonLinesReader()
{
    return std::make_unique<JsonLinesReader>();
}
} // namespace record
