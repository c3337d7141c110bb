// SPDX-License-Identifier: GPL-3.0-or-later
// A cable between a program and the simulator's terminal, as a terminal or a TCP port of its own,
// that can be told to send without end: bytes at a rate, mixed into whatever the servos say. Knows
// bytes only. A thread of its own; flood() from the test's. POSIX only.
#pragma once

#include "support/feetech_bytes.h"
#include "support/port_endpoints.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <poll.h>
#include <random>
#include <thread>

namespace support {
class FloodCable {
public:
    enum class Endpoint { Terminal, Tcp };

    /// `terminal` empty: no servos behind it.
    FloodCable(Endpoint front, const QString& terminal)
    {
        if (!terminal.isEmpty()) {
            m_servoFd = open(qPrintable(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
            makeRaw(m_servoFd);
        }
        if (front == Endpoint::Terminal)
            openTerminal();
        else
            listenOnTcp();
        m_thread = std::thread([this] { serve(); });
    }
    ~FloodCable()
    {
        m_over = true;
        m_thread.join();
        for (const int side : {m_servoFd, m_hostFd, m_slave, m_listener}) {
            if (side >= 0)
                close(side);
        }
    }
    FloodCable(const FloodCable&) = delete;
    FloodCable& operator=(const FloodCable&) = delete;

    QString port() const { return m_port; }

    /// `unit` again and again, so many bytes a second; 0: no more.
    void flood(const QByteArray& unit, double bytesPerSecond)
    {
        const std::lock_guard lock(m_mutex);
        m_unit = unit;
        m_rate = bytesPerSecond;
        m_sent = 0;
        m_from = Clock::now();
    }
    /// Begins by itself with the first frame of the program that contains these bytes.
    void floodOnFrame(const QByteArray& trigger, const QByteArray& unit, double bytesPerSecond)
    {
        const std::lock_guard lock(m_mutex);
        m_trigger = trigger;
        m_nextUnit = unit;
        m_nextRate = bytesPerSecond;
    }
    /// TCP: hangs up at the first frame that contains these bytes, before the servo has heard it.
    void cutAt(const QByteArray& trigger)
    {
        const std::lock_guard lock(m_mutex);
        m_cutTrigger = trigger;
    }
    bool flooding()
    {
        const std::lock_guard lock(m_mutex);
        return m_rate > 0;
    }

private:
    using Clock = std::chrono::steady_clock;

    void openTerminal()
    {
        const Terminal terminal = makeTerminal(O_NONBLOCK);
        m_hostFd = terminal.master;
        m_slave = terminal.slave; // held open, so that no program that leaves hangs it up
        m_port = terminal.port;
    }

    void listenOnTcp()
    {
        const TcpPort tcp = listenOnLoopback(SOCK_NONBLOCK);
        m_listener = tcp.listener;
        m_port = tcp.port;
    }

    void serve()
    {
        while (!m_over) {
            pollfd states[3] = {
                {m_hostFd, POLLIN, 0}, {m_servoFd, POLLIN, 0}, {m_listener, POLLIN, 0}};
            poll(states, 3, 1);
            if ((states[2].revents & POLLIN) != 0)
                accept();
            if ((states[0].revents & (POLLIN | POLLHUP)) != 0)
                fromHost();
            if ((states[1].revents & POLLIN) != 0)
                fromServos();
            sendFlood();
        }
    }

    void accept()
    {
        const int accepted = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (accepted < 0)
            return;
        if (m_hostFd >= 0)
            close(m_hostFd);
        m_hostFd = accepted;
        const std::lock_guard lock(m_mutex);
        m_sent = 0; // for this one from its beginning
        m_from = Clock::now();
    }

    void fromHost()
    {
        char chunk[4096];
        const ssize_t got = read(m_hostFd, chunk, sizeof chunk);
        if (got == 0 && m_listener >= 0) { // hung up
            close(std::exchange(m_hostFd, -1));
            return;
        }
        if (got <= 0)
            return;
        if (isCut(QByteArray(chunk, int(got)))) {
            close(std::exchange(m_hostFd, -1));
            return;
        }
        if (m_servoFd >= 0 && write(m_servoFd, chunk, std::size_t(got)) != got)
            return;
        const std::lock_guard lock(m_mutex);
        if (m_trigger.isEmpty() || !QByteArray(chunk, int(got)).contains(m_trigger))
            return;
        m_trigger.clear();
        m_unit = m_nextUnit;
        m_rate = m_nextRate;
        m_sent = 0;
        m_from = Clock::now();
    }

    bool isCut(const QByteArray& received)
    {
        const std::lock_guard lock(m_mutex);
        if (m_cutTrigger.isEmpty() || !received.contains(m_cutTrigger))
            return false;
        m_cutTrigger.clear();
        return true;
    }

    void fromServos()
    {
        char chunk[4096];
        const ssize_t got = read(m_servoFd, chunk, sizeof chunk);
        if (got > 0 && m_hostFd >= 0)
            put(chunk, std::size_t(got));
    }

    void sendFlood()
    {
        const std::lock_guard lock(m_mutex);
        if (m_rate <= 0 || m_hostFd < 0)
            return;
        const double passed = std::chrono::duration<double>(Clock::now() - m_from).count();
        const double due = passed * m_rate;
        while (m_sent < due) {
            const auto size =
                std::min<std::size_t>(std::size_t(m_unit.size()), std::size_t(due - m_sent) + 1);
            const ssize_t done = put(m_unit.constData(), size);
            if (done <= 0) { // it takes no more: nothing is saved up
                m_sent = due;
                return;
            }
            m_sent += double(done);
        }
    }

    ssize_t put(const char* bytes, std::size_t size)
    {
        return m_listener >= 0 ? send(m_hostFd, bytes, size, MSG_NOSIGNAL)
                               : write(m_hostFd, bytes, size);
    }

    int m_servoFd = -1;
    int m_hostFd = -1;
    int m_slave = -1;
    int m_listener = -1;
    QString m_port;
    std::atomic<bool> m_over{false};
    std::mutex m_mutex;
    QByteArray m_unit;
    double m_rate = 0;
    double m_sent = 0;
    Clock::time_point m_from;
    QByteArray m_trigger;
    QByteArray m_cutTrigger;
    QByteArray m_nextUnit;
    double m_nextRate = 0;
    std::thread m_thread;
};

/// A valid status packet of servo `id` that was not asked for.
inline QByteArray statusPacket(int id)
{
    return feetechFrame(id, 0);
}

inline QByteArray garbage(int size)
{
    std::minstd_rand random(7);
    QByteArray bytes(size, '\0');
    for (char& byte : bytes)
        byte = char(random() >> 8);
    return bytes;
}
} // namespace support
