// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission_look.h"

#include "device/talk.h"
#include "device/twin_check.h"
#include "jobs/scan_manner.h"

#include <algorithm>
#include <cstdlib>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

constexpr base::Duration settleTime = std::chrono::milliseconds(2);
/// IDs of the slow search in one round: some 150 ms.
constexpr int sliceIds = 32;
/// The vendor's rates; the first three are what servos leave the factory with.
constexpr int usualRates[] = {1'000'000, 115'200, 500'000};
constexpr int otherRates[] = {250'000, 256'000, 128'000, 76'800, 57'600,
                              38'400,  19'200,  9'600,   4'800};

void addRate(std::vector<int>& rates, int baud)
{
    if (baud > 0 && std::find(rates.begin(), rates.end(), baud) == rates.end())
        rates.push_back(baud);
}

/// So near that a servo at one is heard at the other.
bool neighbours(int a, int b)
{
    constexpr double apart = 0.05;
    return a != b && std::abs(a - b) < apart * std::max(a, b);
}
} // namespace

CommissionLook::CommissionLook(const device::Context& context, const CommissionSpec& spec)
    : m_context(context)
    , m_spec(spec)
{
    if (!context.bus.hasBaud()) {
        m_likely.push_back(context.bus.baud());
        return;
    }
    if (!spec.rates.empty()) {
        for (const int baud : spec.rates)
            addRate(m_likely, baud);
        addRate(m_likely, spec.baud);
        return;
    }
    for (const int baud : usualRates)
        addRate(m_likely, baud);
    addRate(m_likely, spec.baud);
    addRate(m_likely, context.bus.baud());
    for (const int baud : otherRates) {
        if (std::find(m_likely.begin(), m_likely.end(), baud) == m_likely.end())
            m_others.push_back(baud);
    }
}

base::Result<bool> CommissionLook::tune(int baud) const
{
    if (!m_context.bus.hasBaud() || m_context.bus.baud() == baud)
        return true;
    const auto set = m_context.bus.setBaud(baud);
    if (!set && set.error().code == ErrorCode::RateUnsupported)
        return false;
    if (!set)
        return tl::unexpected(set.error());
    const auto settled = m_context.bus.listen(settleTime);
    return settled ? base::Result<bool>(true) : tl::unexpected(settled.error());
}

std::vector<Protocol> CommissionLook::languages(int baud) const
{
    auto possible = m_context.catalog.protocolsAt(baud);
    if (!m_context.bus.hasBaud())
        possible.assign(base::allProtocols.begin(), base::allProtocols.end());
    if (!m_spec.protocols.empty()) {
        std::erase_if(possible, [this](Protocol protocol) {
            return std::find(m_spec.protocols.begin(), m_spec.protocols.end(), protocol) ==
                   m_spec.protocols.end();
        });
    }
    return possible;
}

base::Result<CommissionLook::Answer> CommissionLook::ask(Protocol protocol, int id,
                                                         base::Duration patience) const
{
    const auto outcome = device::pingOnce(m_context, protocol, id, patience);
    if (outcome)
        return Answer{Voice::Clean, outcome->parts.empty() ? id : outcome->parts.front().id};
    switch (outcome.error().code) {
    case ErrorCode::NoAnswer:
        return Answer{};
    case ErrorCode::Refused:
        return Answer{Voice::Clean, id};
    case ErrorCode::Garbled:
    case ErrorCode::WrongAnswer:
        return Answer{Voice::Broken, -1};
    default:
        return tl::unexpected(outcome.error());
    }
}

