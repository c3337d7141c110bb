// SPDX-License-Identifier: GPL-3.0-or-later
// The history for the window: asked on a thread of its own, answered on the main thread; never
// waits, but that the destructor writes down what keep() was given. Beside Desk, in no need of it.
// Other programs may change the history at any time; whoever shows a list asks again at changed().
// Answers to a `context` that has gone are dropped.
#pragma once

#include "record/history.h"
#include "record/sweep_compare.h"
#include "session/inbox.h"
#include "session/job_thread.h"
#include "session/paths.h"

#include <QPointer>

namespace session {
using SharedRun = std::shared_ptr<const record::SweepRun>;

/// One servo of a run against the reference of its model.
struct ReferenceResult {
    int servo = -1;
    record::TestRun run; ///< the reference's
    record::TestServo reference;
    record::SweepComparison found; ///< A is the reference
};

class Archive final : public QObject {
    Q_OBJECT

public:
    explicit Archive(QString path = historyFile(), QObject* parent = nullptr);
    ~Archive() override;

    /// kept() or keepFailed() follow. Order is kept.
    void keep(SharedRun run, const QStringList& files = {});

    template <typename T>
    using Answer = std::function<void(const base::Result<T>&)>;

    void list(const record::RunFilter& filter, QObject* context,
              Answer<std::vector<record::TestRun>> answer);
    void load(std::int64_t number, QObject* context, Answer<SharedRun> answer);
    /// Of the servos whose model has a reference that is not this very run.
    void compareWithReference(SharedRun run, QObject* context,
                              Answer<std::vector<ReferenceResult>> answer);

    // changed() or failed() follow
    void setLabel(std::int64_t number, int servo, const QString& label);
    void setNote(std::int64_t number, const QString& note);
    void setReference(std::int64_t number, int servo, bool reference);
    void remove(const std::vector<std::int64_t>& numbers);

    /// Something slow that touches no history, such as saving a report, in the same order.
    void work(std::function<base::Result<void>()> job, QObject* context, Answer<void> answer);

Q_SIGNALS:
    void kept(std::int64_t number);
    /// `file`: where the run was left instead; empty: it is nowhere.
    void keepFailed(const base::Error& error, const QString& file);
    void changed();
    void failed(const base::Error& error);

private:
    struct Pending {
        SharedRun run;
        QStringList files;
    };
    template <typename T>
    void ask(std::function<base::Result<T>(record::History&)> question, QObject* context,
             Answer<T> answer);
    void change(std::function<base::Result<void>(record::History&)> deed);
    record::KeptRun keepNext();

    const QString m_path;
    Inbox m_inbox;
    std::mutex m_mutex;
    std::deque<Pending> m_pending; ///< what is to be kept and is not yet
    std::unique_ptr<JobThread> m_thread;
};
} // namespace session
