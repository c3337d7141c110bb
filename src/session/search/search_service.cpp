// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/search/search_service.h"

#include "jobs/scan/scan_plan.h"
#include "session/search/diagnosis_spec.h"
#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
bool inScope(const jobs::ScanSpec& spec, const std::vector<int>& rates, const device::Servo& servo)
{
    const bool language = spec.protocols.empty() ||
                          std::find(spec.protocols.begin(), spec.protocols.end(), servo.protocol) !=
                              spec.protocols.end();
    return language && servo.id >= spec.firstId && servo.id <= spec.lastId &&
           std::find(rates.begin(), rates.end(), servo.baud) != rates.end();
}

bool sameServo(const device::Servo& a, const device::Servo& b)
{
    return a.protocol == b.protocol && a.id == b.id && a.baud == b.baud;
}
} // namespace

SearchService::SearchService(Workbench& bench)
    : m_bench(bench)
{
    connect(&bench.registry(), &ServoRegistry::servosCleared, this,
            [this] { m_lastSearch.reset(); });
}

void SearchService::requestStop()
{
    if (m_search)
        m_search->stop.request();
}

bool SearchService::canStart()
{
    if (m_bench.link().state() != LinkState::Open)
        return false;
    if (!m_bench.tasks().isTesting())
        return true;
    m_bench.emitEvent({.kind = Event::Kind::Failed,
                       .error = base::Error{base::ErrorCode::Held, QStringLiteral("scan"),
                                            QStringLiteral("test")}});
    return false;
}

void SearchService::start(const jobs::ScanSpec& spec)
{
    if (!canStart())
        return;
    auto search = std::make_unique<Search>();
    search->spec = spec;
    begin(std::move(search));
}

void SearchService::diagnose()
{
    if (!canStart())
        return;
    auto search = std::make_unique<Search>();
    search->isDiagnosis = true;
    begin(std::move(search));
}

void SearchService::begin(std::unique_ptr<Search> search)
{
    stop();
    if (search->isDiagnosis) {
        m_diagnosis = {};
        m_diagnosisError.reset();
    }
    if (m_search) { // the one before ends first, and this one takes its turn
        m_next = std::move(search);
        Q_EMIT searchChanged();
        return;
    }
    m_search = std::move(search);
    if (!m_search->isDiagnosis) {
        m_search->spec.expected = expectedServos();
        if (m_search->spec.protocols.empty() && m_bench.link().lastRequest().protocol)
            m_search->spec.protocols = {*m_bench.link().lastRequest().protocol};
        m_lastSpec = m_search->spec;
    }
    Q_EMIT searchChanged();
    m_bench.scheduleNext();
}

void SearchService::stop()
{
    m_next.reset();
    if (!m_search)
        return;
    m_search->stop.request();
    if (m_search->started)
        return;
    m_search.reset();
    Q_EMIT searchChanged();
}

base::Duration SearchService::estimate(const jobs::ScanSpec& spec) const
{
    if (!m_bench.link().connection())
        return {};
    jobs::ScanSpec asked = spec;
    if (asked.protocols.empty() && m_bench.link().lastRequest().protocol)
        asked.protocols = {*m_bench.link().lastRequest().protocol};
    base::StopToken stop;
    device::Notices notices;
    return jobs::estimateScanTime(m_bench.link().connection()->context(stop, notices), asked);
}

void SearchService::startPending()
{
    if (!m_search || m_search->started || m_bench.link().state() != LinkState::Open ||
        m_bench.tasks().running())
        return;
    m_search->started = true;
    m_search->startedAt = m_bench.now();
    m_search->keepsBaud =
        !m_search->isDiagnosis && jobs::ratesToScan(m_search->spec, m_bench.link().baud()) ==
                                      std::vector{m_bench.link().baud()};
    m_bench.polling().updatePolling();
    // Job and search end before they are destroyed: goOn() waits for searchEnded().
    m_bench.searchThread().start([this, search = m_search.get()] {
        if (search->isDiagnosis)
            runDiagnosis(*search);
        else
            runSearch(*search);
    });
}

/// On the search thread.
void SearchService::runSearch(Search& search)
{
    const auto context = m_bench.link().connection()->context(search.stop, search.notices);
    auto result = jobs::scan(
        context, search.spec,
        [this](const jobs::Progress& progress) {
            m_bench.mainQueue().post([this, progress] { Q_EMIT searchProgress(progress); });
        },
        [this](const jobs::FoundServo& one) {
            m_bench.mainQueue().post([this, one] { servoFound(one); });
        });
    m_bench.mainQueue().post([this, result = std::move(result)] { searchEnded(result); });
}

/// On the search thread.
void SearchService::runDiagnosis(Search& search)
{
    const auto context = m_bench.link().connection()->context(search.stop, search.notices);
    auto result = jobs::diagnose(
        context, diagnosisSpec(m_bench.link().lastRequest()),
        [this](const jobs::Progress& progress) {
            m_bench.mainQueue().post([this, progress] { Q_EMIT searchProgress(progress); });
        },
        [this](const base::Evidence& evidence) {
            m_bench.mainQueue().post([this, evidence] { addEvidence(evidence); });
        });
    m_bench.mainQueue().post([this, result = std::move(result)] { diagnosisEnded(result); });
}

void SearchService::addEvidence(const base::Evidence& evidence)
{
    m_diagnosis.evidence.push_back(evidence);
    Q_EMIT evidenceFound();
}

