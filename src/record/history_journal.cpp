// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/history_journal.h"

#include "record/file_handle.h"
#include "record/history_intents.h"
#include "record/journal_takeover.h"

#include <QFileInfo>
#include <QUuid>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace record {
namespace {
/// For what has been written to a servo already: its record is worth a wait.
constexpr std::chrono::milliseconds endPatience{5000};

/// SQLite's, while this lives.
class Patience {
public:
    Patience(const HistoryFile& file, std::chrono::milliseconds meanwhile,
             std::chrono::milliseconds afterwards)
        : m_file(file)
        , m_afterwards(afterwards)
    {
        set(meanwhile);
    }
    ~Patience() { set(m_afterwards); }
    Patience(const Patience&) = delete;
    Patience& operator=(const Patience&) = delete;

private:
    void set(std::chrono::milliseconds span) const
    {
        (void)m_file.run(QStringLiteral("PRAGMA busy_timeout = %1").arg(qint64(span.count())));
    }

    const HistoryFile& m_file;
    std::chrono::milliseconds m_afterwards;
};
} // namespace

/// The connection and its thread. Calls from any thread are done one after another; the thread is
/// there from the first call on.
class HistoryJournal::Worker {
public:
    Worker(QString path, QString program, std::chrono::milliseconds patience)
        : m_path(std::move(path))
        , m_program(std::move(program))
        , m_patience(patience)
    {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker();

    /// `work` on the worker's thread with the history open; its answer.
    template <typename T>
    base::Result<T> ask(const std::function<base::Result<T>(const HistoryFile&)>& work)
    {
        base::Result<T> answer = tl::unexpected(base::Error{});
        run([&] {
            const auto file = ready();
            answer = file ? work(**file) : base::Result<T>(tl::unexpected(file.error()));
        });
        return answer;
    }

    /// Neither a history nor what would have to be taken over: nothing is made by looking.
    bool nothingThere() const;
    const QString& program() const { return m_program; }
    std::chrono::milliseconds patience() const { return m_patience; }

private:
    void run(const std::function<void()>& work);
    void live();
    base::Result<const HistoryFile*> ready();

    const QString m_path;
    const QString m_program;
    const std::chrono::milliseconds m_patience;

    std::mutex m_turn; ///< one caller at a time
    std::mutex m_mutex;
    std::condition_variable m_changed;
    const std::function<void()>* m_work = nullptr; ///< of the caller who waits
    bool m_ending = false;
    std::thread m_thread;

    // Of the worker's thread.
    std::unique_ptr<HistoryFile> m_file;
    FileMark m_mark; ///< of the file that is open
};

HistoryJournal::Worker::~Worker()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_changed.notify_all();
    if (m_thread.joinable())
        m_thread.join();
}

void HistoryJournal::Worker::run(const std::function<void()>& work)
{
    const std::lock_guard turn(m_turn);
    if (!m_thread.joinable())
        m_thread = std::thread([this] { live(); });
    std::unique_lock lock(m_mutex);
    m_work = &work;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return m_work == nullptr; });
}

void HistoryJournal::Worker::live()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_changed.wait(lock, [this] { return m_work != nullptr || m_ending; });
        if (m_work == nullptr)
            break;
        const std::function<void()>& work = *m_work;
        lock.unlock();
        work();
        lock.lock();
        m_work = nullptr;
        m_changed.notify_all();
    }
    m_file.reset(); // on the thread that opened it
}

/// A file that was moved away or replaced meanwhile must not swallow what is written to it.
base::Result<const HistoryFile*> HistoryJournal::Worker::ready()
{
    const auto present = FileHandle::infoOf(m_path);
    if (m_file && !(present && present->mark == m_mark))
        m_file.reset();
    if (!m_file) {
        auto opened = HistoryFile::open(m_path, m_patience);
        if (!opened)
            return tl::unexpected(opened.error());
        m_file = std::move(*opened);
        m_mark = FileHandle::infoOf(m_path).value_or(FileHandle::Info()).mark;
    }
    if (const auto taken = takeOverJournal(*m_file); !taken)
        return tl::unexpected(taken.error());
    return m_file.get();
}

