// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sim_bag.h"

#include <QByteArrayList>

#include <atomic>
#include <csignal>

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
} // namespace

SimBag::SimBag(sim::VirtualBus& bus, std::function<void(const QString&)> tell)
    : m_bus(bus)
    , m_tell(std::move(tell))
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
    for (auto line = m_input.take(); line; line = m_input.take()) {
        if (!line->isEmpty())
            obey(*line);
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
