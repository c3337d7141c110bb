// SPDX-License-Identifier: GPL-3.0-or-later
// A pseudo-terminal for the transport tests: `path` is the port under test, `master` the far end of
// its cable. POSIX only. dropConnection() unplugs it; its name stays taken.
#pragma once

#include "support/held_port_name.h"

#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <stdlib.h>
#include <string>
#include <unistd.h>

class PtyPair {
public:
    PtyPair()
    {
        master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        grantpt(master);
        unlockpt(master);
        path = QString::fromLocal8Bit(ptsname(master));
    }
    ~PtyPair() { dropConnection(); }
    PtyPair(const PtyPair&) = delete;
    PtyPair& operator=(const PtyPair&) = delete;

    void dropConnection()
    {
        if (master < 0)
            return;
        m_name = std::make_unique<support::HeldPortName>(path);
        close(master);
        master = -1;
    }

    void send(const std::string& bytes) const
    {
        if (write(master, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            qFatal("pty write");
    }

    /// Whatever has come through, at least `count` bytes.
    std::string receive(std::size_t count) const
    {
        std::string all;
        char chunk[256];
        pollfd state{master, POLLIN, 0};
        while (all.size() < count && poll(&state, 1, 5000) > 0) {
            const ssize_t got = ::read(master, chunk, sizeof chunk);
            if (got <= 0)
                break;
            all.append(chunk, static_cast<std::size_t>(got));
        }
        return all;
    }

    int master = -1;
    QString path;

private:
    std::unique_ptr<support::HeldPortName> m_name;
};
