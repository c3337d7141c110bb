// SPDX-License-Identifier: GPL-3.0-or-later
// Writes snapshots to servos: to one, as its plan says and in one transaction, or to several, one
// after the other at the port's baud rate. Reported like a write, and undo reverts it. Owned by the
// workbench; main thread; never waits.
#pragma once

#include "session/tasks/work.h"

#include <QObject>

namespace jobs {
struct ApplyResult;
}

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
    /// A servo of the list that a task has written so and has merged: as if apply() had done it.
    void report(const jobs::ApplyResult& one);

private:
    struct PendingApply;
    base::Result<void> runApply(const std::shared_ptr<PendingApply>& apply, TaskContext& task);
    void takeApplied(PendingApply& apply, const jobs::ApplyResult& one);
    void tableSaved(int id, const QString& path);

    Workbench& m_bench;
};
} // namespace session
