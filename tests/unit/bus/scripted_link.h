// SPDX-License-Identifier: GPL-3.0-or-later
// A link in memory on a manual clock, with servos of a few lines behind it. A reply reaches the
// host when its last byte would have left a wire of this rate, plus the latency of the adapter.
// Single thread. Frames are built here from the published rules, not by the codec under test.
#pragma once

#include "base/clock.h"
#include "transport/link.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <numeric>

using base::Bytes;
using base::Duration;

inline Bytes frameOf(int id, int instructionOrError, const Bytes& params)
{
    Bytes frame;
    frame.reserve(params.size() + 6);
    frame.assign({0xFF, 0xFF, std::uint8_t(id), std::uint8_t(params.size() + 2),
                  std::uint8_t(instructionOrError)});
    frame.insert(frame.end(), params.begin(), params.end());
    const int sum = std::accumulate(frame.begin() + 2, frame.end(), 0);
    frame.push_back(std::uint8_t(~sum));
    return frame;
}

struct SentFrame {
    Duration at;
    Bytes bytes;
    int id() const { return bytes.at(2); }
    int instruction() const { return bytes.at(4); }
    int address() const { return bytes.at(5); }
};

class ScriptedLink final : public transport::Link {
public:
    /// Shared with the test, which outlives the link.
    struct Script {
        base::ManualClock clock;
        int baud = 1'000'000;
        bool echo = false;
        Duration latency{};
        Duration replyDelay{};
        std::map<int, Bytes> tables; ///< servos by ID
        std::vector<SentFrame> sent;
        /// Changes what the servos do: returns true when it has dealt with the frame itself.
        std::function<bool(const Bytes& frame)> intercept;
        std::function<void()> onWait; ///< called at every wait, for what another thread would do
        std::deque<std::pair<Duration, Bytes>> arriving; ///< sorted by time
        bool cut = false;
        int refusedBaud = 0;
        Duration wireFreeAt{};

        Duration wire(std::size_t bytes) const
        {
            return Duration(std::int64_t(bytes) * 10'000'000 / baud);
        }
        void deliver(Duration at, const Bytes& bytes)
        {
            const auto place = std::upper_bound(
                arriving.begin(), arriving.end(), at,
                [](Duration time, const auto& entry) { return time < entry.first; });
            arriving.insert(place, {at, bytes});
        }
        /// A servo speaks after whatever is on the wire.
        void reply(const Bytes& frame, Duration extra = {})
        {
            wireFreeAt =
                std::max(wireFreeAt, clock.now()) + replyDelay + wire(frame.size()) + extra;
            deliver(wireFreeAt + latency, frame);
        }
        void answer(const Bytes& frame);
        std::vector<SentFrame> takeSent() { return std::exchange(sent, {}); }
    };

    explicit ScriptedLink(Script& script)
        : m_script(script)
    {}

    base::Result<void> write(base::ByteView bytes) override
    {
        if (m_script.cut)
            return gone();
        const Bytes frame(bytes.begin(), bytes.end());
        m_script.sent.push_back({m_script.clock.now(), frame});
        m_script.wireFreeAt = m_script.clock.now() + m_script.wire(frame.size());
        if (m_script.echo)
            m_script.deliver(m_script.wireFreeAt + m_script.latency, frame);
        if (!m_script.intercept || !m_script.intercept(frame))
            m_script.answer(frame);
        return {};
    }

    base::Result<std::size_t> read(Bytes& buffer) override
    {
        if (m_script.cut)
            return gone();
        std::size_t count = 0;
        auto& arriving = m_script.arriving;
        while (!arriving.empty() && arriving.front().first <= m_script.clock.now()) {
            const Bytes bytes = arriving.front().second;
            arriving.pop_front();
            buffer.insert(buffer.end(), bytes.begin(), bytes.end());
            count += bytes.size();
        }
        return count;
    }

    base::Result<bool> waitForReadyRead(Duration span) override
    {
        if (m_script.onWait)
            m_script.onWait();
        if (m_script.cut)
            return gone();
        const Duration until = m_script.clock.now() + span;
        if (m_script.arriving.empty() || m_script.arriving.front().first > until) {
            m_script.clock.sleepUntil(until);
            return false;
        }
        m_script.clock.sleepUntil(m_script.arriving.front().first);
        return true;
    }

    base::Result<void> setBaud(int baud) override
    {
        if (baud == m_script.refusedBaud)
            return base::fail(base::ErrorCode::RateUnsupported);
        m_script.baud = baud;
        return {};
    }
    int baud() const override { return m_script.baud; }
    QString name() const override { return QStringLiteral("scripted"); }

private:
    tl::unexpected<base::Error> gone() const
    {
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("read"), name());
    }

    Script& m_script;
};

using Script = ScriptedLink::Script;

inline void Script::answer(const Bytes& frame)
{
    if (frame.size() < 6)
        return;
    const int id = frame[2];
    const auto servo = tables.find(id);
    const auto part = [](const Bytes& table, int address, int count) {
        return Bytes(table.begin() + address, table.begin() + address + count);
    };
    if (frame[4] == 0x82) {
        for (std::size_t i = 7; i + 1 < frame.size(); ++i) {
            const auto listed = tables.find(frame[i]);
            if (listed != tables.end())
                reply(frameOf(frame[i], 0, part(listed->second, frame[5], frame[6])));
        }
        return;
    }
    if (servo == tables.end())
        return;
    switch (frame[4]) {
    case 0x02:
        reply(frameOf(id, 0, part(servo->second, frame[5], frame[6])));
        break;
    case 0x03:
        std::copy(frame.begin() + 6, frame.end() - 1, servo->second.begin() + frame[5]);
        reply(frameOf(id, 0, {}));
        break;
    case 0x08:
        break;
    default:
        reply(frameOf(id, 0, {}));
    }
}

/// A table in which each byte is its address plus `seed`.
inline Bytes sequentialTable(int seed)
{
    Bytes table(256);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = std::uint8_t(int(i) + seed);
    return table;
}
