// SPDX-License-Identifier: GPL-3.0-or-later
// What an Exchange does besides asking: listening, silence, stop frames, the echo probe.
#include "bus/exchange.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Result;
using namespace std::chrono_literals;

namespace {
constexpr int maxProbes = 3;
constexpr std::size_t maxProbeReply = 4096;
constexpr int maxSilentProbes = 2; ///< the first transaction after opening may be lost

/// Where it has not fallen silent before, or more comes than a line could carry.
constexpr Duration shortWait = 5ms;
/// With less of the time taken by bytes the line has pauses.
constexpr double minLoad = 0.05;

/// Room for the shortest reply after a stop frame, and for a servo that is slow to begin.
constexpr std::size_t minReplySize = 6;
constexpr Duration stopFrameMargin = 500us;
constexpr int maxModbusRate = 256'000;

/// From this rate on nothing that was asked for keeps stop frames waiting for longer than this. A
/// slower wire is busy for as long as the replies that were asked for, and the longest frame, take:
/// a frame that falls into a reply is lost.
constexpr int promptRate = 115'200;
constexpr Duration maxStopDelay = 30ms;
} // namespace

Result<void> Exchange::listenUntil(Duration instant, const Interrupt& interrupt)
{
    Duration now = m_clock.now();
    do {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const auto hasData = m_line.receive(std::clamp(instant - now, Duration{}, waitSlice));
        if (!hasData)
            return tl::unexpected(hasData.error());
        if (*hasData)
            m_scanner.scanUnexpected(false);
        now = m_clock.now();
    } while (now < instant);
    return {};
}

Result<void> Exchange::awaitSilence(const Interrupt& interrupt)
{
    const Duration start = m_clock.now();
    const Duration limit = start + (m_lineBusy ? shortWait : m_scanner.noiseTolerance());
    Duration span{};
    Duration carried{}; // by the line, meanwhile
    for (;;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const std::size_t before = m_line.received();
        const auto hasData = m_line.receive(span);
        if (!hasData)
            return tl::unexpected(hasData.error());
        if (*hasData) {
            // Less where an echo was taken off that had begun before.
            carried += m_line.wireTime(std::max(m_line.received(), before) - before);
            m_scanner.scanUnexpected(false);
            m_awaitingSilence = true;
        }
        const Duration now = m_clock.now();
        const Duration quietFrom = m_line.lastByteAt() + m_line.silence();
        const Duration timeout = m_scanner.isOverloaded() ? start + shortWait : limit;
        const Duration silentAt = std::min({quietFrom, limit, timeout});
        const bool frameOpen = !m_line.pending().empty();
        if ((!m_awaitingSilence && !frameOpen) || now >= silentAt) {
            // A busy computer does not see the pauses between single bytes.
            m_lineBusy = m_awaitingSilence && now < quietFrom && carried >= minLoad * (now - start);
            break;
        }
        span = std::min(silentAt - now, waitSlice);
    }
    m_scanner.scanUnexpected(true);
    m_awaitingSilence = false;
    return {};
}

Result<void> Exchange::sendStopFrames(const std::vector<StopFrame>& frames, Duration replyDelay)
{
    // A Modbus station takes only what stands between silences; above its fastest rate there is
    // none.
    const protocol::Codec& modbus = protocol::modbusCodec();
    Duration gap{};
    // A longer one that was chosen would add up to seconds on a line with many servos.
    if (m_line.baud() <= maxModbusRate)
        gap = std::min(frameGap(modbus), modbus.silence(m_line.baud()));
    // A frame that falls into a running reply is lost, but stopping must not wait for long either.
    const Duration now = m_clock.now();
    const Duration limit =
        now + maxStopDelay +
        (m_line.baud() >= promptRate
             ? Duration{}
             : std::max(m_repliesUntil - now, Duration{}) + m_line.wireTime(maxNoiseBytes));
    const Duration busyUntil = std::max(m_line.lastByteAt(), m_line.freeAt());
    Duration clearAt = std::max(m_repliesUntil, busyUntil + gap);
    while (m_clock.now() < std::min(clearAt, limit)) {
        const auto listened = listenUntil(std::min(clearAt, limit), {});
        if (!listened)
            return listened;
        clearAt = std::max(clearAt, m_line.lastByteAt() + std::max(m_line.silence(), gap));
    }
    const int rounds = clearAt > limit ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
        for (const StopFrame& frame : frames) {
            m_scanner.setProtocol(frame.protocol);
            if (const auto sent = m_line.send(frame.bytes); !sent)
                return tl::unexpected(sent.error());
            const Duration replyTime =
                replyDelay + m_line.wireTime(minReplySize) + std::max(stopFrameMargin, gap);
            if (const auto listened = listenUntil(m_line.freeAt() + replyTime, {}); !listened)
                return listened;
            if (const auto listened = listenUntil(m_line.lastByteAt() + gap, {}); !listened)
                return listened;
        }
    }
    m_lateReplyGuard.quietAll(m_clock.now());
    m_awaitingSilence = true;
    return {};
}

