// SPDX-License-Identifier: GPL-3.0-or-later
// What an Exchange does besides asking: listening, silence, stop frames, the echo probe.
#include "bus/exchange.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Result;
using namespace std::chrono_literals;

namespace {
constexpr int probeTries = 3;
constexpr std::size_t maxProbeReply = 4096;
constexpr int silentTries = 2; ///< the first transaction after opening may be lost

/// Where it has not fallen silent before, or more comes than a line could carry.
constexpr Duration shortWait = 5ms;

/// Room for the shortest reply after a stop frame, and for a servo that is slow to begin.
constexpr std::size_t shortestReply = 6;
constexpr Duration stopFrameMargin = 500us;
constexpr int fastestModbus = 256'000;

/// From this rate on nothing that was asked for keeps stop frames waiting for longer than this. A
/// slower wire is busy for as long as the replies that were asked for, and the longest frame, take:
/// a frame that falls into a reply is lost.
constexpr int promptRate = 115'200;
constexpr Duration mostStopDelay = 30ms;
} // namespace

Result<void> Exchange::listenUntil(Duration instant, const Interrupt& interrupt)
{
    Duration now = m_clock.now();
    do {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const auto came = m_line.receive(std::clamp(instant - now, Duration{}, waitSlice));
        if (!came)
            return tl::unexpected(came.error());
        if (*came)
            digestStrays(false);
        now = m_clock.now();
    } while (now < instant);
    return {};
}

Result<void> Exchange::awaitSilence(const Interrupt& interrupt)
{
    const Duration start = m_clock.now();
    const Duration limit = start + (m_neverSilent ? shortWait : tolerance());
    Duration span{};
    for (;;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const auto came = m_line.receive(span);
        if (!came)
            return tl::unexpected(came.error());
        if (*came) {
            digestStrays(false);
            m_unsettled = true;
        }
        const Duration now = m_clock.now();
        const Duration quietFrom = m_line.lastByteAt() + m_line.silence();
        const Duration patience = overloaded() ? start + shortWait : limit;
        const Duration silentAt = std::min({quietFrom, limit, patience});
        const bool frameOpen = !m_line.pending().empty();
        if ((!m_unsettled && !frameOpen) || now >= silentAt) {
            m_neverSilent = m_unsettled && now < quietFrom;
            break;
        }
        span = std::min(silentAt - now, waitSlice);
    }
    digestStrays(true);
    m_unsettled = false;
    return {};
}

Result<void> Exchange::sendStopFrames(const std::vector<StopFrame>& frames, Duration replyDelay)
{
    // A Modbus station takes only what stands between silences; above its fastest rate there is
    // none.
    const protocol::Codec& modbus = protocol::modbusCodec();
    Duration gap{};
    // A longer one that was chosen would add up to seconds on a line with many servos.
    if (m_line.baud() <= fastestModbus)
        gap = std::min(silenceOf(modbus), modbus.silence(m_line.baud()));
    // A frame that falls into a running reply is lost, but stopping must not wait for long either.
    const Duration now = m_clock.now();
    const Duration limit =
        now + mostStopDelay +
        (m_line.baud() >= promptRate
             ? Duration{}
             : std::max(m_repliesUntil - now, Duration{}) + m_line.wireTime(maxNoiseBytes));
    const Duration spokenUntil = std::max(m_line.lastByteAt(), m_line.freeAt());
    Duration clearAt = std::max(m_repliesUntil, spokenUntil + gap);
    while (m_clock.now() < std::min(clearAt, limit)) {
        const auto heard = listenUntil(std::min(clearAt, limit), {});
        if (!heard)
            return heard;
        clearAt = std::max(clearAt, m_line.lastByteAt() + std::max(m_line.silence(), gap));
    }
    const int rounds = clearAt > limit ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
        for (const StopFrame& frame : frames) {
            m_codec = &protocol::codecFor(frame.protocol);
            m_trace.speak(frame.protocol);
            if (const auto sent = m_line.send(frame.bytes); !sent)
                return tl::unexpected(sent.error());
            const Duration room =
                replyDelay + m_line.wireTime(shortestReply) + std::max(stopFrameMargin, gap);
            if (const auto heard = listenUntil(m_line.freeAt() + room, {}); !heard)
                return heard;
            if (const auto heard = listenUntil(m_line.lastByteAt() + gap, {}); !heard)
                return heard;
        }
    }
    m_guard.quietAll(m_clock.now());
    m_unsettled = true;
    return {};
}

