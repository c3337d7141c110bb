// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_sending.h"

#include "record/history.h"
#include "session/loose_thread.h"
#include "session/safety_snapshot.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QSysInfo>

namespace session {
namespace {
std::int64_t steadyMs()
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Tells this file from a copy of it on another machine or in another folder, and tells nobody
/// which machine it is.
QString originOf(const QString& bench, const QString& path)
{
    const QByteArray all = bench.toUtf8() + '\n' + QSysInfo::machineUniqueId() + '\n' +
                           QFileInfo(path).canonicalFilePath().toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(all, QCryptographicHash::Sha256).toHex().left(32));
}
} // namespace

HistorySending::HistorySending(QString historyPath, QString server, QString bench)
    : m_path(std::move(historyPath))
    , m_address(std::move(server))
    , m_bench(std::move(bench))
{}

HistorySending::~HistorySending() = default;

void HistorySending::alive()
{
    m_askedAt = steadyMs();
}

std::chrono::milliseconds HistorySending::silence() const
{
    const std::int64_t since = m_askedAt;
    return std::chrono::milliseconds(since == 0 ? 0 : steadyMs() - since);
}

void HistorySending::abort()
{
    m_aborted = true;
    hangUp();
}

void HistorySending::hangUp()
{
    const std::lock_guard lock(m_mutex);
    if (m_server)
        m_server->abort();
}

void HistorySending::disconnect()
{
    m_copy.reset();
    std::unique_ptr<record::HistoryServer> gone;
    const std::lock_guard lock(m_mutex);
    gone.swap(m_server);
}

base::Result<void> HistorySending::connect(const record::HistoryChanges& changes)
{
    const auto bench = changes.bench();
    if (!bench)
        return tl::unexpected(bench.error());
    if (m_copy && *bench == m_sentBench)
        return {};
    disconnect();
    if (*bench != m_sentBench)
        m_reached.reset();
    const auto address = record::ServerAddress::parse(m_address);
    if (!address)
        return tl::unexpected(address.error());
    {
        const std::lock_guard lock(m_mutex);
        m_server =
            std::make_unique<record::HistoryServer>(*address, record::HistoryServer::Purpose::Send);
    }
    alive();
    if (const auto connected = m_server->connect(); !connected)
        return connected;
    m_copy = std::make_unique<record::HistoryCopy>(
        *m_server, record::HistoryOrigin{*bench, originOf(*bench, m_path), m_bench, programName()});
    alive();
    const auto reached = m_copy->greet();
    if (!reached)
        return tl::unexpected(reached.error());
    m_reached = *reached;
    m_sentBench = *bench;
    return {};
}

base::Result<SendProgress>
HistorySending::sendAll(const record::HistoryChanges& changes,
                        const std::function<void(const SendProgress&)>& progress)
{
    SendProgress done;
    while (!m_aborted) {
        const auto waiting = changes.waiting(*m_reached);
        if (!waiting)
            return tl::unexpected(waiting.error());
        done.waiting = *waiting;
        if (progress)
            progress(done);
        const auto rows = changes.after(*m_reached);
        if (!rows)
            return tl::unexpected(rows.error());
        if (rows->empty())
            return done;
        const std::int64_t until = rows->back().revision;
        alive();
        const auto reached = m_copy->take(*rows, *m_reached, until);
        if (!reached)
            return tl::unexpected(reached.error());
        if (*reached == until)
            done.sent += std::int64_t(rows->size());
        m_reached = *reached; // another where another program of this bench was quicker
    }
    return base::fail(base::ErrorCode::Stopped, QStringLiteral("history-server"));
}

base::Result<SendProgress>
HistorySending::sendOver(const record::HistoryChanges& changes,
                         const std::function<void(const SendProgress&)>& progress)
{
    if (const auto connected = connect(changes); !connected)
        return tl::unexpected(connected.error());
    const auto revision = changes.revision();
    if (!revision)
        return tl::unexpected(revision.error());
    if (*m_reached > *revision) {
        alive();
        if (const auto again = m_copy->restart(); !again)
            return tl::unexpected(again.error());
        m_reached = 0;
    }
    return sendAll(changes, progress);
}

base::Result<SendProgress>
HistorySending::send(const std::function<void(const SendProgress&)>& progress)
{
    m_waiting = 0;
    const auto history = record::History::open(m_path);
    if (!history)
        return tl::unexpected(history.error());
    const record::HistoryChanges changes((*history)->file());
    const bool kept = m_copy != nullptr;
    auto sent = sendOver(changes, progress);
    // A connection that was idle may have been cut by whatever lies between.
    if (!sent && kept && sent.error().code == base::ErrorCode::LinkLost && !m_aborted) {
        disconnect();
        sent = sendOver(changes, progress);
    }
    m_askedAt = 0;
    LooseThread::stayIfProgramEnds();
    if (!sent)
        disconnect();
    const auto waiting = m_reached ? changes.waiting(*m_reached)
                                   : base::Result<std::int64_t>(tl::unexpected(base::Error{}));
    m_waiting = waiting ? std::optional(*waiting) : std::nullopt;
    return sent;
}
} // namespace session
