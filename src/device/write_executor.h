// SPDX-License-Identifier: GPL-3.0-or-later
// One write from the first byte to the last: torque, lock, frames, reading back, saving. Internal
// to device: owned by write(), which has checked everything and opened the intent. The job's
// thread.
#pragma once

#include "device/motion/mode.h"

namespace device {
class WriteExecutor {
public:
    WriteExecutor(const Context& context, Servo& servo, RegisterValues items,
                  const WriteOptions& options)
        : m_context(context)
        , m_servo(servo)
        , m_items(std::move(items))
        , m_options(options)
    {
        m_report.id = servo.id;
        for (const RegisterValue& item : m_items) {
            m_report.writes.push_back({item.reg->key,
                                       item.reg->address,
                                       servo.raw(*item.reg),
                                       item.raw,
                                       std::nullopt,
                                       WriteOutcome::Unknown,
                                       {}});
        }
    }

    bool concernsLock() const { return nextLocked(0) < m_items.size(); }

    /// The change of mode these items mean, if any; known after the settings have been read.
    void setModeChange(std::optional<ModeChange> change) { m_change = change; }

    WriteReport run();
    bool finished() const;

private:
    bool needsTorqueOff() const;
    std::size_t nextLocked(std::size_t from) const;
    std::size_t endOfSection(std::size_t first) const;
    base::Result<void> prepare();
    bool writeSection(std::size_t first, std::size_t last);
    bool writeRange(std::size_t first, std::size_t last);
    bool writeGroups(std::size_t first, std::size_t last);
    void writeGroup(std::size_t first, std::size_t last);
    base::Result<void> sendGroup(std::size_t first, std::size_t last);
    void abortAt(std::size_t first, std::size_t last, const base::Error& why);
    const WriteResult* failed(std::size_t first, std::size_t last) const;
    bool readTogether(std::size_t first, std::size_t last);
    void evaluate(std::size_t index, const base::Result<void>& sent, bool alreadyRead);
    void finishModeChange();
    void setLockState(LockState lock);
    void makePersistent(std::size_t index);
    void markUncertain(std::size_t first, std::size_t last);
    void skipRest(std::size_t first, const base::Error& why);

    const Context& m_context;
    Servo& m_servo;
    RegisterValues m_items;
    const WriteOptions& m_options;
    std::optional<ModeChange> m_change;
    bool m_open = false; ///< the lock is open for the present items
    bool m_modeChangeFailed = false;
    std::optional<base::Error> m_fatalError; ///< nothing more may be sent after it
    WriteReport m_report;
};
} // namespace device
