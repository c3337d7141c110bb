// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan_plan.h"
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
    if (testing()) {
        tell({.kind = Event::Kind::Failed,
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
    goOn();
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
    base::Stop stop;
    device::Notices notices;
    return jobs::scanEstimate(m_connection->context(stop, notices), asked);
}

void Desk::startSearch()
{
    if (!m_search || m_search->started || m_state != LinkState::Open || m_running)
        return;
    m_search->started = true;
    m_search->startedAt = now();
    m_search->staysHere = jobs::ratesToSearch(m_search->spec, baud()) == std::vector{baud()};
    updateFeed();
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
            m_inbox.post([this, progress] { Q_EMIT searchProgress(progress); });
        },
        [this](const jobs::Found& one) { m_inbox.post([this, one] { found(one); }); });
    const QString others = m_connection->simulated()
                               ? QString()
                               : transport::portHolders(transport::canonicalPath(search.port));
    m_inbox.post([this, others, result = std::move(result)] { searchEnded(result, others); });
}

void Desk::found(const jobs::Found& one)
{
    if (m_connection && one.servo.profile)
        m_connection->know(one.servo);
    for (auto& [ref, known] : m_servos) {
        if (!sameServo(known.servo, one.servo))
            continue;
        if (!sameKind(known.servo, one.servo)) {
            replace(ref, one);
            return;
        }
        known.twinsSuspected = one.twinsSuspected;
        known.heardLate = one.heardLate;
        known.lastSeen = now();
        known.silent = known.heardAgain = false;
        met(known, one);
        changed(known);
        return;
    }
    add(one);
}

ServoRef Desk::add(const jobs::Found& one)
{
    ServoEntry added;
    added.ref = ++m_lastRef;
    added.servo = one.servo;
    added.firstImage = one.servo.image;
    added.twinsSuspected = one.twinsSuspected;
    added.heardLate = one.heardLate;
    added.lastSeen = now();
    const ServoRef ref = added.ref;
    insert(std::move(added));
    if (ServoEntry* known = entry(ref))
        markAlarms(*known);
    return ref;
}

/// Another of its kind may have been put in its place, and nothing in it tells: what was read and
/// saved before this search began is no longer taken for this servo's.
void Desk::met(ServoEntry& known, const jobs::Found& one)
{
    if (!one.servo.profile || !m_search)
        return;
    if (m_search->met.insert(known.ref).second) {
        known.tableRead = false;
        known.snapshotPath.clear();
    }
    device::Servo heard = one.servo;
    if (known.servo.profile)
        heard.profile = known.servo.profile; // who holds its registers may go on
    merge(known, heard, m_search->startedAt);
}

void Desk::insert(ServoEntry added)
{
    const ServoRef ref = added.ref;
    m_servos.emplace(ref, std::move(added));
    const auto place = std::upper_bound(m_order.begin(), m_order.end(), ref,
                                        [this](ServoRef a, ServoRef b) { return before(a, b); });
    m_order.insert(place, ref);
    Q_EMIT servoAdded(ref);
}

/// The order of the list.
bool Desk::before(ServoRef a, ServoRef b) const
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
    m_feeder.forget(ref);
    updateFeed();
    Q_EMIT servoRemoved(ref);
    Q_EMIT undoChanged();
}

void Desk::searchEnded(const base::Result<jobs::ScanReport>& result, const QString& otherPrograms)
{
    m_otherPrograms = otherPrograms;
    const device::Notices notices = m_search->notices;
    if (m_connection)
        noteHeard(); // what the search has asked in vain does not count
    m_search.reset();
    if (std::exchange(m_checkAfterSearch, false))
        checkStop();
    Event event{.kind = Event::Kind::SearchEnded, .notices = notices};
    if (result) {
        m_lastSearch = *result;
        event.missing = missingOf(*result);
        removeSilent(*result);
    } else {
        event.error = result.error();
    }
    Q_EMIT searchChanged();
    tell(event);
    if (m_nextSearch) {
        const jobs::ScanSpec next = *m_nextSearch;
        m_nextSearch.reset();
        search(next);
    }
    if (result && !m_intentsLooked && m_state == LinkState::Open) {
        m_intentsLooked = true;
        lookForIntents();
    }
    goOn();
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
std::vector<int> Desk::missingOf(const jobs::ScanReport& report) const
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
        const bool found =
            std::any_of(report.found.begin(), report.found.end(), [&](const jobs::Found& other) {
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
        const bool heard = std::any_of(
            report.found.begin(), report.found.end(),
            [&servo = known.servo](const jobs::Found& one) { return sameServo(one.servo, servo); });
        if (!heard && !known.writing() && inScope(m_lastSpec, report.rates, known.servo))
            silent.push_back(ref);
    }
    for (const ServoRef ref : silent)
        remove(ref);
}
} // namespace session
