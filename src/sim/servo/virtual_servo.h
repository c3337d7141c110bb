// SPDX-License-Identifier: GPL-3.0-or-later
// One simulated servo: the firmware (ServoFirmware) and the request handler of its protocol. It
// receives decoded requests of its own protocol only; bytes, timing and collisions belong to the
// wire. Owned by a VirtualBus; one thread. Behavior follows the sheets: a write to the locked EPROM
// acts but is lost at power-off, the lock closes at every power-on, an LX servo stores every write.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "catalog/profile.h"
#include "sim/faults/defects.h"
#include "sim/servo/bootloader.h"
#include "sim/servo/reply_timing.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace sim {
/// What is attached to the output shaft. SI units, output side.
struct Load {
    double inertia = 2e-4;         ///< kg·m²
    double viscousFriction = 0.0;  ///< N·m·s/rad, of the load
    double coulombFriction = 0.0;  ///< N·m, of the load
    double gravityTorque = 0.0;    ///< N·m at 90° from hanging down, which is mid-range
    double springRate = 0.0;       ///< N·m/rad around springCenter
    double springCenter = 0.0;     ///< rad
    std::optional<double> stopLow; ///< rad, hard stops
    std::optional<double> stopHigh;
    /// rad/s: a hand turns the shaft back and forth between the stops while the bridge is open;
    /// without stops, on and on.
    double handSpeed = 0.0;
    bool operator==(const Load&) const = default;
};

/// Power supply and ambient temperature.
struct Environment {
    double supplyVolts = 7.4;
    double supplyOhms = 0.05;
    double ambientCelsius = 25.0;
};

/// Points where firmware is reported to behave in more than one way. The defaults are what existing
/// programs rely on; each alternative has been reported or cannot be ruled out, so a host has to
/// cope with it as well.
struct FirmwareBehavior {
    /// Receives nothing while it writes its EPROM. Default: it answers when the value is written,
    /// and requests that arrive meanwhile wait in its receive buffer. No sheet states the write
    /// time; LeRobot and the vendor's ProgramEprom write back to back and lose nothing.
    bool deafWhileWriting = false;
    /// The status packet of an ID change carries the new ID (fanhao375/microduck-replica PR 28).
    /// Default: the old one, which lerobot's setup_motor and the vendor's Python SDK expect.
    bool acknowledgesWithNewId = false;
    /// Torque on runs to the goal register although no goal was written since power-on. Default:
    /// it holds its position. lerobot's connect() switches torque on without a goal on every start
    /// of STS servos, and no report mentions a jump; assumed for the other families as well.
    bool runsToOldGoal = false;
    /// A new rate acts from the next power-on. Default: at once (both are reported).
    bool baudAfterRestart = false;
    /// Feetech: answers a broadcast PING in turn, 3 ms per ID, which is what lerobot's
    /// broadcast_ping waits for (3 ms × 252 + 16 ms). Default: at once; several servos collide.
    bool staggersBroadcastPing = false;
};

struct ServoConfig {
    int id = 1;
    std::optional<int> baud; ///< the model's factory rate if not given
    std::optional<int> returnDelayRaw;
    Load load;
    Environment environment;
    base::Duration epromTime = std::chrono::milliseconds(6); ///< to write its EPROM
    base::Duration rebootTime = std::chrono::milliseconds(820);
    Defects defects; ///< none
    double gearPlayDegrees = 0.3;
    double initialDegrees = 180.0; ///< shaft angle at the start, from the encoder's zero
    FirmwareBehavior behavior;
    ReplyTiming timing; ///< exact
    std::uint64_t seed = 1;
};

/// A request as it reached the servo: instruction, Modbus function or LX command, and the bytes
/// between it and the checksum. SYNC READ and SYNC WRITE carry their whole parameter list; the
/// servo finds its own part.
struct ServoRequest {
    bool broadcast = false;
    std::uint8_t instruction = 0;
    base::Bytes params;
    int syncReadIndex = -1; ///< place in a SYNC READ list, -1 otherwise
};

struct ServoReply {
    int id = 0;              ///< the ID in the reply
    std::uint8_t status = 0; ///< Feetech: error byte
    base::Bytes data;
    std::uint8_t function = 0; ///< Modbus: with its exception flag; LX: command
    base::Duration wait{};     ///< beyond the reply delay
};

enum class AddressMatch : std::uint8_t {
    No,
    Silently, ///< obeys, but never answers
    Yes,
};

class VirtualServo {
public:
    VirtualServo(catalog::ProfilePtr profile, ServoConfig config);
    ~VirtualServo();
    VirtualServo(VirtualServo&&) noexcept;

    const catalog::Profile& profile() const;

    int id() const;
    int baud() const;
    /// Whether a request to this ID is meant for it: HLS servos obey a second ID for some.
    AddressMatch addressMatch(int id, std::uint8_t instruction) const;
    /// Off, in its bootloader, or writing its EPROM if that makes it deaf.
    bool isDeaf() const;
    bool isInBootloader() const;
    bool hearsFirmware() const; ///< in its bootloader, or within the window after power-up
    /// What its bootloader replies to a byte at Bootloader::baud.
    std::optional<Bootloader::Reply> receiveInBootloader(std::uint8_t byte);
    /// How long the latest request delays the next one, because the servo writes its EPROM.
    base::Duration writeTime() const;
    base::Duration replyDelay() const;
    ReplyTiming& timing();

    /// Carries the request out at the servo's present time; nullopt: it stays silent. The reply
    /// leaves after replyDelay() at the rate the request came at, even if the request changed it.
    std::optional<ServoReply> handle(const ServoRequest& request);

    /// Mechanics, protections and timers. dt up to a few ms; typically 1 ms.
    void step(base::Duration dt);

    void powerOff();
    void powerOn();
    bool powered() const;

    /// The EPROM as it would survive a power-off, for --state files. False: a block of the wrong
    /// size is refused.
    base::Bytes epromImage() const;
    bool setEpromImage(base::ByteView image);

    /// Access for tests and presets, by register key; without the wire, with the same effect.
    std::int64_t raw(const QString& key) const;
    void poke(const QString& key, std::int64_t raw); ///< no register that the servo measures
    double shaftDegrees() const; ///< true output angle, unbounded, clockwise positive
    bool ledOn() const;
    Load& load();
    Environment& environment();
    Defects& defects();                   ///< acts from the next millisecond on
    FirmwareBehavior& behavior();         ///< acts from the next request on
    void injectStatus(std::uint8_t bits); ///< error bits as of a sensor fault, until power-off
    void setTemperature(double celsius);

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace sim
