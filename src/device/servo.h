// SPDX-License-Identifier: GPL-3.0-or-later
// One servo as the program knows it: address, identity, and what was read of it. A value, copied
// freely; owned by its holder. All numbers by register key or role.
#pragma once

#include "base/journal.h"
#include "catalog/value.h"
#include "device/image.h"

namespace device {
/// The mode that these three registers select, or null while they are not known.
const catalog::Mode* modeFor(const catalog::Profile& profile,
                             std::optional<std::int64_t> operatingMode,
                             std::optional<std::int64_t> minAngle,
                             std::optional<std::int64_t> maxAngle);

struct Servo {
    base::Protocol protocol = base::Protocol::Feetech;
    int id = -1;
    int baud = 0;
    QString port;
    catalog::ProfilePtr profile;
    Image image;
    /// Fault bits in the layout of the family: the error byte of its latest reply, or its status
    /// register when last read; 0 for servos that report neither.
    std::uint8_t status = 0;

    std::optional<std::int64_t> raw(const catalog::Register& reg) const;
    std::optional<std::int64_t> raw(const QString& key) const;
    std::optional<std::int64_t> raw(catalog::Role role) const;
    /// Physical value with all variants resolved by what has been read.
    std::optional<double> physical(catalog::Role role) const;
    catalog::ValueFormat meaning(const catalog::Register& reg) const;
    catalog::Lookup lookup() const;

    /// The mode that its registers select (STS: 33, 9, 11), or null while they are not known.
    const catalog::Mode* mode() const;
    base::ServoIdentity identity() const;
    bool acknowledgesWrites() const; ///< its protocol acknowledges writes
    bool repliesToWrites() const;    ///< and its response level is not 0
    bool repliesCarryStatus() const; ///< every reply has an error byte
    bool movesNeedTorque() const;    ///< a goal does not switch torque on, and is lost without it
    /// False for a register without a source in this servo: current without a sensor.
    bool measures(const catalog::Register& reg) const;
};
} // namespace device