Duration Exchange::silenceOf(const protocol::Codec& codec) const
{
    const Duration::rep chosen = m_silence.load(std::memory_order_relaxed);
    const Duration own = codec.silence(m_line.baud());
    return own > 0us && chosen >= 0 ? Duration(chosen) : own;
}

/// Some protocols know where a frame begins by the silence before it, and where it ends by the one
/// after: a request that nobody answers needs it too when another language follows.
Result<void> Exchange::keepSilence(const protocol::Codec& next, const Interrupt& interrupt)
{
    const auto silentFrom = [&] {
        const Duration before = std::max(m_line.lastByteAt(), m_line.freeAt()) + silenceOf(next);
        return std::max(before, m_line.freeAt() + silenceOf(*m_codec));
    };
    Duration from = silentFrom();
    const Duration limit = from + tolerance();
    while (m_clock.now() < from) {
        const Duration last = m_line.lastByteAt();
        if (const auto heard = listenUntil(from, interrupt); !heard)
            return heard;
        if (m_line.lastByteAt() == last)
            break;
        m_unsettled = true;
        if (const auto quiet = awaitSilence(interrupt); !quiet)
            return quiet;
        from = std::min(silentFrom(), limit);
    }
    return {};
}

Result<bool> Exchange::probeEcho(const Interrupt& interrupt)
{
    m_trace.speak(m_codec->echoProbe().protocol);
    const auto probe = m_codec->encode(m_codec->echoProbe());
    if (!probe)
        return tl::unexpected(probe.error());
    EchoProbe state{*probe};
    int silent = 0;
    while (state.sent < probeTries && silent < silentTries) {
        if (const auto quiet = awaitSilence(interrupt); !quiet)
            return tl::unexpected(quiet.error());
        if (const auto sent = m_line.send(*probe); !sent)
            return tl::unexpected(sent.error());
        m_unsettled = true;
        state.lastOnTime = m_line.freeAt();
        state.firstOnTime = state.sent++ == 0 ? state.lastOnTime : state.firstOnTime;
        const auto echoed = awaitEcho(state, state.lastOnTime + m_guard.patience(), interrupt);
        if (!echoed)
            return echoed;
        if (*echoed)
            return takeEchoes(state, interrupt);
        silent += m_line.received() > 0 ? 0 : 1;
    }
    // Nothing has shown yet how late this adapter is. Where bytes fill the line they would show.
    const Duration limit = state.lastOnTime + m_guard.replyTimeout();
    const auto echoed = overloaded() ? Result<bool>(false) : awaitEcho(state, limit, interrupt);
    return echoed && *echoed ? takeEchoes(state, interrupt) : echoed;
}

/// True as soon as the probe has come back.
Result<bool> Exchange::awaitEcho(EchoProbe& state, Duration deadline, const Interrupt& interrupt)
{
    for (;;) {
        const base::ByteView seen = m_line.pending();
        const auto found =
            std::search(seen.begin(), seen.end(), state.probe.begin(), state.probe.end());
        if (found != seen.end()) {
            const auto size = std::size_t(found - seen.begin()) + state.probe.size();
            m_trace.add(m_line.lastByteAt(), TraceKind::Echo, seen.first(size));
            m_line.consume(size);
            ++state.echoed;
            state.echoedAt = m_line.lastByteAt();
            return true;
        }
        if (seen.size() > maxProbeReply)
            m_line.consumeAllBut(state.probe.size());
        const Duration now = m_clock.now();
        if (now >= deadline)
            return false;
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const std::size_t before = m_line.received();
        const auto came = m_line.receive(std::min(deadline - now, waitSlice));
        if (!came)
            return came;
        if (*came)
            unasked(m_line.received() - before, false);
    }
}

/// The echoes of the other probes must not run into what is said next, and they show how late this
/// adapter is.
Result<bool> Exchange::takeEchoes(EchoProbe& state, const Interrupt& interrupt)
{
    const Duration limit = m_clock.now() + (state.lastOnTime - state.firstOnTime) + waitSlice;
    bool more = true;
    while (more && state.echoed < state.sent) {
        const auto echoed = awaitEcho(state, limit, interrupt);
        if (!echoed)
            return echoed;
        more = *echoed;
    }
    // Where one was lost, it is not known which one this is the echo of.
    const bool all = state.echoed == state.sent;
    m_guard.learn(state.echoedAt - (all ? state.lastOnTime : state.firstOnTime));
    return true;
}
} // namespace bus
