// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_uploader.h"

#include "history/history.h"
#include "session/detachable_worker.h"
#include "session/snapshot/safety_snapshot.h"

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

/// Differs for a copy of this file on another machine or in another folder, and does not reveal
/// which machine it is.
QString originOf(const QString& bench, const QString& path)
{
    const QByteArray all = bench.toUtf8() + '\n' + QSysInfo::machineUniqueId() + '\n' +
                           QFileInfo(path).canonicalFilePath().toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(all, QCryptographicHash::Sha256).toHex().left(32));
}
} // namespace

HistoryUploader::HistoryUploader(QString historyPath, QString server, QString bench)
    : m_path(std::move(historyPath))
    , m_address(std::move(server))
    , m_bench(std::move(bench))
{}

HistoryUploader::~HistoryUploader() = default;

void HistoryUploader::resetSilence()
{
    m_askedAt = steadyMs();
}

std::chrono::milliseconds HistoryUploader::silenceTime() const
{
    const std::int64_t since = m_askedAt;
    return std::chrono::milliseconds(since == 0 ? 0 : steadyMs() - since);
}

void HistoryUploader::abort()
{
    m_aborted = true;
    dropConnection();
}

void HistoryUploader::dropConnection()
{
    const std::lock_guard lock(m_mutex);
    if (m_server)
        m_server->abort();
}

void HistoryUploader::disconnect()
{
    m_copy.reset();
    std::unique_ptr<history::HistoryServer> gone;
    const std::lock_guard lock(m_mutex);
    gone.swap(m_server);
}

base::Result<void> HistoryUploader::connect(const history::HistoryChanges& changes)
{
    const auto bench = changes.bench();
    if (!bench)
        return tl::unexpected(bench.error());
    if (m_copy && *bench == m_sentBench)
        return {};
    disconnect();
    if (*bench != m_sentBench)
        m_serverRevision.reset();
    const auto address = history::ServerAddress::parse(m_address);
    if (!address)
        return tl::unexpected(address.error());
    {
        const std::lock_guard lock(m_mutex);
        m_server = std::make_unique<history::HistoryServer>(*address,
                                                            history::HistoryServer::Purpose::Send);
    }
    resetSilence();
    if (const auto connected = m_server->connect(); !connected)
        return connected;
    m_copy = std::make_unique<history::HistoryServerWriter>(
        *m_server,
        history::HistoryOrigin{*bench, originOf(*bench, m_path), m_bench, programName()});
    resetSilence();
    const auto reached = m_copy->registerBench();
    if (!reached)
        return tl::unexpected(reached.error());
    m_serverRevision = *reached;
    m_sentBench = *bench;
    return {};
}

base::Result<SendProgress>
HistoryUploader::sendAll(const history::HistoryChanges& changes,
                         const std::function<void(const SendProgress&)>& progress)
{
    SendProgress done;
    while (!m_aborted) {
        const auto waiting = changes.pendingCount(*m_serverRevision);
        if (!waiting)
            return tl::unexpected(waiting.error());
        done.pending = *waiting;
        if (progress)
            progress(done);
        const auto rows = changes.after(*m_serverRevision);
        if (!rows)
            return tl::unexpected(rows.error());
        if (rows->empty())
            return done;
        const std::int64_t until = rows->back().revision;
        resetSilence();
        const auto reached = m_copy->apply(*rows, *m_serverRevision, until);
        if (!reached)
            return tl::unexpected(reached.error());
        if (*reached == until)
            done.sent += std::int64_t(rows->size());
        m_serverRevision = *reached; // another where another program of this bench was quicker
    }
    return base::fail(base::ErrorCode::Stopped, QStringLiteral("history-server"));
}

base::Result<SendProgress>
HistoryUploader::sendOver(const history::HistoryChanges& changes,
                          const std::function<void(const SendProgress&)>& progress)
{
    if (const auto connected = connect(changes); !connected)
        return tl::unexpected(connected.error());
    const auto revision = changes.revision();
    if (!revision)
        return tl::unexpected(revision.error());
    if (*m_serverRevision > *revision) {
        resetSilence();
        if (const auto again = m_copy->restart(); !again)
            return tl::unexpected(again.error());
        m_serverRevision = 0;
    }
    return sendAll(changes, progress);
}

base::Result<SendProgress>
HistoryUploader::send(const std::function<void(const SendProgress&)>& progress)
{
    m_waiting = 0;
    const auto history = history::History::open(m_path);
    if (!history)
        return tl::unexpected(history.error());
    const history::HistoryChanges changes((*history)->file());
    const bool kept = m_copy != nullptr;
    auto sent = sendOver(changes, progress);
    // A connection that was idle may have been cut by a router.
    if (!sent && kept && sent.error().code == base::ErrorCode::LinkLost && !m_aborted) {
        disconnect();
        sent = sendOver(changes, progress);
    }
    m_askedAt = 0;
    DetachableWorker::blockIfProgramEnds();
    if (!sent)
        disconnect();
    const auto waiting = m_serverRevision
                             ? changes.pendingCount(*m_serverRevision)
                             : base::Result<std::int64_t>(tl::unexpected(base::Error{}));
    m_waiting = waiting ? std::optional(*waiting) : std::nullopt;
    return sent;
}
} // namespace session
