// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/host/sim_link.h"

#include <algorithm>

namespace sim {
namespace {
/// The system wakes a sleeper some ten microseconds late; the rest of the way is spun.
constexpr base::Duration spinTime{60};

class SimLink final : public transport::Link {
public:
    SimLink(std::shared_ptr<SharedBus> bus, QString name, base::Clock& clock, int baud)
        : m_bus(std::move(bus))
        , m_name(std::move(name))
        , m_clock(clock)
        , m_baud(baud)
    {
        m_bus->with([&](VirtualBus& wire) {
            wire.setHostBaud(baud);
            wire.hostReads(m_clock.now());
            m_lost = wire.linkCut();
        });
    }

    base::Result<void> write(base::ByteView bytes) override
    {
        const bool alive = m_bus->with([&](VirtualBus& wire) {
            if (detectLoss(wire))
                return false;
            wire.hostWrites(bytes, m_baud, m_clock.now());
            return true;
        });
        if (!alive)
            return lostError(QStringLiteral("write"));
        return {};
    }

    base::Result<std::size_t> read(base::Bytes& buffer) override
    {
        collect();
        if (m_lost)
            return lostError(QStringLiteral("read"));
        const std::size_t count = m_arrived.size();
        buffer.insert(buffer.end(), m_arrived.begin(), m_arrived.end());
        m_arrived.clear();
        return count;
    }

    base::Result<bool> waitForReadyRead(base::Duration span) override
    {
        const base::Duration deadline = m_clock.now() + span;
        for (;;) {
            collect();
            if (m_lost)
                return lostError(QStringLiteral("read"));
            if (!m_arrived.empty())
                return true;
            if (m_clock.now() >= deadline)
                return false;
            const auto due =
                m_bus->with([deadline](VirtualBus& wire) { return wire.nextHostRun(deadline); });
            waitUntil(due.value_or(deadline), due.has_value());
        }
    }

    base::Result<void> setBaud(int baud) override
    {
        if (m_lost)
            return lostError(QStringLiteral("set-baud"));
        if (baud <= 0)
            return base::fail(base::ErrorCode::RateUnsupported, QStringLiteral("set-baud"),
                              QString::number(baud));
        m_baud = baud;
        m_bus->with([baud](VirtualBus& wire) { wire.setHostBaud(baud); });
        return {};
    }

    int baud() const override { return m_baud; }
    QString name() const override { return m_name; }

private:
    bool detectLoss(const VirtualBus& wire)
    {
        m_lost = m_lost || wire.linkCut();
        return m_lost;
    }

    void collect()
    {
        m_bus->with([this](VirtualBus& wire) {
            if (detectLoss(wire))
                return;
            const auto bytes = wire.hostReads(m_clock.now());
            m_arrived.insert(m_arrived.end(), bytes.begin(), bytes.end());
        });
    }

    void waitUntil(base::Duration instant, bool precise)
    {
        if (m_clock.isManual() || !precise) {
            m_clock.sleepUntil(instant);
            return;
        }
        if (instant - m_clock.now() > spinTime)
            m_clock.sleepUntil(instant - spinTime);
        while (m_clock.now() < instant) {
        }
    }

    tl::unexpected<base::Error> lostError(const QString& operation) const
    {
        return base::fail(base::ErrorCode::LinkLost, operation, m_name);
    }

    std::shared_ptr<SharedBus> m_bus;
    QString m_name;
    base::Clock& m_clock;
    int m_baud;
    bool m_lost = false;
    base::Bytes m_arrived;
};
} // namespace

std::unique_ptr<transport::Link> makeSimLink(std::shared_ptr<SharedBus> bus, QString name,
                                             base::Clock& clock, int baud)
{
    return std::make_unique<SimLink>(std::move(bus), std::move(name), clock, baud);
}
} // namespace sim
