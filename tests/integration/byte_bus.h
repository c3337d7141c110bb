// SPDX-License-Identifier: GPL-3.0-or-later
// Servos that know only bytes, behind a pseudo-terminal of their own: tables of 256 bytes that
// answer PING, READ and WRITE of the published protocol description through an adapter as late as
// the test asks, and make of a restart what the test asks. Runs on a thread of its own. POSIX only.
#pragma once

#include <QByteArray>
#include <QString>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <fcntl.h>
#include <map>
#include <mutex>
#include <poll.h>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace bytes {
enum class Restart { Ignored, AcknowledgedOnly, TooQuickToSee };

class Bus {
public:
    using Clock = std::chrono::steady_clock;
    using Table = std::array<unsigned char, 256>;

    Bus(std::initializer_list<int> ids, std::chrono::milliseconds latency,
        Restart restart = Restart::Ignored)
        : m_latency(latency)
        , m_restart(restart)
    {
        for (const int id : ids)
            m_servos[id] = factoryTable(id);
        m_master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        if (m_master < 0 || grantpt(m_master) != 0 || unlockpt(m_master) != 0)
            qFatal("no terminal");
        m_name = QString::fromLocal8Bit(ptsname(m_master));
        const int slave = open(ptsname(m_master), O_RDWR | O_NOCTTY | O_CLOEXEC);
        termios raw{};
        tcgetattr(slave, &raw);
        cfmakeraw(&raw);
        tcsetattr(slave, TCSANOW, &raw);
        close(slave); // or the port would be somebody's
        m_thread = std::thread([this] { serve(); });
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
    /// The next `count` WRITEs of this address are lost on their way to the servo.
    void loseWrites(int id, int address, int count)
    {
        const std::lock_guard lock(m_mutex);
        m_lost[{id, address}] = count;
    }
    int writes() const { return m_writes; }
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
    /// An STS3215 with firmware 3.10.
    static Table factoryTable(int id)
    {
        Table table{};
        table[0] = 3;
        table[1] = 10;
        table[3] = 9;
        table[4] = 3;
        table[5] = static_cast<unsigned char>(id);
        table[8] = 1;
        table[11] = 0xFF;
        table[12] = 0x0F;
        table[13] = 70;
        table[14] = 80;
        table[15] = 40;
        table[16] = table[48] = 0xE8;
        table[17] = table[49] = 0x03;
        table[55] = 1;
        table[57] = 0x08;
        table[62] = 74;
        table[63] = 30;
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
        const auto at = [&frame](int place) { return static_cast<unsigned char>(frame[place]); };
        const int id = at(2);
        const auto servo = m_servos.find(id);
        if (servo == m_servos.end())
            return;
        switch (at(4)) {
        case 0x01:
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
            if (m_restart == Restart::AcknowledgedOnly)
                reply(id, {});
            if (m_restart == Restart::TooQuickToSee) {
                servo->second[48] = servo->second[16];
                servo->second[49] = servo->second[17];
            }
            break;
        default:
            break;
        }
    }

    void reply(int id, const QByteArray& data)
    {
        QByteArray frame("\xFF\xFF");
        frame.append(static_cast<char>(id));
        frame.append(static_cast<char>(data.size() + 2));
        frame.append('\0');
        frame.append(data);
        unsigned sum = 0;
        for (qsizetype i = 2; i < frame.size(); ++i)
            sum += static_cast<unsigned char>(frame[i]);
        frame.append(static_cast<char>(~sum & 0xFFU));
        m_replies.emplace_back(Clock::now() + m_latency, frame);
    }

    const std::chrono::milliseconds m_latency;
    const Restart m_restart;
    int m_master = -1;
    QString m_name;
    std::mutex m_mutex; ///< guards the tables
    std::map<int, Table> m_servos;
    std::map<std::pair<int, int>, int> m_lost;                      ///< WRITEs by ID and address
    std::deque<std::pair<Clock::time_point, QByteArray>> m_replies; ///< the thread's
    std::atomic<int> m_writes{0};
    std::atomic<int> m_restarts{0};
    std::atomic<bool> m_ended{false};
    std::thread m_thread;
};
} // namespace bytes