/// Asks these IDs one after the other with the short patience of a search, then listens for what a
/// slow adapter brings later. The first answer of all may have been asked for elsewhere: the line
/// is drained and the question repeated. What comes late, or broken, which a late answer in another
/// language is, makes it listen every time from then on.
base::Result<std::optional<CommissionLook::Place>>
CommissionLook::questions(Protocol protocol, const std::vector<int>& ids, int baud)
{
    const base::Duration drain = m_context.bus.replyTimeout();
    m_context.bus.takeStrays();
    Answer heard;
    for (std::size_t i = 0; i < ids.size() && heard.voice == Voice::Silent; ++i) {
        const auto answer = ask(protocol, ids[i], mannerOf(protocol).patience);
        if (!answer)
            return tl::unexpected(answer.error());
        heard = *answer;
    }
    const bool clean = heard.voice == Voice::Clean;
    auto strays = m_context.bus.takeStrays();
    const bool late = !m_awaitsLate && (heard.voice == Voice::Broken || !strays.empty());
    const bool again = late || (clean && !m_heard);
    if (!again && heard.voice != Voice::Silent)
        return Place{protocol, clean ? heard.id : -1, baud};
    if (again || (m_awaitsLate && strays.empty())) {
        const auto span = std::max(drain, m_context.bus.replyTimeout());
        if (const auto listened = m_context.bus.listen(span); !listened)
            return tl::unexpected(listened.error());
    }
    m_awaitsLate = m_awaitsLate || late;
    m_heard = m_heard || clean;
    if (again)
        return questions(protocol, ids, baud);
    for (const bus::Stray& more : m_context.bus.takeStrays())
        strays.push_back(more);
    return lateAnswer(strays, protocol, baud);
}

std::optional<CommissionLook::Place>
CommissionLook::lateAnswer(const std::vector<bus::Stray>& strays, Protocol protocol, int baud) const
{
    for (const bus::Stray& late : strays) {
        if (answersQuestion(protocol, late) && !readsLikeEcho(m_context.bus, protocol, late))
            return Place{protocol, late.id, baud};
    }
    return std::nullopt;
}

/// Whoever is alone answers the question to all; families that do not know it have the factory's
/// ID.
base::Result<std::optional<CommissionLook::Place>> CommissionLook::quickly(int baud)
{
    const auto tuned = tune(baud);
    if (!tuned || !*tuned)
        return tuned ? base::Result<std::optional<Place>>() : tl::unexpected(tuned.error());
    for (const Protocol protocol : languages(baud)) {
        std::vector<int> ids{protocol::broadcastId};
        if (protocol == Protocol::Feetech)
            ids.push_back(factoryId);
        auto heard = questions(protocol, ids, baud);
        if (!heard || *heard)
            return heard;
    }
    return std::nullopt;
}

/// A few IDs more of the search for those that answer to their own ID only.
base::Result<std::optional<CommissionLook::Place>> CommissionLook::slowly()
{
    const int baud = m_likely[m_sweptRate];
    const auto tuned = tune(baud);
    if (!tuned)
        return tl::unexpected(tuned.error());
    const auto spoken = languages(baud);
    const bool feetech = std::find(spoken.begin(), spoken.end(), Protocol::Feetech) != spoken.end();
    std::vector<int> ids;
    while (*tuned && feetech && int(ids.size()) < sliceIds && m_sweptId <= protocol::maxId)
        ids.push_back(m_sweptId++);
    auto heard = questions(Protocol::Feetech, ids, baud);
    if (!heard || *heard)
        return heard;
    if (m_sweptId > protocol::maxId || !*tuned || !feetech) {
        m_sweptId = 0;
        m_sweptRate = (m_sweptRate + 1) % m_likely.size();
    }
    return std::nullopt;
}

base::Result<std::optional<CommissionLook::Place>>
CommissionLook::round(const std::vector<Place>& known)
{
    for (const Place& place : known) {
        const auto tuned = tune(place.baud);
        if (!tuned)
            return tl::unexpected(tuned.error());
        auto heard = questions(place.protocol, {place.id}, place.baud);
        if (!heard || *heard)
            return heard;
    }
    for (const int baud : m_likely) {
        auto heard = quickly(baud);
        if (!heard || *heard)
            return heard;
    }
    if (!m_others.empty()) {
        auto heard = quickly(m_others[m_other]);
        m_other = (m_other + 1) % m_others.size();
        if (!heard || *heard)
            return heard;
    }
    return slowly();
}

