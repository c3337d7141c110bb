// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_lease.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

#include <mutex>
#include <set>

namespace transport {
namespace {
struct Registry {
    std::mutex mutex;
    std::set<QString> paths;
};

Registry& registry()
{
    static Registry instance;
    return instance;
}

QString processName(const QString& pid)
{
    QFile file(QStringLiteral("/proc/%1/comm").arg(pid));
    if (!file.open(QIODevice::ReadOnly))
        return QStringLiteral("?");
    return QString::fromLocal8Bit(file.readAll()).trimmed();
}

/// A simulated bus holds both ends of its pseudo-terminal.
bool isMasterOf(const QString& pid, const QString& descriptor, const QString& path)
{
    QFile info(QStringLiteral("/proc/%1/fdinfo/%2").arg(pid, descriptor));
    if (!path.startsWith(QLatin1String("/dev/pts/")) || !info.open(QIODevice::ReadOnly))
        return false;
    const QByteArray index = path.section(QLatin1Char('/'), -1).toLatin1();
    for (const QByteArray& line : info.readAll().split('\n')) {
        if (line.startsWith("tty-index:"))
            return line.mid(line.indexOf(':') + 1).trimmed() == index;
    }
    return false;
}

bool isOpenIn(const QString& pid, const QString& path)
{
    const QDir descriptors(QStringLiteral("/proc/%1/fd").arg(pid));
    const auto links = descriptors.entryInfoList(QDir::Files | QDir::System | QDir::NoDotAndDotDot);
    bool found = false;
    for (const QFileInfo& link : links) {
        const QString target = link.symLinkTarget();
        if (target.endsWith(QLatin1String("/ptmx")) && isMasterOf(pid, link.fileName(), path))
            return false;
        found = found || target == path;
    }
    return found;
}
} // namespace

QString canonicalPath(const QString& name)
{
    const QString canonical = QFileInfo(name).canonicalFilePath();
    if (!canonical.isEmpty())
        return canonical;
    const QString device = QFileInfo(QStringLiteral("/dev/") + name).canonicalFilePath();
    return device.isEmpty() || name.startsWith(QLatin1Char('/')) ? name : device;
}

base::Result<PortLease> PortLease::acquire(const QString& canonical)
{
    Registry& leases = registry();
    const std::lock_guard lock(leases.mutex);
    if (!leases.paths.insert(canonical).second)
        return base::fail(base::ErrorCode::PortBusy, QStringLiteral("open"),
                          QStringLiteral("%1 (%2)")
                              .arg(processName(QStringLiteral("self")))
                              .arg(QCoreApplication::applicationPid()));
    return PortLease(canonical);
}

PortLease& PortLease::operator=(PortLease&& other) noexcept
{
    m_path.swap(other.m_path);
    return *this;
}

void PortLease::release()
{
    if (m_path.isEmpty())
        return;
    Registry& leases = registry();
    const std::lock_guard lock(leases.mutex);
    leases.paths.erase(m_path);
    m_path.clear();
}

QString portHolders(const QString& canonical)
{
    const QString self = QString::number(QCoreApplication::applicationPid());
    QStringList holders;
    const QStringList processes = QDir(QStringLiteral("/proc")).entryList(QDir::Dirs);
    for (const QString& pid : processes) {
        bool isNumber = false;
        pid.toInt(&isNumber);
        if (isNumber && pid != self && isOpenIn(pid, canonical))
            holders += QStringLiteral("%1 (%2)").arg(processName(pid), pid);
    }
    return holders.join(QLatin1String(", "));
}

QString portGroup(const QString& canonical)
{
    return QFileInfo(canonical).group();
}
} // namespace transport
