// SPDX-License-Identifier: GPL-3.0-or-later
// What writing a value to a register means: the one answer for memory table, tasks, jobs and
// command line. Pure; any thread; never fails.
#pragma once

#include "catalog/register.h"

namespace device {
/// Bit of the fault reset register: "the present position becomes the middle" (Modbus sheet).
inline constexpr std::int64_t centerBit = 4;

/// How a value is written; a mixture is written in this order.
enum class WriteProcedure : std::uint8_t {
    Torque,
    Center,   ///< the present position becomes the midpoint
    Register, ///< the safe write
    CloseLock,
    OpenLock, ///< by the safe write itself only
    BaudRate, ///< the servo replies at another baud rate afterwards
    Id,       ///< the servo replies under another ID afterwards
};

struct WriteMeaning {
    WriteProcedure procedure = WriteProcedure::Register;
    bool needsConsent = false; ///< can make the servo unreachable, dangerous or wrong in position
    bool moves = false;        ///< a goal: the shaft may turn at once
    bool enablesTorque = false;

    bool changesAddress() const
    {
        return procedure == WriteProcedure::BaudRate || procedure == WriteProcedure::Id;
    }
    /// The safe write can do it.
    bool isRegisterWrite() const
    {
        return procedure == WriteProcedure::Register || procedure == WriteProcedure::CloseLock ||
               procedure == WriteProcedure::OpenLock;
    }
    /// Undo excludes it: reverting a setting must not turn a shaft.
    bool isMotion() const { return moves || procedure == WriteProcedure::Torque; }
};

/// Of one value by itself; what several mean together: removesAngleLimits() in consent.h.
WriteMeaning classify(const catalog::Register& reg, std::int64_t raw);

/// Whether every value of this register needs consent; for lists that show no value yet.
bool alwaysNeedsConsent(const catalog::Register& reg);

/// The name of this number in the register's list; empty if it has none.
QString valueName(const catalog::Register& reg, std::int64_t raw);
} // namespace device
