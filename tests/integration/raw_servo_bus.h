// SPDX-License-Identifier: GPL-3.0-or-later
// Servos that know only bytes, behind a pseudo-terminal of their own: tables of 256 bytes that
// answer PING, READ, WRITE and SYNC WRITE of the published protocol description through an adapter
// as late as the test asks, and make of a restart what the test asks. Runs on a thread of its own.
// POSIX only.
#pragma once

#include "support/feetech_bytes.h"
#include "support/port_endpoints.h"
#include "support/raw_servo_line.h"
#include "support/simulator_priority.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <poll.h>
#include <thread>

namespace bytes {
enum class RestartBehavior { Ignored, AcknowledgedOnly, TooFastToDetect };

class Bus {
public:
    using Clock = std::chrono::steady_clock;
    using Table = std::array<unsigned char, 256>;

    Bus(std::initializer_list<int> ids, std::chrono::milliseconds latency,
        RestartBehavior restart = RestartBehavior::Ignored)
        : m_latency(latency)
        , m_restart(restart)
    {
        for (const int id : ids)
            m_servos[id] = factoryTable(id);
        const support::Terminal terminal = support::makeTerminal();
        m_master = terminal.master;
        m_name = terminal.port;
        close(terminal.slave); // or another program would seem to have the port open
        m_thread = std::thread([this] {
            support::raisePriority();
            serve();
        });
    }
    ~Bus()
    {
        m_ended = true;
        m_thread.join();
        close(m_master);
    }
    Bus(const Bus&) = delete;
    Bus& operator=(const Bus&) = delete;

    QString port() const { return m_name; }
    void setLatency(std::chrono::milliseconds latency) { m_latency = latency; }
    /// The next `count` WRITEs of this address are lost on their way to the servo.
    void dropWrites(int id, int address, int count)
    {
        const std::lock_guard lock(m_mutex);
        m_lost[{id, address}] = count;
    }
    /// The next `count` PINGs are lost on their way to the servo.
    void dropPings(int id, int count)
    {
        const std::lock_guard lock(m_mutex);
        m_pingsToDrop[id] = count;
    }
    int writes() const { return m_writes; }
    /// What the host has sent, in order.
    std::vector<QByteArray> frames()
    {
        const std::lock_guard lock(m_mutex);
        return m_frames;
    }
    int restarts() const { return m_restarts; }
    bool has(int id)
    {
        const std::lock_guard lock(m_mutex);
        return m_servos.count(id) > 0;
    }
    /// As the factory or an accident left it.
    void setByte(int id, int address, int value)
    {
        const std::lock_guard lock(m_mutex);
        m_servos.at(id)[static_cast<std::size_t>(address)] = static_cast<unsigned char>(value);
    }
    int byteAt(int id, int address)
    {
        const std::lock_guard lock(m_mutex);
        return m_servos.at(id)[static_cast<std::size_t>(address)];
    }

private:
    static Table factoryTable(int id)
    {
        Table table{};
        const base::Bytes sts = support::rawSts3215(id).table;
        std::copy(sts.begin(), sts.end(), table.begin());
        return table;
    }

    void serve()
    {
        QByteArray buffer;
        while (!m_ended) {
            pollfd state{m_master, POLLIN, 0};
            poll(&state, 1, 1);
            if ((state.revents & POLLIN) == 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(200)); // hung up: no program
            } else {
                char chunk[512];
                const ssize_t got = read(m_master, chunk, sizeof chunk);
                if (got > 0)
                    buffer.append(chunk, got);
            }
            takeFrames(buffer);
            while (!m_replies.empty() && m_replies.front().first <= Clock::now()) {
                const QByteArray reply = m_replies.front().second;
                m_replies.pop_front();
                if (write(m_master, reply.constData(), static_cast<std::size_t>(reply.size())) < 0)
                    qFatal("write");
            }
        }
    }

    void takeFrames(QByteArray& buffer)
    {
        for (;;) {
            const auto start = buffer.indexOf("\xFF\xFF");
            if (start < 0 || buffer.size() < start + 4)
                return;
            const auto size = 4 + static_cast<unsigned char>(buffer[start + 3]);
            if (buffer.size() < start + size)
                return;
            handle(buffer.mid(start, size));
            buffer.remove(0, start + size);
        }
    }

    void handle(const QByteArray& frame)
    {
        const std::lock_guard lock(m_mutex);
        m_frames.push_back(frame);
        const auto at = [&frame](int place) { return static_cast<unsigned char>(frame[place]); };
        const int id = at(2);
        if (id == 254 && at(4) == 0x83)
            syncWrite(frame);
        const auto servo = m_servos.find(id);
        if (servo == m_servos.end())
            return;
        switch (at(4)) {
        case 0x01:
            if (m_pingsToDrop[id] > 0)
                --m_pingsToDrop[id];
            else
                reply(id, {});
            break;
        case 0x02: {
            QByteArray data;
            for (int i = 0; i < at(6); ++i)
                data.append(static_cast<char>(servo->second[std::size_t(at(5) + i)]));
            reply(id, data);
            break;
        }
        case 0x03:
            if (const auto lost = m_lost.find({id, at(5)});
                lost != m_lost.end() && lost->second > 0) {
                --lost->second;
                break;
            }
            ++m_writes;
            for (int i = 6; i < frame.size() - 1; ++i)
                servo->second[std::size_t(at(5) + i - 6)] = at(i);
            reply(id, {}); // from the old ID, also when it has just changed
            if (at(5) == 5) {
                const Table moved = servo->second;
                m_servos.erase(servo);
                m_servos[moved[5]] = moved;
            }
            break;
        case 0x08:
            ++m_restarts;
            if (m_restart == RestartBehavior::AcknowledgedOnly)
                reply(id, {});
            if (m_restart == RestartBehavior::TooFastToDetect) {
                servo->second[48] = servo->second[16];
                servo->second[49] = servo->second[17];
            }
            break;
        default:
            break;
        }
    }

    /// SYNC WRITE: address, count, then an ID and its data for each servo.
    void syncWrite(const QByteArray& frame)
    {
        const auto at = [&frame](int place) { return static_cast<unsigned char>(frame[place]); };
        const int count = at(6);
        for (int place = 7; place + count < frame.size() - 1; place += 1 + count) {
            const auto servo = m_servos.find(at(place));
            for (int i = 0; servo != m_servos.end() && i < count; ++i)
                servo->second[std::size_t(at(5) + i)] = at(place + 1 + i);
        }
    }

    void reply(int id, const QByteArray& data)
    {
        m_replies.emplace_back(Clock::now() + m_latency.load(), support::feetechFrame(id, 0, data));
    }

    std::atomic<std::chrono::milliseconds> m_latency;
    const RestartBehavior m_restart;
    int m_master = -1;
    QString m_name;
    std::mutex m_mutex; ///< guards the tables and the frames
    std::map<int, Table> m_servos;
    std::vector<QByteArray> m_frames;
    std::map<std::pair<int, int>, int> m_lost;                      ///< WRITEs by ID and address
    std::map<int, int> m_pingsToDrop;                               ///< by ID
    std::deque<std::pair<Clock::time_point, QByteArray>> m_replies; ///< the thread's
    std::atomic<int> m_writes{0};
    std::atomic<int> m_restarts{0};
    std::atomic<bool> m_ended{false};
    std::thread m_thread;
};
} // namespace bytes
