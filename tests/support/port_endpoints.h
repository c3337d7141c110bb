// SPDX-License-Identifier: GPL-3.0-or-later
// What the program under test opens: a terminal, or a TCP port on 127.0.0.1. What is made here is
// the caller's to close. POSIX only.
#pragma once

#include <QString>

#include <arpa/inet.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

namespace support {
inline void makeRaw(int terminal)
{
    termios settings{};
    tcgetattr(terminal, &settings);
    cfmakeraw(&settings);
    tcsetattr(terminal, TCSANOW, &settings);
}

/// While `slave` is open the rate can be read, and the line stays up when a program leaves.
struct Terminal {
    int master = -1;
    int slave = -1;
    QString port; ///< to be opened by the program
};

/// Raw; `flags` of the master besides O_RDWR, O_NOCTTY and O_CLOEXEC.
inline Terminal makeTerminal(int flags = 0)
{
    Terminal made;
    made.master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | flags);
    if (made.master < 0 || grantpt(made.master) != 0 || unlockpt(made.master) != 0)
        qFatal("no terminal");
    made.port = QString::fromLocal8Bit(ptsname(made.master));
    made.slave = open(qPrintable(made.port), O_RDWR | O_NOCTTY | O_CLOEXEC);
    makeRaw(made.slave);
    return made;
}

struct TcpPort {
    int listener = -1;
    quint16 number = 0;
    QString port; ///< "tcp://127.0.0.1:…"
};

/// `flags` of the socket besides SOCK_CLOEXEC; `waiting`: connections before they are accepted;
/// `number`: of a port that was closed just now; 0: a free one.
inline TcpPort listenOnLoopback(int flags = 0, int waiting = 1, quint16 number = 0)
{
    TcpPort made;
    made.listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | flags, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(number);
    const int on = 1;
    setsockopt(made.listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    socklen_t size = sizeof address;
    if (bind(made.listener, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(made.listener, waiting) != 0 ||
        getsockname(made.listener, reinterpret_cast<sockaddr*>(&address), &size) != 0)
        qFatal("no TCP port");
    made.number = ntohs(address.sin_port);
    made.port = QStringLiteral("tcp://127.0.0.1:%1").arg(made.number);
    return made;
}
} // namespace support
