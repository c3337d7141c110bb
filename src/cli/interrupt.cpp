// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"

#include <QtGlobal>

#include <chrono>
#include <csignal>

#ifdef Q_OS_UNIX
#include <pthread.h>
#endif

namespace cli {
#ifdef Q_OS_UNIX
namespace {
constexpr auto lockGracePeriod = std::chrono::seconds(2);

sigset_t endingSignals()
{
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP})
        sigaddset(&set, signal);
    return set;
}

/// By the signal itself, so that the shell sees what ended the program. _exit is no alternative:
/// that of a sanitizer flushes stdout first, and the program may hang in just that.
void exitBySignal(int signal)
{
    std::signal(signal, SIG_DFL);
    const sigset_t set = endingSignals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    pthread_kill(pthread_self(), signal);
}
} // namespace

Interrupt::Interrupt()
{
    // A reader that ends ("| head") must not kill the program while an EPROM is unlocked.
    std::signal(SIGPIPE, SIG_IGN);
    // Nor must a file size limit; the write fails instead.
    std::signal(SIGXFSZ, SIG_IGN);
    const sigset_t set = endingSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    m_receiver = std::thread(&Interrupt::receive, this);
}

Interrupt::~Interrupt()
{
    m_ending = true;
    pthread_kill(m_receiver.native_handle(), SIGTERM);
    m_receiver.join();
}

void Interrupt::receive()
{
    const sigset_t set = endingSignals();
    int signal = 0;
    if (sigwait(&set, &signal) != 0 || m_ending)
        return;
    m_stop.request();
    const auto lastMoment = std::chrono::steady_clock::now() + lockGracePeriod;
    if (sigwait(&set, &signal) != 0 || m_ending)
        return;
    while (std::chrono::steady_clock::now() < lastMoment && !m_ending)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (!m_ending)
        exitBySignal(signal);
}
#else
namespace {
base::StopToken* stopOfProgram = nullptr;

// The system calls this on its own thread.
void requestStop(int)
{
    stopOfProgram->request();
}
} // namespace

Interrupt::Interrupt()
{
    stopOfProgram = &m_stop;
    std::signal(SIGINT, requestStop);
    std::signal(SIGTERM, requestStop);
}

Interrupt::~Interrupt() = default;

void Interrupt::receive() {}
#endif
} // namespace cli
