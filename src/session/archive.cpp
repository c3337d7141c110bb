// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/archive.h"

#include "session/history_watch.h"

namespace session {
using record::History;

namespace {
base::Result<std::vector<ReferenceResult>> compared(const History& history,
                                                    const record::SweepRun& run)
{
    std::vector<ReferenceResult> results;
    for (const record::SweepServo& servo : run.servos) {
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
        const record::SweepServo* held = record::servoOf(*other, (*reference)->servo.id);
        if (held)
            results.push_back(
                {servo.parameters.servo.id, (*reference)->run, (*reference)->servo,
                 record::compareSweeps({QString(), *other, *held}, {QString(), run, servo})});
    }
    return results;
}

/// Opened for each question: a file that was moved or mended meanwhile is no trouble then.
class FileSource final : public ArchiveSource {
public:
    FileSource(QString path, std::shared_ptr<JobThread> thread)
        : m_path(std::move(path))
        , m_thread(std::move(thread))
    {}

    void start(Question question) override
    {
        m_thread->start([path = m_path, question = std::move(question)] {
            const auto history = History::open(path);
            question(history ? base::Result<History*>(history->get())
                             : base::Result<History*>(tl::unexpected(history.error())));
        });
    }

private:
    const QString m_path;
    const std::shared_ptr<JobThread> m_thread; ///< the archive's: what is kept goes in between
};
} // namespace

Archive::Archive(QString path, QObject* parent)
    : QObject(parent)
    , m_path(std::move(path))
    , m_post(std::make_shared<LoosePost>(m_inbox))
    , m_thread(std::make_shared<JobThread>())
    , m_source(std::make_unique<FileSource>(m_path, m_thread))
    , m_watch(std::make_unique<HistoryWatch>(m_path, *m_thread, m_post))
{
    connect(m_watch.get(), &HistoryWatch::changed, this, &Archive::changed);
}

Archive::Archive(std::unique_ptr<ArchiveSource> source, QObject* parent)
    : QObject(parent)
    , m_post(std::make_shared<LoosePost>(m_inbox))
    , m_thread(std::make_shared<JobThread>())
    , m_source(std::move(source))
{}

/// The thread drops what waits; a run is not dropped.
Archive::~Archive()
{
    m_post->close();
    m_source.reset();
    m_thread.reset();
    m_watch.reset();
    while (!m_pending.empty())
        keepNext();
}

/// On the archive's thread, and at the very end on the main thread.
record::KeptRun Archive::keepNext()
{
    Keeping next;
    {
        const std::lock_guard lock(m_mutex);
        next = m_pending.front();
    }
    record::KeptRun kept = next(m_path);
    const std::lock_guard lock(m_mutex);
    m_pending.pop_front();
    return kept;
}

void Archive::keepLater(Keeping keeping, Kind kind)
{
    {
        const std::lock_guard lock(m_mutex);
        m_pending.push_back(std::move(keeping));
    }
    m_thread->start([this, kind] {
        m_inbox.post([this, kind, kept = keepNext()] {
            if (kept.trouble) {
                if (kind == Kind::Run)
                    Q_EMIT keepFailed(*kept.trouble, kept.file);
                else
                    Q_EMIT failed(*kept.trouble);
                return;
            }
            if (kind == Kind::Run)
                Q_EMIT this->kept(kept.number);
            Q_EMIT changed();
        });
    });
}

void Archive::keep(SharedRun run, const QStringList& files)
{
    keepLater([run = std::move(run), files](const QString& path) {
        return record::keepRun(path, *run, files);
    });
}

void Archive::keep(SharedStep run, const QStringList& files)
{
    keepLater([run = std::move(run), files](const QString& path) {
        return record::keepRun(path, *run, files);
    });
}

void Archive::setViewed(QObject* viewer, bool viewed)
{
    if (m_watch)
        m_watch->setViewed(viewer, viewed);
}

void Archive::change(std::function<base::Result<void>(History&)> deed)
{
    ask<void>(std::move(deed), this, [this](const base::Result<void>& done) {
        if (!done)
            Q_EMIT failed(done.error());
        else
            Q_EMIT changed();
    });
}

void Archive::list(const record::RunFilter& filter, QObject* context,
                   Answer<std::vector<record::TestRun>> answer)
{
    ask<std::vector<record::TestRun>>([filter](History& history) { return history.runs(filter); },
                                      context, std::move(answer));
}

void Archive::load(std::int64_t number, QObject* context, Answer<SharedRun> answer)
{
    ask<SharedRun>(
        [number](History& history) -> base::Result<SharedRun> {
            auto run = history.sweep(number);
            if (!run)
                return tl::unexpected(run.error());
            return std::make_shared<const record::SweepRun>(std::move(*run));
        },
        context, std::move(answer));
}

void Archive::compareWithReference(SharedRun run, QObject* context,
                                   Answer<std::vector<ReferenceResult>> answer)
{
    ask<std::vector<ReferenceResult>>(
        [run = std::move(run)](History& history) { return compared(history, *run); }, context,
        std::move(answer));
}

void Archive::setLabel(std::int64_t number, int servo, const QString& label)
{
    change([=](History& history) { return history.setLabel(number, servo, label); });
}

void Archive::setNote(std::int64_t number, const QString& note)
{
    change([=](History& history) { return history.setNote(number, note); });
}

void Archive::setReference(std::int64_t number, int servo, bool reference)
{
    change([=](History& history) { return history.setReference(number, servo, reference); });
}

void Archive::remove(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) -> base::Result<void> {
        for (const std::int64_t number : numbers) {
            if (const auto done = history.remove(number); !done)
                return done;
        }
        return {};
    });
}

void Archive::work(std::function<base::Result<void>()> job, QObject* context, Answer<void> answer)
{
    const QPointer<QObject> guard(context);
    m_thread->start([this, job = std::move(job), guard, answer = std::move(answer)] {
        m_inbox.post([guard, answer, done = job()] {
            if (guard)
                answer(done);
        });
    });
}
} // namespace session
