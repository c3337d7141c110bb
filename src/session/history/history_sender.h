// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the copies on the history server up to date while the program runs: after each
// notifyChanged(), and every half minute, since other programs write too. Main thread, never waits;
// it sends on a thread of its own. A server that cannot be reached is tried again after 1 s, 2 s …
// 60 s, and at the next start; what it missed is sent then. The destructor waits for a second or
// less.
#pragma once

#include "session/detachable_worker.h"
#include "session/history/history_uploader.h"
#include "session/paths.h"

#include <QObject>
#include <QTimer>

namespace session {
struct SendState {
    enum class Phase : std::uint8_t {
        Off,     ///< no server is set
        Waiting, ///< something may have to be sent, soon
        Sending,
        UpToDate, ///< the server has all there was when last looked
        Failed,   ///< `error`; tried again at `nextTry`
    };
    Phase phase = Phase::Off;
    QString server{};                      ///< without password, for people
    std::optional<std::int64_t> pending{}; ///< rows to go; nullopt: not known
    std::optional<base::Error> error{};
    QDateTime nextTry{};
    QDateTime upToDate{}; ///< when it last was; invalid: not since the start
};

class HistorySender final : public QObject {
    Q_OBJECT

public:
    struct Timing {
        std::chrono::milliseconds checkInterval = std::chrono::seconds(30);
        std::chrono::milliseconds debounce =
            std::chrono::milliseconds(500); ///< after notifyChanged()
        std::chrono::milliseconds firstRetry = std::chrono::seconds(1);
        std::chrono::milliseconds lastRetry = std::chrono::seconds(60);
        std::chrono::milliseconds silence = std::chrono::seconds(120); ///< then it counts as hung
        std::chrono::milliseconds shutdownTimeout = std::chrono::milliseconds(900);
    };

    explicit HistorySender(QString path = historyFile(), QObject* parent = nullptr);
    HistorySender(QString path, Timing times, QObject* parent = nullptr);
    ~HistorySender() override;

    /// Empty: sends nothing any more. `bench`: its name for people.
    void setServer(const QString& address, const QString& bench);
    void notifyChanged(); ///< something was written to the history
    void tryNow();        ///< without waiting for the next try

    const SendState& state() const { return m_state; }

Q_SIGNALS:
    void stateChanged();

private:
    void begin();
    void advanced(const SendProgress& progress);
    void ended(const base::Result<SendProgress>& sent, std::optional<std::int64_t> waiting);
    void watch();
    void detachThread(std::chrono::milliseconds grace);
    void set(SendState state);

    const QString m_path;
    const Timing m_timing;
    SendState m_state;
    std::shared_ptr<HistoryUploader> m_uploader;
    std::shared_ptr<GuardedPoster> m_post; ///< of the server that is set now
    std::unique_ptr<DetachableWorker> m_thread;
    bool m_running = false;
    bool m_sendAgain = false; ///< notifyChanged() while it ran
    std::chrono::milliseconds m_retry{};
    QTimer m_next;
    QTimer m_watch;
    MainThreadQueue m_mainQueue;
};
} // namespace session
