// SPDX-License-Identifier: GPL-3.0-or-later
// Which open intents a running program is executing: a locked file for each, in a folder beside the
// history. The system releases the lock when the program ends, also by kill -9, so that no times or
// process numbers are needed. Where files cannot be locked, no intent counts as being executed. Any
// thread.
#pragma once

#include "files/file_handle.h"

#include <map>
#include <memory>
#include <mutex>

namespace history {
class IntentLocks {
public:
    /// The folder is made by the first acquire().
    explicit IntentLocks(QString folder);
    ~IntentLocks();
    IntentLocks(const IntentLocks&) = delete;
    IntentLocks& operator=(const IntentLocks&) = delete;

    void acquire(const QString& uuid);
    void release(const QString& uuid); ///< does nothing if it is not held here
    void releaseAll();

    /// Removes the file of a program that was killed.
    bool isHeldElsewhere(const QString& uuid) const;

private:
    QString lockPathOf(const QString& uuid) const;

    const QString m_folder;
    mutable std::mutex m_mutex;
    std::map<QString, std::unique_ptr<files::FileHandle>> m_heldLocks;
};
} // namespace history
