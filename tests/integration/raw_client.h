// SPDX-License-Identifier: GPL-3.0-or-later
// A scripted client that knows nothing of ours: opens a terminal with POSIX calls, writes bytes,
// polls, reads bytes. And servodesk-sim as a program under test. POSIX only.
#pragma once

#include "support/held_port_name.h"
#include "support/simulator_priority.h"
#include "support/test_paths.h"

#include <QProcess>
#include <QStringList>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace raw {
constexpr int timeoutMs = 20'000;

inline QByteArray bytes(const char* hex)
{
    return QByteArray::fromHex(hex);
}

class Client {
public:
    explicit Client(const QString& path, speed_t rate = B1000000)
    {
        m_port = open(qPrintable(path), O_RDWR | O_NOCTTY | O_CLOEXEC);
        setRate(rate);
    }
    ~Client() { leave(); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool isOpen() const { return m_port >= 0; }
    void leave()
    {
        if (m_port >= 0)
            close(m_port);
        m_port = -1;
    }

    void setRate(speed_t rate)
    {
        termios settings{};
        tcgetattr(m_port, &settings);
        cfmakeraw(&settings);
        cfsetspeed(&settings, rate);
        tcsetattr(m_port, TCSANOW, &settings);
    }

    void send(const QByteArray& frame) const
    {
        if (write(m_port, frame.constData(), static_cast<std::size_t>(frame.size())) !=
            frame.size())
            qFatal("write");
    }

    bool readable(int waitMs) const
    {
        pollfd state{m_port, POLLIN, 0};
        return poll(&state, 1, waitMs) > 0;
    }

    /// Exactly `count` bytes, or what there is when patience ends: nothing new for so long.
    QByteArray receive(qsizetype count, int waitMs = timeoutMs) const
    {
        QByteArray all;
        while (all.size() < count && readable(waitMs)) {
            char chunk[512];
            const auto room =
                std::min<std::size_t>(sizeof chunk, static_cast<std::size_t>(count - all.size()));
            const ssize_t got = read(m_port, chunk, room);
            if (got <= 0)
                break;
            all.append(chunk, got);
        }
        return all;
    }

    QByteArray ask(const char* requestHex, qsizetype replyBytes) const
    {
        send(bytes(requestHex));
        return receive(replyBytes);
    }

    /// Repeats a harmless request while nobody answers: a servo is deaf while it starts. Through a
    /// slow adapter a reply to the program before may still come: one of another length is not the
    /// answer.
    QByteArray requestUntilReply(const char* requestHex, qsizetype replyBytes) const
    {
        constexpr int lateMs = 200;
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeoutMs);
        while (std::chrono::steady_clock::now() < end) {
            send(bytes(requestHex));
            const QByteArray reply = receive(replyBytes, lateMs);
            if (reply.size() == replyBytes && reply[3] + 4 == replyBytes)
                return reply;
            while (readable(lateMs) && !receive(1, 0).isEmpty()) {
            }
        }
        return {};
    }

private:
    int m_port = -1;
};

class Simulator {
public:
    explicit Simulator(const QStringList& arguments)
    {
        support::raisePriority(m_process);
        m_process.start(QStringLiteral(BIN_DIR "/servodesk-sim"), arguments);
        while (m_process.waitForReadyRead(timeoutMs) && !m_process.canReadLine()) {
        }
        m_firstLine = QString::fromLocal8Bit(m_process.readLine());
    }
    ~Simulator() { end(); }

    QString firstLine() const { return m_firstLine; }
    QString port() const { return m_firstLine.mid(6).trimmed(); }
    qint64 pid() const { return m_process.processId(); }

    /// SIGTERM unless it has ended already; the exit code, -1 for a crash.
    int end(int signal = SIGTERM)
    {
        if (m_process.state() != QProcess::NotRunning) {
            m_name.emplace(port());
            kill(static_cast<pid_t>(m_process.processId()), signal);
        }
        return wait();
    }
    int wait()
    {
        if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(timeoutMs))
            return -1;
        return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
    }
    /// A line for its standard input.
    void sendLine(const char* line)
    {
        m_process.write(line);
        m_process.write("\n");
    }
    /// The next line it says after the first; empty when patience ends.
    QString nextLine()
    {
        while (!m_process.canReadLine() && m_process.waitForReadyRead(timeoutMs)) {
        }
        return QString::fromUtf8(m_process.readLine()).trimmed();
    }
    QString complaint() { return QString::fromUtf8(m_process.readAllStandardError()); }

private:
    QProcess m_process;
    QString m_firstLine;
    std::optional<support::HeldPortName> m_name; ///< once it has ended
};
} // namespace raw
