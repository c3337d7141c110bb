// SPDX-License-Identifier: GPL-3.0-or-later
// Everything known about one kind of servo: model, firmware and the register map that fits them,
// with the limits of that series and firmware already applied. Shared, immutable; any thread.
#pragma once

#include "base/bytes.h"
#include "base/protocol.h"
#include "catalog/family_facts.h"
#include "catalog/register.h"

#include <memory>

namespace catalog {
/// The identity as read from the servo: the first five bytes of every Feetech table; the two
/// version words of a Modbus servo as firmware; an LX servo has none.
struct Identity {
    int firmwareMajor = -1;
    int firmwareMinor = -1;
    int byteOrderFlag = -1; ///< 0 little, 1 big, -1 could not be read
    int modelMajor = -1;
    int modelMinor = -1;
    base::Protocol protocol = base::Protocol::Feetech;
    bool operator==(const Identity&) const = default;
    QString firmware() const; ///< "3.10"
    QString modelId() const;  ///< "9.3"
};

enum class Line : std::uint8_t { Unknown, Ttl, Rs485 };

/// Whether register 69 means anything.
enum class CurrentSensing : std::uint8_t { Unknown, No, Yes, UnlessPhaseBit5 };

/// How to calibrate the present position to the middle.
enum class Centering : std::uint8_t {
    None,
    Write128,
    Instruction0B,
    FaultReset4, ///< Modbus: 4 to the fault reset register
};

/// An operating mode as the technician names it, and what the registers hold in it.
struct Mode {
    QString key; ///< position, multiturn, speed, pwm, step, motor, current …
    Text name;
    std::optional<int> operatingMode;  ///< register 33, where the family has it
    bool limitsZero = false;           ///< minimum and maximum angle both 0
    Role command = Role::GoalPosition; ///< the register that drives it
};

struct Profile {
    Identity identity;
    QString modelName; ///< "STS3215"; for an unknown model the series with its number
    bool modelKnown = false;
    QString series; ///< "STS", "SMS", "SCS"
    QString mapKey; ///< "sts-sms", "scs"
    base::Protocol protocol = base::Protocol::Feetech;
    base::ByteOrder byteOrder = base::ByteOrder::Little;
    Line line = Line::Unknown;
    bool writable = true; ///< false: firmware unknown; identity and feedback may be read only
    /// Set where the identity contradicts itself: no map is trusted, the table is
    /// bytes, and nothing is written.
    std::optional<FamilyFacts> conflict;
    int stepsPerTurn = 4096;
    std::optional<double> angleRangeDeg;
    std::optional<int> defaultBaud;
    std::optional<double> minVoltage;
    std::optional<double> maxVoltage;
    CurrentSensing currentSensing = CurrentSensing::Unknown;
    bool syncRead = false;
    bool damping = false;
    bool multiTurn = false;
    int readGap = 8;   ///< unwanted bytes read along at most; -1: blocks are read as they are
    int maxRead = 128; ///< bytes in one read
    Centering centering = Centering::None;
    std::vector<Mode> modes;
    std::vector<Register> registers; ///< by offset

    const Register* find(const QString& key) const;
    const Register* byRole(Role role) const;
    const Register* at(int offset) const; ///< the register that covers this byte
    const Mode* mode(const QString& key) const;
};

using ProfilePtr = std::shared_ptr<const Profile>;
} // namespace catalog
