// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/intent_locks.h"

#include <QDir>

namespace history {
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
    auto file =
        std::make_unique<files::FileHandle>(lockPathOf(uuid), files::FileHandle::Mode::Append);
    if (!file->isOpen())
        return;
    if (file->tryLock(files::FileHandle::Lock::Exclusive) !=
        files::FileHandle::LockResult::Locked) {
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
        m_heldLocks.erase(m_heldLocks.begin()); // some systems cannot remove an open file
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
        files::FileHandle file(lockPathOf(uuid), files::FileHandle::Mode::Read);
        if (!file.isOpen())
            return false;
        const auto tried = file.tryLock(
            files::FileHandle::Lock::Shared); // other programs may check at the same time
        if (tried == files::FileHandle::LockResult::HeldElsewhere)
            return true;
        stale = tried == files::FileHandle::LockResult::Locked;
    }
    if (stale)
        QFile::remove(lockPathOf(uuid));
    return false;
}
} // namespace history
