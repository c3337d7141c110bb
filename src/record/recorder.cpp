// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/recorder.h"

#include "record/recording_file.h"
#include "record/recording_text.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace record {
namespace {
const QString operation = QStringLiteral("record");
constexpr auto flushPeriod = std::chrono::milliseconds(400);
constexpr std::size_t blockSize = std::size_t(256) << 10;

struct Batch {
    std::vector<RecordingRow> rows;
    std::vector<Mark> marks;
    std::size_t size() const { return rows.size() + marks.size(); }
};
} // namespace

class Recorder::Thread {
public:
    Thread(RecorderSpec spec, std::unique_ptr<RecordingFile> file)
        : m_spec(std::move(spec))
        , m_text(m_spec.format, m_spec.head)
        , m_file(std::move(file))
        , m_thread([this] { run(); })
    {}

    ~Thread()
    {
        stop();
        m_thread.join();
    }

    bool offer(std::vector<RecordingRow>& rows, std::vector<Mark>& marks);
    void lost(std::uint64_t rows);
    void reach(base::Duration now);
    void stop();
    RecorderStatus status() const;
    const RecorderSpec& spec() const { return m_spec; }

private:
    enum class Next : std::uint8_t { GoOn, End };

    void run();
    Next round();
    base::Result<Next> write(std::deque<Batch>& batches);
    Next add(const Batch& batch);
    void addMark(const Mark& mark);
    bool overAt(base::Duration at) const;
    base::Result<void> writeBlock();
    base::Result<void> flush(bool last);
    void publish();
    void end(const std::optional<base::Error>& error);

    const RecorderSpec m_spec;
    const RecordingText m_text;

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Batch> m_waiting;
    std::size_t m_waitingSize = 0;
    std::optional<base::Duration> m_reached;
    std::uint64_t m_accepted = 0; ///< rows
    bool m_stopping = false;
    RecorderStatus m_status;

    // of the thread alone
    const std::unique_ptr<RecordingFile> m_file;
    RecordingBlock m_block;
    std::optional<base::Duration> m_start;    ///< of the first line
    std::optional<base::Duration> m_firstRow; ///< from here the length counts
    base::Duration m_lastRow{};
    std::uint64_t m_strangers = 0; ///< rows of servos that are not in the head
    std::chrono::steady_clock::time_point m_flushed = std::chrono::steady_clock::now();

    std::thread m_thread; ///< last: it uses the others
};

bool Recorder::Thread::offer(std::vector<RecordingRow>& rows, std::vector<Mark>& marks)
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
        // A batch that is larger than the room by itself gets through when nothing else waits.
        if (m_waitingSize > 0 && m_waitingSize + size > mostWaiting)
            return false;
        if (size == 0)
            return true;
        m_accepted += rows.size();
        m_waiting.push_back({std::exchange(rows, {}), std::exchange(marks, {})});
        m_waitingSize += size;
    }
    m_wake.notify_one();
    return true;
}

void Recorder::Thread::lost(std::uint64_t rows)
{
    const std::lock_guard lock(m_mutex);
    m_status.lost += rows;
}

void Recorder::Thread::reach(base::Duration now)
{
    const std::lock_guard lock(m_mutex);
    m_reached = now; // looked at within a flush period
}

void Recorder::Thread::stop()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_wake.notify_one();
}

RecorderStatus Recorder::Thread::status() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void Recorder::Thread::run()
{
    while (round() == Next::GoOn) {
    }
}

/// Takes what waits, or wakes in time for the next flush.
Recorder::Thread::Next Recorder::Thread::round()
{
    std::deque<Batch> batches;
    std::optional<base::Duration> reached;
    bool stopping = false;
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait_until(lock, m_flushed + flushPeriod,
                          [this] { return m_stopping || !m_waiting.empty(); });
        batches.swap(m_waiting);
        reached = m_reached;
        stopping = m_stopping;
    }
    const auto next = write(batches);
    const bool over = stopping || !next || *next == Next::End || (reached && overAt(*reached));
    const auto flushed = next ? flush(over) : base::Result<void>();
    if (!next)
        end(next.error());
    else if (!flushed)
        end(flushed.error());
    else if (over)
        end(std::nullopt);
    else
        publish();
    return over || !flushed ? Next::End : Next::GoOn;
}

