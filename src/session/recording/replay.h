// SPDX-License-Identifier: GPL-3.0-or-later
// Opens recordings for the trend chart: reads a file into a sample store of its own on a thread of
// its own, and hands it over when it is whole. A newer load() ends the one before. Main thread;
// ending it waits for the reader to look at its stop, not for the file.
#pragma once

#include "base/job_thread.h"
#include "recording/recording.h"
#include "session/main_thread_queue.h"

#include <memory>

namespace session {
struct ReplayData {
    static constexpr std::size_t budget = std::size_t(384) << 20;
    QString path;
    recording::SampleStore store{budget};
    recording::LoadedRecording content;
};

class Replay final : public QObject {
    Q_OBJECT

public:
    explicit Replay(QObject* parent = nullptr);
    ~Replay() override;

    void load(const QString& path);
    void cancel();
    bool isLoading() const { return m_stop != nullptr; }

Q_SIGNALS:
    void progress(double fraction);
    void loaded(const std::shared_ptr<session::ReplayData>& recording);
    void failed(const base::Error& error);

private:
    MainThreadQueue m_mainQueue;
    std::shared_ptr<base::StopToken> m_stop; ///< of the load that is under way
    base::JobThread m_thread;                ///< last: its job uses the others
};
} // namespace session
