// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/relay.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace support {
namespace {
sockaddr_in loopback(quint16 port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
}
} // namespace

struct Relay::Pair {
    int client = -1;
    int server = -1;
    qint64 up = 0; ///< bytes from the client
    qint64 down = 0;
};

Relay::Relay(quint16 server)
    : m_server(server)
    , m_listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    if (::bind(m_listener, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
        ::listen(m_listener, 100) == 0 &&
        ::getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &size) == 0)
        m_port = ntohs(address.sin_port);
    m_thread = std::thread([this] { serve(); });
}

Relay::~Relay()
{
    m_ending = true;
    m_thread.join();
    ::close(m_listener);
}

void Relay::limitTo(qint64 bytes, LimitAction then)
{
    m_limitAction = then;
    m_limit = bytes;
}

void Relay::accept(std::vector<Pair>& pairs) const
{
    const int client = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0)
        return;
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(m_server);
    if (::connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
        ::close(client);
        ::close(server);
        return;
    }
    ++m_connections;
    pairs.push_back({client, server});
}

/// False: this direction has ended, or is to be cut.
bool Relay::copy(int from, int to, qint64& passed, bool limited) const
{
    pollfd ready{from, POLLIN, 0};
    if (::poll(&ready, 1, 0) <= 0)
        return true;
    std::array<char, 1 << 16> bytes{};
    const ssize_t count =
        ::recv(from, bytes.data(), std::size_t(std::min(m_rateLimit.load(), int(bytes.size()))), 0);
    if (count <= 0)
        return false;
    const qint64 limit = limited ? m_limit.load() : -1;
    const qint64 rest = limit < 0 ? count : std::clamp<qint64>(limit - passed, 0, count);
    passed += count;
    if (rest > 0 && ::send(to, bytes.data(), std::size_t(rest), MSG_NOSIGNAL) != rest)
        return false;
    if (rest == count)
        return true;
    if (m_limitAction == LimitAction::Discard)
        m_hasSwallowed = true;
    return m_limitAction == LimitAction::Discard;
}

bool Relay::pass(Pair& pair) const
{
    return copy(pair.client, pair.server, pair.up, true) &&
           copy(pair.server, pair.client, pair.down, false);
}

void Relay::serve()
{
    std::vector<Pair> pairs;
    const auto close = [](const Pair& pair) {
        ::close(pair.client);
        ::close(pair.server);
    };
    while (!m_ending) {
        pollfd waiting{m_listener, POLLIN, 0};
        if (::poll(&waiting, 1, 1) > 0)
            accept(pairs);
        for (auto pair = pairs.begin(); pair != pairs.end();) {
            if (pass(*pair)) {
                ++pair;
            } else {
                close(*pair);
                pair = pairs.erase(pair);
            }
        }
    }
    std::for_each(pairs.begin(), pairs.end(), close);
}
} // namespace support
