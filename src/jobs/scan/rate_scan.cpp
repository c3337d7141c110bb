// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/rate_scan.h"

#include "device/transactions.h"

#include <algorithm>

namespace jobs {
namespace {
using std::chrono::milliseconds;

// USB adapters hold bytes back for up to 16 ms; some servos take tens of milliseconds when busy.
constexpr base::Duration longTimeout = milliseconds(60);
// How long after a PING its reply may still come in: for the final listening, and for the search
// for the sender of garbled bytes.
constexpr base::Duration lateWindow = milliseconds(40);
// After the last PING of a search at one rate: a busy computer holds back replies for longer. At
// many rates it would add up.
constexpr base::Duration stallWindow = milliseconds(250);
constexpr int confirmTries = 3;
// The first transaction after opening a port or changing its rate may be lost.
constexpr int broadcastTries = 2;
// Where an absent ID costs more than this, a search is long, and replies are reported at once.
constexpr base::Duration slowStep = milliseconds(10);
// How long the bus listens after a broadcast without a reply.
constexpr base::Duration quietTime = milliseconds(25);
// Behind a still slower adapter two servos with one ID would not be found, because nothing but
// damaged bytes ever shows how late it is. With more broken replies than this it would take long.
constexpr base::Duration longLateWindow = milliseconds(100);
constexpr std::size_t maxGarbledSearchedLong = 2;
// More broken replies than this at one rate mean a bad line, and asking each again would take long.
constexpr std::size_t maxGarbledResolved = 16;

/// The lateness of this link and the user's timeout may require more.
base::Duration atLeastBusPatience(const bus::Bus& bus, base::Duration defaultTimeout)
{
    return std::max(defaultTimeout, bus.statistics().timeout);
}

base::Duration finalWindow(const ScanSpec& spec)
{
    return spec.bauds.size() <= 1 ? stallWindow : lateWindow;
}

bool isGarbled(base::ErrorCode code)
{
    return code == base::ErrorCode::Garbled || code == base::ErrorCode::UnexpectedReply;
}
} // namespace

base::Duration broadcastEstimate(int baud, base::Protocol protocol)
{
    const ScanProfile& scanProfile = scanProfileOf(protocol);
    if (!scanProfile.supportsBroadcast)
        return {};
    return broadcastTries * (pingTime(scanProfile, baud, scanProfile.timeout) + quietTime);
}

base::Duration idScanEstimate(const ScanSpec& spec, int baud, base::Protocol protocol)
{
    const ScanProfile& scanProfile = scanProfileOf(protocol);
    const int ids = idsToScan(spec, protocol).count();
    if (ids == 0)
        return {};
    base::Duration total =
        (ids + 1) * pingTime(scanProfile, baud, scanProfile.timeout) + finalWindow(spec);
    if (spec.slowPass)
        total += ids * pingTime(scanProfile, baud, longTimeout);
    return total;
}

RateScan::RateScan(const device::Context& context, const ScanSpec& spec, base::Protocol protocol,
                   OnPinged onPinged, OnReply onReply)
    : m_context(context)
    , m_spec(spec)
    , m_protocol(protocol)
    , m_scanProfile(scanProfileOf(protocol))
    , m_ids(idsToScan(spec, protocol))
    , m_onPinged(std::move(onPinged))
    , m_onReply(std::move(onReply))
{}

base::Result<std::optional<int>> RateScan::pingBroadcast()
{
    std::optional<int> onlyId;
    const int tries = m_scanProfile.supportsBroadcast && m_ids.count() > 0 ? broadcastTries : 0;
    for (int i = 0; !m_hasReply && i < tries; ++i) {
        const auto outcome = sendPing(protocol::broadcastId, m_scanProfile.timeout);
        notify(broadcastEstimate(m_context.bus.baud(), m_protocol) / broadcastTries);
        if (outcome) {
            m_hasReply = true;
            onlyId = outcome->replies.front().id;
            if (const auto dropped = i > 0 ? dropLateReplies() : base::Result<void>{}; !dropped)
                return tl::unexpected(dropped.error());
        } else if (isGarbled(outcome.error().code) ||
                   outcome.error().code == base::ErrorCode::LineBusy) {
            m_hasReply = true; // the search itself decides about a busy line
        } else if (outcome.error().code != base::ErrorCode::NoReply) {
            return tl::unexpected(outcome.error());
        }
    }
    if (!onlyId || !m_ids.contains(*onlyId))
        return std::nullopt;
    // Colliding replies may form a frame that no servo sent.
    if (const auto pinged = ping(*onlyId, atLeastBusPatience(m_context.bus, longTimeout)); !pinged)
        return tl::unexpected(pinged.error());
    return m_responsesById[*onlyId].replies > 0 ? onlyId : std::nullopt;
}

/// Through a slow adapter the reply to the first broadcast comes after the second. The one that
/// still follows would look like a second servo on the ID.
base::Result<void> RateScan::dropLateReplies()
{
    const auto listened = m_context.bus.listen(m_context.bus.maxReplyLateness());
    m_context.bus.takeUnexpectedFrames();
    return listened;
}

base::Result<void> RateScan::run()
{
    if (m_ids.count() == 0)
        return {};
    m_context.bus.takeUnexpectedFrames();
    return pingEachId()
        .and_then([this] { return listenForLateReplies(); })
        .and_then([this] { return confirmLateReplies(); })
        .and_then([this] { return resolveGarbled(); })
        .and_then([this] { return pingExpected(); })
        .and_then([this] { return m_spec.slowPass ? pingSilent() : base::Result<void>{}; });
}

base::Result<void> RateScan::pingEachId()
{
    const auto step = pingTime(m_scanProfile, m_context.bus.baud(), m_scanProfile.timeout);
    const bool reportsAtOnce = m_onReply && step >= slowStep;
    bus::DamagedReplyWatch watch(m_context.bus);
    std::optional<int> previousId;
    // The first transaction after opening a port or changing its rate may be lost, so it goes to an
    // ID that is asked again later.
    for (int i = m_ids.first - 1; i <= m_ids.last; ++i) {
        const int id = i < m_ids.first ? m_ids.last : i;
        const IdResponse before = m_responsesById[id];
        if (const auto pinged = ping(id, m_scanProfile.timeout); !pinged)
            return pinged;
        const bool cameBetween = watch.hasReplyCome();
        const bool isRest = !m_garbledReplies.empty() && m_garbledReplies.back().id == previousId;
        if (m_responsesById[id].garbled > before.garbled)
            m_garbledReplies.push_back({id, m_responsesById[id].askedAt});
        else if (cameBetween && !isRest)
            m_garbledReplies.push_back({std::nullopt, m_responsesById[id].askedAt});
        previousId = id;
        notify(step);
        const bool answered =
            m_responsesById[id].replies > before.replies && !m_responsesById[id].late;
        const auto reported =
            reportsAtOnce && answered ? m_onReply(*this, id) : base::Result<void>{};
        if (!reported)
            return reported;
    }
    return {};
}

/// The replies to the last PINGs may still be on their way through a slow adapter, also broken
/// ones.
base::Result<void> RateScan::listenForLateReplies()
{
    bus::DamagedReplyWatch watch(m_context.bus);
    const auto listened = listen(atLeastBusPatience(m_context.bus, finalWindow(m_spec)));
    if (listened && watch.hasReplyCome())
        m_garbledReplies.push_back({std::nullopt, m_responsesById[m_ids.last].askedAt});
    return listened;
}

base::Result<void> RateScan::confirmLateReplies()
{
    const base::Duration timeout = atLeastBusPatience(m_context.bus, longTimeout);
    for (auto& [id, response] : m_responsesById) {
        // A late reply proves a servo; a clean one adds its present status and shows duplicates.
        const bool inconclusive = response.isMaybeEcho && response.replies == 0;
        for (int i = 0; (response.late || inconclusive) && i < (inconclusive ? 1 : confirmTries);
             ++i) {
            const int repliesBefore = response.replies;
            if (const auto pinged = ping(id, timeout); !pinged)
                return pinged;
            if (response.replies > repliesBefore)
                break;
        }
    }
    return {};
}

base::Result<void> RateScan::resolveGarbled()
{
    const bool isNoisyLine = m_garbledReplies.size() > maxGarbledResolved;
    if (isNoisyLine)
        m_garbledReplies.resize(maxGarbledResolved);
    m_hasUnexplainedGarbled = isNoisyLine;
    for (const GarbledReply& garbledReply : m_garbledReplies) {
        const auto explained = findSource(garbledReply);
        if (!explained)
            return tl::unexpected(explained.error());
        if (!*explained)
            m_hasUnexplainedGarbled = true;
    }
    // On such a line broken bytes prove no servo.
    for (auto& [id, response] : m_responsesById) {
        if (isNoisyLine && response.replies == 0)
            response.garbled = 0;
    }
    return {};
}

// Through a slow adapter the broken reply arrives while a later ID is being asked, so the IDs of
// the last moments are asked as well, the latest first.
base::Result<bool> RateScan::findSource(const GarbledReply& garbledReply)
{
    const bool few = m_garbledReplies.size() <= maxGarbledSearchedLong;
    const base::Duration window = few ? longLateWindow : lateWindow;
    const base::Duration timeout = few ? longLateWindow : longTimeout;
    bool isFound = false;
    for (const auto& [age, id] : candidates(garbledReply, window)) {
        // Requests that a busy computer sent in one go collide with the replies: their servos have
        // not heard them, and it takes no long wait to hear from these.
        if (isFound && age > lateWindow)
            break;
        const auto found =
            pingUntilKnown(id, id == garbledReply.id, isFound ? base::Duration{} : timeout);
        if (!found)
            return found;
        isFound = isFound || *found;
    }
    return isFound;
}

/// The IDs without a reply that were asked in the `window` before, with their age.
std::vector<std::pair<base::Duration, int>> RateScan::candidates(const GarbledReply& garbledReply,
                                                                 base::Duration window) const
{
    std::vector<std::pair<base::Duration, int>> candidates;
    for (const auto& [id, response] : m_responsesById) {
        const base::Duration age = garbledReply.at - response.askedAt;
        const bool shortlyBefore = age >= base::Duration{} && age <= window;
        if (id != garbledReply.id && shortlyBefore && response.replies == 0)
            candidates.emplace_back(age, id);
    }
    std::sort(candidates.begin(), candidates.end());
    if (garbledReply.id)
        candidates.insert(candidates.begin(), {base::Duration{}, *garbledReply.id});
    return candidates;
}

base::Result<bool> RateScan::pingUntilKnown(int id, bool persistent, base::Duration timeout)
{
    IdResponse& response = m_responsesById[id];
    for (int i = 0; response.replies == 0 && i < confirmTries; ++i) {
        const int garbledBefore = response.garbled;
        if (const auto pinged = ping(id, atLeastBusPatience(m_context.bus, timeout)); !pinged)
            return tl::unexpected(pinged.error());
        const bool silent = response.replies == 0 && response.garbled == garbledBefore;
        if (silent && !persistent)
            break;
    }
    return response.isPresent();
}

/// One lost reply must not make a known servo disappear.
base::Result<void> RateScan::pingExpected()
{
    for (const ExpectedServo& one : m_spec.expected) {
        const bool here = one.baud == m_context.bus.baud() &&
                          one.protocol.value_or(m_protocol) == m_protocol && m_ids.contains(one.id);
        if (!here || m_responsesById[one.id].isPresent())
            continue;
        if (const auto pinged = pingUntilKnown(one.id, true, longTimeout); !pinged)
            return tl::unexpected(pinged.error());
    }
    return {};
}

base::Result<void> RateScan::pingSilent()
{
    const base::Duration timeout = atLeastBusPatience(m_context.bus, longTimeout);
    const auto step = pingTime(m_scanProfile, m_context.bus.baud(), timeout);
    for (auto& [id, response] : m_responsesById) {
        if (!response.isPresent()) {
            if (const auto pinged = ping(id, timeout); !pinged)
                return pinged;
        }
        notify(step);
    }
    return {};
}

base::Result<bus::Outcome> RateScan::sendPing(int id, base::Duration timeout)
{
    if (m_context.stop.isRequested())
        return base::fail(base::ErrorCode::Stopped, QStringLiteral("scan"));
    return device::pingOnce(m_context, m_protocol, id, timeout);
}

base::Result<void> RateScan::ping(int id, base::Duration timeout)
{
    IdResponse& response = m_responsesById[id];
    ++response.pings;
    const auto outcome = sendPing(id, timeout);
    response.askedAt = m_context.bus.clock().now();
    if (outcome) {
        response.status = outcome->status();
        ++response.replies;
    } else if (outcome.error().code == base::ErrorCode::Refused) {
        ++response.replies; // a refusal proves the servo
    } else if (isGarbled(outcome.error().code)) {
        ++response.garbled;
    } else if (outcome.error().code == base::ErrorCode::LineBusy) {
        return handleBusyLine(response, outcome.error());
    } else if (outcome.error().code != base::ErrorCode::NoReply) {
        return tl::unexpected(outcome.error());
    }
    collectStrays();
    return {};
}

/// Between bursts of noise a servo may still answer; otherwise the bus does not even send the
/// request.
base::Result<void> RateScan::handleBusyLine(IdResponse& response, const base::Error& error)
{
    m_lineBusy = true;
    if (error.attempts == 0)
        return tl::unexpected(error);
    ++response.garbled;
    return {};
}

base::Result<void> RateScan::listen(base::Duration span)
{
    const auto done = m_context.bus.listen(span);
    collectStrays();
    notify(span);
    return done;
}

void RateScan::collectStrays()
{
    for (const bus::UnexpectedFrame& stray : m_context.bus.takeUnexpectedFrames()) {
        const auto pinged = m_responsesById.find(stray.id);
        if (pinged == m_responsesById.end() || !isPingReply(m_protocol, stray))
            continue; // not the reply to a request of this search
        IdResponse& response = pinged->second;
        if (looksLikeEcho(m_context.bus, m_protocol, stray)) {
            response.isMaybeEcho = true;
            continue;
        }
        response.status = stray.status;
        ++response.replies;
        if (response.replies == 1) {
            response.late = true;
            ++m_lateReplies;
        }
    }
}

void RateScan::notify(base::Duration planned) const
{
    const auto foundCount =
        std::count_if(m_responsesById.begin(), m_responsesById.end(),
                      [](const auto& entry) { return entry.second.isPresent(); });
    m_onPinged(planned, int(foundCount));
}
} // namespace jobs
