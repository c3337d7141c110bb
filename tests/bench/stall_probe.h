// SPDX-License-Identifier: GPL-3.0-or-later
// How long the main thread was busy: a timer that notes how late each of its ticks comes. And an
// event loop as the program has it. For benches of the window; main thread.
#pragma once

#include <QEventLoop>
#include <QTextStream>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <vector>

namespace bench {
using Clock = std::chrono::steady_clock;
inline double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

inline double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[values.size() / 2];
}

/// An event loop as the program has it; QTest::qWait sleeps in between.
inline void runEventLoop(int ms)
{
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Notes how late each tick of a busy timer comes.
class StallProbe : public QObject {
public:
    StallProbe()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(std::chrono::milliseconds(1));
        connect(&m_timer, &QTimer::timeout, this, [this] {
            m_gaps.push_back(since(m_last));
            m_last = Clock::now();
        });
        m_last = Clock::now();
        m_timer.start();
    }
    void report(QTextStream& out, const char* what)
    {
        m_timer.stop();
        std::sort(m_gaps.begin(), m_gaps.end());
        out << what << ": main thread busy p50 " << m_gaps[m_gaps.size() / 2] << " ms, p99 "
            << m_gaps[m_gaps.size() * 99 / 100] << " ms, longest " << m_gaps.back()
            << " ms (wanted p99 <= 16)\n";
    }

private:
    QTimer m_timer;
    Clock::time_point m_last;
    std::vector<double> m_gaps;
};

} // namespace bench