base::Result<Recorder::Thread::Next> Recorder::Thread::write(std::deque<Batch>& batches)
{
    Next next = Next::GoOn;
    while (!batches.empty() && next == Next::GoOn) {
        const Batch& batch = batches.front();
        next = add(batch);
        if (m_block.text.size() >= blockSize) {
            if (const auto written = writeBlock(); !written)
                return tl::unexpected(written.error());
        }
        {
            const std::lock_guard lock(m_mutex);
            m_waitingSize -= batch.size();
        }
        batches.pop_front();
    }
    if (const auto written = writeBlock(); !written)
        return tl::unexpected(written.error());
    return next;
}

/// Rows and marks, each in order of time, become one sequence. End: the length is over.
Recorder::Thread::Next Recorder::Thread::add(const Batch& batch)
{
    auto mark = batch.marks.begin();
    for (const RecordingRow& row : batch.rows) {
        for (; mark != batch.marks.end() && mark->at < row.at; ++mark)
            addMark(*mark);
        if (overAt(row.at))
            return Next::End;
        if (!m_start)
            m_start = row.at;
        if (!m_text.row(row.at - *m_start, row, m_block.text)) {
            lost(1); // of a servo that is not in the head
            ++m_strangers;
            continue;
        }
        m_block.rowEnds.push_back(m_block.text.size());
        if (!m_firstRow)
            m_firstRow = row.at;
        m_lastRow = row.at;
    }
    for (; mark != batch.marks.end(); ++mark)
        addMark(*mark);
    return Next::GoOn;
}

void Recorder::Thread::addMark(const Mark& mark)
{
    if (overAt(mark.at))
        return;
    if (!m_start)
        m_start = mark.at;
    m_text.mark(mark.at - *m_start, mark, m_block.text);
}

bool Recorder::Thread::overAt(base::Duration at) const
{
    return m_spec.length.count() > 0 && m_firstRow && at - *m_firstRow >= m_spec.length;
}

base::Result<void> Recorder::Thread::writeBlock()
{
    if (m_block.text.empty())
        return {};
    auto written = m_file->append(m_block);
    m_block.clear();
    return written;
}

base::Result<void> Recorder::Thread::flush(bool last)
{
    if (!last && std::chrono::steady_clock::now() < m_flushed + flushPeriod)
        return {};
    auto flushed = m_file->flush();
    m_flushed = std::chrono::steady_clock::now();
    return flushed;
}

void Recorder::Thread::publish()
{
    const std::lock_guard lock(m_mutex);
    m_status.rows = m_file->rows();
    m_status.bytes = m_file->bytes();
    m_status.elapsed = m_lastRow - m_firstRow.value_or(m_lastRow);
}

void Recorder::Thread::end(const std::optional<base::Error>& error)
{
    publish();
    const std::lock_guard lock(m_mutex);
    m_waiting.clear();
    m_waitingSize = 0;
    m_status.ended = true;
    m_status.error = error;
    if (error)
        m_status.lost += m_accepted - m_strangers - m_status.rows;
}

base::Result<std::unique_ptr<Recorder>> Recorder::start(const RecorderSpec& spec)
{
    if (spec.head.channels.empty())
        return base::fail(base::ErrorCode::BadArgument, operation,
                          QStringLiteral("nothing to record"));
    auto file = RecordingFile::create(spec.path, RecordingText(spec.format, spec.head).head());
    if (!file)
        return tl::unexpected(file.error());
    return std::unique_ptr<Recorder>(
        new Recorder(std::make_unique<Thread>(spec, std::move(*file))));
}

Recorder::Recorder(std::unique_ptr<Thread> thread)
    : m_thread(std::move(thread))
{}

Recorder::~Recorder() = default;

bool Recorder::offer(std::vector<RecordingRow>& rows, std::vector<Mark>& marks)
{
    return m_thread->offer(rows, marks);
}

void Recorder::lost(std::uint64_t rows)
{
    m_thread->lost(rows);
}

void Recorder::reach(base::Duration now)
{
    m_thread->reach(now);
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
} // namespace record
