// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_plan.h"
#include "session/desk_work.h"
#include "transport/port_lease.h"

#include <algorithm>
#include <tuple>

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

void Desk::search(const jobs::ScanSpec& spec)
{
    if (m_state != LinkState::Open)
        return;
    if (isTesting()) {
        emitEvent({.kind = Event::Kind::Failed,
                   .error = base::Error{base::ErrorCode::Held, QStringLiteral("scan"),
                                        QStringLiteral("test")}});
        return;
    }
    stopSearch();
    if (m_search) { // the one before ends first, and this one takes its turn
        m_nextSearch = spec;
        return;
    }
    m_search = std::make_unique<Search>();
    m_search->spec = spec;
    m_search->port = m_request.name;
    m_search->spec.expected = expectedServos();
    if (m_search->spec.protocols.empty() && m_request.protocol)
        m_search->spec.protocols = {*m_request.protocol};
    m_lastSpec = m_search->spec;
    Q_EMIT searchChanged();
    scheduleNext();
}

void Desk::stopSearch()
{
    m_nextSearch.reset();
    if (!m_search)
        return;
    m_search->stop.request();
    if (m_search->started)
        return;
    m_search.reset();
    Q_EMIT searchChanged();
}

base::Duration Desk::searchEstimate(const jobs::ScanSpec& spec) const
{
    if (!m_connection)
        return {};
    jobs::ScanSpec asked = spec;
    if (asked.protocols.empty() && m_request.protocol)
        asked.protocols = {*m_request.protocol};
    base::StopToken stop;
    device::Notices notices;
    return jobs::estimateScanTime(m_connection->context(stop, notices), asked);
}

void Desk::startSearch()
{
    if (!m_search || m_search->started || m_state != LinkState::Open || m_running)
        return;
    m_search->started = true;
    m_search->startedAt = now();
    m_search->keepsBaud = jobs::ratesToScan(m_search->spec, baud()) == std::vector{baud()};
    updatePolling();
    // Job and search end before they are destroyed: goOn() waits for searchEnded().
    m_searchThread->start([this, search = m_search.get()] { runSearch(*search); });
}

/// On the search thread.
void Desk::runSearch(Search& search)
{
    const auto context = m_connection->context(search.stop, search.notices);
    auto result = jobs::scan(
        context, search.spec,
        [this](const jobs::Progress& progress) {
            m_mainQueue.post([this, progress] { Q_EMIT searchProgress(progress); });
        },
        [this](const jobs::FoundServo& one) {
            m_mainQueue.post([this, one] { servoFound(one); });
        });
    const QString others = m_connection->isSimulated()
                               ? QString()
                               : transport::portHolders(transport::canonicalPath(search.port));
    m_mainQueue.post([this, others, result = std::move(result)] { searchEnded(result, others); });
}

void Desk::servoFound(const jobs::FoundServo& one)
{
    if (m_connection && one.servo.profile)
        m_connection->addStopTarget(one.servo);
    for (auto& [ref, known] : m_servos) {
        if (!sameServo(known.servo, one.servo))
            continue;
        if (!isSameKind(known.servo, one.servo)) {
            replace(ref, one);
            return;
        }
        known.duplicateSuspected = one.duplicateSuspected;
        known.lateReplySeen = one.lateReplySeen;
        known.lastSeen = now();
        known.silent = known.answeredAgain = false;
        updateFound(known, one);
        changed(known);
        return;
    }
    add(one);
}

ServoRef Desk::add(const jobs::FoundServo& one)
{
    ServoEntry added;
    added.ref = ++m_lastRef;
    added.servo = one.servo;
    added.firstImage = one.servo.image;
    added.duplicateSuspected = one.duplicateSuspected;
    added.lateReplySeen = one.lateReplySeen;
    added.lastSeen = now();
    const ServoRef ref = added.ref;
    insertServo(std::move(added));
    if (ServoEntry* known = entry(ref))
        markAlarms(*known);
    return ref;
}

