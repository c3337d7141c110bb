// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the bus for servos. A search waits for running tasks where it needs other baud rates;
// servos appear in the list as they are found. Those in the searched range that did not reply, also
// when asked again, leave the list at the end, and the event names them. Owned by the workbench;
// main thread; the search itself runs on the search thread and writes nothing.
#pragma once

#include "session/servos/servo_registry.h"

#include <set>

namespace session {
class Workbench;

class SearchService final : public QObject {
    Q_OBJECT

public:
    explicit SearchService(Workbench& bench);

    void start(const jobs::ScanSpec& spec);
    void stop();
    bool isSearching() const { return m_search != nullptr; } ///< running, or waiting for its turn
    /// The next searches also report whether this ID is absent at the port's rate.
    void setExpectedId(std::optional<int> id) { m_expectedId = id; }
    /// Duration of a search that finds nothing.
    base::Duration estimate(const jobs::ScanSpec& spec) const;
    const std::optional<jobs::ScanReport>& lastReport() const { return m_lastSearch; }
    const jobs::ScanSpec& lastSpec() const { return m_lastSpec; }
    /// Programs that had the port open at its end: "minicom (1234)".
    const QString& otherPrograms() const { return m_otherPrograms; }

    /// For the services of the workbench.
    bool isStarted() const { return m_search && m_search->started; }
    bool keepsBaud() const { return m_search && m_search->keepsBaud; }
    void requestStop();
    void drop() { m_search.reset(); }
    void startPending(); ///< when nothing else needs the bus

Q_SIGNALS:
    void searchChanged(); ///< started or ended
    void searchProgress(const jobs::Progress& progress);

private:
    struct Search {
        jobs::ScanSpec spec;
        QString port{};
        bool started = false;
        base::Duration startedAt{};
        std::set<ServoRef> knownFound{}; ///< known before and found again
        bool keepsBaud = false;          ///< at the port's rate: other work can go on beside it
        base::StopToken stop;
        device::Notices notices;
    };
    void runSearch(Search& search);
    void servoFound(const jobs::FoundServo& one);
    void updateFound(ServoEntry& known, const jobs::FoundServo& one);
    void searchEnded(const base::Result<jobs::ScanReport>& result, const QString& otherPrograms);
    void removeSilent(const jobs::ScanReport& report);
    std::vector<jobs::ExpectedServo> expectedServos() const;
    std::vector<int> missingServos(const jobs::ScanReport& report) const;

    Workbench& m_bench;
    std::unique_ptr<Search> m_search;
    std::optional<jobs::ScanSpec> m_nextSearch; ///< begins when the present one has stopped
    std::optional<jobs::ScanReport> m_lastSearch;
    jobs::ScanSpec m_lastSpec;
    QString m_otherPrograms;
    std::optional<int> m_expectedId;
};
} // namespace session
