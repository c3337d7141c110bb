// SPDX-License-Identifier: GPL-3.0-or-later
// A cable between a program and the simulator's terminal that can be cut: a terminal of its own,
// which hangs up, or a TCP bridge, whose link drops. The servos keep their power. The terminal has
// a name of its own, because the system gives its own name at once to the next program that asks.
// It counts the Feetech frames of the program that change something. A thread of its own;
// everything else from the test's. POSIX only.
#pragma once

#include "support/port_endpoints.h"
#include "support/sim_fixture.h"
#include "support/simulator_priority.h"
#include "transport/tty_speed.h"

#include <QFile>
#include <QTemporaryDir>

#include <atomic>
#include <mutex>
#include <netinet/tcp.h>
#include <poll.h>
#include <thread>

namespace support {
class CutCable {
public:
    CutCable(const QString& terminal, bool tcp)
        : m_terminal(open(qPrintable(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        makeRaw(m_terminal);
        transport::setTtySpeed(m_terminal, 1'000'000);
        if (tcp)
            listenForClient();
        else
            openTerminal();
        m_thread = std::thread([this] {
            support::raisePriority();
            serve();
        });
    }
    ~CutCable()
    {
        cut();
        m_over = true;
        m_thread.join();
        if (m_slave >= 0)
            close(m_slave);
    }
    CutCable(const CutCable&) = delete;
    CutCable& operator=(const CutCable&) = delete;

    QString port() const { return m_port; }
    /// Frames so far that are neither a PING nor a read.
    int writes() const { return m_writes; }

    /// Also releases the servos' side: a reader there gets every byte from now on.
    void cut()
    {
        const std::lock_guard lock(m_mutex);
        dropConnection();
    }
    /// Cuts instead of passing on the frame of that number among those writes() counts from now.
    void cutAtWrite(int number) { m_cutAt = m_writes + number; }
    /// The program's bytes are dropped from now on; the line stays up.
    void dropAll() { m_dropAll = true; }
    /// Frames with this instruction are lost from now on; 0: none.
    void dropInstruction(int instruction) { m_lost = instruction; }

private:
    void dropConnection()
    {
        if (!m_name.isEmpty())
            QFile::remove(m_name);
        for (int* side : {&m_host, &m_listener, &m_terminal}) { // m_slave keeps the port's number
            if (*side >= 0)
                close(*side);
            *side = -1;
        }
    }

    void openTerminal()
    {
        const Terminal terminal = makeTerminal();
        m_host = terminal.master;
        m_slave = terminal.slave; // held open, so that the rate can be asked for
        m_name = m_folder.filePath(QStringLiteral("port"));
        if (!QFile::link(terminal.port, m_name))
            qFatal("no name for the terminal");
        m_port = m_name;
    }

    void listenForClient()
    {
        const TcpPort tcp = listenOnLoopback();
        m_listener = tcp.listener;
        m_port = tcp.port;
    }

    void serve()
    {
        while (!m_over) {
            pollfd states[2] = {{-1, POLLIN, 0}, {-1, POLLIN, 0}};
            {
                const std::lock_guard lock(m_mutex);
                states[0].fd = m_host >= 0 ? m_host : m_listener;
                states[1].fd = m_terminal;
            }
            if (poll(states, 2, 2) <= 0)
                continue;
            const std::lock_guard lock(m_mutex);
            if (m_terminal < 0)
                continue; // cut meanwhile
            if ((states[0].revents & POLLIN) != 0 && m_host < 0 && m_listener >= 0)
                accept();
            else if ((states[0].revents & POLLIN) != 0 && m_host >= 0)
                fromHost();
            if ((states[1].revents & POLLIN) != 0 && m_terminal >= 0)
                fromServos();
        }
    }

    void accept()
    {
        m_host = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        const int on = 1;
        setsockopt(m_host, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    }

    void fromHost()
    {
        char chunk[512];
        const ssize_t got = read(m_host, chunk, sizeof chunk);
        if (got <= 0 && m_slave < 0) {
            close(m_host); // the program has closed the link
            m_host = -1;
        }
        if (got <= 0)
            return;
        if (m_dropAll)
            return;
        const QByteArray passed = passFrames(QByteArray(chunk, qsizetype(got)));
        if (m_cutAt > 0 && m_writes >= m_cutAt) {
            m_cutAt = 0;
            dropConnection();
            return;
        }
        const auto rate = m_slave >= 0 ? transport::ttySpeed(m_slave) : std::nullopt;
        if (rate && transport::ttySpeed(m_terminal) != rate)
            transport::setTtySpeed(m_terminal, *rate);
        if (!passed.isEmpty())
            (void)!write(m_terminal, passed.data(), std::size_t(passed.size()));
    }

    /// Without those that are to be lost. A program hands over whole frames, several at once if
    /// this thread was busy.
    QByteArray passFrames(const QByteArray& bytes)
    {
        constexpr qsizetype head = 6;
        const auto byteAt = [&](qsizetype index) { return int(std::uint8_t(bytes[index])); };
        QByteArray passed;
        qsizetype at = 0;
        while (at + head <= bytes.size() && byteAt(at) == 0xFF && byteAt(at + 1) == 0xFF) {
            const int instruction = byteAt(at + 4);
            const qsizetype size = byteAt(at + 3) + 4;
            if (instruction != Ping && instruction != Read && instruction != SyncRead)
                ++m_writes;
            if (instruction != m_lost)
                passed += bytes.mid(at, size);
            at += size;
        }
        return passed + bytes.mid(at);
    }

    void fromServos()
    {
        char chunk[512];
        const ssize_t got = read(m_terminal, chunk, sizeof chunk);
        if (got <= 0 || m_host < 0)
            return;
        if (m_slave >= 0)
            (void)!write(m_host, chunk, std::size_t(got));
        else
            (void)send(m_host, chunk, std::size_t(got), MSG_NOSIGNAL);
    }

    std::mutex m_mutex; ///< guards what follows, once the thread runs
    int m_terminal;
    int m_host = -1;
    int m_slave = -1;
    int m_listener = -1;
    QString m_port;
    QTemporaryDir m_folder;
    QString m_name{}; ///< of the terminal; none with TCP
    std::atomic<bool> m_over{false};
    std::atomic<int> m_writes{0};
    std::atomic<int> m_cutAt{0}; ///< 0: not
    std::atomic<int> m_lost{0};
    std::atomic<bool> m_dropAll{false};
    std::thread m_thread;
};
} // namespace support
