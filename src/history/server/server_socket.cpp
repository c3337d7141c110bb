// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/server/server_socket.h"

#include <QByteArray>
#include <QLibrary>
#include <QSqlDriver>
#include <QVariant>

#ifdef Q_OS_UNIX
#include <sys/socket.h>
#include <unistd.h>
#endif

namespace history {
#ifdef Q_OS_UNIX
namespace {
using SocketOf = int (*)(const void* connection);

/// From the library that the driver has loaded already, so that the program does not link to it.
int socketOf(const QSqlDriver& driver)
{
    const QVariant handle = driver.handle();
    const QByteArray type(handle.typeName());
    if (type != "pg_conn*" && type != "PGconn*") // one type; Qt's versions name it differently
        return -1;
    QLibrary library(QStringLiteral("pq"), 5);
    const auto function = reinterpret_cast<SocketOf>(library.resolve("PQsocket"));
    return function == nullptr ? -1 : function(*static_cast<void* const*>(handle.constData()));
}
} // namespace

void ServerSocket::attach(const QSqlDriver& driver)
{
    detach();
    const int socket = socketOf(driver);
    const std::lock_guard lock(m_mutex);
    m_socket = socket < 0 ? -1 : ::dup(socket);
    if (m_closed && m_socket >= 0)
        ::shutdown(m_socket, SHUT_RDWR);
}

void ServerSocket::detach()
{
    const std::lock_guard lock(m_mutex);
    if (m_socket >= 0)
        ::close(m_socket);
    m_socket = -1;
}

void ServerSocket::close()
{
    const std::lock_guard lock(m_mutex);
    m_closed = true;
    if (m_socket >= 0)
        ::shutdown(m_socket, SHUT_RDWR);
}
#else
void ServerSocket::attach(const QSqlDriver&) {}
void ServerSocket::detach() {}

void ServerSocket::close()
{
    const std::lock_guard lock(m_mutex);
    m_closed = true;
}
#endif

bool ServerSocket::isClosed() const
{
    const std::lock_guard lock(m_mutex);
    return m_closed;
}
} // namespace history
