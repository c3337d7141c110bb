// SPDX-License-Identifier: GPL-3.0-or-later
// The system gives the number of a closed pseudo-terminal to the next program that asks, which may
// be another test's. As long as this lives it does not. To be made before the terminal is closed.
// POSIX only.
#pragma once

#include <QString>

#include <fcntl.h>
#include <unistd.h>

namespace support {
class HeldPortName {
public:
    explicit HeldPortName(const QString& port)
        : m_slave(open(qPrintable(port), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
    {}
    ~HeldPortName()
    {
        if (m_slave >= 0)
            close(m_slave);
    }
    HeldPortName(const HeldPortName&) = delete;
    HeldPortName& operator=(const HeldPortName&) = delete;

private:
    int m_slave;
};
} // namespace support