bool HistoryJournal::Worker::nothingThere() const
{
    return !QFileInfo::exists(m_path) && !QFileInfo::exists(oldJournalBeside(m_path));
}

HistoryJournal::HistoryJournal(QString historyPath, QString program,
                               std::chrono::milliseconds patience)
    : m_path(std::move(historyPath))
    , m_worker(std::make_unique<Worker>(m_path, std::move(program), patience))
    , m_locks(QFileInfo(m_path).absolutePath() + QStringLiteral("/running"))
{}

HistoryJournal::~HistoryJournal() = default;

base::Result<QString> HistoryJournal::begin(const base::Intent& intent)
{
    base::Intent kept = intent;
    kept.uuid = QUuid::createUuid().toString(QUuid::WithoutBraces);
    kept.at = QDateTime::currentDateTimeUtc();
    m_locks.take(kept.uuid); // before any other program can see it
    auto begun = m_worker->ask<QString>([&](const HistoryFile& file) -> base::Result<QString> {
        const auto done =
            file.together([&] { return insertIntent(file, kept, m_worker->program()); });
        if (!done)
            return tl::unexpected(done.error());
        ++m_begun;
        return kept.uuid;
    });
    if (!begun)
        m_locks.free(kept.uuid);
    return begun;
}

void HistoryJournal::release()
{
    m_locks.freeAll();
}

base::Result<void> HistoryJournal::end(const QString& uuid, const base::IntentEnd& end)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    auto recorded = m_worker->ask<void>([&](const HistoryFile& file) {
        const auto usual = m_worker->patience();
        const Patience patience(file, std::max(endPatience, usual), usual);
        return file.together([&]() -> base::Result<void> {
            const auto ended = endIntent(file, uuid, end, now);
            if (!ended)
                return tl::unexpected(ended.error());
            if (!*ended)
                return base::fail(base::ErrorCode::BadArgument, QStringLiteral("journal"), uuid);
            return {};
        });
    });
    if (recorded)
        m_locks.free(uuid);
    return recorded;
}

base::Result<std::vector<base::JournalEntry>> HistoryJournal::entries() const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->nothingThere())
        return All();
    return m_worker->ask<All>([](const HistoryFile& file) {
        return readEntries(file, QStringLiteral("ORDER BY i.at, i.number"), {});
    });
}

base::Result<std::vector<base::Intent>> HistoryJournal::open() const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->nothingThere())
        return std::vector<base::Intent>();
    const auto entries = m_worker->ask<All>([](const HistoryFile& file) {
        return readEntries(file, QStringLiteral("WHERE i.outcome IS NULL ORDER BY i.at, i.number"),
                           {});
    });
    if (!entries)
        return tl::unexpected(entries.error());
    std::vector<base::Intent> intents;
    for (const base::JournalEntry& entry : *entries) {
        intents.push_back(entry.intent);
        intents.back().underWayElsewhere = m_locks.isHeldElsewhere(entry.intent.uuid);
    }
    return intents;
}

base::Result<std::vector<base::JournalEntry>>
HistoryJournal::entriesOf(const base::ServoIdentity& servo, int most) const
{
    using All = std::vector<base::JournalEntry>;
    if (m_worker->nothingThere())
        return All();
    return m_worker->ask<All>(
        [&](const HistoryFile& file) { return entriesOfServo(file, servo, most); });
}

base::Result<void> HistoryJournal::keep(const base::ServoIdentity& servo, const QString& name,
                                        const std::vector<std::int64_t>& values)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    return m_worker->ask<void>([&](const HistoryFile& file) {
        return file.together([&] { return keepFact(file, servo, name, values, now); });
    });
}

base::Result<std::optional<std::vector<std::int64_t>>>
HistoryJournal::kept(const base::ServoIdentity& servo, const QString& name) const
{
    using Fact = std::optional<std::vector<std::int64_t>>;
    if (m_worker->nothingThere())
        return Fact();
    return m_worker->ask<Fact>([&](const HistoryFile& file) { return factOf(file, servo, name); });
}
} // namespace record
