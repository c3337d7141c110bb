// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the received bytes with the codec of the latest request: assigns each frame to that
// request, to an earlier one or to none, and keeps the statistics, the trace and the measure of
// unrest on the line. Waits for nothing. Part of an Exchange; bus thread only.
#pragma once

#include "bus/bus.h"
#include "bus/late_reply_guard.h"
#include "bus/line.h"
#include "bus/line_noise_meter.h"
#include "bus/unexpected_frame_list.h"
#include "protocol/codec.h"

#include <algorithm>
#include <optional>

namespace bus {
/// A line that never falls silent is judged after this and the time of the longest frames.
constexpr base::Duration maxNoiseTime = std::chrono::milliseconds(20);
constexpr std::size_t maxNoiseBytes = 512;

struct ReceivedReply {
    protocol::Reply part;
    base::Duration at{}; ///< when its last byte had come
};

/// The error that is reported for a fault.
base::ErrorCode errorFor(FaultKind kind);

/// What sending a request once brought.
struct Attempt {
    std::vector<ReceivedReply> receivedReplies;
    std::vector<int> missing;       ///< asked, but not answered
    std::optional<FaultKind> fault; ///< the most telling one, if something is missing
    bool refused = false;           ///< not sent, because of the unrest on the line
    std::optional<int> foreignId;   ///< of a reply from an ID that was not asked
    base::Duration sentAt{};
    base::Duration expectedAt{}; ///< when a prompt adapter would have shown the last reply
    base::Duration endedAt{};
};

/// A request that waits for its replies.
struct PendingRequest {
    protocol::Expectation expected; ///< `ids` shrinks as the replies come
    Attempt attempt;
    base::Duration deadline{};
    std::vector<int> broken; ///< answered with a wrong checksum
    /// A PING asks whether a servo is there: silence is an answer to that, not an error.
    bool isPing = false;
    bool isFlooded = false; ///< more bytes than the line could carry came while it waited

    bool expects(int id) const;
    bool isDone() const;    ///< the replies that are still missing were broken
    int soleTarget() const; ///< the servo that noise is counted for; -1: several
    void addFault(FaultKind kind);
};

class ReplyScanner {
public:
    ReplyScanner(Line& line, const protocol::Codec& codec, base::Clock& clock,
                 LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics, TraceRing& trace,
                 UnexpectedFrameList& unexpectedFrames);

    /// From now on bytes are read as frames of this protocol.
    void setProtocol(base::Protocol protocol);
    const protocol::Codec& codec() const { return *m_codec; }

    /// Takes all complete frames; at the deadline also what will not become one.
    void scan(PendingRequest& request, bool atDeadline);
    void scanUnexpected(bool atDeadline); ///< while no request is pending
    /// The replies that are still expected are missing. An interrupted wait proves no time-out.
    void giveUp(PendingRequest& request, bool interrupted);
    void countSent(const protocol::Request& request, const protocol::Expectation& expected);
    void countTimeout(const PendingRequest& request, int id);

    /// Bytes that answer no request. `isFrame`: they are a valid frame.
    void countUnsolicited(std::size_t bytes, bool isFrame);
    bool hasUnsolicitedFrames() const { return m_lineNoise.hasFrames(); }
    /// They are more than a line with pauses could carry.
    bool isOverloaded() const;
    /// For how long a line may go on without falling silent, by the longest frames.
    base::Duration noiseTolerance() const;

private:
    void countNoise(const PendingRequest& request, std::size_t bytes);
    void handleReply(PendingRequest& request, protocol::Reply part);
    void handleForeign(PendingRequest& request, protocol::Reply part, base::ByteView frame);
    void handleBadChecksum(PendingRequest& request, int id);

    Line& m_line;
    const protocol::Codec* m_codec; ///< of the latest request, also for unexpected frames
    base::Protocol m_protocol;
    base::Clock& m_clock;
    LateReplyGuard& m_lateReplyGuard;
    StatisticsCollector& m_statistics;
    TraceRing& m_trace;
    UnexpectedFrameList& m_unexpectedFrames;
    LineNoiseMeter m_lineNoise;
};
} // namespace bus
