// SPDX-License-Identifier: GPL-3.0-or-later
// The ports of this computer, kept up to date: looks about once a second on a thread of its own,
// because listing them takes tens of milliseconds. Lives on the main thread, which never waits for
// it.
#pragma once

#include "base/stop.h"
#include "session/inbox.h"
#include "transport/port_inventory.h"

#include <thread>

namespace session {
class PortWatch final : public QObject {
    Q_OBJECT

public:
    using Lister = std::function<std::vector<transport::PortInfo>()>;
    /// `lister` replaces the system's list, for tests.
    explicit PortWatch(QObject* parent = nullptr, Lister lister = {});
    ~PortWatch() override;

    /// Adapters first, then the other ports; by path.
    const std::vector<transport::PortInfo>& ports() const { return m_ports; }

    /// What stays the same when an adapter is plugged in elsewhere: vendor, product and serial
    /// number; its path if it has none, or for anything that is not in the list (tcp://, sim:).
    QString adapterKey(const QString& port) const;
    /// Where the adapter is now; empty: not there.
    QString portOf(const QString& adapterKey) const;

Q_SIGNALS:
    void portsChanged(); ///< only when the list differs

private:
    void run();

    Lister m_lister;
    std::vector<transport::PortInfo> m_ports;
    Inbox m_inbox;
    base::Stop m_stop;
    std::thread m_thread;
};
} // namespace session
