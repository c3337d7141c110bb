// SPDX-License-Identifier: GPL-3.0-or-later
// The socket below a connection of Qt's PostgreSQL driver, for the one thing neither Qt nor libpq
// offers: ending a wait for a server that has stopped answering, from another thread. Owned by
// HistoryServer; take() and release() on its thread, close() from any.
#pragma once

#include <mutex>

class QSqlDriver;

namespace history {
class ServerSocket {
public:
    ~ServerSocket() { detach(); }

    /// Of an open connection. Closed at once if close() has been called before.
    void attach(const QSqlDriver& driver);
    void detach();
    /// Code that reads or writes there sees the end of the connection.
    void close();
    bool isClosed() const;

private:
    mutable std::mutex m_mutex;
    int m_socket = -1; ///< our own descriptor of it, so that it is never another file's
    bool m_closed = false;
};
} // namespace history
