// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/intent_locks.h"

#include <QDir>

namespace record {
IntentLocks::IntentLocks(QString folder)
    : m_folder(std::move(folder))
{}

IntentLocks::~IntentLocks()
{
    releaseAll();
}

QString IntentLocks::lockPathOf(const QString& uuid) const
{
    return m_folder + QLatin1Char('/') + uuid;
}

void IntentLocks::acquire(const QString& uuid)
{
    QDir().mkpath(m_folder);
    auto file = std::make_unique<FileHandle>(lockPathOf(uuid), FileHandle::Mode::Append);
    if (!file->isOpen())
        return;
    if (file->tryLock(FileHandle::Lock::Exclusive) != FileHandle::LockResult::Locked) {
        file.reset();
        QFile::remove(lockPathOf(uuid));
        return;
    }
    const std::lock_guard lock(m_mutex);
    m_heldLocks[uuid] = std::move(file);
}

void IntentLocks::release(const QString& uuid)
{
    const std::lock_guard lock(m_mutex);
    if (m_heldLocks.erase(uuid) > 0)
        QFile::remove(lockPathOf(uuid));
}

void IntentLocks::releaseAll()
{
    const std::lock_guard lock(m_mutex);
    while (!m_heldLocks.empty()) {
        const QString uuid = m_heldLocks.begin()->first;
        m_heldLocks.erase(m_heldLocks.begin()); // a file that is open cannot be removed everywhere
        QFile::remove(lockPathOf(uuid));
    }
}

bool IntentLocks::isHeldElsewhere(const QString& uuid) const
{
    {
        const std::lock_guard lock(m_mutex);
        if (m_heldLocks.count(uuid) > 0)
            return false;
    }
    bool stale = false;
    {
        FileHandle file(lockPathOf(uuid), FileHandle::Mode::Read);
        if (!file.isOpen())
            return false;
        const auto tried = file.tryLock(FileHandle::Lock::Shared); // others may ask as well
        if (tried == FileHandle::LockResult::HeldElsewhere)
            return true;
        stale = tried == FileHandle::LockResult::Locked;
    }
    if (stale)
        QFile::remove(lockPathOf(uuid));
    return false;
}
} // namespace record
