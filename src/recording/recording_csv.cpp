// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording's CSV, also after editing in a spreadsheet program or by hand: columns
// may have been moved, left out or added, cells quoted, '#' lines padded with commas.
#include "files/csv_line_parser.h"
#include "recording/recording_text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace recording {
namespace {
constexpr std::string_view title = "# ServoDesk recording ";

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

std::optional<int> parseInt(std::string_view text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// Takes what is before the next blank.
std::string_view nextWord(std::string_view& text)
{
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

QString unescaped(std::string_view text)
{
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            plain += text[i];
            continue;
        }
        ++i;
        plain += text[i] == 'n' ? '\n' : text[i] == 'r' ? '\r' : text[i];
    }
    return toQString(plain);
}

std::optional<Mark> parseMark(std::string_view text, base::Duration at)
{
    const auto kind = markFromName(toQString(nextWord(text)));
    const std::string_view id = nextWord(text);
    const std::optional<int> number = id == "-" ? std::optional(-1) : parseInt(id);
    if (!kind || !number)
        return std::nullopt;
    return Mark{at, *kind, *number, unescaped(text)};
}

class CsvReader final : public RecordingReader {
public:
    tl::expected<HeaderState, QString> parseHeader(std::string_view line) override;
    LineKind take(std::string_view line, RecordingLine& out) override;

private:
    struct Column {
        enum class Kind : std::uint8_t { Other, Time, Servo, Value, Marks };
        Kind kind = Kind::Other;
        std::size_t servo = 0;
        std::size_t place = 0; ///< among that servo's values
    };
    struct NamedServo {
        std::string label;
        RecordingChannel servo;
    };

    tl::expected<HeaderState, QString> parseTitle(std::string_view line);
    void parseComment(std::string_view comment);
    void parseServo(std::string_view comment);
    tl::expected<HeaderState, QString> parseColumns(std::string_view line);
    Column findColumn(std::string_view name);
    std::optional<std::size_t> findServoByLabel(std::string_view label) const;