Duration Exchange::frameGap(const protocol::Codec& codec) const
{
    const Duration::rep configured = m_silence.load(std::memory_order_relaxed);
    const Duration codecSilence = codec.silence(m_line.baud());
    return codecSilence > 0us && configured >= 0 ? Duration(configured) : codecSilence;
}

/// Some protocols know where a frame begins by the silence before it, and where it ends by the one
/// after: a request without a reply needs it too when another protocol follows.
Result<void> Exchange::awaitFrameGap(const protocol::Codec& next, const Interrupt& interrupt)
{
    const auto silentFrom = [&] {
        const Duration before = std::max(m_line.lastByteAt(), m_line.freeAt()) + frameGap(next);
        return std::max(before, m_line.freeAt() + frameGap(m_scanner.codec()));
    };
    Duration from = silentFrom();
    const Duration limit = from + m_scanner.noiseTolerance();
    while (m_clock.now() < from) {
        const Duration last = m_line.lastByteAt();
        if (const auto listened = listenUntil(from, interrupt); !listened)
            return listened;
        if (m_line.lastByteAt() == last)
            break;
        m_awaitingSilence = true;
        if (const auto quiet = awaitSilence(interrupt); !quiet)
            return quiet;
        from = std::min(silentFrom(), limit);
    }
    return {};
}

Result<bool> Exchange::probeEcho(const Interrupt& interrupt)
{
    m_trace.setProtocol(m_scanner.codec().echoProbe().protocol);
    const auto probe = m_scanner.codec().encode(m_scanner.codec().echoProbe());
    if (!probe)
        return tl::unexpected(probe.error());
    EchoProbe state{*probe};
    int silent = 0;
    while (state.sent < maxProbes && silent < maxSilentProbes) {
        if (const auto quiet = awaitSilence(interrupt); !quiet)
            return tl::unexpected(quiet.error());
        if (const auto sent = m_line.send(*probe); !sent)
            return tl::unexpected(sent.error());
        m_awaitingSilence = true;
        state.lastExpectedAt = m_line.freeAt();
        state.firstExpectedAt = state.sent++ == 0 ? state.lastExpectedAt : state.firstExpectedAt;
        const auto echoed =
            awaitEcho(state, state.lastExpectedAt + m_lateReplyGuard.timeout(), interrupt);
        if (!echoed)
            return echoed;
        if (*echoed)
            return collectEchoes(state, interrupt);
        silent += m_line.received() > 0 ? 0 : 1;
    }
    // Nothing has shown yet how late this adapter is. Where bytes fill the line they would show.
    const Duration limit = state.lastExpectedAt + m_lateReplyGuard.maxReplyLateness();
    const auto echoed =
        m_scanner.isOverloaded() ? Result<bool>(false) : awaitEcho(state, limit, interrupt);
    return echoed && *echoed ? collectEchoes(state, interrupt) : echoed;
}

/// True as soon as the probe has come back.
Result<bool> Exchange::awaitEcho(EchoProbe& state, Duration deadline, const Interrupt& interrupt)
{
    for (;;) {
        const base::ByteView pending = m_line.pending();
        const auto found =
            std::search(pending.begin(), pending.end(), state.probe.begin(), state.probe.end());
        if (found != pending.end()) {
            const auto size = std::size_t(found - pending.begin()) + state.probe.size();
            m_trace.add(m_line.lastByteAt(), TraceKind::Echo, pending.first(size));
            m_line.consume(size);
            ++state.echoed;
            state.echoedAt = m_line.lastByteAt();
            return true;
        }
        if (pending.size() > maxProbeReply)
            m_line.keepLatest(state.probe.size());
        const Duration now = m_clock.now();
        if (now >= deadline)
            return false;
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const std::size_t before = m_line.received();
        const auto hasData = m_line.receive(std::min(deadline - now, waitSlice));
        if (!hasData)
            return hasData;
        if (*hasData)
            m_scanner.countUnsolicited(m_line.received() - before, false);
    }
}

/// The echoes of the other probes must not run into what is said next, and they show how late this
/// adapter is.
Result<bool> Exchange::collectEchoes(EchoProbe& state, const Interrupt& interrupt)
{
    const Duration limit =
        m_clock.now() + (state.lastExpectedAt - state.firstExpectedAt) + waitSlice;
    bool more = true;
    while (more && state.echoed < state.sent) {
        const auto echoed = awaitEcho(state, limit, interrupt);
        if (!echoed)
            return echoed;
        more = *echoed;
    }
    // Where one was lost, it is not known which one this is the echo of.
    const bool all = state.echoed == state.sent;
    m_lateReplyGuard.learn(state.echoedAt - (all ? state.lastExpectedAt : state.firstExpectedAt));
    return true;
}
} // namespace bus
