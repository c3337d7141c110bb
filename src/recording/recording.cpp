// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording: the file in blocks, lines out of them, samples into the store.
#include "recording/recording.h"

#include "recording/recording_text.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace recording {
namespace {
const QString loadOperation = QStringLiteral("load-recording");
constexpr std::size_t readBlockSize = std::size_t(1) << 20;
constexpr std::size_t maxLineLength = readBlockSize; ///< far more than any servo has registers

class RecordingLoader {
public:
    RecordingLoader(const QString& path, SampleStore& store)
        : m_path(path)
        , m_store(store)
    {}

    base::Result<void> take(std::string_view bytes);
    base::Result<LoadedRecording> finish();
    void discard();

private:
    base::Result<void> parseLine(std::string_view line);
    base::Result<void> parseHeader(std::string_view line);
    bool isInOrder(const RecordingLine& line);
    void storeRow(const RecordingLine& line);
    tl::unexpected<base::Error> formatError(const QString& what) const;

    QString m_path;
    SampleStore& m_store;
    std::unique_ptr<RecordingReader> m_reader;
    bool m_isHeaderComplete = false;
    quint64 m_lines = 0;
    std::string m_unfinished;
    bool m_tooLong = false; ///< the rest of this line is discarded
    RecordingLine m_line;
    std::vector<std::optional<base::Duration>> m_latest; ///< per servo
    LoadedRecording m_loaded;
};

tl::unexpected<base::Error> RecordingLoader::formatError(const QString& what) const
{
    return base::fail(base::ErrorCode::FileFormat, loadOperation,
                      QStringLiteral("%1: line %2: %3").arg(m_path).arg(m_lines).arg(what));
}

base::Result<void> RecordingLoader::take(std::string_view bytes)
{
    while (!bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        if (end == bytes.npos) {
            m_tooLong = m_tooLong || m_unfinished.size() + bytes.size() > maxLineLength;
            m_unfinished = m_tooLong ? std::string("?") : m_unfinished.append(bytes);
            return {};
        }
        std::string_view line = bytes.substr(0, end);
        if (!m_unfinished.empty())
            line = m_unfinished.append(line);
        if (const auto taken = parseLine(line); !taken)
            return taken;
        m_unfinished.clear();
        m_tooLong = false;
        bytes.remove_prefix(end + 1);
    }
    return {};
}

base::Result<void> RecordingLoader::parseLine(std::string_view line)
{
    ++m_lines;
    if (m_lines == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
        line.remove_prefix(3);
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    if (!m_isHeaderComplete)
        return parseHeader(line);
    auto verdict = m_tooLong ? RecordingReader::LineKind::Invalid : m_reader->take(line, m_line);
    if (verdict == RecordingReader::LineKind::Content && !isInOrder(m_line))
        verdict = RecordingReader::LineKind::Invalid;
    if (verdict == RecordingReader::LineKind::Invalid)
        ++m_loaded.report.badLines;
    if (verdict != RecordingReader::LineKind::Content)
        return {};
    if (m_line.isRow)
        storeRow(m_line);
    if (m_line.mark)
        m_loaded.marks.push_back(*m_line.mark);
    return {};
}

base::Result<void> RecordingLoader::parseHeader(std::string_view line)
{
    if (!m_reader)
        m_reader = line.substr(0, 1) == "{" ? makeJsonLinesReader() : makeCsvReader();
    const auto head = m_reader->parseHeader(line);
    if (!head)
        return formatError(head.error());
    if (*head == RecordingReader::HeaderState::More)
        return {};
    m_isHeaderComplete = true;
    m_loaded.head = m_reader->head();
    m_latest.resize(m_reader->servos().size());
    for (std::size_t i = 0; i < m_loaded.head.channels.size(); ++i)
        m_loaded.ids.push_back(m_store.open());
    return {};
}

/// A row earlier than the previous one of its servo was inserted by hand.
bool RecordingLoader::isInOrder(const RecordingLine& line)
{
    if (!line.isRow)
        return true;
    std::optional<base::Duration>& latest = m_latest[line.servo];
    if (latest && line.at < *latest)
        return false;
    latest = line.at;
    return true;
}

void RecordingLoader::storeRow(const RecordingLine& line)
{
    const std::vector<std::size_t>& channels = m_reader->servos()[line.servo];
    const bool answered = std::any_of(line.values.begin(), line.values.end(),
                                      [](double value) { return !std::isnan(value); });
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const ChannelId id = m_loaded.ids[channels[i]];
        if (!answered)
            m_store.gap(id);
        else if (!std::isnan(line.values[i]))
            m_store.append(id, line.at, line.values[i]);
    }
    RecordingReport& report = m_loaded.report;
    if (report.rows++ == 0)
        report.span = {line.at, line.at};
    report.span.from = std::min(report.span.from, line.at);
    report.span.to = std::max(report.span.to, line.at);
}

base::Result<LoadedRecording> RecordingLoader::finish()
{
    if (!m_isHeaderComplete) {
        ++m_lines;
        return formatError(m_lines == 1 && m_unfinished.empty()
                               ? QStringLiteral("the file is empty")
                               : QStringLiteral("the file ends within its head"));
    }
    m_loaded.report.isTruncated = !m_unfinished.empty();
    std::stable_sort(m_loaded.marks.begin(), m_loaded.marks.end(),
                     [](const Mark& a, const Mark& b) { return a.at < b.at; });
    return std::move(m_loaded);
}

void RecordingLoader::discard()
{
    for (const ChannelId id : m_loaded.ids)
        m_store.close(id);
}

base::Result<void> readInto(RecordingLoader& loader, QFile& file, const base::StopToken& stop,
                            const std::function<void(double)>& onProgress)
{
    std::vector<char> block(readBlockSize);
    const auto size = double(std::max<qint64>(file.size(), 1));
    while (true) {
        if (stop.isRequested())
            return base::fail(base::ErrorCode::Stopped, loadOperation);
        const qint64 got = file.read(block.data(), qint64(block.size()));
        if (got < 0)
            return base::fail(base::ErrorCode::FileUnreadable, loadOperation,
                              file.fileName() + QStringLiteral(": ") + file.errorString());
        if (got == 0)
            return {};
        if (auto taken = loader.take({block.data(), std::size_t(got)}); !taken)
            return taken;
        if (onProgress)
            onProgress(std::min(1.0, double(file.pos()) / size));
    }
}
} // namespace

RecordingFormat recordingFormatOf(const QString& path)
{
    return path.endsWith(QLatin1String(".jsonl"), Qt::CaseInsensitive) ? RecordingFormat::JsonLines
                                                                       : RecordingFormat::Csv;
}

base::Result<LoadedRecording> loadRecording(const QString& path, SampleStore& into,
                                            const base::StopToken& stop,
                                            const std::function<void(double)>& onProgress)
{
    const QFileInfo source(path);
    if (!source.exists())
        return base::fail(base::ErrorCode::FileMissing, loadOperation, path);
    if (!source.isFile())
        return base::fail(base::ErrorCode::FileUnreadable, loadOperation,
                          path + QStringLiteral(": not a regular file"));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return base::fail(base::ErrorCode::FileUnreadable, loadOperation,
                          path + QStringLiteral(": ") + file.errorString());
    RecordingLoader loader(path, into);
    if (const auto read = readInto(loader, file, stop, onProgress); !read) {
        loader.discard();
        return tl::unexpected(read.error());
    }
    return loader.finish();
}
} // namespace recording
