// SPDX-License-Identifier: GPL-3.0-or-later
// One restore from the first byte to the last: what was broken off earlier, the registers, ID and
// rate, the way back. Internal to jobs: lives on the stack of restore(), which has checked the
// plan. The job's thread; what it points to outlives it.
#pragma once

#include "jobs/restore/restore.h"

namespace jobs {
/// An ID or a rate: a job of its own.
bool needsOwnJob(const RestoreWrite& write);
bool isLockOpen(const device::Servo& servo);

class RestoreRunner {
public:
    RestoreRunner(const device::Context& context, device::Servo& servo,
                  const RestoreOptions& options, RestoreOutcome& outcome)
        : m_context(context)
        , m_servo(servo)
        , m_options(options)
        , m_outcome(outcome)
    {}

    /// What was broken off earlier, then registers, ID and rate; rolled back where asked. Fills in
    /// verdict, rows and lock. Errors: nothing was written.
    base::Result<void> run(const std::vector<base::Intent>& earlier,
                           const std::vector<RestoreWrite>& writes);

private:
    /// False: a row of it did not take its value, so nothing more is to be written.
    bool finishInterrupted(const std::vector<base::Intent>& intents);
    /// Registers, then ID and rate; nothing where everything is so already. Errors: nothing was
    /// written.
    base::Result<void> writeAll(const std::vector<RestoreWrite>& writes);
    /// The registers, in one transaction. Errors: nothing was written.
    bool isStillToWrite(const RestoreWrite& write) const;
    base::Result<void> writeRegisters(const std::vector<RestoreWrite>& writes);
    /// ID and rate, each as a job of its own.
    void writeIdentity(const std::vector<RestoreWrite>& writes);
    void closeOpenLock();
    void rollBack();
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
    RestoreOutcome& m_outcome;
    QStringList m_openIntents;
    std::optional<base::Error> m_unfinished; ///< why something earlier could not be ended
};
} // namespace jobs
