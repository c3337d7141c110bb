// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_sender.h"

#include <algorithm>

namespace session {
namespace {
constexpr auto watchEvery = std::chrono::milliseconds(500);
} // namespace

HistorySender::HistorySender(QString path, QObject* parent)
    : HistorySender(std::move(path), Times{}, parent)
{}

HistorySender::HistorySender(QString path, Times times, QObject* parent)
    : QObject(parent)
    , m_path(std::move(path))
    , m_times(times)
{
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &HistorySender::begin);
    connect(&m_watch, &QTimer::timeout, this, &HistorySender::watch);
}

HistorySender::~HistorySender()
{
    leave(m_times.end);
}

/// A thread that hangs is left to itself; it holds nothing of ours but its own connection.
void HistorySender::leave(std::chrono::milliseconds grace)
{
    if (m_sending)
        m_sending->abort();
    if (m_post)
        m_post->close();
    if (m_thread)
        m_thread->end(grace, [sending = m_sending] { sending->disconnect(); });
    m_thread.reset();
    m_sending.reset();
    m_post.reset();
    m_next.stop();
    m_watch.stop();
    m_running = false;
    m_again = false;
    m_retry = {};
}

void HistorySender::set(SendState state)
{
    m_state = std::move(state);
    Q_EMIT stateChanged();
}

void HistorySender::setServer(const QString& address, const QString& bench)
{
    leave({}); // the window waits for nobody
    SendState state;
    if (address.trimmed().isEmpty()) {
        set(state);
        return;
    }
    m_sending = std::make_shared<HistorySending>(m_path, address, bench);
    m_post = std::make_shared<LoosePost>(m_inbox);
    m_thread = std::make_unique<LooseThread>();
    if (const auto parsed = record::ServerAddress::parse(address))
        state.server = parsed->shown();
    state.phase = SendState::Phase::Waiting;
    set(state);
    tryNow();
}

void HistorySender::poke()
{
    if (!m_sending || m_state.phase == SendState::Phase::Trouble)
        return; // it is tried again anyway
    m_again = m_running;
    if (m_running || m_state.phase == SendState::Phase::Waiting)
        return;
    SendState state = m_state;
    state.phase = SendState::Phase::Waiting;
    state.waiting.reset();
    m_next.start(m_times.settle);
    set(state);
}

void HistorySender::tryNow()
{
    if (m_sending && !m_running)
        begin();
}

void HistorySender::begin()
{
    m_next.stop();
    m_running = true;
    m_again = false;
    m_watch.start(std::min(watchEvery, m_times.silence));
    m_thread->start([this, sending = m_sending, post = m_post] {
        // What was said before another server was set is of no interest; m_post tells.
        const auto sent = sending->send([&](const SendProgress& progress) {
            if (progress.waiting > 0)
                post->post([this, post, progress] {
                    if (m_post == post)
                        advanced(progress);
                });
        });
        const auto waiting = sending->waiting();
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
    state.waiting = progress.waiting;
    state.error.reset();
    set(state);
}

void HistorySender::ended(const base::Result<SendProgress>& sent,
                          std::optional<std::int64_t> waiting)
{
    m_running = false;
    m_watch.stop();
    SendState state = m_state;
    state.waiting = waiting;
    if (sent) {
        m_retry = {};
        state.phase = SendState::Phase::UpToDate;
        state.error.reset();
        state.nextTry = {};
        state.upToDate = QDateTime::currentDateTimeUtc();
        m_next.start(m_again ? m_times.settle : m_times.look);
        set(state);
        return;
    }
    m_retry = std::clamp(m_retry * 2, m_times.firstRetry, m_times.lastRetry);
    state.phase = SendState::Phase::Trouble;
    state.error = sent.error();
    state.nextTry = QDateTime::currentDateTimeUtc().addMSecs(m_retry.count());
    m_next.start(m_retry);
    set(state);
}

void HistorySender::watch()
{
    if (m_running && m_sending->silence() > m_times.silence)
        m_sending->hangUp();
}
} // namespace session