/// In the languages with a question to all, the IDs need not be gone through: who is alone answers
/// it cleanly every time.
base::Result<void> CommissionLook::addAlone(const Place& first, std::vector<Found>& found)
{
    constexpr int questions = 3;
    for (int i = 0; i < questions; ++i) {
        const auto heard = ask(first.protocol, protocol::broadcastId, m_context.bus.replyTimeout());
        if (!heard)
            return tl::unexpected(heard.error());
        const bool same = heard->voice == Voice::Clean && heard->id == first.id;
        if (heard->voice != Voice::Silent && !same && !found.empty())
            found.front().twinsSuspected = true;
    }
    return {};
}

base::Result<void> CommissionLook::addElsewhere(const Place& first, std::vector<Found>& found)
{
    std::vector<int> rates = m_likely;
    rates.insert(rates.end(), m_others.begin(), m_others.end());
    for (const int baud : rates) {
        const bool asked =
            first.protocol == Protocol::Feetech && (baud == first.baud || baud == m_spec.baud);
        if (asked || neighbours(baud, first.baud))
            continue;
        const auto tuned = tune(baud);
        if (!tuned)
            return tl::unexpected(tuned.error());
        for (const Protocol protocol : languages(baud)) {
            if (!*tuned || (protocol == first.protocol && baud == first.baud))
                continue;
            // Modbus leaves the factory with one rate; others cost more than they find.
            if (protocol == Protocol::Modbus && baud != usualRates[1])
                continue;
            const int id = protocol == Protocol::Feetech ? factoryId : protocol::broadcastId;
            const auto heard = questions(protocol, {id}, baud);
            if (!heard)
                return tl::unexpected(heard.error());
            if (!*heard)
                continue;
            Found other;
            other.servo.protocol = protocol;
            other.servo.id = (*heard)->id;
            other.servo.baud = baud;
            found.push_back(std::move(other));
        }
    }
    return {};
}

base::Result<std::vector<Found>> CommissionLook::everybody(const Place& first)
{
    ScanSpec spec;
    spec.bauds = {first.baud};
    spec.protocols = {first.protocol};
    if (first.protocol == Protocol::Feetech) {
        if (m_context.bus.hasBaud())
            addRate(spec.bauds, m_spec.baud);
        for (const int baud : otherRates) {
            if (neighbours(baud, first.baud))
                addRate(spec.bauds, baud);
        }
    } else if (first.id >= 0) {
        spec.firstId = spec.lastId = first.id;
    }
    const auto tuned = tune(first.baud);
    if (!tuned)
        return tl::unexpected(tuned.error());
    // An answer to the questions before is no second servo.
    if (m_awaitsLate) {
        if (const auto drained = m_context.bus.listen(m_context.bus.replyTimeout()); !drained)
            return tl::unexpected(drained.error());
    }
    const auto report = scan(m_context, spec);
    if (!report)
        return tl::unexpected(report.error());
    if (report->stopped)
        return base::fail(ErrorCode::Stopped, QStringLiteral("commission"));
    std::vector<Found> found = report->found;
    if (first.protocol != Protocol::Feetech) {
        if (const auto alone = addAlone(first, found); !alone)
            return tl::unexpected(alone.error());
    }
    if (m_context.bus.hasBaud()) {
        if (const auto others = addElsewhere(first, found); !others)
            return tl::unexpected(others.error());
    }
    return found;
}

base::Result<bool> CommissionLook::twins(const device::Servo& servo)
{
    const auto found = device::lookForTwins(m_context, servo);
    if (found)
        return found->sign != device::TwinSign::None;
    // One that is not answered has gone; the write looks again.
    if (found.error().code == ErrorCode::NoAnswer)
        return false;
    return tl::unexpected(found.error());
}

base::Result<bool> CommissionLook::present(const Place& place)
{
    constexpr int tries = 2;
    const auto tuned = tune(place.baud);
    if (!tuned || !*tuned)
        return tuned;
    for (int i = 0; i < tries; ++i) {
        const auto heard = ask(place.protocol, place.id, m_context.bus.replyTimeout());
        if (!heard)
            return tl::unexpected(heard.error());
        if (heard->voice != Voice::Silent)
            return true;
    }
    return false;
}
} // namespace jobs
