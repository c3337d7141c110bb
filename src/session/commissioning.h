// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line for the window: starts and stops it, carries the click to it, and has the
// batch and what the line is doing. Beside Desk, which must outlive it; main thread, never waits.
#pragma once

#include "jobs/commission.h"
#include "session/desk.h"

namespace session {
class Commissioning final : public QObject {
    Q_OBJECT

public:
    explicit Commissioning(Desk& desk, QObject* parent = nullptr);
    ~Commissioning() override;

    /// False: it runs already, or no port is open. A template file is loaded by the job: what is
    /// wrong with it arrives as ended(). `templateFile` empty: as in the spec.
    bool start(const jobs::CommissionSpec& spec, const QString& csvPath,
               const QString& templateFile = {});
    void stop();
    bool running() const { return m_running; }
    void answer(jobs::CommissionAnswer answer);

    const jobs::CommissionView& view() const { return m_view; } ///< while it runs
    const record::CommissionBatch& batch() const { return m_batch; }
    const QString& csvPath() const { return m_csvPath; } ///< of that batch; empty: none yet

    // --- a simulated bag of servos ---
    bool hasBag() const;
    std::size_t inBag() const;
    void plugNext();
    void unplug();

Q_SIGNALS:
    void began();
    void changed();      ///< view()
    void batchChanged(); ///< batch()
    /// `error`: why it could not begin or go on.
    void ended(const std::optional<base::Error>& error);

private:
    struct Live;
    void drain();
    void finish(const TaskEnd& end);

    Desk& m_desk;
    bool m_running = false;
    std::shared_ptr<Live> m_live; ///< shared with the job
    jobs::CommissionView m_view;
    record::CommissionBatch m_batch;
    QString m_csvPath;
    QTimer m_drainTimer;
};
} // namespace session
