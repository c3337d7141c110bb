// SPDX-License-Identifier: GPL-3.0-or-later
// The port: opens it, watches whether it is lost, closes it. Opening and closing run on the
// workbench's background thread, since an adapter may take its time. Owned by the workbench; main
// thread; never waits. What fails arrives as connectFailed.
#pragma once

#include "session/connection.h"
#include "session/event.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace session {
class Workbench;

class LinkController final : public QObject {
    Q_OBJECT

public:
    explicit LinkController(Workbench& bench);

    LinkState state() const { return m_state; }
    const PortRequest& lastRequest() const { return m_request; }
    bool isSimulated() const;
    int baud() const; ///< the port's present rate; 0 without port
    bool canSetBaud() const;
    bus::Statistics statistics() const;
    Connection* connection() const { return m_connection.get(); } ///< null while not open
    bool hasOpenedPort() const { return !m_portName.isEmpty(); }  ///< one was open before, or is
    const QString& portName() const
    {
        return m_portName;
    } ///< as the journal has it; of the latest port
    bool isOpening() const { return m_opening; }

    /// Closes what is open first. linkChanged follows; a failure arrives as connectFailed.
    void connectTo(const PortRequest& request);
    /// Opens the lost port again, under the present name of its adapter, at its latest rate. The
    /// list of servos stays, and only those of this rate are asked whether they reply. Does nothing
    /// unless the port is lost and closed. It stays lost until it is open.
    void reconnect(const QString& portName);
    void cancelReconnect(); ///< an attempt under way opens nothing any more
    bool isReconnect() const { return m_isReconnect; } ///< that is how it was opened
    void powerCycle();                                 ///< simulated servos only

    /// For the services of the workbench.
    void setState(LinkState state);
    void dropNextRequest() { m_nextRequest.reset(); }
    void connectToNext(); ///< what was asked for while the port was closing
    void closeConnection();

Q_SIGNALS:
    void linkChanged();
    void connectFailed(const base::Error& error);

private:
    void open(const PortRequest& request);
    void portOpened(base::Result<std::unique_ptr<Connection>> result);
    void checkLink();

    Workbench& m_bench;
    LinkState m_state = LinkState::Off;
    PortRequest m_request;
    std::optional<PortRequest> m_nextRequest; ///< connect when the present one is closed
    bool m_isReconnect = false;
    bool m_isCanceled = false;
    bool m_isRenamed = false; ///< the reconnected port had another name when it was lost
    int m_lostBaud = 0;       ///< the port's rate before it was lost, outside of searches
    bool m_opening = false;   ///< the opening of a port has not ended, needed or not
    QString m_portName;
    std::unique_ptr<Connection> m_connection;
    QTimer m_timer;
};
} // namespace session
