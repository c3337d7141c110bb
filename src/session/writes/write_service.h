// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the memory table of a servo: as tasks, with what happens to each register marked
// in the list, and with undo and redo. Owned by the workbench; main thread; never waits. A write
// that cannot run marks its registers and is reported like one that failed.
#pragma once

#include "device/writer.h"
#include "session/tasks/work.h"

#include <QObject>

namespace jobs {
struct RecoveryResult;
}

namespace session {
class Workbench;

class WriteService final : public QObject {
    Q_OBJECT

public:
    explicit WriteService(Workbench& bench);

    /// Reads the whole table. Writes nothing.
    void readTable(ServoRef ref);
    void write(ServoRef ref, const WriteRequest& request);

    const UndoStep* undoStep() const;
    const UndoStep* redoStep() const;
    /// Consent is asked for anew; without it a dangerous row is refused, in both.
    void undo(device::Consent consent = {});
    void redo(device::Consent consent = {});

    /// Reads this servo's writes from the journal; servoChanged follows.
    void loadHistory(ServoRef ref);

    /// For the services of the workbench.
    enum class WriteKind : std::uint8_t { New, Undo, Redo };
    void markWritesPending(ServoEntry& known, const WriteRequest& request);
    void writeEnded(const Work& ended, const WriteRequest& request, WriteKind kind,
                    const std::optional<device::WriteReport>& report);
    void mergeRecoveredUndo(const jobs::RecoveryResult& one, ServoRef ref);

Q_SIGNALS:
    void undoChanged();

private:
    void tableRead(const Work& ended);
    /// `expected`: of a way back, what its registers must still hold.
    void enqueueWrite(ServoRef ref, const WriteRequest& request, WriteKind kind,
                      const std::vector<device::WriteItem>& expected = {});
    void markWrites(const ServoEntry& about, const Work& ended, const WriteRequest& request,
                    const std::optional<device::WriteReport>& report);
    void recordUndo(const Work& ended, const WriteRequest& request, WriteKind kind,
                    const std::optional<device::WriteReport>& report);
    void forget(ServoRef ref);

    Workbench& m_bench;
    std::vector<UndoStep> m_undo;
    std::vector<UndoStep> m_redo;
    std::optional<UndoStep> m_pendingStep; ///< the step an undo or redo is writing now
};
} // namespace session
