// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every connection on 127.0.0.1 and never says a word, like a server that hangs or a firewall
// that swallows. Lives in the kernel: nobody has to run an event loop for it.
#pragma once

#include <QString>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace support {
class SilentServer {
public:
    SilentServer()
        : m_socket(::socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(m_socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
            ::listen(m_socket, 100) == 0 &&
            ::getsockname(m_socket, reinterpret_cast<sockaddr*>(&address), &size) == 0)
            m_port = ntohs(address.sin_port);
    }
    ~SilentServer() { ::close(m_socket); }
    SilentServer(const SilentServer&) = delete;
    SilentServer& operator=(const SilentServer&) = delete;

    QString address() const
    {
        return QStringLiteral("host=127.0.0.1 port=%1 user=u dbname=d").arg(m_port);
    }

private:
    int m_socket;
    int m_port = 0;
};
} // namespace support
