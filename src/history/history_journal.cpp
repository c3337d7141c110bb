// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_journal.h"

#include "base/job_thread.h"
#include "files/file_handle.h"
#include "history/history_intents.h"
#include "history/history_query.h"

#include <QFileInfo>

#include <algorithm>
#include <future>
#include <mutex>

namespace history {
namespace {
/// For what has been written to a servo already: its record is worth a wait.
constexpr std::chrono::milliseconds endTimeout{5000};

/// SQLite's, while this lives.
class BusyTimeout {
public:
    BusyTimeout(const HistoryFile& file, std::chrono::milliseconds meanwhile,
                std::chrono::milliseconds afterwards)
        : m_file(file)
        , m_afterwards(afterwards)
    {
        set(meanwhile);
    }
    ~BusyTimeout() { set(m_afterwards); }
    BusyTimeout(const BusyTimeout&) = delete;
    BusyTimeout& operator=(const BusyTimeout&) = delete;

private:
    void set(std::chrono::milliseconds span) const
    {
        (void)m_file.run(QStringLiteral("PRAGMA busy_timeout = %1").arg(qint64(span.count())));
    }

    const HistoryFile& m_file;
    std::chrono::milliseconds m_afterwards;
};
} // namespace

/// The connection and its thread, which starts with the first call. Calls from any thread are
/// executed one after another.
class HistoryJournal::Worker {
public:
    Worker(QString path, QString program, std::chrono::milliseconds timeout)
        : m_path(std::move(path))
        , m_program(std::move(program))
        , m_timeout(timeout)
    {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker();

    /// Runs `work` on the thread with the history open, and returns its answer.
    template <typename T>
    base::Result<T> call(const std::function<base::Result<T>(const HistoryFile&)>& work)
    {
        base::Result<T> answer = tl::unexpected(base::Error{});
        run([&] {
            const auto file = ensureOpen();
            answer = file ? work(**file) : base::Result<T>(tl::unexpected(file.error()));
        });
        return answer;
    }

    /// There is no history. Reading must not create one.
    bool isNothingStored() const;
    const QString& program() const { return m_program; }
    std::chrono::milliseconds timeout() const { return m_timeout; }

private:
    void run(const std::function<void()>& work);
    base::Result<const HistoryFile*> ensureOpen();

    const QString m_path;
    const QString m_program;
    const std::chrono::milliseconds m_timeout;

    // Used on the thread only.
    std::unique_ptr<HistoryFile> m_file;
    files::FileId m_fileId; ///< of the file that is open

    std::mutex m_mutex;
    std::optional<base::JobThread> m_thread; ///< last: its jobs use the others
};

HistoryJournal::Worker::~Worker()
{
    if (m_thread)
        run([this] { m_file.reset(); }); // on the thread that opened it
}

void HistoryJournal::Worker::run(const std::function<void()>& work)
{
    const auto task = std::make_shared<std::packaged_task<void()>>(work);
    {
        const std::lock_guard lock(m_mutex);
        if (!m_thread)
            m_thread.emplace();
        m_thread->start([task] { (*task)(); });
    }
    task->get_future().wait();
}

/// A file that was moved away or replaced meanwhile must not swallow what is written to it.
base::Result<const HistoryFile*> HistoryJournal::Worker::ensureOpen()
{
    const auto present = files::FileHandle::infoOf(m_path);
    if (m_file && !(present && present->id == m_fileId))
        m_file.reset();
    if (!m_file) {
        auto opened = HistoryFile::open(m_path, m_timeout);
        if (!opened)
            return tl::unexpected(opened.error());
        m_file = std::move(*opened);
        m_fileId = files::FileHandle::infoOf(m_path).value_or(files::FileHandle::Info()).id;
    }
    return m_file.get();
}

bool HistoryJournal::Worker::isNothingStored() const
{
    return !QFileInfo::exists(m_path);
}

HistoryJournal::HistoryJournal(QString historyPath, QString program,
                               std::chrono::milliseconds timeout)
    : m_path(std::move(historyPath))
    , m_worker(std::make_unique<Worker>(m_path, std::move(program), timeout))
    , m_locks(QFileInfo(m_path).absolutePath() + QStringLiteral("/running"))
{}

HistoryJournal::~HistoryJournal() = default;

base::Result<QString> HistoryJournal::begin(const base::Intent& intent)
{
    base::Intent kept = intent;
    kept.uuid = newUuid();
    kept.at = QDateTime::currentDateTimeUtc();
    m_locks.acquire(kept.uuid); // before any other program can see it
    auto intentCount =
        m_worker->call<QString>([&](const HistoryFile& file) -> base::Result<QString> {
            const auto done =
                file.transaction([&] { return insertIntent(file, kept, m_worker->program()); });
            if (!done)
                return tl::unexpected(done.error());
            ++m_intentCount;
            return kept.uuid;
        });
    if (!intentCount)
        m_locks.release(kept.uuid);
    return intentCount;
}

void HistoryJournal::release()
{
    m_locks.releaseAll();
}

base::Result<void> HistoryJournal::end(const QString& uuid, const base::IntentResult& end)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    auto recorded = m_worker->call<void>([&](const HistoryFile& file) {
        const auto previousTimeout = m_worker->timeout();
        const BusyTimeout timeout(file, std::max(endTimeout, previousTimeout), previousTimeout);
        return file.transaction([&]() -> base::Result<void> {
            const auto ended = endIntent(file, uuid, end, now);
            if (!ended)
                return tl::unexpected(ended.error());
            if (!*ended)
                return base::fail(base::ErrorCode::BadArgument, QStringLiteral("journal"), uuid);
            return {};
        });
    });
    if (recorded)
        m_locks.release(uuid);
    return recorded;
}

base::Result<std::vector<base::JournalEntry>> HistoryJournal::entries() const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->isNothingStored())
        return All();
    return m_worker->call<All>([](const HistoryFile& file) {
        return readEntries(file, QStringLiteral("ORDER BY i.at, i.number"), {});
    });
}

