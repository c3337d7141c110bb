// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorder.h"

#include "recording/recording_file.h"
#include "recording/recording_text.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace recording {
namespace {
const QString recordOperation = QStringLiteral("record");
constexpr auto flushPeriod = std::chrono::milliseconds(400);
constexpr std::size_t recorderBlockSize = std::size_t(256) << 10;
} // namespace

class Recorder::Worker {
public:
    Worker(RecorderSpec spec, std::unique_ptr<RecordingFile> file)
        : m_spec(std::move(spec))
        , m_text(m_spec.format, m_spec.head)
        , m_file(std::move(file))
        , m_thread([this] { run(); })
    {}

    ~Worker()
    {
        stop();
        m_thread.join();
    }

    bool tryWrite(std::vector<RecordingRow>& rows, std::vector<Mark>& marks);
    void lost(std::uint64_t rows);
    void advanceTo(base::Duration now);
    void stop();
    RecorderStatus status() const;
    const RecorderSpec& spec() const { return m_spec; }

private:
    struct Batch {
        std::vector<RecordingRow> rows;
        std::vector<Mark> marks;
        std::size_t size() const { return rows.size() + marks.size(); }
    };
    enum class Next : std::uint8_t { Continue, End };

    void run();
    Next processQueue();
    base::Result<Next> write(std::deque<Batch>& batches);
    Next add(const Batch& batch);
    void addMark(const Mark& mark);
    bool isOverAt(base::Duration at) const;
    base::Result<void> writeBlock();
    base::Result<void> flush(bool last);
    void publish();
    void end(const std::optional<base::Error>& error);

    const RecorderSpec m_spec;
    const RecordingFormatter m_text;

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Batch> m_queue;
    std::size_t m_queuedSize = 0;
    std::optional<base::Duration> m_reached;
    std::uint64_t m_accepted = 0; ///< rows
    bool m_stopping = false;
    RecorderStatus m_status;

    // used by the thread only
    const std::unique_ptr<RecordingFile> m_file;
    RecordingBlock m_blockSize;
    std::optional<base::Duration> m_start;    ///< of the first line
    std::optional<base::Duration> m_firstRow; ///< from here the length counts
    base::Duration m_lastRow{};
    std::uint64_t m_unknownRows = 0; ///< rows of servos that are not in the header
    std::chrono::steady_clock::time_point m_lastFlush = std::chrono::steady_clock::now();

    std::thread m_thread; ///< last: it uses the others
};

bool Recorder::Worker::tryWrite(std::vector<RecordingRow>& rows, std::vector<Mark>& marks)
{
    const std::size_t size = rows.size() + marks.size();
    {
        const std::lock_guard lock(m_mutex);
        if (m_status.ended) {
            m_status.lost += m_status.error ? rows.size() : 0;
            rows.clear();
            marks.clear();
            return true;
        }
        // A batch larger than the buffer is accepted when the buffer is empty.
        if (m_queuedSize > 0 && m_queuedSize + size > maxPending)
            return false;
        if (size == 0)
            return true;
        m_accepted += rows.size();
        m_queue.push_back({std::exchange(rows, {}), std::exchange(marks, {})});
        m_queuedSize += size;
    }
    m_wake.notify_one();
    return true;
}

void Recorder::Worker::lost(std::uint64_t rows)
{
    const std::lock_guard lock(m_mutex);
    m_status.lost += rows;
}

void Recorder::Worker::advanceTo(base::Duration now)
{
    const std::lock_guard lock(m_mutex);
    m_reached = now; // checked within a flush period
}

void Recorder::Worker::stop()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_wake.notify_one();
}

RecorderStatus Recorder::Worker::status() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void Recorder::Worker::run()
{
    while (processQueue() == Next::Continue) {
    }
}

/// Waits for rows, at most until the next flush.
Recorder::Worker::Next Recorder::Worker::processQueue()
{
    std::deque<Batch> batches;
    std::optional<base::Duration> reached;
    bool stopping = false;
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait_until(lock, m_lastFlush + flushPeriod,
                          [this] { return m_stopping || !m_queue.empty(); });
        batches.swap(m_queue);
        reached = m_reached;
        stopping = m_stopping;
    }
    const auto next = write(batches);
    const bool over = stopping || !next || *next == Next::End || (reached && isOverAt(*reached));
    const auto flushed = next ? flush(over) : base::Result<void>();
    if (!next)
        end(next.error());
    else if (!flushed)
        end(flushed.error());
    else if (over)
        end(std::nullopt);
    else
        publish();
    return over || !flushed ? Next::End : Next::Continue;
}

