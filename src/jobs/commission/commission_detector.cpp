// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_detector.h"

#include "device/duplicate_id_check.h"
#include "device/transactions.h"
#include "jobs/scan/scan_profile.h"

#include <algorithm>
#include <cstdlib>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

constexpr base::Duration settleTime = std::chrono::milliseconds(2);
/// IDs of the slow search in one round: about 150 ms.
constexpr int idsPerSlice = 32;
/// The vendor's rates; the first three are what servos leave the factory with.
constexpr int commonRates[] = {1'000'000, 115'200, 500'000};
constexpr int otherRates[] = {250'000, 256'000, 128'000, 76'800, 57'600,
                              38'400,  19'200,  9'600,   4'800};

void addRate(std::vector<int>& rates, int baud)
{
    if (baud > 0 && std::find(rates.begin(), rates.end(), baud) == rates.end())
        rates.push_back(baud);
}

/// So close that a servo at one rate is received at the other.
bool areClose(int a, int b)
{
    constexpr double apart = 0.05;
    return a != b && std::abs(a - b) < apart * std::max(a, b);
}
} // namespace

CommissionDetector::CommissionDetector(const device::Context& context, const CommissionSpec& spec)
    : m_context(context)
    , m_spec(spec)
{
    if (!context.bus.canSetBaud()) {
        m_likelyRates.push_back(context.bus.baud());
        return;
    }
    if (!spec.rates.empty()) {
        for (const int baud : spec.rates)
            addRate(m_likelyRates, baud);
        addRate(m_likelyRates, spec.baud);
        return;
    }
    for (const int baud : commonRates)
        addRate(m_likelyRates, baud);
    addRate(m_likelyRates, spec.baud);
    addRate(m_likelyRates, context.bus.baud());
    for (const int baud : otherRates) {
        if (std::find(m_likelyRates.begin(), m_likelyRates.end(), baud) == m_likelyRates.end())
            m_otherRates.push_back(baud);
    }
}

base::Result<bool> CommissionDetector::setRate(int baud) const
{
    if (!m_context.bus.canSetBaud() || m_context.bus.baud() == baud)
        return true;
    const auto set = m_context.bus.setBaud(baud);
    if (!set && set.error().code == ErrorCode::RateUnsupported)
        return false;
    if (!set)
        return tl::unexpected(set.error());
    const auto quietResult = m_context.bus.listen(settleTime);
    return quietResult ? base::Result<bool>(true) : tl::unexpected(quietResult.error());
}

std::vector<Protocol> CommissionDetector::protocolsFor(int baud) const
{
    auto possible = m_context.catalog.protocolsAt(baud);
    if (!m_context.bus.canSetBaud())
        possible.assign(base::allProtocols.begin(), base::allProtocols.end());
    if (!m_spec.protocols.empty()) {
        std::erase_if(possible, [this](Protocol protocol) {
            return std::find(m_spec.protocols.begin(), m_spec.protocols.end(), protocol) ==
                   m_spec.protocols.end();
        });
    }
    return possible;
}

base::Result<CommissionDetector::PingResult> CommissionDetector::ping(Protocol protocol, int id,
                                                                      base::Duration timeout) const
{
    const auto outcome = device::pingOnce(m_context, protocol, id, timeout);
    if (outcome)
        return PingResult{BusPresence::Clean,
                          outcome->replies.empty() ? id : outcome->replies.front().id};
    switch (outcome.error().code) {
    case ErrorCode::NoReply:
        return PingResult{};
    case ErrorCode::Refused:
        return PingResult{BusPresence::Clean, id};
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
        return PingResult{BusPresence::Broken, -1};
    default:
        return tl::unexpected(outcome.error());
    }
}

