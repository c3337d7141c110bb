// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every connection on 127.0.0.1 and never answers, like a server that hangs or a firewall
// that swallows. Lives in the kernel: no event loop has to run for it.
#pragma once

#include "support/port_endpoints.h"

#include <poll.h>

namespace support {
class SilentServer {
public:
    SilentServer() = default;
    ~SilentServer() { ::close(m_tcp.listener); }
    SilentServer(const SilentServer&) = delete;
    SilentServer& operator=(const SilentServer&) = delete;

    QString address() const
    {
        return QStringLiteral("host=127.0.0.1 port=%1 user=u dbname=d").arg(m_tcp.number);
    }

    /// A client is waiting to be accepted.
    bool isAsked() const
    {
        pollfd listener{m_tcp.listener, POLLIN, 0};
        return ::poll(&listener, 1, 0) > 0;
    }

private:
    const TcpPort m_tcp = listenOnLoopback(0, 100);
};
} // namespace support