base::Result<Recorder::Worker::Next> Recorder::Worker::write(std::deque<Batch>& batches)
{
    Next next = Next::Continue;
    while (!batches.empty() && next == Next::Continue) {
        const Batch& batch = batches.front();
        next = add(batch);
        if (m_blockSize.text.size() >= recorderBlockSize) {
            if (const auto written = writeBlock(); !written)
                return tl::unexpected(written.error());
        }
        {
            const std::lock_guard lock(m_mutex);
            m_queuedSize -= batch.size();
        }
        batches.pop_front();
    }
    if (const auto written = writeBlock(); !written)
        return tl::unexpected(written.error());
    return next;
}

/// Rows and marks, each in order of time, become one sequence. End: the length is over.
Recorder::Worker::Next Recorder::Worker::add(const Batch& batch)
{
    auto mark = batch.marks.begin();
    for (const RecordingRow& row : batch.rows) {
        for (; mark != batch.marks.end() && mark->at < row.at; ++mark)
            addMark(*mark);
        if (isOverAt(row.at))
            return Next::End;
        if (!m_start)
            m_start = row.at;
        if (!m_text.row(row.at - *m_start, row, m_blockSize.text)) {
            lost(1); // of a servo that is not in the header
            ++m_unknownRows;
            continue;
        }
        m_blockSize.rowEnds.push_back(m_blockSize.text.size());
        if (!m_firstRow)
            m_firstRow = row.at;
        m_lastRow = row.at;
    }
    for (; mark != batch.marks.end(); ++mark)
        addMark(*mark);
    return Next::Continue;
}

void Recorder::Worker::addMark(const Mark& mark)
{
    if (isOverAt(mark.at))
        return;
    if (!m_start)
        m_start = mark.at;
    m_text.mark(mark.at - *m_start, mark, m_blockSize.text);
}

bool Recorder::Worker::isOverAt(base::Duration at) const
{
    return m_spec.length.count() > 0 && m_firstRow && at - *m_firstRow >= m_spec.length;
}

base::Result<void> Recorder::Worker::writeBlock()
{
    if (m_blockSize.text.empty())
        return {};
    auto written = m_file->append(m_blockSize);
    m_blockSize.clear();
    return written;
}

base::Result<void> Recorder::Worker::flush(bool last)
{
    if (!last && std::chrono::steady_clock::now() < m_lastFlush + flushPeriod)
        return {};
    auto flushed = m_file->flush();
    m_lastFlush = std::chrono::steady_clock::now();
    return flushed;
}

void Recorder::Worker::publish()
{
    const std::lock_guard lock(m_mutex);
    m_status.rows = m_file->rows();
    m_status.bytes = m_file->bytes();
    m_status.elapsed = m_lastRow - m_firstRow.value_or(m_lastRow);
}

void Recorder::Worker::end(const std::optional<base::Error>& error)
{
    publish();
    const std::lock_guard lock(m_mutex);
    m_queue.clear();
    m_queuedSize = 0;
    m_status.ended = true;
    m_status.error = error;
    if (error)
        m_status.lost += m_accepted - m_unknownRows - m_status.rows;
}

base::Result<std::unique_ptr<Recorder>> Recorder::start(const RecorderSpec& spec)
{
    if (spec.head.channels.empty())
        return base::fail(base::ErrorCode::BadArgument, recordOperation,
                          QStringLiteral("nothing to record"));
    auto file = RecordingFile::create(spec.path, RecordingFormatter(spec.format, spec.head).head());
    if (!file)
        return tl::unexpected(file.error());
    return std::unique_ptr<Recorder>(
        new Recorder(std::make_unique<Worker>(spec, std::move(*file))));
}

Recorder::Recorder(std::unique_ptr<Worker> thread)
    : m_thread(std::move(thread))
{}

Recorder::~Recorder() = default;

bool Recorder::tryWrite(std::vector<RecordingRow>& rows, std::vector<Mark>& marks)
{
    return m_thread->tryWrite(rows, marks);
}

void Recorder::lost(std::uint64_t rows)
{
    m_thread->lost(rows);
}

void Recorder::advanceTo(base::Duration now)
{
    m_thread->advanceTo(now);
}

void Recorder::stop()
{
    m_thread->stop();
}

RecorderStatus Recorder::status() const
{
    return m_thread->status();
}

const RecorderSpec& Recorder::spec() const
{
    return m_thread->spec();
}
} // namespace recording