/// Asks these IDs one after the other with the short timeout of a search, then waits for the late
/// replies of a slow adapter. The first reply may belong to an earlier request: the input is
/// drained and the request repeated. After a reply that is late, or corrupt (as a late reply in
/// another protocol is), it waits every time.
base::Result<std::optional<CommissionDetector::BusLocation>>
CommissionDetector::pingEach(Protocol protocol, const std::vector<int>& ids, int baud)
{
    const base::Duration drain = m_context.bus.maxReplyLateness();
    m_context.bus.takeUnexpectedFrames();
    PingResult reply;
    for (std::size_t i = 0; i < ids.size() && reply.presence == BusPresence::Silent; ++i) {
        const auto answer = ping(protocol, ids[i], scanProfileOf(protocol).timeout);
        if (!answer)
            return tl::unexpected(answer.error());
        reply = *answer;
    }
    const bool clean = reply.presence == BusPresence::Clean;
    auto strays = m_context.bus.takeUnexpectedFrames();
    const bool late =
        !m_expectsLateReplies && (reply.presence == BusPresence::Broken || !strays.empty());
    const bool isRepeat = late || (clean && !m_hasReplied);
    if (!isRepeat && reply.presence != BusPresence::Silent)
        return BusLocation{protocol, clean ? reply.id : -1, baud};
    if (isRepeat || (m_expectsLateReplies && strays.empty())) {
        const auto span = std::max(drain, m_context.bus.maxReplyLateness());
        if (const auto listened = m_context.bus.listen(span); !listened)
            return tl::unexpected(listened.error());
    }
    m_expectsLateReplies = m_expectsLateReplies || late;
    m_hasReplied = m_hasReplied || clean;
    if (isRepeat)
        return pingEach(protocol, ids, baud);
    for (const bus::UnexpectedFrame& more : m_context.bus.takeUnexpectedFrames())
        strays.push_back(more);
    return findLateReply(strays, protocol, baud);
}

std::optional<CommissionDetector::BusLocation>
CommissionDetector::findLateReply(const std::vector<bus::UnexpectedFrame>& strays,
                                  Protocol protocol, int baud) const
{
    for (const bus::UnexpectedFrame& late : strays) {
        if (isPingReply(protocol, late) && !looksLikeEcho(m_context.bus, protocol, late))
            return BusLocation{protocol, late.id, baud};
    }
    return std::nullopt;
}

/// A servo that is alone replies to a broadcast PING; families without one have the factory ID.
base::Result<std::optional<CommissionDetector::BusLocation>>
CommissionDetector::scanCommonIds(int baud)
{
    const auto rateSet = setRate(baud);
    if (!rateSet || !*rateSet)
        return rateSet ? base::Result<std::optional<BusLocation>>()
                       : tl::unexpected(rateSet.error());
    for (const Protocol protocol : protocolsFor(baud)) {
        std::vector<int> ids{protocol::broadcastId};
        if (protocol == Protocol::Feetech)
            ids.push_back(factoryId);
        auto reply = pingEach(protocol, ids, baud);
        if (!reply || *reply)
            return reply;
    }
    return std::nullopt;
}

/// Continues the search for servos that reply to their own ID only, by a few IDs.
base::Result<std::optional<CommissionDetector::BusLocation>> CommissionDetector::scanNextSlice()
{
    const int baud = m_likelyRates[m_scanRate];
    const auto rateSet = setRate(baud);
    if (!rateSet)
        return tl::unexpected(rateSet.error());
    const auto usedProtocols = protocolsFor(baud);
    const bool feetech = std::find(usedProtocols.begin(), usedProtocols.end(), Protocol::Feetech) !=
                         usedProtocols.end();
    std::vector<int> ids;
    while (*rateSet && feetech && int(ids.size()) < idsPerSlice && m_scanId <= protocol::maxId)
        ids.push_back(m_scanId++);
    auto reply = pingEach(Protocol::Feetech, ids, baud);
    if (!reply || *reply)
        return reply;
    if (m_scanId > protocol::maxId || !*rateSet || !feetech) {
        m_scanId = 0;
        m_scanRate = (m_scanRate + 1) % m_likelyRates.size();
    }
    return std::nullopt;
}

base::Result<std::optional<CommissionDetector::BusLocation>>
CommissionDetector::scanRound(const std::vector<BusLocation>& known)
{
    for (const BusLocation& place : known) {
        const auto rateSet = setRate(place.baud);
        if (!rateSet)
            return tl::unexpected(rateSet.error());
        auto reply = pingEach(place.protocol, {place.id}, place.baud);
        if (!reply || *reply)
            return reply;
    }
    for (const int baud : m_likelyRates) {
        auto reply = scanCommonIds(baud);
        if (!reply || *reply)
            return reply;
    }
    if (!m_otherRates.empty()) {
        auto reply = scanCommonIds(m_otherRates[m_nextOtherRate]);
        m_nextOtherRate = (m_nextOtherRate + 1) % m_otherRates.size();
        if (!reply || *reply)
            return reply;
    }
    return scanNextSlice();
}

