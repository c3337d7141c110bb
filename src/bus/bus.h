// SPDX-License-Identifier: GPL-3.0-or-later
// One wire as jobs and windows see it. Implemented twice: BusCore runs on the caller's thread
// (tests, fast simulation), BusThread owns a core on a thread of its own and adds queue and
// priorities. Every call may block the caller until the wire has answered; none needs an event
// loop.
#pragma once

#include "base/clock.h"
#include "base/error.h"
#include "bus/poll.h"
#include "bus/statistics.h"
#include "bus/stop_frame.h"
#include "bus/trace.h"
#include "bus/verified_ids.h"
#include "protocol/request.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace bus {
enum class Priority : std::uint8_t { Emergency, Interactive, Job, Poll };

/// Unrest: the line never fell silent, so a reply cannot be told from other bytes.
enum class FaultKind : std::uint8_t {
    Timeout,
    BadChecksum,
    Foreign,
    Late,
    Noise,
    UnexpectedReply,
    LineBusy
};

/// A trouble that was overcome by repeating, kept on the reply so that nothing is hidden.
struct Fault {
    FaultKind kind = FaultKind::Timeout;
    base::Duration at{};
};

struct Transaction {
    protocol::Request request;
    Priority priority = Priority::Job;
    int retries = -1; ///< -1: the bus' default; requests with Repeat::Never are never repeated
    /// The wait beyond wire time and reply delay. 0: adaptive (25 ms, growing). A scan uses 4 ms,
    /// a confirmation a long one.
    base::Duration timeout{};
    /// With retries and an adaptive timeout: silence counts only when it has lasted as long as a
    /// busy computer may hold a reply back (0.25 s). Not where many absent servos are asked.
    bool patient = true;
    std::uint64_t hold = 0; ///< token of a Hold this transaction belongs to
    /// Ends the transaction early with Stopped. A request that must not be repeated is waited for
    /// to its deadline once it is sent, so that its fate is known. Null: nothing stops it (a lock
    /// that must be closed after the user has stopped the job).
    const base::StopToken* stop = nullptr;
    /// What emergencies() said when the work this belongs to was asked for: after another one it
    /// is refused with Preempted before its first byte. Inside a Hold the hold sees to that.
    std::optional<std::uint64_t> epoch{};
};

struct Outcome {
    /// In order of arrival; sync reads may miss servos; empty when nothing was to be answered. A
    /// raw request has one part of ID -1 with all bytes that came, maybe none.
    std::vector<protocol::Reply> replies;
    std::vector<Fault> faults;
    int attempts = 0;
    base::Duration sentAt{};
    base::Duration roundTrip{}; ///< of the attempt that succeeded

    const base::Bytes& data() const { return replies.front().data; }
    std::uint8_t status() const
    {
        return replies.empty() ? std::uint8_t{0} : replies.front().status;
    }
};

/// A valid frame that answers no request: a late reply, or another servo. Scans collect them.
struct UnexpectedFrame {
    int id = 0;
    std::uint8_t status = 0;
    base::Bytes data;
    base::Duration at{};
    std::uint8_t exception = 0; ///< Modbus; 0: none
};

/// The word for a Modbus exception: "illegal-function", "illegal-address" …
QString exceptionName(std::uint8_t exception);

class Bus;

/// While it lives, the servos belong to the job that took it: polls skip them without counting
/// errors, other transactions to them wait; only the emergency lane passes. Movable value.
class Hold {
public:
    Hold() = default;
    Hold(Bus* owner, std::uint64_t token)
        : m_owner(owner)
        , m_token(token)
    {}
    Hold(Hold&& other) noexcept { swap(other); }
    Hold& operator=(Hold&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Hold();
    std::uint64_t token() const { return m_token; }

private:
    void swap(Hold& other) noexcept
    {
        std::swap(m_owner, other.m_owner);
        std::swap(m_token, other.m_token);
    }
    Bus* m_owner = nullptr;
    std::uint64_t m_token = 0;
};

class Bus {
public:
    virtual ~Bus() = default;

    /// NoReply, Garbled, UnexpectedReply, LineBusy, Uncertain, LinkLost, Stopped, Preempted,
    /// BadArgument. Where bytes fill the line, or are frames without a pause, nothing is asked:
    /// LineBusy after no attempt; only a write that may be repeated is still sent, without
    /// believing what follows it. Waits for servos another thread holds; Held at once when the
    /// calling thread holds them itself and the transaction does not carry the token.
    virtual base::Result<Outcome> transact(const Transaction& transaction) = 0;

    /// Only listens for `span`; valid frames count as unexpected.
    virtual base::Result<void> listen(base::Duration span) = 0;
    virtual std::vector<UnexpectedFrame> takeUnexpectedFrames() = 0;

