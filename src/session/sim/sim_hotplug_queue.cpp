// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sim/sim_hotplug_queue.h"

#include <QByteArrayList>

#include <atomic>
#include <csignal>

namespace session {
namespace {
std::atomic<int> nextRequested{0};

extern "C" void requestNext(int)
{
    nextRequested.fetch_add(1);
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

SimHotplugQueue::SimHotplugQueue(sim::VirtualBus& bus, std::function<void(const QString&)> log)
    : m_bus(bus)
    , m_log(std::move(log))
{
    if (m_bus.hasHotplugQueue())
        onNextSignal(requestNext);
}

SimHotplugQueue::~SimHotplugQueue()
{
    if (m_bus.hasHotplugQueue())
        onNextSignal(SIG_DFL);
}

void SimHotplugQueue::poll()
{
    if (!m_bus.hasHotplugQueue())
        return;
    for (int asked = nextRequested.exchange(0); asked > 0; --asked)
        next();
    for (auto line = m_input.readLine(); line; line = m_input.readLine()) {
        if (!line->isEmpty())
            execute(*line);
    }
}

void SimHotplugQueue::execute(const QByteArray& line)
{
    const auto fields = line.split(' ');
    bool ok = false;
    const int index = fields.size() == 2 ? fields[1].toInt(&ok) : 0;
    if (line == "next") {
        next();
    } else if (line == "unplug") {
        m_bus.unplugAll();
        m_log(QStringLiteral("unplugged"));
    } else if (fields[0] == "plug" && ok && index >= 1 && index <= int(m_bus.servos().size())) {
        m_bus.plug(static_cast<std::size_t>(index - 1));
        reportPlugged(static_cast<std::size_t>(index - 1));
    } else {
        m_log(QStringLiteral("not understood: %1").arg(QString::fromUtf8(line)));
    }
}

void SimHotplugQueue::next()
{
    if (const auto index = m_bus.connectNext())
        reportPlugged(*index);
    else
        m_log(QStringLiteral("unplugged; the bag is empty"));
}

void SimHotplugQueue::reportPlugged(std::size_t index)
{
    const auto servos = m_bus.servos();
    m_log(QStringLiteral("plugged: %1 (%2 of %3)")
              .arg(servos[index]->profile().modelName)
              .arg(index + 1)
              .arg(servos.size()));
}
} // namespace session
