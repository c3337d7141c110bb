// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the bus for servos. A search waits for running tasks where it needs other baud rates;
// servos appear in the list as they are found. Those in the searched range that did not reply, also
// when asked again, leave the list at the end, and the event names them. Owned by the workbench;
// main thread; the search itself runs on the search thread and writes nothing.
#pragma once

#include "jobs/diagnose/diagnose.h"
#include "session/servos/servo_registry.h"

#include <set>

namespace session {
class Workbench;

class SearchService final : public QObject {
    Q_OBJECT

public:
    explicit SearchService(Workbench& bench);

    void start(const jobs::ScanSpec& spec);
    /// Finds out why servos do not reply. Takes its turn like a search, which it is for the others.
    void diagnose();
    void stop();
    bool isSearching() const { return m_search != nullptr; } ///< running, or waiting for its turn
    /// The next searches also report whether this ID is absent at the port's rate.
    void setExpectedId(std::optional<int> id) { m_expectedId = id; }
    /// Running, or waiting for its turn.
    bool isDiagnosing() const
    {
        return (m_search && m_search->isDiagnosis) || (m_next && m_next->isDiagnosis);
    }
    /// The latest one, as far as it is; nothing in it before the first.
    const base::Diagnosis& diagnosis() const { return m_diagnosis; }
    const std::optional<base::Error>& diagnosisError() const { return m_diagnosisError; }
    /// Duration of a search that finds nothing.
    base::Duration estimate(const jobs::ScanSpec& spec) const;
    const std::optional<jobs::ScanReport>& lastReport() const { return m_lastSearch; }
    const jobs::ScanSpec& lastSpec() const { return m_lastSpec; }
    /// For the services of the workbench.
    bool isStarted() const { return m_search && m_search->started; }
    bool keepsBaud() const { return m_search && m_search->keepsBaud; }
    void requestStop();
    void drop() { m_search.reset(); }
    void startPending(); ///< when nothing else needs the bus

Q_SIGNALS:
    void searchChanged(); ///< started or ended
    void searchProgress(const jobs::Progress& progress);
    void evidenceFound();

private:
    struct Search {
        jobs::ScanSpec spec;
        bool started = false;
        base::Duration startedAt{};
        std::set<ServoRef> knownFound{}; ///< known before and found again
        bool keepsBaud = false;          ///< at the port's rate: other work can go on beside it
        bool isDiagnosis = false;
        base::StopToken stop;
        device::Notices notices;
    };
    void begin(std::unique_ptr<Search> search);
    bool canStart();
    void runSearch(Search& search);
    void runDiagnosis(Search& search);
    void addEvidence(const base::Evidence& evidence);
    void diagnosisEnded(const base::Result<jobs::DiagnosisReport>& result);
    void leave(); ///< the search has ended
    void goOn();
    void servoFound(const jobs::FoundServo& one);
    void updateFound(ServoEntry& known, const jobs::FoundServo& one);
    void searchEnded(const base::Result<jobs::ScanReport>& result);
    void removeSilent(const jobs::ScanReport& report);
    std::vector<jobs::ExpectedServo> expectedServos() const;
    std::vector<int> missingServos(const jobs::ScanReport& report) const;

    Workbench& m_bench;
    std::unique_ptr<Search> m_search;
    std::unique_ptr<Search> m_next; ///< begins when the present one has stopped
    std::optional<jobs::ScanReport> m_lastSearch;
    jobs::ScanSpec m_lastSpec;
    std::optional<int> m_expectedId;
    base::Diagnosis m_diagnosis;
    std::optional<base::Error> m_diagnosisError;
};
} // namespace session
