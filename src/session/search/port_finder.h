// SPDX-License-Identifier: GPL-3.0-or-later
// Which port are the servos on, and at what rate? Searches several ports, one after the other, and
// closes each again: all rates, the most common ones first, until a servo replies. Nothing is
// written. A port that cannot be opened has its error in the results. Owned by its dialog; main
// thread; the search runs on a thread of its own, and the destructor waits for the port to close.
#pragma once

#include "base/job_thread.h"
#include "jobs/scan/scan.h"
#include "session/main_thread_queue.h"
#include "session/session.h"

#include <map>

namespace session {
/// One port: opens it, searches it, closes it. A rate or a protocol in the request is the only one
/// tried. The servos in the report have one rate. Any thread. Errors: those of connect() and
/// scan().
base::Result<jobs::ScanReport> findServos(Session& session, PortRequest request,
                                          const base::StopToken& stop,
                                          const jobs::ProgressFn& progress);

std::map<base::Protocol, std::vector<int>>
idsByProtocol(const std::vector<jobs::FoundServo>& found);

struct PortResult {
    enum class State { Waiting, Searching, Searched, Stopped };
    QString port;
    State state = State::Waiting;
    std::vector<jobs::FoundServo> found{}; ///< of one rate
    std::optional<base::Error> error{};
};

class PortFinder final : public QObject {
    Q_OBJECT

public:
    explicit PortFinder(Session& session, QObject* parent = nullptr);
    ~PortFinder() override;

    void start(const QStringList& ports); ///< ignored while it is running
    void stop();
    bool isRunning() const { return m_stop != nullptr; }
    const std::vector<PortResult>& results() const { return m_results; } ///< so far

Q_SIGNALS:
    void changed();                                  ///< the results; started or ended
    void progressed(const jobs::Progress& progress); ///< of the port that is being searched

private:
    void searchNext();
    void search(const QString& port, const base::StopToken& stop);
    void searched(const base::Result<jobs::ScanReport>& report);

    Session& m_session;
    MainThreadQueue m_mainQueue;
    std::vector<PortResult> m_results;
    std::size_t m_current = 0;
    std::unique_ptr<base::StopToken> m_stop;   ///< null: not running
    std::unique_ptr<base::JobThread> m_thread; ///< last: it uses the others
};
} // namespace session
