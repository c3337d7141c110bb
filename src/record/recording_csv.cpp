// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording's CSV, also after a spreadsheet program or a person has been at it: columns
// may have been moved, left out or added, cells quoted, '#' lines padded with commas.
#include "record/csv_cells.h"
#include "record/recording_text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace record {
namespace {
constexpr std::string_view title = "# ServoDesk recording ";

QString words(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

std::optional<int> wholeNumber(std::string_view text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// Takes what is before the next blank.
std::string_view takeWord(std::string_view& text)
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
    return words(plain);
}

std::optional<Mark> parseMark(std::string_view text, base::Duration at)
{
    const auto kind = markFromName(words(takeWord(text)));
    const std::string_view id = takeWord(text);
    const std::optional<int> number = id == "-" ? std::optional(-1) : wholeNumber(id);
    if (!kind || !number)
        return std::nullopt;
    return Mark{at, *kind, *number, unescaped(text)};
}

class CsvReader final : public RecordingReader {
public:
    tl::expected<Head, QString> takeHead(std::string_view line) override;
    Verdict take(std::string_view line, RecordingLine& out) override;

private:
    struct Column {
        enum class Kind : std::uint8_t { Other, Time, Servo, Value, Marks };
        Kind kind = Kind::Other;
        std::size_t servo = 0;
        std::size_t place = 0; ///< among that servo's values
    };
    struct Named {
        std::string label;
        RecordingChannel servo;
    };

    tl::expected<Head, QString> takeTitle(std::string_view line);
    void takeRemark(std::string_view remark);
    void takeServo(std::string_view remark);
    tl::expected<Head, QString> takeColumns(std::string_view line);
    Column columnCalled(std::string_view name);
    std::optional<std::size_t> servoCalled(std::string_view label) const;

    bool m_titled = false;
    std::vector<Named> m_named;
    std::vector<Column> m_columns;
    std::size_t m_time = 0;
    std::size_t m_servo = 0;
    std::vector<std::pair<std::string, std::size_t>> m_labels;
    CsvCells m_cells;
};

tl::expected<RecordingReader::Head, QString> CsvReader::takeHead(std::string_view line)
{
    if (line.substr(0, 2) == "\"#")
        line = m_cells.split(line).front();
    const bool remark = line.substr(0, 1) == "#";
    const bool blank = line.find_first_not_of(", \t") == line.npos;
    if (m_titled && !remark && !blank)
        return takeColumns(line);
    while (remark && (line.back() == ',' || line.back() == ' '))
        line.remove_suffix(1);
    if (!m_titled)
        return takeTitle(line);
    if (remark)
        takeRemark(trimmed(line.substr(1)));
    return Head::More;
}

tl::expected<RecordingReader::Head, QString> CsvReader::takeTitle(std::string_view line)
{
    const auto version = line.substr(0, title.size()) == title
                             ? wholeNumber(line.substr(title.size()))
                             : std::nullopt;
    if (!version || *version < 1)
        return tl::unexpected(QStringLiteral("no recording: it does not begin with \"%1%2\"")
                                  .arg(words(title))
                                  .arg(recordingVersion));
    if (*version > recordingVersion)
        return tl::unexpected(QStringLiteral("format version %1, this program knows %2")
                                  .arg(*version)
                                  .arg(recordingVersion));
    m_titled = true;
    return Head::More;
}

void CsvReader::takeRemark(std::string_view remark)
{
    const std::string_view key = takeWord(remark);
    if (key == "started")
        m_head.started = QDateTime::fromString(words(remark), Qt::ISODateWithMs);
    else if (key == "program")
        m_head.program = words(remark);
    else if (key == "port")
        m_head.port = words(remark);
    else if (key == "baud")
        m_head.baud = wholeNumber(remark).value_or(0);
    else if (key == "simulated")
        m_head.simulated = remark == "yes";
    else if (key == "servo")
        takeServo(remark);
}

void CsvReader::takeServo(std::string_view remark)
{
    Named named;
    named.label = takeWord(remark);
    const auto number = wholeNumber(takeWord(remark));
    const auto id = wholeNumber(takeWord(remark));
    if (!number || !id)
        return; // its columns are then unknown ones
    named.servo.servo = *number;
    named.servo.servoId = *id;
    named.servo.protocol = words(takeWord(remark));
    named.servo.servoName = words(remark);
    m_named.push_back(named);
}

tl::expected<RecordingReader::Head, QString> CsvReader::takeColumns(std::string_view line)
{
    bool time = false;
    bool servo = false;
    for (const std::string_view name : m_cells.split(line)) {
        Column column = columnCalled(name);
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
    return Head::Complete;
}

CsvReader::Column CsvReader::columnCalled(std::string_view name)
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
    for (const Named& named : m_named) {
        if (named.label != label)
            continue;
        RecordingChannel channel = named.servo;
        channel.key = unescaped(name.substr(dot + 1, unit - dot - 1));
        channel.unit = unescaped(name.substr(unit + 1, name.size() - unit - 2));
        const auto [servo, place] = addChannel(channel);
        if (!servoCalled(label))
            m_labels.emplace_back(label, servo);
        return {Column::Kind::Value, servo, place};
    }
    return {};
}

std::optional<std::size_t> CsvReader::servoCalled(std::string_view label) const
{
    for (const auto& named : m_labels) {
        if (named.first == label)
            return named.second;
    }
    return std::nullopt;
}

RecordingReader::Verdict CsvReader::take(std::string_view line, RecordingLine& out)
{
    out.clear();
    if (line.empty() || line.front() == '#' || line.substr(0, 2) == "\"#")
        return Verdict::Nothing;
    const std::vector<std::string_view>& cells = m_cells.split(line);
    if (cells.size() < m_columns.size())
        return Verdict::Bad;
    const auto at = parseInstant(cells[m_time]);
    if (!at)
        return Verdict::Bad;
    out.at = *at;
    if (!cells[m_servo].empty()) {
        const auto servo = servoCalled(cells[m_servo]);
        if (!servo)
            return Verdict::Bad;
        out.isRow = true;
        out.servo = *servo;
        out.values.assign(servos()[*servo].size(), std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].empty())
            continue;
        if (i >= m_columns.size())
            return Verdict::Bad;
        const Column& column = m_columns[i];
        if (column.kind == Column::Kind::Marks) {
            out.mark = parseMark(cells[i], *at);
            if (!out.mark)
                return Verdict::Bad;
        } else if (column.kind == Column::Kind::Value) {
            const auto value = parseNumber(cells[i]);
            if (!value || !out.isRow || column.servo != out.servo)
                return Verdict::Bad;
            out.values[column.place] = *value;
        }
    }
    return out.isRow || out.mark ? Verdict::Content : Verdict::Nothing;
}
} // namespace

std::unique_ptr<RecordingReader> makeCsvReader()
{
    return std::make_unique<CsvReader>();
}
} // namespace record
