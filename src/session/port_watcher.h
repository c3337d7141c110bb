// SPDX-License-Identifier: GPL-3.0-or-later
// The ports of this computer, kept up to date: looks twice a second on a thread of its own, because
// listing them, where that is needed, takes tens of milliseconds. Lives on the main thread, which
// never waits for it; the destructor waits for the look that is under way.
#pragma once

#include "base/stop_token.h"
#include "session/main_thread_queue.h"
#include "transport/port_inventory.h"

#include <QDateTime>

#include <chrono>
#include <set>
#include <thread>

namespace session {
using PortInfo = transport::PortInfo;

/// When the ports must be listed, which takes thousands of system calls: after a change in the
/// folder of device nodes, for a while, since permissions and links follow; and now and then,
/// since a permission alone changes nothing there. A value; any thread.
class ListingSchedule {
public:
    using Time = std::chrono::steady_clock::time_point;
    /// `changed`: the time of the folder; invalid: there is none, so always.
    bool isDue(const QDateTime& changed, Time now);

private:
    QDateTime m_changed;
    Time m_settledAt{};
    Time m_nextAt{};
};

class PortWatcher final : public QObject {
    Q_OBJECT

public:
    struct PortList {
        std::vector<PortInfo> ports;
        QStringList claimedAdapters; ///< adapters the braille service holds: "1a86:7523"
        bool operator==(const PortList&) const = default;
    };
    using PortLister = std::function<PortList()>;
    /// `lister` replaces the system's list, for tests; it is called on the watch's thread.
    explicit PortWatcher(QObject* parent = nullptr, PortLister lister = {});
    ~PortWatcher() override;

    /// False until the first look: nothing can be said of what is there yet.
    bool isReady() const { return m_isReady; }

    /// Adapters first, then the other ports; by path.
    const std::vector<PortInfo>& ports() const { return m_ports.ports; }
    const PortInfo* find(const QString& path) const; ///< null: not there

    /// Adapters that are plugged in and have no port, because the braille service took them.
    const QStringList& claimedAdapters() const { return m_ports.claimedAdapters; }

    /// What stays the same when an adapter is plugged in elsewhere: vendor, product and serial
    /// number. One without a serial number is known by its path as well; anything that is not an
    /// adapter in the list (tcp://, sim:) by its name only.
    QString adapterKey(const QString& port) const;
    /// Where the adapter is now; empty: not there. One without a serial number is also found at
    /// another path, if it is the only one of its kind.
    QString findAdapter(const QString& adapterKey) const;

Q_SIGNALS:
    void portsChanged(); ///< only when the list differs, and after the first look

private:
    void run();
    void take(PortList look);

    PortLister m_listPorts;
    PortList m_ports;
    bool m_isReady = false;
    MainThreadQueue m_mainQueue;
    base::StopToken m_stop;
    std::thread m_thread; ///< last: it uses the others
};

/// Waits for one adapter to come back after it was unplugged. Others of the same kind that were
/// there all the time are not it. Main thread; a value.
class ReplugWatcher {
public:
    /// From now on; `adapterKey` as it was while the adapter was there.
    void start(const PortWatcher& ports, const QString& adapterKey, const QString& oldPath);
    void stop() { m_key.clear(); }
    /// Some time later: a port that is still in the list has come back faster than was looked.
    void forgetOldPath() { m_others.erase(m_oldPath); }
    bool isRunning() const { return !m_key.isEmpty(); }

    /// Call at each portsChanged: where the adapter is, once it is back.
    QString detect(const PortWatcher& ports);

private:
    QString m_key;
    QString m_oldPath;
    std::set<QString> m_others; ///< paths that were never free since
};
} // namespace session
