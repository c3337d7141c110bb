// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_service.h"

#include "session/history/history_watcher.h"

namespace session {
using history::History;

namespace {
base::Result<std::vector<ReferenceResult>> compared(const History& history,
                                                    const results::SweepRun& run)
{
    std::vector<ReferenceResult> results;
    for (const results::SweepServo& servo : run.servos) {
        const auto reference = history.reference(servo.parameters.servo.model);
        if (!reference)
            return tl::unexpected(reference.error());
        if (!*reference || (*reference)->run.at == run.at)
            continue;
        if (!(*reference)->isUsable()) {
            results.push_back(
                {servo.parameters.servo.id, (*reference)->run, (*reference)->servo, {}, true});
            continue;
        }
        const auto other = history.sweep((*reference)->run.number);
        if (!other)
            return tl::unexpected(other.error());
        const results::SweepServo* held = results::servoOf(*other, (*reference)->servo.id);
        if (held)
            results.push_back(
                {servo.parameters.servo.id, (*reference)->run, (*reference)->servo,
                 results::compareSweeps({QString(), *other, *held}, {QString(), run, servo})});
    }
    return results;
}

/// Opened for each question: a file that was moved or mended meanwhile is no trouble then.
class HistoryFileSource final : public HistorySource {
public:
    HistoryFileSource(QString path, std::shared_ptr<base::JobThread> thread)
        : m_path(std::move(path))
        , m_thread(std::move(thread))
    {}

    void start(Query query) override
    {
        m_thread->start([path = m_path, query = std::move(query)] {
            const auto history = History::open(path);
            query(history ? base::Result<History*>(history->get())
                          : base::Result<History*>(tl::unexpected(history.error())));
        });
    }

private:
    const QString m_path;
    const std::shared_ptr<base::JobThread>
        m_thread; ///< the service's: saving takes its turn between queries
};
} // namespace

HistoryService::HistoryService(QString path, QObject* parent)
    : QObject(parent)
    , m_path(std::move(path))
    , m_post(std::make_shared<GuardedPoster>(m_mainQueue))
    , m_thread(std::make_shared<base::JobThread>())
    , m_source(std::make_unique<HistoryFileSource>(m_path, m_thread))
    , m_watch(std::make_unique<HistoryWatcher>(m_path, *m_thread, m_post))
{
    connect(m_watch.get(), &HistoryWatcher::changed, this, &HistoryService::changed);
}

HistoryService::HistoryService(std::unique_ptr<HistorySource> source, QObject* parent)
    : QObject(parent)
    , m_post(std::make_shared<GuardedPoster>(m_mainQueue))
    , m_thread(std::make_shared<base::JobThread>())
    , m_source(std::move(source))
{}

/// The thread drops what waits; a run is not dropped.
HistoryService::~HistoryService()
{
    m_post->close();
    m_source.reset();
    m_thread.reset();
    m_watch.reset();
    while (!m_pending.empty())
        saveNext();
}

/// On the service's thread, and at the very end on the main thread.
history::SavedRun HistoryService::saveNext()
{
    SaveJob next;
    {
        const std::lock_guard lock(m_mutex);
        next = m_pending.front();
    }
    history::SavedRun kept = next(m_path);
    const std::lock_guard lock(m_mutex);
    m_pending.pop_front();
    return kept;
}

void HistoryService::saveLater(SaveJob saveJob, Kind kind)
{
    {
        const std::lock_guard lock(m_mutex);
        m_pending.push_back(std::move(saveJob));
    }
    m_thread->start([this, kind] {
        m_mainQueue.post([this, kind, kept = saveNext()] {
            if (kept.trouble) {
                if (kind == Kind::Run)
                    Q_EMIT runSaveFailed(*kept.trouble, kept.file);
                else
                    Q_EMIT failed(*kept.trouble);
                return;
            }
            if (kind == Kind::Run)
                Q_EMIT this->runSaved(kept.number);
            Q_EMIT changed();
        });
    });
}

void HistoryService::saveRun(SharedRun run, const QStringList& files)
{
    saveLater([run = std::move(run), files](const QString& path) {
        return history::saveRun(path, *run, files);
    });
}

void HistoryService::saveRun(SharedStep run, const QStringList& files)
{
    saveLater([run = std::move(run), files](const QString& path) {
        return history::saveRun(path, *run, files);
    });
}

void HistoryService::setWatched(QObject* viewer, bool viewed)
{
    if (m_watch)
        m_watch->setWatched(viewer, viewed);
}

void HistoryService::change(std::function<base::Result<void>(History&)> action)
{
    query<void>(std::move(action), this, [this](const base::Result<void>& done) {
        if (!done)
            Q_EMIT failed(done.error());
        else
            Q_EMIT changed();
    });
}

void HistoryService::list(const history::RunFilter& filter, QObject* context,
                          Answer<std::vector<history::TestRun>> answer)
{
    query([filter](History& history) { return history.runs(filter); }, context, std::move(answer));
}

void HistoryService::load(std::int64_t number, QObject* context, Answer<SharedRun> answer)
{
    query(
        [number](History& history) -> base::Result<SharedRun> {
            auto run = history.sweep(number);
            if (!run)
                return tl::unexpected(run.error());
            return std::make_shared<const results::SweepRun>(std::move(*run));
        },
        context, std::move(answer));
}

void HistoryService::compareWithReference(SharedRun run, QObject* context,
                                          Answer<std::vector<ReferenceResult>> answer)
{
    query([run = std::move(run)](History& history) { return compared(history, *run); }, context,
          std::move(answer));
}

void HistoryService::setLabel(std::int64_t number, int servo, const QString& label)
{
    change([=](History& history) { return history.setLabel(number, servo, label); });
}

void HistoryService::setNote(std::int64_t number, const QString& note)
{
    change([=](History& history) { return history.setNote(number, note); });
}

void HistoryService::setReference(std::int64_t number, int servo, bool reference)
{
    change([=](History& history) { return history.setReference(number, servo, reference); });
}

void HistoryService::runInOrder(std::function<base::Result<void>()> job, QObject* context,
                                Answer<void> answer)
{
    const QPointer<QObject> guard(context);
    m_thread->start([this, job = std::move(job), guard, answer = std::move(answer)] {
        m_mainQueue.post([guard, answer, done = job()] {
            if (guard)
                answer(done);
        });
    });
}
} // namespace session