    bool m_hasTitle = false;
    std::vector<NamedServo> m_namedServos;
    std::vector<Column> m_columns;
    std::size_t m_time = 0;
    std::size_t m_servo = 0;
    std::vector<std::pair<std::string, std::size_t>> m_labels;
    files::CsvLineParser m_cells;
};

tl::expected<RecordingReader::HeaderState, QString> CsvReader::parseHeader(std::string_view line)
{
    if (line.substr(0, 2) == "\"#")
        line = m_cells.split(line).front();
    const bool comment = line.substr(0, 1) == "#";
    const bool blank = line.find_first_not_of(", \t") == line.npos;
    if (m_hasTitle && !comment && !blank)
        return parseColumns(line);
    while (comment && (line.back() == ',' || line.back() == ' '))
        line.remove_suffix(1);
    if (!m_hasTitle)
        return parseTitle(line);
    if (comment)
        parseComment(files::trimmed(line.substr(1)));
    return HeaderState::More;
}

tl::expected<RecordingReader::HeaderState, QString> CsvReader::parseTitle(std::string_view line)
{
    const auto version =
        line.substr(0, title.size()) == title ? parseInt(line.substr(title.size())) : std::nullopt;
    if (!version || *version < 1)
        return tl::unexpected(QStringLiteral("no recording: it does not begin with \"%1%2\"")
                                  .arg(toQString(title))
                                  .arg(recordingVersion));
    if (*version > recordingVersion)
        return tl::unexpected(QStringLiteral("format version %1, this program knows %2")
                                  .arg(*version)
                                  .arg(recordingVersion));
    m_hasTitle = true;
    return HeaderState::More;
}

void CsvReader::parseComment(std::string_view comment)
{
    const std::string_view key = nextWord(comment);
    if (key == "started")
        m_head.started = QDateTime::fromString(toQString(comment), Qt::ISODateWithMs);
    else if (key == "program")
        m_head.program = toQString(comment);
    else if (key == "port")
        m_head.port = toQString(comment);
    else if (key == "baud")
        m_head.baud = parseInt(comment).value_or(0);
    else if (key == "simulated")
        m_head.simulated = comment == "yes";
    else if (key == "servo")
        parseServo(comment);
}

void CsvReader::parseServo(std::string_view comment)
{
    NamedServo named;
    named.label = nextWord(comment);
    const auto number = parseInt(nextWord(comment));
    const auto id = parseInt(nextWord(comment));
    if (!number || !id)
        return; // its columns are then unknown ones
    named.servo.servo = *number;
    named.servo.servoId = *id;
    named.servo.protocol = toQString(nextWord(comment));
    named.servo.servoName = toQString(comment);
    m_namedServos.push_back(named);
}

tl::expected<RecordingReader::HeaderState, QString> CsvReader::parseColumns(std::string_view line)
{
    bool time = false;
    bool servo = false;
    for (const std::string_view name : m_cells.split(line)) {
        Column column = findColumn(name);
        if (column.kind == Column::Kind::Time) {
            time = true;
            m_time = m_columns.size();
        } else if (column.kind == Column::Kind::Servo) {
            servo = true;
            m_servo = m_columns.size();
        }
        m_columns.push_back(column);
    }
    if (m_columns.size() == 1)
        return tl::unexpected(QStringLiteral("the columns are not separated by commas"));
    if (!time || !servo)
        return tl::unexpected(QStringLiteral("no column \"%1\"")
                                  .arg(time ? QStringLiteral("servo") : QStringLiteral("time_us")));
    if (m_head.channels.empty())
        return tl::unexpected(QStringLiteral("no column of a servo"));
    return HeaderState::Complete;
}

CsvReader::Column CsvReader::findColumn(std::string_view name)
{
    if (name == "time_us")
        return {Column::Kind::Time};
    if (name == "servo")
        return {Column::Kind::Servo};
    if (name == "marks")
        return {Column::Kind::Marks};
    const std::size_t dot = name.find('.');
    const std::size_t unit = name.rfind('[');
    if (dot == name.npos || unit == name.npos || unit < dot || name.back() != ']')
        return {};
    const std::string_view label = name.substr(0, dot);
    for (const NamedServo& named : m_namedServos) {
        if (named.label != label)
            continue;
        RecordingChannel channel = named.servo;
        channel.key = unescaped(name.substr(dot + 1, unit - dot - 1));
        channel.unit = unescaped(name.substr(unit + 1, name.size() - unit - 2));
        const auto [servo, place] = addChannel(channel);
        if (!findServoByLabel(label))
            m_labels.emplace_back(label, servo);
        return {Column::Kind::Value, servo, place};
    }
    return {};
}

std::optional<std::size_t> CsvReader::findServoByLabel(std::string_view label) const
{
    for (const auto& named : m_labels) {
        if (named.first == label)
            return named.second;
    }
    return std::nullopt;
}

RecordingReader::LineKind CsvReader::take(std::string_view line, RecordingLine& out)
{
    out.clear();
    if (line.empty() || line.front() == '#' || line.substr(0, 2) == "\"#")
        return LineKind::Blank;
    const std::vector<std::string_view>& cells = m_cells.split(line);
    if (cells.size() < m_columns.size())
        return LineKind::Invalid;
    const auto at = parseInstant(cells[m_time]);
    if (!at)
        return LineKind::Invalid;
    out.at = *at;
    if (!cells[m_servo].empty()) {
        const auto servo = findServoByLabel(cells[m_servo]);
        if (!servo)
            return LineKind::Invalid;
        out.isRow = true;
        out.servo = *servo;
        out.values.assign(servos()[*servo].size(), std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].empty())
            continue;
        if (i >= m_columns.size())
            return LineKind::Invalid;
        const Column& column = m_columns[i];
        if (column.kind == Column::Kind::Marks) {
            out.mark = parseMark(cells[i], *at);
            if (!out.mark)
                return LineKind::Invalid;
        } else if (column.kind == Column::Kind::Value) {
            const auto value = parseNumber(cells[i]);
            if (!value || !out.isRow || column.servo != out.servo)
                return LineKind::Invalid;
            out.values[column.place] = *value;
        }
    }
    return out.isRow || out.mark ? LineKind::Content : LineKind::Blank;
}
} // namespace

std::unique_ptr<RecordingReader> makeCsvReader()
{
    return std::make_unique<CsvReader>();
}
} // namespace recording