/// Protocols with a broadcast PING need no search of every ID: a servo that is alone replies to it
/// without a collision every time.
base::Result<void> CommissionDetector::checkAlone(const BusLocation& first,
                                                  std::vector<FoundServo>& found)
{
    constexpr int pingEach = 3;
    for (int i = 0; i < pingEach; ++i) {
        const auto reply =
            ping(first.protocol, protocol::broadcastId, m_context.bus.maxReplyLateness());
        if (!reply)
            return tl::unexpected(reply.error());
        const bool same = reply->presence == BusPresence::Clean && reply->id == first.id;
        if (reply->presence != BusPresence::Silent && !same && !found.empty())
            found.front().duplicateSuspected = true;
    }
    return {};
}

base::Result<void> CommissionDetector::addOtherRates(const BusLocation& first,
                                                     std::vector<FoundServo>& found)
{
    std::vector<int> rates = m_likelyRates;
    rates.insert(rates.end(), m_otherRates.begin(), m_otherRates.end());
    for (const int baud : rates) {
        const bool asked =
            first.protocol == Protocol::Feetech && (baud == first.baud || baud == m_spec.baud);
        if (asked || areClose(baud, first.baud))
            continue;
        const auto rateSet = setRate(baud);
        if (!rateSet)
            return tl::unexpected(rateSet.error());
        for (const Protocol protocol : protocolsFor(baud)) {
            if (!*rateSet || (protocol == first.protocol && baud == first.baud))
                continue;
            // Modbus servos have one factory rate; searching others takes too long for what it
            // finds.
            if (protocol == Protocol::Modbus && baud != commonRates[1])
                continue;
            const int id = protocol == Protocol::Feetech ? factoryId : protocol::broadcastId;
            const auto reply = pingEach(protocol, {id}, baud);
            if (!reply)
                return tl::unexpected(reply.error());
            if (!*reply)
                continue;
            FoundServo other;
            other.servo.protocol = protocol;
            other.servo.id = (*reply)->id;
            other.servo.baud = baud;
            found.push_back(std::move(other));
        }
    }
    return {};
}

base::Result<std::vector<FoundServo>> CommissionDetector::findAll(const BusLocation& first)
{
    ScanSpec spec;
    spec.bauds = {first.baud};
    spec.protocols = {first.protocol};
    if (first.protocol == Protocol::Feetech) {
        if (m_context.bus.canSetBaud())
            addRate(spec.bauds, m_spec.baud);
        for (const int baud : otherRates) {
            if (areClose(baud, first.baud))
                addRate(spec.bauds, baud);
        }
    } else if (first.id >= 0) {
        spec.firstId = spec.lastId = first.id;
    }
    const auto rateSet = setRate(first.baud);
    if (!rateSet)
        return tl::unexpected(rateSet.error());
    // A late reply to an earlier request is not a second servo.
    if (m_expectsLateReplies) {
        if (const auto drained = m_context.bus.listen(m_context.bus.maxReplyLateness()); !drained)
            return tl::unexpected(drained.error());
    }
    const auto report = scan(m_context, spec);
    if (!report)
        return tl::unexpected(report.error());
    if (report->stopped)
        return base::fail(ErrorCode::Stopped, QStringLiteral("commission"));
    std::vector<FoundServo> found = report->found;
    if (first.protocol != Protocol::Feetech) {
        if (const auto checkResult = checkAlone(first, found); !checkResult)
            return tl::unexpected(checkResult.error());
    }
    if (m_context.bus.canSetBaud()) {
        if (const auto others = addOtherRates(first, found); !others)
            return tl::unexpected(others.error());
    }
    return found;
}

base::Result<bool> CommissionDetector::hasDuplicateId(const device::Servo& servo)
{
    const auto found = device::checkDuplicateId(m_context, servo);
    if (found)
        return found->sign != device::DuplicateIdSign::None;
    // A servo that does not reply is gone; the write checks again.
    if (found.error().code == ErrorCode::NoReply)
        return false;
    return tl::unexpected(found.error());
}

base::Result<bool> CommissionDetector::isPresent(const BusLocation& place)
{
    constexpr int tries = 2;
    const auto rateSet = setRate(place.baud);
    if (!rateSet || !*rateSet)
        return rateSet;
    for (int i = 0; i < tries; ++i) {
        const auto reply = ping(place.protocol, place.id, m_context.bus.maxReplyLateness());
        if (!reply)
            return tl::unexpected(reply.error());
        if (reply->presence != BusPresence::Silent)
            return true;
    }
    return false;
}
} // namespace jobs
