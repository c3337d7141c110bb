// SPDX-License-Identifier: GPL-3.0-or-later
// The test bench of the integration tests: a virtual bus behind a simulated port, a BusCore on a
// manual clock, an in-memory journal, the built-in catalog. Everything on the test's thread; hours
// pass in seconds. What servos really hold is asked of the simulator, past the wire.
#pragma once

#include "bus/bus_core.h"
#include "catalog/catalog.h"
#include "device/context.h"
#include "device/servo.h"
#include "sim/host/sim_link.h"
#include "sim/servo/servo_spec.h"
#include "support/link_tap.h"
#include "support/memory_journal.h"

namespace support {
/// The built-in models and maps, loaded once.
const catalog::Catalog& builtInCatalog();

/// Feetech instruction codes of the frames a test counts.
enum Instruction : std::uint8_t {
    Ping = 0x01,
    Read = 0x02,
    Write = 0x03,
    RegWrite = 0x04,
    Action = 0x05,
    Restore = 0x06,
    Reboot = 0x08,
    Calibrate = 0x0B,
    SyncRead = 0x82,
    SyncWrite = 0x83,
};

/// The firmware that is hardest for a host: it loses requests while it writes its EPROM,
/// acknowledges an ID change with the new ID, and runs to an old goal when its torque is turned on.
/// Tests of the host use it to prove that the host copes. With SERVODESK_TEST_FIRMWARE=default they
/// use the simulator's default; tests/CMakeLists.txt names those that are run both ways.
sim::FirmwareBehavior strictFirmware();

struct SimFixtureOptions {
    int baud = 1'000'000;           ///< of the port
    std::optional<int> servoBaud{}; ///< of all servos; their factory rates if not given
    sim::WireConfig wire{};
    sim::FirmwareBehavior firmware = strictFirmware(); ///< of all servos
};

class SimFixture {
public:
    /// A preset's name or a list "sts3215@1,scs15@2"; the test fails hard if it is neither.
    explicit SimFixture(const QString& servos);
    SimFixture(const QString& servos, const SimFixtureOptions& options);
    explicit SimFixture(const std::vector<sim::ServoSpec>& servos);
    SimFixture(const std::vector<sim::ServoSpec>& servos, const SimFixtureOptions& options);

    device::Context context();
    bus::BusCore& bus() { return *m_bus; }
    base::ManualClock& clock() { return m_clock; }
    base::StopToken& stop() { return *m_stop; }
    MemoryJournal& journal() { return m_journal; }
    device::Notices& notices() { return m_notices; }
    bool hasNotice(device::NoticeCode code) const;
    double shaft(int id); ///< degrees
    LinkTap& tap() { return m_tap; }

    /// The virtual bus, for what has no helper below.
    template <typename Function>
    decltype(auto) withBus(Function&& function)
    {
        return m_wire->with(std::forward<Function>(function));
    }

    std::int64_t raw(int id, const QString& key);
    void poke(int id, const QString& key, std::int64_t raw);
    sim::WireConfig& wireConfig();

    void runFor(base::Duration span); ///< without any traffic
    void powerCycle();                ///< of the servos; the port stays open
    void cutLink();
    void restoreLink(); ///< the plug is back: a bus that awaits it finds it
    void cutAfterHostBytes(std::size_t count);
    /// The cable is back and the port opened again: new link, new bus, new stop, no notices. The
    /// journal stays.
    void reconnect(int baud);

    /// Frames the host has written since the port was opened (and its echo probed) or since
    /// clearFrames().
    int frames(std::uint8_t instruction) const;
    int framesSentTo(int id) const;
    std::size_t frameCount() const { return m_tap.written.size(); }
    void clearFrames() { m_tap.written.clear(); }
    /// True when nothing was sent that could change a servo.
    bool onlyReadsSent() const;

    /// The servo at `id`, with its settings read; the test fails hard if none answers.
    device::Servo servo(int id, base::Protocol protocol = base::Protocol::Feetech);

private:
    SimFixture(std::unique_ptr<sim::VirtualBus> wire, const SimFixtureOptions& options);

    base::ManualClock m_clock;
    std::shared_ptr<sim::SharedBus> m_wire;
    LinkTap m_tap;
    MemoryJournal m_journal;
    device::Notices m_notices;
    std::unique_ptr<base::StopToken> m_stop;
    std::unique_ptr<bus::BusCore> m_bus;
};
} // namespace support
