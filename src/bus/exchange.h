// SPDX-License-Identifier: GPL-3.0-or-later
// One request and what comes back for it, once: deadlines, classification of every frame, and the
// rule that the host never speaks into a running reply. Bus thread only. Errors are LinkLost,
// Stopped and Preempted; everything the servos do wrong is in the Attempt.
#pragma once

#include "bus/bus.h"
#include "bus/interrupt.h"
#include "bus/late_reply_guard.h"
#include "bus/line.h"
#include "bus/line_noise_meter.h"
#include "bus/unexpected_frame_list.h"
#include "protocol/codec.h"

#include <atomic>
#include <optional>

namespace bus {
/// A line that never falls silent is judged after this and the time of the longest frames.
constexpr base::Duration maxNoiseTime = std::chrono::milliseconds(20);
constexpr std::size_t maxNoiseBytes = 512;

struct ReceivedReply {
    protocol::Reply part;
    base::Duration at{}; ///< when its last byte had come
};

/// What the user is told when this was the trouble.
base::ErrorCode errorFor(FaultKind kind);

/// What sending a request once brought.
struct Attempt {
    std::vector<ReceivedReply> receivedReplies;
    std::vector<int> missing;       ///< asked, but not answered
    std::optional<FaultKind> fault; ///< the most telling trouble, if something is missing
    bool refused = false;           ///< not sent, because of the unrest on the line
    std::optional<int> foreignId;   ///< a reply that came meanwhile, from an ID that was not asked
    base::Duration sentAt{};
    base::Duration expectedAt{}; ///< when a prompt adapter would have shown the last reply
    base::Duration endedAt{};
};

class Exchange {
public:
    Exchange(Line& line, const protocol::Codec& probeCodec, base::Clock& clock,
             LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics, TraceRing& trace,
             UnexpectedFrameList& strays);

    /// `frame` is the encoded request. `patience` 0: adaptive.
    base::Result<Attempt> run(const protocol::Request& request, base::ByteView frame,
                              base::Duration timeout, base::Duration replyDelay,
                              const Interrupt& interrupt);

    /// Only listens; frames become strays. At least looks once.
    base::Result<void> listenUntil(base::Duration instant, const Interrupt& interrupt);

    /// Waits for the end of a reply that is still running; not for ever where bytes never end.
    base::Result<void> awaitSilence(const Interrupt& interrupt);

    /// Sends ready-made frames with room for the replies nobody waits for. Begins at the computed
    /// end of the reply that is running, at 115200 and above 30 ms after the call at the latest, at
    /// slower rates when the longest frame would have ended, however much comes.
    base::Result<void> sendStopFrames(const std::vector<StopFrame>& frames,
                                      base::Duration replyDelay);

    void setSilence(base::Duration silence) { m_silence.store(silence.count()); }

    /// Finds out whether the adapter returns what is sent, and how late.
    base::Result<bool> probeEcho(const Interrupt& interrupt);

private:
    struct Wait;
    template <typename Predicate>
    base::Result<void> receiveUntil(const Wait& wait, const Interrupt& interrupt,
                                    Predicate&& isFinished);
    base::Result<void> receiveReplies(Wait& wait, const Interrupt& interrupt);
    base::Result<void> receiveRaw(Wait& wait, const Interrupt& interrupt);
    void countTimeout(const Wait& wait, int id);
    void countSent(const protocol::Request& request, const protocol::Expectation& expected);
    base::Result<Attempt> sendFailed(Wait& wait, const Interrupt& interrupt);
    enum class LineState : std::uint8_t {
        None,
        Noisy,      ///< bytes never end, but a reply could be told from them by its checksum
        Unreadable, ///< they fill the line, or are frames: no reply could be told
    };
    LineState lineState() const;
    base::Duration tolerance() const;
    bool isOverloaded() const;
    void countUnsolicited(std::size_t bytes, bool frame);
    base::Result<Attempt> receiveAttempt(const protocol::Request& request, Wait& wait,
                                         LineState before, const Interrupt& interrupt);
    base::Result<Attempt> refused(Wait& wait, const Interrupt& interrupt);
    void parseBuffer(Wait& wait, bool atDeadline);
    void parseUnexpected(bool atDeadline);
    void handleReply(Wait& wait, protocol::Reply part);
    void handleForeign(Wait& wait, protocol::Reply part, base::ByteView frame);
    void handleBadChecksum(Wait& wait, int id);
    void giveUp(Wait& wait, bool interrupted);
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
    const protocol::Codec* m_codec; ///< of the latest request, which names what strays in
    base::Protocol m_protocol = base::Protocol::Feetech; ///< the same
    base::Clock& m_clock;
    LateReplyGuard& m_lateReplyGuard;
    StatisticsCollector& m_statistics;
    TraceRing& m_trace;
    UnexpectedFrameList& m_unexpectedFrames;
    std::atomic<base::Duration::rep> m_silence{-1}; ///< replaces the protocols' own
    base::Duration m_repliesUntil{}; ///< when the wire is free of the replies asked for
    bool m_awaitingSilence = true;   ///< the last exchange did not end with its reply's last byte
    LineNoiseMeter m_lineNoise;
    bool m_lineBusy = false; ///< the last wait for silence ended without any
};
} // namespace bus
