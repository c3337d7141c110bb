// SPDX-License-Identifier: GPL-3.0-or-later
// One restore from the first byte to the last: interrupted earlier ones, the registers, ID and
// rate, rolling back. Internal to jobs: owned by restore(), which has checked the plan. The job's
// thread; it must not outlive what it refers to.
#pragma once

#include "jobs/restore/restore.h"

namespace jobs {
/// An ID or a rate: a job of its own.
bool needsOwnJob(const RestoreWrite& write);
bool isLockOpen(const device::Servo& servo);

class RestoreRunner {
public:
    RestoreRunner(const device::Context& context, device::Servo& servo,
                  const RestoreOptions& options, const ProgressFn& progress,
                  RestoreOutcome& outcome)
        : m_context(context)
        , m_servo(servo)
        , m_options(options)
        , m_progress(progress)
        , m_outcome(outcome)
    {}

    /// Finishes interrupted earlier ones, then writes registers, ID and rate; rolls back where
    /// requested. Fills in verdict, rows and lock. Errors: nothing was written.
    base::Result<void> run(const std::vector<base::Intent>& earlier,
                           const std::vector<RestoreWrite>& writes);

private:
    /// False: a row of it did not take its value, so nothing more must be written.
    bool finishInterrupted(const std::vector<base::Intent>& intents);
    /// Registers, then ID and rate; nothing if all values are set already. Errors: nothing was
    /// written.
    base::Result<void> writeAll(const std::vector<RestoreWrite>& writes);
    bool isStillToWrite(const RestoreWrite& write) const;
    /// The registers, in one transaction. Errors: nothing was written.
    base::Result<void> writeRegisters(const std::vector<RestoreWrite>& writes);
    /// ID and rate, each as a job of its own.
    void writeIdentity(const std::vector<RestoreWrite>& writes);
    void closeOpenLock();
    void rollBack();
    void addRollBack(const device::WriteReport& report);
    bool isSuccessful() const;
    void addResults(const device::WriteReport& report);
    void addRefused(const RestoreWrite& write, const base::Error& why);
    void addAllRefused(const std::vector<RestoreWrite>& writes, const base::Error& why);
    base::Error skippedAfterFailure(const QString& key) const;
    base::Result<device::WriteReport> changeIdentity(const RestoreWrite& write);
    std::vector<device::WriteItem> previousItems() const;
    std::vector<base::ItemResult> revertedItemEnds() const;
    void forgetTorque();
    void noteTorque();

    const device::Context& m_context;
    device::Servo& m_servo;
    const RestoreOptions& m_options;
    const ProgressFn& m_progress;
    RestoreOutcome& m_outcome;
    QStringList m_openIntents;
    std::optional<base::Error> m_unfinished; ///< why an earlier one could not be finished
};
} // namespace jobs
