// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_sender.h"

#include <algorithm>

namespace session {
namespace {
constexpr auto watchInterval = std::chrono::milliseconds(500);
} // namespace

HistorySender::HistorySender(QString path, QObject* parent)
    : HistorySender(std::move(path), Timing{}, parent)
{}

HistorySender::HistorySender(QString path, Timing times, QObject* parent)
    : QObject(parent)
    , m_path(std::move(path))
    , m_timing(times)
{
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &HistorySender::begin);
    connect(&m_watch, &QTimer::timeout, this, &HistorySender::watch);
}

HistorySender::~HistorySender()
{
    detachThread(m_timing.shutdownTimeout);
}

/// A thread that hangs is left to itself; it holds nothing of ours but its own connection.
void HistorySender::detachThread(std::chrono::milliseconds grace)
{
    if (m_uploader)
        m_uploader->abort();
    if (m_post)
        m_post->close();
    if (m_thread)
        m_thread->finish(grace, [sending = m_uploader] { sending->disconnect(); });
    m_thread.reset();
    m_uploader.reset();
    m_post.reset();
    m_next.stop();
    m_watch.stop();
    m_running = false;
    m_sendAgain = false;
    m_retry = {};
}

void HistorySender::set(SendState state)
{
    m_state = std::move(state);
    Q_EMIT stateChanged();
}

void HistorySender::setServer(const QString& address, const QString& bench)
{
    detachThread({}); // the window does not wait
    SendState state;
    if (address.trimmed().isEmpty()) {
        set(state);
        return;
    }
    m_uploader = std::make_shared<HistoryUploader>(m_path, address, bench);
    m_post = std::make_shared<GuardedPoster>(m_mainQueue);
    m_thread = std::make_unique<DetachableWorker>();
    if (const auto parsed = history::ServerAddress::parse(address))
        state.server = parsed->displayText();
    state.phase = SendState::Phase::Waiting;
    set(state);
    tryNow();
}

void HistorySender::notifyChanged()
{
    if (!m_uploader || m_state.phase == SendState::Phase::Failed)
        return; // it is tried again anyway
    m_sendAgain = m_running;
    if (m_running || m_state.phase == SendState::Phase::Waiting)
        return;
    SendState state = m_state;
    state.phase = SendState::Phase::Waiting;
    state.pending.reset();
    m_next.start(m_timing.debounce);
    set(state);
}

void HistorySender::tryNow()
{
    if (m_uploader && !m_running)
        begin();
}

void HistorySender::begin()
{
    m_next.stop();
    m_running = true;
    m_sendAgain = false;
    m_watch.start(std::min(watchInterval, m_timing.silence));
    m_thread->start([this, sending = m_uploader, post = m_post] {
        // A report about a server that was replaced since is dropped: m_post differs then.
        const auto sent = sending->send([&](const SendProgress& progress) {
            if (progress.pending > 0)
                post->post([this, post, progress] {
                    if (m_post == post)
                        advanced(progress);
                });
        });
        const auto waiting = sending->pendingRows();
        post->post([this, post, sent, waiting] {
            if (m_post == post)
                ended(sent, waiting);
        });
    });
}

void HistorySender::advanced(const SendProgress& progress)
{
    SendState state = m_state;
    state.phase = SendState::Phase::Sending;
    state.pending = progress.pending;
    state.error.reset();
    set(state);
}

void HistorySender::ended(const base::Result<SendProgress>& sent,
                          std::optional<std::int64_t> waiting)
{
    m_running = false;
    m_watch.stop();
    SendState state = m_state;
    state.pending = waiting;
    if (sent) {
        m_retry = {};
        state.phase = SendState::Phase::UpToDate;
        state.error.reset();
        state.nextTry = {};
        state.upToDate = QDateTime::currentDateTimeUtc();
        m_next.start(m_sendAgain ? m_timing.debounce : m_timing.checkInterval);
        set(state);
        return;
    }
    m_retry = std::clamp(m_retry * 2, m_timing.firstRetry, m_timing.lastRetry);
    state.phase = SendState::Phase::Failed;
    state.error = sent.error();
    state.nextTry = QDateTime::currentDateTimeUtc().addMSecs(m_retry.count());
    m_next.start(m_retry);
    set(state);
}

void HistorySender::watch()
{
    if (m_running && m_uploader->silenceTime() > m_timing.silence)
        m_uploader->dropConnection();
}
} // namespace session
