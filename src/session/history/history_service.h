// SPDX-License-Identifier: GPL-3.0-or-later
// The history for the window: queries run on a thread of its own and are answered on the main
// thread; never waits, except that the destructor saves what is still to be saved. Other programs
// may change the history at any time: a page that shows a list is its viewer for that time and
// queries again at changed(). Answers to a `context` that was destroyed are dropped.
#pragma once

#include "base/job_thread.h"
#include "history/history.h"
#include "history/history_export.h"
#include "history/history_table.h"
#include "history/server/history_server.h"
#include "results/sweep_compare.h"
#include "session/detachable_worker.h"
#include "session/history/history_source.h"
#include "session/history/reported_alarms.h"
#include "session/main_thread_queue.h"
#include "session/paths.h"

#include <QPointer>

namespace session {
class HistoryWatcher;
using SharedRun = std::shared_ptr<const results::SweepRun>;
using SharedStep = std::shared_ptr<const results::StepRun>;
using SharedSnapshot = std::shared_ptr<const snapshot::Snapshot>;

/// One servo of a run against the reference of its model.
struct ReferenceResult {
    int servo = -1;
    history::TestRun run; ///< the reference's
    history::TestServo reference;
    results::SweepComparison comparison; ///< A is the reference
    bool ignored = false;                ///< the reference did not finish: nothing is compared
};

class HistoryService final : public QObject {
    Q_OBJECT

public:
    explicit HistoryService(QString path = historyFile(), QObject* parent = nullptr);
    /// Asked only: what would keep or change anything fails.
    explicit HistoryService(std::unique_ptr<HistorySource> source, QObject* parent = nullptr);
    ~HistoryService() override;

    /// kept() or keepFailed() follow. Order is kept.
    void saveRun(SharedRun run, const QStringList& files = {});
    void saveRun(SharedStep run, const QStringList& files = {});

    // Saved in order; changed() or failed() follow.
    void saveAlarm(const base::ServoIdentity& identity, const AlarmChange& change);
    void saveRecording(const history::HistoryRecording& recording,
                       const std::vector<base::ServoIdentity>& servos);
    void saveHistorySnapshot(SharedSnapshot snapshot, history::SnapshotReason reason,
                             const QString& file = {});

    template <typename T>
    using Answer = std::function<void(const base::Result<T>&)>;

    void list(const history::RunFilter& filter, QObject* context,
              Answer<std::vector<history::TestRun>> answer);
    void load(std::int64_t number, QObject* context, Answer<SharedRun> answer);
    void loadStep(std::int64_t number, QObject* context, Answer<SharedStep> answer);

    /// Any other: `query` takes the open history, on the service's thread, and returns a Result<T>.
    template <typename T, typename Query>
    void query(Query query, QObject* context, Answer<T> answer);

    // Pages: filter.limit rows, filter.after for the next.
    void servos(const history::HistoryFilter& filter, QObject* context,
                Answer<std::vector<history::HistoryServo>> answer);
    void writes(const history::HistoryFilter& filter, QObject* context,
                Answer<std::vector<history::HistoryWrite>> answer);
    void countWrites(const history::HistoryFilter& filter, QObject* context,
                     Answer<std::int64_t> answer);
    void writtenKeys(std::optional<std::int64_t> servo, QObject* context,
                     Answer<QStringList> answer);
    void snapshots(const history::HistoryFilter& filter, QObject* context,
                   Answer<std::vector<history::HistorySnapshot>> answer);
    void loadSnapshot(std::int64_t number, QObject* context, Answer<SharedSnapshot> answer);
    /// The catalog's data is shared; the object may go.
    void tableAt(const catalog::Catalog& catalog, std::int64_t servo, const QDateTime& at,
                 QObject* context, Answer<history::TableState> answer);
    void alarms(const history::HistoryFilter& filter, QObject* context,
                Answer<std::vector<history::HistoryAlarm>> answer);
    void recordings(const history::HistoryFilter& filter, QObject* context,
                    Answer<std::vector<history::HistoryRecording>> answer);
    /// CSV takes one kind, JSON any. Answers the rows written.
    void exportTo(const QString& path, bool csv, const std::vector<history::HistoryKind>& kinds,
                  const history::HistoryFilter& filter, QObject* context,
                  Answer<std::int64_t> answer);
    /// Of the servos whose model has a reference that is not this very run.
    void compareWithReference(SharedRun run, QObject* context,
                              Answer<std::vector<ReferenceResult>> answer);

    // Of a server: the benches that send there; the bench whose history is read from now on
    // (nullopt: all); and the bench that sent each row of "writes", "snapshots" …, number → name.
    // A file answers none.
    void benches(QObject* context, Answer<std::vector<history::HistoryBench>> answer);
    void selectBench(std::optional<std::int64_t> bench) { m_source->selectBench(bench); }
    void benchNames(const QString& table, const std::vector<std::int64_t>& numbers,
                    QObject* context, Answer<QMap<qint64, QString>> answer);

    // changed() or failed() follow
    void setLabel(std::int64_t number, int servo, const QString& label);
    void setNote(std::int64_t number, const QString& note);
    void setReference(std::int64_t number, int servo, bool reference);
    void remove(const std::vector<std::int64_t>& numbers);
    void setServoLabel(std::int64_t servo, const QString& label);
    void setSnapshotNote(std::int64_t number, const QString& label, const QString& note);
    void removeSnapshots(const std::vector<std::int64_t>& numbers);

    /// While there is a viewer, changed() also follows what other programs and connections write
    /// to the file. A server is not watched.
    void setWatched(QObject* viewer, bool viewed);

    /// Something slow that touches no history, such as saving a report, in the same order.
    void runInOrder(std::function<base::Result<void>()> job, QObject* context, Answer<void> answer);

Q_SIGNALS:
    void runSaved(std::int64_t number);
    /// `file`: where the run was left instead; empty: it is nowhere.
    void runSaveFailed(const base::Error& error, const QString& file);
    void changed();
    void failed(const base::Error& error);

private:
    /// What must be saved in any case; answers where it was saved.
    using SaveJob = std::function<history::SavedRun(const QString& path)>;
    /// The number of a run is in runSaved(); for the others failed() follows an error.
    enum class Kind : std::uint8_t { Run, Other };
    void saveLater(SaveJob saveJob, Kind kind = Kind::Run);
    void change(std::function<base::Result<void>(history::History&)> action);
    history::SavedRun saveNext();

    const QString m_path;
    MainThreadQueue m_mainQueue;
    std::mutex m_mutex;
    std::deque<SaveJob> m_pending; ///< what is to be kept and is not yet
    std::shared_ptr<GuardedPoster> m_post;
    std::shared_ptr<base::JobThread> m_thread; ///< shared with the source, where that is the file
    std::unique_ptr<HistorySource> m_source;
    std::unique_ptr<HistoryWatcher> m_watch; ///< null over a server
};

template <typename T, typename Query>
void HistoryService::query(Query query, QObject* context, Answer<T> answer)
{
    const QPointer<QObject> guard(context);
    m_source->start([post = m_post, query = std::move(query), guard,
                     answer = std::move(answer)](const base::Result<history::History*>& history) {
        base::Result<T> result = tl::unexpected(history ? base::Error{} : history.error());
        if (history)
            result = query(**history);
        post->post([guard, answer, result = std::move(result)] {
            if (guard)
                answer(result);
        });
    });
}
} // namespace session