/// What it found is listed like the servos of a search; nothing leaves the list.
void SearchService::diagnosisEnded(const base::Result<jobs::DiagnosisReport>& result)
{
    if (result) {
        m_diagnosis = result->diagnosis;
        for (const jobs::FoundServo& one : result->found)
            servoFound(one);
    } else {
        m_diagnosisError = result.error();
    }
    leave();
    Q_EMIT searchChanged();
    goOn();
}

void SearchService::leave()
{
    if (m_bench.link().connection())
        m_bench.presence().update(); // what the search has asked in vain does not count
    m_search.reset();
    m_bench.emergencyStop().baudRestored();
}

void SearchService::goOn()
{
    if (auto next = std::move(m_next); next && m_bench.link().state() == LinkState::Open)
        begin(std::move(next));
    else if (next)
        Q_EMIT searchChanged();
    m_bench.scheduleNext();
}

void SearchService::servoFound(const jobs::FoundServo& one)
{
    if (m_bench.link().connection() && one.servo.profile)
        m_bench.link().connection()->addStopTarget(one.servo);
    for (const ServoRef ref : m_bench.registry().order()) {
        ServoEntry& known = *m_bench.registry().entry(ref);
        if (!sameServo(known.servo, one.servo))
            continue;
        if (!isSameKind(known.servo, one.servo)) {
            m_bench.presence().replace(ref, one);
            return;
        }
        known.duplicateSuspected = one.duplicateSuspected;
        known.lateReplySeen = one.lateReplySeen;
        known.lastSeen = m_bench.now();
        known.silent = known.answeredAgain = false;
        updateFound(known, one);
        m_bench.registry().changed(known);
        return;
    }
    m_bench.registry().add(one);
}

/// Another of its kind may have been put in its place, and nothing in it tells: what was read and
/// saved before this search began is no longer taken for this servo's.
void SearchService::updateFound(ServoEntry& known, const jobs::FoundServo& one)
{
    if (!one.servo.profile || !m_search)
        return;
    if (m_search->knownFound.insert(known.ref).second) {
        known.hasFullTable = false;
        known.snapshotPath.clear();
    }
    device::Servo heard = one.servo;
    if (known.servo.profile)
        heard.profile = known.servo.profile; // pointers to its registers stay valid
    m_bench.registry().merge(known, heard, m_search->startedAt);
}

void SearchService::searchEnded(const base::Result<jobs::ScanReport>& result)
{
    Event event{.kind = Event::Kind::SearchEnded, .notices = m_search->notices};
    leave();
    if (result) {
        m_lastSearch = *result;
        event.found = int(result->found.size());
        event.elapsed = result->elapsed;
        event.missing = missingServos(*result);
        removeSilent(*result);
    } else {
        event.error = result.error();
    }
    Q_EMIT searchChanged();
    m_bench.emitEvent(event);
    if (result && m_bench.link().state() == LinkState::Open)
        m_bench.recovery().checkOnce();
    goOn();
}

std::vector<jobs::ExpectedServo> SearchService::expectedServos() const
{
    std::vector<jobs::ExpectedServo> expected;
    for (const auto& [ref, known] : m_bench.registry().entries())
        expected.push_back({known.servo.id, known.servo.baud, known.servo.protocol});
    const bool listed = m_expectedId && std::any_of(expected.begin(), expected.end(),
                                                    [this](const jobs::ExpectedServo& one) {
                                                        return one.id == *m_expectedId;
                                                    });
    if (m_expectedId && !listed)
        expected.push_back({*m_expectedId, m_bench.link().baud()});
    return expected;
}

/// Under no rate, that is: one that was found at another one is there.
std::vector<int> SearchService::missingServos(const jobs::ScanReport& report) const
{
    if (report.stopped)
        return {};
    std::set<int> missing;
    for (const jobs::ExpectedServo& one : m_lastSpec.expected) {
        const auto& languages = m_lastSpec.protocols;
        const bool language = languages.empty() || !one.protocol ||
                              std::count(languages.begin(), languages.end(), *one.protocol) > 0;
        const bool asked = language && one.id >= m_lastSpec.firstId &&
                           one.id <= m_lastSpec.lastId &&
                           std::count(report.rates.begin(), report.rates.end(), one.baud) > 0;
        const bool found = std::any_of(
            report.found.begin(), report.found.end(), [&](const jobs::FoundServo& other) {
                return other.servo.id == one.id &&
                       (!one.protocol || other.servo.protocol == *one.protocol);
            });
        if (asked && !found)
            missing.insert(one.id);
    }
    return {missing.begin(), missing.end()};
}

/// Those that were asked and did not answer leave the list; one that is being worked on does not.
void SearchService::removeSilent(const jobs::ScanReport& report)
{
    if (report.stopped)
        return;
    std::vector<ServoRef> silent;
    for (const auto& [ref, known] : m_bench.registry().entries()) {
        const bool heard = std::any_of(report.found.begin(), report.found.end(),
                                       [&servo = known.servo](const jobs::FoundServo& one) {
                                           return sameServo(one.servo, servo);
                                       });
        if (!heard && !known.writing() && inScope(m_lastSpec, report.rates, known.servo))
            silent.push_back(ref);
    }
    for (const ServoRef ref : silent)
        m_bench.registry().remove(ref);
}
} // namespace session
