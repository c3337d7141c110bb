// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sim_fixture.h"

#include "device/reader.h"
#include "protocol/codec.h"
#include "sim/host/presets.h"

#include <QtGlobal>

#include <algorithm>

namespace support {
namespace {
constexpr std::size_t idPlace = 2;
constexpr std::size_t lengthPlace = 3;
constexpr std::size_t instructionPlace = 4; ///< of Feetech, and the command of LX
constexpr std::size_t functionPlace = 1;    ///< of Modbus

/// Feetech packets and LX packets begin with the same byte twice, Modbus frames with the station.
bool begins(const base::Bytes& frame, std::uint8_t header)
{
    return frame.size() > instructionPlace && frame[0] == header && frame[1] == header;
}

bool isReadOnlyFrame(const base::Bytes& frame)
{
    if (frame == base::Bytes{'1', 'f', 'B', 'V', 'A'}) // asks a bootloader; it starts nothing
        return true;
    const auto is = [](std::uint8_t code, std::initializer_list<int> codes) {
        return std::find(codes.begin(), codes.end(), code) != codes.end();
    };
    if (begins(frame, 0xFF))
        return is(frame[instructionPlace], {Ping, Read, SyncRead});
    if (begins(frame, 0x55)) // without parameters: a read, start, stop, or save the offset
        return frame[lengthPlace] == 3 && !is(frame[instructionPlace], {11, 12, 18});
    return frame.size() > functionPlace && is(frame[functionPlace], {0x03, 0x11});
}

std::unique_ptr<sim::VirtualBus> checked(base::Result<std::unique_ptr<sim::VirtualBus>> made)
{
    if (!made)
        qFatal("no such bus: %s", qPrintable(made.error().detail));
    return std::move(*made);
}

std::unique_ptr<sim::VirtualBus> makeVirtualBus(const QString& servos,
                                                const SimFixtureOptions& options)
{
    const catalog::Catalog& models = builtInCatalog();
    return checked(sim::presetNames().contains(servos)
                       ? sim::makePreset(servos, models, options.wire, options.servoBaud)
                       : sim::makeServos(servos, models, options.servoBaud, options.wire));
}
} // namespace

const catalog::Catalog& builtInCatalog()
{
    static const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    return catalog;
}

sim::FirmwareBehavior strictFirmware()
{
    const QByteArray chosen = qgetenv("SERVODESK_TEST_FIRMWARE");
    if (chosen == "default")
        return {};
    if (!chosen.isEmpty())
        qFatal("no such firmware: %s", chosen.constData());
    sim::FirmwareBehavior strict;
    strict.deafWhileWriting = true;
    strict.acknowledgesWithNewId = true;
    strict.runsToOldGoal = true;
    return strict;
}

// Overloads, not default arguments: GCC 12 takes the members of a default SimFixtureOptions that it
// destroys inline in a caller for uninitialized.
SimFixture::SimFixture(const QString& servos)
    : SimFixture(servos, SimFixtureOptions())
{}

SimFixture::SimFixture(const std::vector<sim::ServoSpec>& servos)
    : SimFixture(servos, SimFixtureOptions())
{}

SimFixture::SimFixture(const QString& servos, const SimFixtureOptions& options)
    : SimFixture(makeVirtualBus(servos, options), options)
{}

SimFixture::SimFixture(const std::vector<sim::ServoSpec>& servos, const SimFixtureOptions& options)
    : SimFixture(checked(sim::makeBus(servos, builtInCatalog(), options.wire, std::nullopt)),
                 options)
{}

SimFixture::SimFixture(std::unique_ptr<sim::VirtualBus> wire, const SimFixtureOptions& options)
    : m_wire(std::make_shared<sim::SharedBus>(std::move(wire)))
{
    withBus([&options](sim::VirtualBus& bus) {
        for (sim::VirtualServo* servo : bus.servos())
            servo->behavior() = options.firmware;
    });
    reconnect(options.baud);
}

device::Context SimFixture::context()
{
    return {*m_bus, builtInCatalog(), m_journal, *m_stop, m_notices};
}

std::int64_t SimFixture::raw(int id, const QString& key)
{
    return withBus([&](sim::VirtualBus& wire) { return wire.servo(id)->raw(key); });
}

void SimFixture::poke(int id, const QString& key, std::int64_t raw)
{
    withBus([&](sim::VirtualBus& wire) { wire.servo(id)->poke(key, raw); });
}

sim::WireConfig& SimFixture::wireConfig()
{
    return *withBus([](sim::VirtualBus& wire) { return &wire.config(); });
}

void SimFixture::runFor(base::Duration span)
{
    m_clock.advance(span);
    withBus([this](sim::VirtualBus& wire) { return wire.hostReads(m_clock.now()); });
}

void SimFixture::powerCycle()
{
    withBus([](sim::VirtualBus& wire) { wire.powerCycle(); });
}

void SimFixture::cutLink()
{
    withBus([](sim::VirtualBus& wire) { wire.cutLink(); });
}

void SimFixture::cutAfterHostBytes(std::size_t count)
{
    withBus([count](sim::VirtualBus& wire) { wire.cutAfterHostBytes(count); });
}

void SimFixture::restoreLink()
{
    withBus([](sim::VirtualBus& wire) { wire.restoreLink(); });
}

void SimFixture::reconnect(int baud)
{
    withBus([](sim::VirtualBus& wire) { wire.restoreLink(); });
    m_bus.reset();
    m_stop = std::make_unique<base::StopToken>();
    m_notices.clear();
    const auto open = [this, baud]() -> base::Result<std::unique_ptr<transport::Link>> {
        if (m_tap.onOpen)
            m_tap.onOpen();
        return tapped(sim::makeSimLink(m_wire, QStringLiteral("sim:bench"), m_clock, baud), m_tap);
    };
    m_bus = std::make_unique<bus::BusCore>(*open(), protocol::feetechCodec(), m_clock,
                                           bus::CoreOptions{10, nullptr, open});
    clearFrames();
}

int SimFixture::frames(std::uint8_t instruction) const
{
    return int(std::count_if(m_tap.written.begin(), m_tap.written.end(), [&](const auto& frame) {
        return begins(frame, 0xFF) && frame[instructionPlace] == instruction;
    }));
}

int SimFixture::framesSentTo(int id) const
{
    return int(std::count_if(m_tap.written.begin(), m_tap.written.end(), [&](const auto& frame) {
        return frame.size() > idPlace && frame[idPlace] == id;
    }));
}

bool SimFixture::onlyReadsSent() const
{
    return std::all_of(m_tap.written.begin(), m_tap.written.end(), isReadOnlyFrame);
}

device::Servo SimFixture::servo(int id, base::Protocol protocol)
{
    auto found = device::identify(context(), id, protocol);
    if (found && !device::readSettings(context(), *found))
        qFatal("servo %d does not tell its settings", id);
    if (!found)
        qFatal("servo %d does not answer", id);
    return *found;
}

bool SimFixture::hasNotice(device::NoticeCode code) const
{
    return std::any_of(m_notices.begin(), m_notices.end(),
                       [code](const device::Notice& notice) { return notice.code == code; });
}

double SimFixture::shaft(int id)
{
    return withBus([id](sim::VirtualBus& wire) { return wire.servo(id)->shaftDegrees(); });
}
} // namespace support
