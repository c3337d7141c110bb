// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan_sweep.h"

#include "device/talk.h"

#include <algorithm>

namespace jobs {
namespace {
using std::chrono::milliseconds;

// USB adapters hold bytes back for up to 16 ms; some servos take tens of milliseconds when busy.
constexpr base::Duration longPatience = milliseconds(60);
// How long after a PING its reply may still come in: the final listening, and the search for
// whoever sent garbled bytes.
constexpr base::Duration lateWindow = milliseconds(40);
constexpr int confirmTries = 3;
// The first transaction after opening a port or changing its rate may be lost.
constexpr int questionTries = 2;
// Where an absent ID costs more than this, a sweep is long, and who answers is told at once.
constexpr base::Duration slowStep = milliseconds(10);
// After a question to all that nobody answered the bus listens for so long.
constexpr base::Duration quietTime = milliseconds(25);
// More broken answers than this at one rate are a bad line, and asking each again would take long.
constexpr std::size_t maxGarblesExplained = 16;

/// What this link has shown and the user's time-out may ask for more.
base::Duration patient(const bus::Bus& bus, base::Duration usual)
{
    return std::max(usual, bus.statistics().patience);
}

bool unreadable(base::ErrorCode code)
{
    return code == base::ErrorCode::Garbled || code == base::ErrorCode::WrongAnswer;
}
} // namespace

base::Duration questionEstimate(int baud, base::Protocol protocol)
{
    const Manner& manner = mannerOf(protocol);
    if (!manner.asksAll)
        return {};
    return questionTries * (askTime(manner, baud, manner.patience) + quietTime);
}

base::Duration sweepEstimate(const ScanSpec& spec, int baud, base::Protocol protocol)
{
    const Manner& manner = mannerOf(protocol);
    const int ids = idsToAsk(spec, protocol).count();
    if (ids == 0)
        return {};
    base::Duration total = (ids + 1) * askTime(manner, baud, manner.patience) + lateWindow;
    if (spec.slowPass)
        total += ids * askTime(manner, baud, longPatience);
    return total;
}

RateSweep::RateSweep(const device::Context& context, const ScanSpec& spec, base::Protocol protocol,
                     OnAsked onAsked, OnAnswer onAnswer)
    : m_context(context)
    , m_spec(spec)
    , m_protocol(protocol)
    , m_manner(mannerOf(protocol))
    , m_ids(idsToAsk(spec, protocol))
    , m_onAsked(std::move(onAsked))
    , m_onAnswer(std::move(onAnswer))
{}

base::Result<std::optional<int>> RateSweep::askAll()
{
    std::optional<int> alone;
    const int tries = m_manner.asksAll && m_ids.count() > 0 ? questionTries : 0;
    for (int i = 0; !m_heardSomebody && i < tries; ++i) {
        const auto outcome = question(protocol::broadcastId, m_manner.patience);
        tell(questionEstimate(m_context.bus.baud(), m_protocol) / questionTries);
        if (outcome) {
            m_heardSomebody = true;
            alone = outcome->parts.front().id;
        } else if (unreadable(outcome.error().code) ||
                   outcome.error().code == base::ErrorCode::LineBusy) {
            m_heardSomebody = true; // the search itself decides about a busy line
        } else if (outcome.error().code != base::ErrorCode::NoAnswer) {
            return tl::unexpected(outcome.error());
        }
    }
    if (!alone || !m_ids.contains(*alone))
        return std::nullopt;
    // Out of colliding answers may come a frame that nobody sent.
    if (const auto asked = ask(*alone, patient(m_context.bus, longPatience)); !asked)
        return tl::unexpected(asked.error());
    return m_contacts[*alone].replies > 0 ? alone : std::nullopt;
}

base::Result<void> RateSweep::run()
{
    if (m_ids.count() == 0)
        return {};
    m_context.bus.takeStrays();
    return askEach()
        .and_then([this] { return listen(patient(m_context.bus, lateWindow)); })
        .and_then([this] { return confirmLate(); })
        .and_then([this] { return explainGarbles(); })
        .and_then([this] { return askExpected(); })
        .and_then([this] { return m_spec.slowPass ? askSilent() : base::Result<void>{}; });
}

base::Result<void> RateSweep::askEach()
{
    const auto step = askTime(m_manner, m_context.bus.baud(), m_manner.patience);
    const bool tellsAtOnce = m_onAnswer && step >= slowStep;
    // The first transaction after opening a port or changing its rate may be lost, so somebody is
    // asked who gets another turn.
    for (int i = m_ids.first - 1; i <= m_ids.last; ++i) {
        const int id = i < m_ids.first ? m_ids.last : i;
        const Contact before = m_contacts[id];
        if (const auto asked = ask(id, m_manner.patience); !asked)
            return asked;
        if (m_contacts[id].garbled > before.garbled)
            m_garbles.push_back({id, m_contacts[id].askedAt});
        tell(step);
        const bool answered = m_contacts[id].replies > before.replies && !m_contacts[id].late;
        const auto told = tellsAtOnce && answered ? m_onAnswer(*this, id) : base::Result<void>{};
        if (!told)
            return told;
    }
    return {};
}

base::Result<void> RateSweep::confirmLate()
{
    const base::Duration patience = patient(m_context.bus, longPatience);
    for (auto& [id, contact] : m_contacts) {
        // A late reply is proof of a servo; a clean one adds its present status and shows twins.
        const bool doubtful = contact.maybeEcho && contact.replies == 0;
        for (int i = 0; (contact.late || doubtful) && i < (doubtful ? 1 : confirmTries); ++i) {
            const int repliesBefore = contact.replies;
            if (const auto asked = ask(id, patience); !asked)
                return asked;
            if (contact.replies > repliesBefore)
                break;
        }
    }
    return {};
}

base::Result<void> RateSweep::explainGarbles()
{
    const bool noisyLine = m_garbles.size() > maxGarblesExplained;
    if (noisyLine)
        m_garbles.resize(maxGarblesExplained);
    m_garbledUnexplained = noisyLine;
    for (const Garble& garble : m_garbles) {
        const auto explained = findSource(garble);
        if (!explained)
            return tl::unexpected(explained.error());
        if (!*explained)
            m_garbledUnexplained = true;
    }
    // On such a line broken bytes prove nobody.
    for (auto& [id, contact] : m_contacts) {
        if (noisyLine && contact.replies == 0)
            contact.garbled = 0;
    }
    return {};
}

// Through a slow adapter the broken answer arrives while a later ID is being asked, so the IDs
// asked shortly before are asked too, nearest first.
base::Result<bool> RateSweep::findSource(const Garble& garble)
{
    std::vector<std::pair<base::Duration, int>> candidates;
    for (const auto& [id, contact] : m_contacts) {
        const base::Duration age = garble.at - contact.askedAt;
        const bool shortlyBefore = age >= base::Duration{} && age <= lateWindow;
        if (id != garble.id && shortlyBefore && contact.replies == 0)
            candidates.emplace_back(age, id);
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.insert(candidates.begin(), {base::Duration{}, garble.id});
    for (const auto& [age, id] : candidates) {
        const auto found = askUntilKnown(id, id == garble.id);
        if (!found || *found)
            return found;
    }
    return false;
}

base::Result<bool> RateSweep::askUntilKnown(int id, bool persistent)
{
    Contact& contact = m_contacts[id];
    for (int i = 0; contact.replies == 0 && i < confirmTries; ++i) {
        const int garbledBefore = contact.garbled;
        if (const auto asked = ask(id, patient(m_context.bus, longPatience)); !asked)
            return tl::unexpected(asked.error());
        const bool silent = contact.replies == 0 && contact.garbled == garbledBefore;
        if (silent && !persistent)
            break;
    }
    return contact.present();
}

/// One lost reply must not make a known servo disappear.
base::Result<void> RateSweep::askExpected()
{
    for (const ExpectedServo& one : m_spec.expected) {
        const bool here = one.baud == m_context.bus.baud() &&
                          one.protocol.value_or(m_protocol) == m_protocol && m_ids.contains(one.id);
        if (!here || m_contacts[one.id].present())
            continue;
        if (const auto asked = askUntilKnown(one.id, true); !asked)
            return tl::unexpected(asked.error());
    }
    return {};
}

base::Result<void> RateSweep::askSilent()
{
    const base::Duration patience = patient(m_context.bus, longPatience);
    const auto step = askTime(m_manner, m_context.bus.baud(), patience);
    for (auto& [id, contact] : m_contacts) {
        if (!contact.present()) {
            if (const auto asked = ask(id, patience); !asked)
                return asked;
        }
        tell(step);
    }
    return {};
}

base::Result<bus::Outcome> RateSweep::question(int id, base::Duration patience)
{
    if (m_context.stop.requested())
        return base::fail(base::ErrorCode::Stopped, QStringLiteral("scan"));
    return device::pingOnce(m_context, m_protocol, id, patience);
}

base::Result<void> RateSweep::ask(int id, base::Duration patience)
{
    Contact& contact = m_contacts[id];
    ++contact.pings;
    const auto outcome = question(id, patience);
    contact.askedAt = m_context.bus.clock().now();
    if (outcome) {
        contact.status = outcome->status();
        ++contact.replies;
    } else if (outcome.error().code == base::ErrorCode::Refused) {
        ++contact.replies; // who refuses is there
    } else if (unreadable(outcome.error().code)) {
        ++contact.garbled;
    } else if (outcome.error().code == base::ErrorCode::LineBusy) {
        return noteBusy(contact, outcome.error());
    } else if (outcome.error().code != base::ErrorCode::NoAnswer) {
        return tl::unexpected(outcome.error());
    }
    collectStrays();
    return {};
}

/// Through noise that leaves room a servo may still be heard; otherwise the bus does not even ask.
base::Result<void> RateSweep::noteBusy(Contact& contact, const base::Error& error)
{
    m_lineBusy = true;
    if (error.attempts == 0)
        return tl::unexpected(error);
    ++contact.garbled;
    return {};
}

base::Result<void> RateSweep::listen(base::Duration span)
{
    const auto done = m_context.bus.listen(span);
    collectStrays();
    tell(span);
    return done;
}

void RateSweep::collectStrays()
{
    for (const bus::Stray& stray : m_context.bus.takeStrays()) {
        const auto asked = m_contacts.find(stray.id);
        if (asked == m_contacts.end() || !answersQuestion(m_protocol, stray))
            continue; // not the reply to a question of this sweep
        Contact& contact = asked->second;
        if (readsLikeEcho(m_context.bus, m_protocol, stray)) {
            contact.maybeEcho = true;
            continue;
        }
        contact.status = stray.status;
        ++contact.replies;
        if (contact.replies == 1) {
            contact.late = true;
            ++m_lateReplies;
        }
    }
}

void RateSweep::tell(base::Duration planned) const
{
    const auto heard = std::count_if(m_contacts.begin(), m_contacts.end(),
                                     [](const auto& entry) { return entry.second.present(); });
    m_onAsked(planned, int(heard));
}
} // namespace jobs
