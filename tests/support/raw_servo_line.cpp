// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/raw_servo_line.h"

#include <algorithm>
#include <numeric>

namespace support {
namespace {
constexpr std::uint8_t ping = 1;
constexpr std::uint8_t read = 2;
constexpr std::uint8_t write = 3;
constexpr base::Duration replyDelay = std::chrono::microseconds(100);
constexpr base::Duration byteTime = std::chrono::microseconds(10); // 1 Mbaud

std::uint8_t checksum(const base::Bytes& frame)
{
    return std::uint8_t(~std::accumulate(frame.begin() + 2, frame.end(), 0U) & 0xFF);
}

base::Bytes reply(int id, const base::Bytes& data)
{
    base::Bytes frame{0xFF, 0xFF, std::uint8_t(id), std::uint8_t(data.size() + 2), 0};
    frame.insert(frame.end(), data.begin(), data.end());
    frame.push_back(checksum(frame));
    return frame;
}

class RawServoLink final : public transport::Link {
public:
    RawServoLink(RawServoLine& line, base::ManualClock& clock)
        : m_line(line)
        , m_clock(clock)
    {}

    base::Result<void> write(base::ByteView bytes) override
    {
        const base::Bytes frame(bytes.begin(), bytes.end());
        m_line.frames.push_back(frame);
        if (m_line.echo) {
            base::Duration at = m_clock.now() + m_line.adapterLatency;
            for (const std::uint8_t value : frame)
                m_pendingBytes.push_back({at += byteTime, value});
        }
        base::Bytes body = frame;
        if (body.size() < 6 || body[0] != 0xFF || body[1] != 0xFF)
            return {};
        const std::uint8_t check = body.back();
        body.pop_back();
        if (checksum(body) != check)
            return {};
        answer(body);
        return {};
    }

    base::Result<std::size_t> read(base::Bytes& buffer) override
    {
        std::size_t count = 0;
        for (; !m_pendingBytes.empty() && m_pendingBytes.front().at <= m_clock.now(); ++count) {
            buffer.push_back(m_pendingBytes.front().value);
            m_pendingBytes.pop_front();
        }
        return count;
    }

    base::Result<bool> waitForReadyRead(base::Duration span) override
    {
        const base::Duration until = m_clock.now() + span;
        if (m_pendingBytes.empty() || m_pendingBytes.front().at > until) {
            m_clock.advance(span);
            return false;
        }
        m_clock.advance(std::max(base::Duration{}, m_pendingBytes.front().at - m_clock.now()));
        return true;
    }

    base::Result<void> setBaud(int baud) override
    {
        m_baud = baud;
        return {};
    }
    int baud() const override { return m_baud; }
    QString name() const override { return QStringLiteral("bytes"); }

private:
    struct PendingBytes {
        base::Duration at{};
        std::uint8_t value = 0;
    };

    static base::Bytes carryOut(RawServo& servo, const base::Bytes& body)
    {
        const std::uint8_t instruction = body[4];
        if (instruction == support::read) {
            const auto first = servo.table.begin() + body[5];
            return {first, first + body[6]};
        }
        if (instruction == support::write) {
            std::copy(body.begin() + 6, body.end(), servo.table.begin() + body[5]);
            ++servo.writes;
            servo.id = servo.table[5];
        }
        return {};
    }

    void answer(const base::Bytes& body)
    {
        if (m_baud != 1'000'000 ||
            (body[4] != ping && body[4] != support::read && body[4] != support::write))
            return;
        std::vector<base::Bytes> pendingReplies;
        for (RawServo& servo : m_line.servos) {
            if (servo.id == body[2])
                pendingReplies.push_back(reply(body[2], carryOut(servo, body)));
        }
        if (pendingReplies.empty())
            return;
        if (m_line.replies == RawServoLine::ReplyTiming::Simultaneous) {
            for (std::size_t i = 0; i < pendingReplies[0].size() && pendingReplies.size() > 1; ++i)
                pendingReplies[0][i] = pendingReplies[0][i] & pendingReplies[1][i];
            pendingReplies.resize(1);
        }
        base::Duration at = m_clock.now() + byteTime * (int(body.size()) + 1) + replyDelay;
        for (std::size_t i = 0; i < pendingReplies.size(); ++i) {
            if (m_line.spoil)
                m_line.spoil(m_line.asked++, pendingReplies[i]);
            at += i > 0 ? m_line.secondReplyDelay : base::Duration{};
            for (const std::uint8_t value : pendingReplies[i])
                m_pendingBytes.push_back({(at += byteTime) + m_line.adapterLatency, value});
            at += byteTime;
        }
    }

    RawServoLine& m_line;
    base::ManualClock& m_clock;
    int m_baud = 1'000'000;
    std::deque<PendingBytes> m_pendingBytes;
};
} // namespace

int RawServoLine::writeFrameCount() const
{
    return int(std::count_if(frames.begin(), frames.end(), [](const base::Bytes& frame) {
        return frame.size() > 4 && frame[4] != ping && frame[4] != read;
    }));
}

std::unique_ptr<transport::Link> openRawServoLine(RawServoLine& line, base::ManualClock& clock)
{
    return std::make_unique<RawServoLink>(line, clock);
}

RawServo rawSts3215(int id, int position)
{
    RawServo servo;
    servo.id = id;
    base::Bytes& t = servo.table;
    const auto set = [&t](std::size_t at, std::initializer_list<int> values) {
        for (const int value : values)
            t[at++] = std::uint8_t(value);
    };
    set(0, {3,  10, 0, 9,  3, id, 0, 250,  1, 0, 0, 0xFF, 0x0F, 70, 80,  40, 0xE8, 3,   12, 44, 47,
            32, 32, 0, 16, 0, 1,  1, 0xF4, 1, 1, 0, 0,    0,    20, 200, 80, 10,   200, 200});
    set(40, {0, 0, position & 0xFF, position >> 8, 0, 0, 0, 0, 0xE8, 3});
    set(55, {1, position & 0xFF, position >> 8, 0, 0, 0, 0, 74, 30});
    return servo;
}
} // namespace support
