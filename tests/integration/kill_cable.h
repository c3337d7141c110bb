// SPDX-License-Identifier: GPL-3.0-or-later
// A cable between a program and the simulator's terminal, as a terminal of its own: what is said on
// one side is heard on the other, at the rate it was said at. Kills the program (SIGKILL) at the
// WRITE of one register or at a firmware block, before the servo has heard it or after; or
// interrupts it at a WRITE as Ctrl-C does. A thread of its own; killAt(), interruptAt(), killed()
// and resetConnection() from the test's, the last while no program is at it. POSIX only.
#pragma once

#include "support/port_endpoints.h"
#include "support/simulator_priority.h"
#include "transport/tty_speed.h"

#include <atomic>
#include <csignal>
#include <mutex>
#include <optional>
#include <poll.h>
#include <sys/ioctl.h>
#include <thread>

namespace support {
struct KillPoint {
    int address = -1; ///< first one of the frame
    bool delivered = false;
    int block = -1; ///< instead: number of the firmware block, from 1
};

/// Ctrl-C at a WRITE of this register that the servo hears; `times`: again at the frames after it.
struct InterruptPoint {
    int address = -1; ///< first one of the frame
    int skip = 0;     ///< so many such frames before it
    int times = 1;
};

class KillCable {
public:
    explicit KillCable(const QString& terminal)
        : m_terminal(open(qPrintable(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        const Terminal own = makeTerminal();
        m_master = own.master;
        m_slave = own.slave; // held open, so that the rate can be asked for
        m_port = own.port;
        makeRaw(m_terminal);
        m_thread = std::thread([this] {
            support::raisePriority();
            serve();
        });
    }
    ~KillCable()
    {
        m_over = true;
        m_thread.join();
        for (const int side : {m_slave, m_master, m_terminal})
            close(side);
    }
    KillCable(const KillCable&) = delete;
    KillCable& operator=(const KillCable&) = delete;

    QString port() const { return m_port; }
    void killAt(const KillPoint& point, qint64 program)
    {
        const std::lock_guard lock(m_mutex);
        m_point = point;
        m_program = static_cast<pid_t>(program);
    }
    void interruptAt(const InterruptPoint& point, qint64 program)
    {
        const std::lock_guard lock(m_mutex);
        m_interrupt = point;
        m_program = static_cast<pid_t>(program);
    }
    bool interrupted()
    {
        const std::lock_guard lock(m_mutex);
        return m_interrupted;
    }
    bool killed()
    {
        const std::lock_guard lock(m_mutex);
        return m_killed;
    }
    /// For the next program: nothing of the one before is left in it.
    void resetConnection()
    {
        const std::lock_guard lock(m_mutex);
        ioctl(m_slave, TIOCNXCL); // a killed program has not given this back
        tcflush(m_slave, TCIOFLUSH);
        m_point.reset();
        m_killed = false;
        m_interrupt.reset();
        m_interrupted = false;
    }

private:
    void serve()
    {
        while (!m_over) {
            pollfd states[2] = {{m_master, POLLIN, 0}, {m_terminal, POLLIN, 0}};
            if (poll(states, 2, 20) <= 0)
                continue;
            const std::lock_guard lock(m_mutex);
            if ((states[0].revents & POLLIN) != 0)
                fromHost();
            if ((states[1].revents & POLLIN) != 0)
                pass(m_terminal, m_master);
        }
    }

    static ssize_t pass(int from, int to)
    {
        char chunk[512];
        const ssize_t got = read(from, chunk, sizeof chunk);
        return got > 0 ? write(to, chunk, std::size_t(got)) : got;
    }

    /// The program says one frame at a time and waits for its answer.
    void fromHost()
    {
        unsigned char frame[512];
        const ssize_t got = read(m_master, frame, sizeof frame);
        if (got <= 0 || m_killed)
            return;
        const auto rate = transport::ttySpeed(m_slave);
        if (rate && transport::ttySpeed(m_terminal) != rate)
            transport::setTtySpeed(m_terminal, *rate);
        constexpr unsigned char writeInstruction = 3;
        const bool writes =
            got > 5 && frame[0] == 0xFF && frame[1] == 0xFF && frame[4] == writeInstruction;
        interrupt(writes ? frame[5] : -1);
        constexpr ssize_t blockSize = 70;
        const bool isBlock = got == blockSize && frame[1] == (frame[0] ^ 0xFF);
        const bool here = m_point && ((writes && frame[5] == m_point->address) ||
                                      (isBlock && frame[0] == m_point->block));
        if ((!here || m_point->delivered) && write(m_terminal, frame, std::size_t(got)) != got)
            qFatal("terminal");
        if (!here)
            return;
        kill(m_program, SIGKILL);
        m_killed = true;
    }

    void interrupt(int address)
    {
        if (!m_interrupt || m_interrupt->times == 0)
            return;
        if (!m_interrupted && (address != m_interrupt->address || m_interrupt->skip-- > 0))
            return;
        m_interrupted = true;
        --m_interrupt->times;
        kill(m_program, SIGINT);
    }

    int m_terminal;
    int m_master = -1;
    int m_slave = -1;
    QString m_port;
    std::atomic<bool> m_over{false};
    std::mutex m_mutex;
    std::optional<KillPoint> m_point;
    pid_t m_program = 0;
    bool m_killed = false;
    std::optional<InterruptPoint> m_interrupt;
    bool m_interrupted = false;
    std::thread m_thread;
};
} // namespace support
