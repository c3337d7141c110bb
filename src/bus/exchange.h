// SPDX-License-Identifier: GPL-3.0-or-later
// Sends one request once and waits for its replies: deadlines, and the rule that the host never
// sends into a running reply. Bus thread only. Errors are LinkLost, Stopped and Preempted; faults
// of the servos are in the Attempt.
#pragma once

#include "bus/interrupt.h"
#include "bus/reply_scanner.h"

#include <atomic>

namespace bus {
class Exchange {
public:
    Exchange(Line& line, const protocol::Codec& probeCodec, base::Clock& clock,
             LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics, TraceRing& trace,
             UnexpectedFrameList& unexpectedFrames);

    /// `frame` is the encoded request. `timeout` 0: adaptive.
    base::Result<Attempt> run(const protocol::Request& request, base::ByteView frame,
                              base::Duration timeout, base::Duration replyDelay,
                              const Interrupt& interrupt);

    /// Only listens: frames count as unexpected. Reads at least once.
    base::Result<void> listenUntil(base::Duration instant, const Interrupt& interrupt);

    /// Waits for the end of a reply that is still running, for a limited time where bytes never
    /// end.
    base::Result<void> awaitSilence(const Interrupt& interrupt);

    /// Sends ready-made frames with room for their replies, which are not awaited. Begins at the
    /// computed end of the reply that is running: at 115200 and above not later than 30 ms after
    /// the call, at slower rates not later than the end of the longest frame, whatever is received.
    base::Result<void> sendStopFrames(const std::vector<StopFrame>& frames,
                                      base::Duration replyDelay);

    void setSilence(base::Duration silence) { m_silence.store(silence.count()); }

    /// Finds out whether the adapter returns what is sent, and how late.
    base::Result<bool> probeEcho(const Interrupt& interrupt);

private:
    template <typename Predicate>
    base::Result<void> receiveUntil(const PendingRequest& pending, const Interrupt& interrupt,
                                    Predicate&& isFinished);
    base::Result<void> receiveReplies(PendingRequest& pending, const Interrupt& interrupt);
    base::Result<void> receiveRaw(const protocol::Request& request, PendingRequest& pending,
                                  const Interrupt& interrupt);
    base::Result<Attempt> sendFailed(PendingRequest& pending, const Interrupt& interrupt);
    enum class LineState : std::uint8_t {
        None,
        Noisy,      ///< bytes never end, but a reply can be recognized by its checksum
        Unreadable, ///< they fill the line, or are frames: no reply can be recognized
    };
    LineState lineState() const;
    base::Result<Attempt> receiveAttempt(const protocol::Request& request, PendingRequest& pending,
                                         LineState before, const Interrupt& interrupt);
    base::Result<Attempt> refused(PendingRequest& pending, const Interrupt& interrupt);
    base::Duration frameGap(const protocol::Codec& codec) const;
    base::Result<void> awaitFrameGap(const protocol::Codec& next, const Interrupt& interrupt);
    struct EchoProbe {
        base::Bytes probe;
        int sent = 0;
        int echoed = 0;
        base::Duration echoedAt{}; ///< the latest one
        base::Duration
            firstExpectedAt{}; ///< when a prompt adapter would have returned the first one
        base::Duration lastExpectedAt{};
    };
    base::Result<bool> awaitEcho(EchoProbe& state, base::Duration deadline,
                                 const Interrupt& interrupt);
    base::Result<bool> collectEchoes(EchoProbe& state, const Interrupt& interrupt);

    Line& m_line;
    base::Clock& m_clock;
    LateReplyGuard& m_lateReplyGuard;
    TraceRing& m_trace;
    ReplyScanner m_scanner;
    std::atomic<base::Duration::rep> m_silence{-1}; ///< replaces the protocols' own
    base::Duration m_repliesUntil{}; ///< when the wire is free of the replies asked for
    bool m_awaitingSilence = true;   ///< the last exchange did not end with its reply's last byte
    bool m_lineBusy = false;         ///< the last wait for silence ended without any
};
} // namespace bus
