// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every connection on 127.0.0.1, waits for the first bytes, says what it was made with and
// hangs up: whatever else may answer at the port of a server. A thread of its own.
#pragma once

#include <QByteArray>

#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace support {
class AnsweringServer {
public:
    explicit AnsweringServer(QByteArray answer)
        : m_answer(std::move(answer))
        , m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(m_socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
            ::listen(m_socket, 100) == 0 &&
            ::getsockname(m_socket, reinterpret_cast<sockaddr*>(&address), &size) == 0)
            m_port = ntohs(address.sin_port);
        m_thread = std::thread([this] { live(); });
    }
    ~AnsweringServer()
    {
        m_ending = true;
        m_thread.join();
        ::close(m_socket);
    }
    AnsweringServer(const AnsweringServer&) = delete;
    AnsweringServer& operator=(const AnsweringServer&) = delete;

    quint16 port() const { return m_port; }

private:
    void live() const
    {
        while (!m_ending) {
            pollfd waiting{m_socket, POLLIN, 0};
            if (::poll(&waiting, 1, 20) <= 0)
                continue;
            const int client = ::accept(m_socket, nullptr, nullptr);
            std::array<char, 4096> bytes{};
            if (::recv(client, bytes.data(), bytes.size(), 0) > 0)
                (void)::send(client, m_answer.constData(), std::size_t(m_answer.size()),
                             MSG_NOSIGNAL);
            ::shutdown(client, SHUT_RDWR);
            ::close(client);
        }
    }

    const QByteArray m_answer;
    const int m_socket;
    quint16 m_port = 0;
    std::atomic<bool> m_ending{false};
    std::thread m_thread;
};
} // namespace support
