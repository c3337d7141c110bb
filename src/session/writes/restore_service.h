// SPDX-License-Identifier: GPL-3.0-or-later
// Writes snapshots to servos: to one, as its plan says and in one transaction, or to several, one
// after the other at the port's baud rate. Reported like a write, and undo reverts it. Owned by the
// workbench; main thread; never waits.
#pragma once

#include "session/tasks/work.h"

#include <QObject>

namespace jobs {
struct ApplyResult;
struct RestoreOutcome;
} // namespace jobs

namespace session {
class Workbench;
struct ApplyRequest;
struct RestoreRequest;

class RestoreService final : public QObject {
    Q_OBJECT

public:
    explicit RestoreService(Workbench& bench);

    void restore(ServoRef ref, const RestoreRequest& request);
    void apply(ApplyRequest request);
    /// For a task of its own that has written to a servo so: told and undone like a write.
    void reportApplied(ServoRef ref, const jobs::ApplyResult& one);

private:
    struct PendingApply;
    void writesEnded(const Work& ended, const WriteRequest& writes,
                     const std::optional<jobs::RestoreOutcome>& outcome);
    base::Result<void> runApply(const std::shared_ptr<PendingApply>& apply, TaskContext& task);
    void takeApplied(PendingApply& apply, const jobs::ApplyResult& one);
    void tableSaved(int id, const QString& path);

    Workbench& m_bench;
};
} // namespace session
