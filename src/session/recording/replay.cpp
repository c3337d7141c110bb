// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recording/replay.h"

namespace session {
Replay::Replay(QObject* parent)
    : QObject(parent)
{}

Replay::~Replay()
{
    cancel();
}

void Replay::cancel()
{
    if (m_stop)
        m_stop->request();
    m_stop.reset();
}

void Replay::load(const QString& path)
{
    cancel();
    const auto stop = std::make_shared<base::StopToken>();
    m_stop = stop;
    m_thread.start([this, path, stop] {
        const auto into = std::make_shared<ReplayData>();
        into->path = path;
        auto content = recording::loadRecording(path, into->store, *stop, [&](double fraction) {
            m_mainQueue.post([this, stop, fraction] {
                if (m_stop == stop)
                    Q_EMIT progress(fraction);
            });
        });
        m_mainQueue.post([this, stop, into, content = std::move(content)]() mutable {
            if (m_stop != stop)
                return; // it is not needed any more
            m_stop.reset();
            if (!content) {
                Q_EMIT failed(content.error());
                return;
            }
            into->content = std::move(*content);
            Q_EMIT loaded(into);
        });
    });
}
} // namespace session
