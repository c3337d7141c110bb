// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sim_bag.h"

#include <QByteArrayList>
#include <QtGlobal>

#include <atomic>
#include <csignal>

#ifdef Q_OS_UNIX
#include <poll.h>
#include <unistd.h>
#endif

namespace session {
namespace {
std::atomic<int> nextAsked{0};

extern "C" void askForNext(int)
{
    nextAsked.fetch_add(1);
}

void onNextSignal(void (*handler)(int))
{
#ifdef SIGUSR1
    std::signal(SIGUSR1, handler);
#else
    (void)handler;
#endif
}

/// What stands there now; nullopt: nothing more will come. Who is in the background of a terminal
/// must not ask it.
std::optional<QByteArray> standardInput()
{
#ifdef Q_OS_UNIX
    if (isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) != getpgrp())
        return QByteArray();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 0) <= 0)
        return QByteArray();
    char bytes[256];
    const auto count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0)
        return std::nullopt;
    return QByteArray(bytes, static_cast<qsizetype>(count));
#else
    return std::nullopt;
#endif
}
} // namespace

SimBag::SimBag(sim::VirtualBus& bus, std::function<void(const QString&)> tell)
    : m_bus(bus)
    , m_tell(std::move(tell))
    , m_inputOpen(bus.isBag())
{
    if (m_bus.isBag())
        onNextSignal(askForNext);
}

SimBag::~SimBag()
{
    if (m_bus.isBag())
        onNextSignal(SIG_DFL);
}

void SimBag::look()
{
    if (!m_bus.isBag())
        return;
    for (int asked = nextAsked.exchange(0); asked > 0; --asked)
        next();
    if (m_inputOpen)
        readInput();
}

void SimBag::readInput()
{
    const auto bytes = standardInput();
    m_inputOpen = bytes.has_value();
    m_input += bytes.value_or(QByteArray("\n"));
    for (auto end = m_input.indexOf('\n'); end >= 0; end = m_input.indexOf('\n')) {
        const QByteArray line = m_input.left(end).simplified();
        m_input.remove(0, end + 1);
        if (!line.isEmpty())
            obey(line);
    }
}

void SimBag::obey(const QByteArray& line)
{
    const auto words = line.split(' ');
    bool ok = false;
    const int place = words.size() == 2 ? words[1].toInt(&ok) : 0;
    if (line == "next") {
        next();
    } else if (line == "unplug") {
        m_bus.unplugAll();
        m_tell(QStringLiteral("unplugged"));
    } else if (words[0] == "plug" && ok && place >= 1 && place <= int(m_bus.servos().size())) {
        m_bus.plug(static_cast<std::size_t>(place - 1));
        sayPlugged(static_cast<std::size_t>(place - 1));
    } else {
        m_tell(QStringLiteral("not understood: %1").arg(QString::fromUtf8(line)));
    }
}

void SimBag::next()
{
    if (const auto place = m_bus.plugNext())
        sayPlugged(*place);
    else
        m_tell(QStringLiteral("unplugged; the bag is empty"));
}

void SimBag::sayPlugged(std::size_t place)
{
    const auto servos = m_bus.servos();
    m_tell(QStringLiteral("plugged: %1 (%2 of %3)")
               .arg(servos[place]->profile().modelName)
               .arg(place + 1)
               .arg(servos.size()));
}
} // namespace session
