// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_server_source.h"

#include <atomic>
#include <mutex>

namespace session {
namespace {
using Clock = std::chrono::steady_clock;
constexpr auto silenceCheckInterval = std::chrono::milliseconds(500);
/// Enough for a query: closing the connection ends it. Only connecting takes longer.
constexpr auto shutdownTimeout = std::chrono::milliseconds(100);
} // namespace

/// The connection, with what both threads need to know of it.
class HistoryServerSource::ServerConnection {
public:
    explicit ServerConnection(QString address)
        : m_address(std::move(address))
    {}

    // --- the detachable thread ---
    void answer(const Query& query, std::optional<std::int64_t> bench)
    {
        m_askedAt = Clock::now().time_since_epoch().count();
        query(open(bench));
        m_askedAt = 0;
    }

    void close()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_server = nullptr;
        }
        m_history.reset();
    }

    // --- any ---
    void dropConnection()
    {
        const std::lock_guard lock(m_mutex);
        if (m_server != nullptr)
            m_server->abort();
    }

    Clock::duration silence() const
    {
        const auto since = m_askedAt.load();
        return since == 0 ? Clock::duration{}
                          : Clock::now().time_since_epoch() - Clock::duration(since);
    }

private:
    base::Result<history::History*> open(std::optional<std::int64_t> bench)
    {
        // A kept connection may have been cut since; this is where it shows.
        if (m_history && !m_server->selectBench(bench))
            close();
        if (!m_history) {
            const auto connected = connect();
            const auto chosen = connected ? m_server->selectBench(bench) : connected;
            if (!chosen) {
                close();
                return tl::unexpected(chosen.error());
            }
        }
        return m_history.get();
    }

    base::Result<void> connect()
    {
        const auto address = history::ServerAddress::parse(m_address);
        if (!address)
            return tl::unexpected(address.error());
        auto server = std::make_unique<history::HistoryServer>(
            *address, history::HistoryServer::Purpose::Browse);
        {
            const std::lock_guard lock(m_mutex);
            m_server = server.get();
        }
        m_history = std::make_unique<history::History>(std::move(server));
        return m_server->connect();
    }

    const QString m_address;
    std::mutex m_mutex;
    history::HistoryServer* m_server = nullptr; ///< the history's; changed under the mutex
    std::unique_ptr<history::History> m_history;
    std::atomic<Clock::rep> m_askedAt{0}; ///< 0: nothing is being asked
};

HistoryServerSource::HistoryServerSource(const QString& address, std::chrono::milliseconds timeout)
    : m_connection(std::make_shared<ServerConnection>(address))
{
    QObject::connect(&m_watch, &QTimer::timeout, &m_watch, [this, timeout] {
        if (m_connection->silence() > timeout)
            m_connection->dropConnection();
    });
    m_watch.start(std::min(silenceCheckInterval, timeout));
}

/// The connection goes on the thread that made it.
HistoryServerSource::~HistoryServerSource()
{
    m_connection->dropConnection();
    m_thread.finish(shutdownTimeout, [line = m_connection] { line->close(); });
}

void HistoryServerSource::start(Query query)
{
    m_thread.start([line = m_connection, bench = m_bench, query = std::move(query)] {
        line->answer(query, bench);
    });
}
} // namespace session