    virtual base::Result<void> setBaud(int baud) = 0;
    virtual int baud() const = 0;
    virtual bool canSetBaud() const = 0;
    virtual QString portName() const = 0;
    virtual bool lost() const = 0; ///< the link is gone and will not come back
    virtual bool
    isReconnecting() const = 0;       ///< the link is gone and awaited; see setReconnectTimeout()
    virtual bool hasEcho() const = 0; ///< the adapter returns what is sent

    /// Waits while polls run; false when `stop` is requested first.
    virtual bool pauseUntil(base::Duration instant, const base::StopToken* stop) = 0;

    /// Empty `ids`: all servos. Blocks until other threads have let go of them; the same thread may
    /// hold a servo more than once.
    virtual Hold hold(const std::vector<int>& ids, std::optional<std::uint64_t> epoch = {}) = 0;

    virtual PollId startPoll(const PollPlan& plan) = 0;
    virtual void stopPoll(PollId id) = 0;
    /// Also after stopPoll, for samples not taken yet. The latest 65536 are kept.
    virtual std::vector<Sample> takeSamples(PollId id) = 0;

    /// Ready-made frames that take torque off; see emergency().
    virtual void setStopFrames(std::vector<StopFrame> frames) = 0;

    /// Sends the stop frames ahead of everything, from any thread, and returns at once. The running
    /// transaction and those waiting end with Preempted, and so does the next one of every Hold, so
    /// that a job between two steps notices.
    virtual void emergency() = 0;
    /// How many there have been. A hold or transaction of work that was asked for before the latest
    /// one (its `epoch`) is preempted at its first word, however late it gets to it.
    virtual std::uint64_t emergencyCount() const = 0;

    virtual void setRetries(int retries) = 0;
    /// Replaces the initial timeout (25 ms) of ordinary transactions.
    virtual void setTimeout(base::Duration timeout) = 0;
    /// How long beyond the wire time a reply may still come: the latest one this link has shown and
    /// half as much again; at least the timeout that was set, 25 ms, and 250 ms before the first
    /// reply. Before a conclusion is drawn from silence, it must have lasted that long.
    virtual base::Duration maxReplyLateness() const = 0;
    /// The largest reply delay of any servo on this bus (SMS: up to 508 µs).
    virtual void setReplyDelay(base::Duration delay) = 0;
    /// Replaces the silence a protocol asks for between frames (Modbus: 1.75 ms above 19200 baud).
    virtual void setSilence(base::Duration silence) = 0;

    /// For how long the bus tries to open a link again that breaks from now on; 0: it is lost at
    /// once. Until then no request is answered, and an emergency stop is the first thing sent
    /// afterwards. The servos may have restarted. See ReconnectScope.
    virtual void setReconnectTimeout(base::Duration span) = 0;

    virtual Statistics statistics() const = 0;
    /// Bytes of no valid frame that have come while no reply was awaited; see DamagedReplyWatch.
    virtual std::uint64_t unsolicitedNoise() const = 0;
    virtual std::vector<TraceEntry> takeTrace() = 0;
    virtual base::Clock& clock() const = 0;

    /// The IDs that were proved to belong to one servo on this connection. Any thread.
    VerifiedIds& verifiedIds() { return m_verifiedIds; }

protected:
    friend class Hold;
    virtual void release(std::uint64_t token) = 0;

private:
    VerifiedIds m_verifiedIds;
};

/// While it lives a pulled plug may be put back. One at a time: for work that has the bus to
/// itself. A wait that has begun goes on when it ends.
class ReconnectScope {
public:
    ReconnectScope(Bus& bus, base::Duration span)
        : m_bus(bus)
    {
        bus.setReconnectTimeout(span);
    }
    ~ReconnectScope() { m_bus.setReconnectTimeout({}); }
    ReconnectScope(const ReconnectScope&) = delete;
    ReconnectScope& operator=(const ReconnectScope&) = delete;

private:
    Bus& m_bus;
};

/// Notices that a damaged reply came too late to be counted for the request that asked for it.
class DamagedReplyWatch {
public:
    explicit DamagedReplyWatch(const Bus& bus)
        : m_bus(bus)
        , m_noiseBefore(bus.unsolicitedNoise())
    {}
    /// Since the last call.
    bool hasReplyCome()
    {
        const std::uint64_t noise = m_bus.unsolicitedNoise();
        return noise - std::exchange(m_noiseBefore, noise) >= minReplyBytes;
    }

private:
    static constexpr std::uint64_t minReplyBytes = 3; ///< fewer are a glitch

    const Bus& m_bus;
    std::uint64_t m_noiseBefore;
};
} // namespace bus
