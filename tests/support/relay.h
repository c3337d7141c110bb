// SPDX-License-Identifier: GPL-3.0-or-later
// Between a client and a server on 127.0.0.1, for what networks do: it passes bytes on, slowly if
// wanted, and after so many from the client it cuts the connection or swallows everything. A thread
// of its own; the settings may be changed at any time and concern every connection.
#pragma once

#include <QString>

#include <atomic>
#include <thread>
#include <vector>

namespace support {
class Relay {
public:
    explicit Relay(quint16 server);
    ~Relay();
    Relay(const Relay&) = delete;
    Relay& operator=(const Relay&) = delete;

    enum class LimitAction { Cut, Discard };
    /// Of each connection's bytes from the client; negative: all.
    void limitTo(qint64 bytes, LimitAction then);
    void removeLimit() { limitTo(-1, LimitAction::Cut); }
    /// The most bytes every millisecond in each direction.
    void setRateLimit(int bytes) { m_rateLimit = bytes; }

    quint16 port() const { return m_port; }
    int connections() const { return m_connections; }
    bool hasSwallowed() const { return m_hasSwallowed; } ///< something, ever

private:
    struct Pair;
    void serve();
    void accept(std::vector<Pair>& pairs) const;
    bool pass(Pair& pair) const;
    bool copy(int from, int to, qint64& passed, bool limited) const;

    const quint16 m_server;
    int m_listener = -1;
    quint16 m_port = 0;
    std::atomic<qint64> m_limit{-1};
    std::atomic<LimitAction> m_limitAction{LimitAction::Cut};
    std::atomic<int> m_rateLimit{1 << 16};
    mutable std::atomic<int> m_connections{0};
    mutable std::atomic<bool> m_hasSwallowed{false};
    std::atomic<bool> m_ending{false};
    std::thread m_thread;
};
} // namespace support
