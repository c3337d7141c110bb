// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every connection on 127.0.0.1, waits for the first bytes, sends the reply given to it and
// closes the connection: some other program at the port of a server. A thread of its own.
#pragma once

#include "support/port_endpoints.h"

#include <QByteArray>

#include <array>
#include <atomic>
#include <poll.h>
#include <thread>

namespace support {
class CannedReplyServer {
public:
    explicit CannedReplyServer(QByteArray answer)
        : m_answer(std::move(answer))
    {
        m_thread = std::thread([this] { serve(); });
    }
    ~CannedReplyServer()
    {
        m_ending = true;
        m_thread.join();
        ::close(m_tcp.listener);
    }
    CannedReplyServer(const CannedReplyServer&) = delete;
    CannedReplyServer& operator=(const CannedReplyServer&) = delete;

    quint16 port() const { return m_tcp.number; }

private:
    void serve() const
    {
        while (!m_ending) {
            pollfd waiting{m_tcp.listener, POLLIN, 0};
            if (::poll(&waiting, 1, 20) <= 0)
                continue;
            const int client = ::accept(m_tcp.listener, nullptr, nullptr);
            std::array<char, 4096> bytes{};
            if (::recv(client, bytes.data(), bytes.size(), 0) > 0)
                (void)::send(client, m_answer.constData(), std::size_t(m_answer.size()),
                             MSG_NOSIGNAL);
            ::shutdown(client, SHUT_RDWR);
            ::close(client);
        }
    }

    const QByteArray m_answer;
    const TcpPort m_tcp = listenOnLoopback(0, 100);
    std::atomic<bool> m_ending{false};
    std::thread m_thread;
};
} // namespace support
