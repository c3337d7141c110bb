// SPDX-License-Identifier: GPL-3.0-or-later
// While it exists, sessions that are created run in real time. For a test with a port that is not
// simulated, and for one that needs a verdict or readings without a gap: at four times the speed, a
// loaded computer reads too seldom for that. Main thread.
#pragma once

#include <QByteArray>

namespace support {
class RealTime {
public:
    RealTime() { qputenv(name, "1"); }
    ~RealTime()
    {
        if (m_before.isNull())
            qunsetenv(name);
        else
            qputenv(name, m_before);
    }
    RealTime(const RealTime&) = delete;
    RealTime& operator=(const RealTime&) = delete;

private:
    static constexpr const char* name = "SERVODESK_CLOCK_SPEED";
    const QByteArray m_before = qgetenv(name);
};
} // namespace support
