// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/port_watcher.h"

#include "transport/port_lease.h"

#include <QFileInfo>

#include <algorithm>

namespace session {
namespace {
constexpr auto period = std::chrono::milliseconds(500);
constexpr auto settleTime = std::chrono::seconds(3);
constexpr auto longestPause = std::chrono::seconds(5);

QString kindOf(const PortInfo& port)
{
    return QStringLiteral("usb:%1:%2")
        .arg(port.vendorId, 4, 16, QLatin1Char('0'))
        .arg(port.productId, 4, 16, QLatin1Char('0'));
}

QString keyOf(const PortInfo& port)
{
    if (port.vendorId == 0)
        return port.path;
    return port.serialNumber.isEmpty() ? kindOf(port) + QLatin1Char('@') + port.path
                                       : kindOf(port) + QLatin1Char('#') + port.serialNumber;
}

bool isBefore(const PortInfo& a, const PortInfo& b)
{
    if ((a.vendorId != 0) != (b.vendorId != 0))
        return a.vendorId != 0;
    return a.path < b.path;
}

/// When a device node was last added or removed; invalid where the system has no such folder.
QDateTime lastPlugging()
{
#ifdef Q_OS_UNIX
    return QFileInfo(QStringLiteral("/dev")).lastModified();
#else
    return {};
#endif
}

/// The ports of the system, listed only when they may have changed.
PortWatcher::PortLister systemPorts()
{
    return [schedule = ListingSchedule(), ports = PortWatcher::PortList()]() mutable {
        const QDateTime changed = lastPlugging();
        if (schedule.isDue(changed, std::chrono::steady_clock::now()))
            ports = {transport::listPorts(), transport::adaptersClaimedByBrltty()};
        return ports;
    };
}
} // namespace

bool ListingSchedule::isDue(const QDateTime& changed, Time now)
{
    if (changed != m_changed) {
        m_changed = changed;
        m_settledAt = now + settleTime;
    }
    if (changed.isValid() && now >= m_settledAt && now < m_nextAt)
        return false;
    m_nextAt = now + longestPause;
    return true;
}

PortWatcher::PortWatcher(QObject* parent, PortLister lister)
    : QObject(parent)
    , m_listPorts(lister ? std::move(lister) : systemPorts())
    , m_thread([this] { run(); })
{}

PortWatcher::~PortWatcher()
{
    m_stop.request();
    m_thread.join();
}

void PortWatcher::run()
{
    std::optional<PortList> last;
    do {
        PortList look = m_listPorts();
        std::sort(look.ports.begin(), look.ports.end(), isBefore);
        if (last != look) {
            last = look;
            m_mainQueue.post([this, look = std::move(look)]() mutable { take(std::move(look)); });
        }
    } while (m_stop.waitUntil(std::chrono::steady_clock::now() + period));
}

void PortWatcher::take(PortList look)
{
    m_ports = std::move(look);
    m_isReady = true;
    Q_EMIT portsChanged();
}

const PortInfo* PortWatcher::find(const QString& path) const
{
    const auto found = std::find_if(m_ports.ports.begin(), m_ports.ports.end(),
                                    [&](const PortInfo& port) { return port.path == path; });
    return found == m_ports.ports.end() ? nullptr : &*found;
}

QString PortWatcher::adapterKey(const QString& port) const
{
    const PortInfo* info = find(transport::canonicalPath(port));
    return info != nullptr ? keyOf(*info) : port;
}

QString PortWatcher::findAdapter(const QString& adapterKey) const
{
    if (adapterKey.isEmpty())
        return {};
    std::vector<const PortInfo*> ofItsKind;
    for (const PortInfo& port : m_ports.ports) {
        if (keyOf(port) == adapterKey)
            return port.path;
        if (port.vendorId != 0 && port.serialNumber.isEmpty() &&
            adapterKey.startsWith(kindOf(port) + QLatin1Char('@')))
            ofItsKind.push_back(&port);
    }
    return ofItsKind.size() == 1 ? ofItsKind.front()->path : QString();
}

void ReplugWatcher::start(const PortWatcher& ports, const QString& adapterKey,
                          const QString& oldPath)
{
    m_key = adapterKey;
    m_oldPath = oldPath;
    m_others.clear();
    // The old path too, where the list has not noticed yet that it is gone.
    for (const PortInfo& port : ports.ports())
        m_others.insert(port.path);
}

QString ReplugWatcher::detect(const PortWatcher& ports)
{
    if (!isRunning())
        return {};
    for (auto it = m_others.begin(); it != m_others.end();)
        it = ports.find(*it) == nullptr ? m_others.erase(it) : std::next(it);
    const QString path = ports.findAdapter(m_key);
    return m_others.count(path) != 0 ? QString() : path;
}
} // namespace session