/// Another of its kind may have been put in its place, and nothing in it tells: what was read and
/// saved before this search began is no longer taken for this servo's.
void Desk::updateFound(ServoEntry& known, const jobs::FoundServo& one)
{
    if (!one.servo.profile || !m_search)
        return;
    if (m_search->knownFound.insert(known.ref).second) {
        known.hasFullTable = false;
        known.snapshotPath.clear();
    }
    device::Servo heard = one.servo;
    if (known.servo.profile)
        heard.profile = known.servo.profile; // who holds its registers may go on
    merge(known, heard, m_search->startedAt);
}

void Desk::insertServo(ServoEntry added)
{
    const ServoRef ref = added.ref;
    m_servos.emplace(ref, std::move(added));
    const auto it = std::upper_bound(m_order.begin(), m_order.end(), ref,
                                     [this](ServoRef a, ServoRef b) { return sortsBefore(a, b); });
    m_order.insert(it, ref);
    Q_EMIT servoAdded(ref);
}

/// The order of the list.
bool Desk::sortsBefore(ServoRef a, ServoRef b) const
{
    const auto key = [this](ServoRef ref) {
        const device::Servo& servo = m_servos.at(ref).servo;
        return std::tuple(servo.id, servo.protocol, servo.baud, ref);
    };
    return key(a) < key(b);
}

void Desk::remove(ServoRef ref)
{
    m_order.erase(std::remove(m_order.begin(), m_order.end(), ref), m_order.end());
    const auto gone = [ref](const UndoStep& step) { return step.servo == ref; };
    m_undo.erase(std::remove_if(m_undo.begin(), m_undo.end(), gone), m_undo.end());
    m_redo.erase(std::remove_if(m_redo.begin(), m_redo.end(), gone), m_redo.end());
    m_servos.erase(ref);
    m_polling.removeServo(ref);
    updatePolling();
    Q_EMIT servoRemoved(ref);
    Q_EMIT undoChanged();
}

void Desk::searchEnded(const base::Result<jobs::ScanReport>& result, const QString& otherPrograms)
{
    m_otherPrograms = otherPrograms;
    const device::Notices notices = m_search->notices;
    if (m_connection)
        updatePresence(); // what the search has asked in vain does not count
    m_search.reset();
    if (std::exchange(m_checkAfterSearch, false))
        verifyStop();
    Event event{.kind = Event::Kind::SearchEnded, .notices = notices};
    if (result) {
        m_lastSearch = *result;
        event.missing = missingServos(*result);
        removeSilent(*result);
    } else {
        event.error = result.error();
    }
    Q_EMIT searchChanged();
    emitEvent(event);
    if (m_nextSearch) {
        const jobs::ScanSpec next = *m_nextSearch;
        m_nextSearch.reset();
        search(next);
    }
    if (result && !m_intentsChecked && m_state == LinkState::Open) {
        m_intentsChecked = true;
        findOpenIntents();
    }
    scheduleNext();
}

std::vector<jobs::ExpectedServo> Desk::expectedServos() const
{
    std::vector<jobs::ExpectedServo> expected;
    for (const auto& [ref, known] : m_servos)
        expected.push_back({known.servo.id, known.servo.baud, known.servo.protocol});
    const bool listed = m_expectedId && std::any_of(expected.begin(), expected.end(),
                                                    [this](const jobs::ExpectedServo& one) {
                                                        return one.id == *m_expectedId;
                                                    });
    if (m_expectedId && !listed)
        expected.push_back({*m_expectedId, baud()});
    return expected;
}

/// Under no rate, that is: one that was found at another one is there.
std::vector<int> Desk::missingServos(const jobs::ScanReport& report) const
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
void Desk::removeSilent(const jobs::ScanReport& report)
{
    if (report.stopped)
        return;
    std::vector<ServoRef> silent;
    for (const auto& [ref, known] : m_servos) {
        const bool heard = std::any_of(report.found.begin(), report.found.end(),
                                       [&servo = known.servo](const jobs::FoundServo& one) {
                                           return sameServo(one.servo, servo);
                                       });
        if (!heard && !known.writing() && inScope(m_lastSpec, report.rates, known.servo))
            silent.push_back(ref);
    }
    for (const ServoRef ref : silent)
        remove(ref);
}
} // namespace session