base::Result<std::vector<base::Intent>> HistoryJournal::open() const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->isNothingStored())
        return std::vector<base::Intent>();
    const auto entries = m_worker->call<All>([](const HistoryFile& file) {
        return readEntries(file, QStringLiteral("WHERE i.outcome IS NULL ORDER BY i.at, i.number"),
                           {});
    });
    if (!entries)
        return tl::unexpected(entries.error());
    std::vector<base::Intent> intents;
    for (const base::JournalEntry& entry : *entries) {
        intents.push_back(entry.intent);
        intents.back().isActiveElsewhere = m_locks.isHeldElsewhere(entry.intent.uuid);
    }
    return intents;
}

base::Result<std::vector<base::JournalEntry>>
HistoryJournal::entriesFor(const base::ServoIdentity& servo, int limit) const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->isNothingStored())
        return All();
    return m_worker->call<All>(
        [&](const HistoryFile& file) { return readServoEntries(file, servo, limit); });
}

base::Result<void> HistoryJournal::saveServoValues(const base::ServoIdentity& servo,
                                                   const QString& name,
                                                   const std::vector<std::int64_t>& values)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    return m_worker->call<void>([&](const HistoryFile& file) {
        return file.transaction([&] { return saveFact(file, servo, name, values, now); });
    });
}

base::Result<std::optional<std::vector<std::int64_t>>>
HistoryJournal::servoValues(const base::ServoIdentity& servo, const QString& name) const
{
    using Fact = std::optional<std::vector<std::int64_t>>;
    if (m_worker->isNothingStored())
        return Fact();
    return m_worker->call<Fact>(
        [&](const HistoryFile& file) { return loadFact(file, servo, name); });
}
} // namespace history
