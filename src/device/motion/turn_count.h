// SPDX-License-Identifier: GPL-3.0-or-later
// Counts whole turns of the shaft from feedback that shows one turn only, starting with the first
// reading; earlier turns are not known. Absolute where the servo itself counts (phase bit 4). The
// feedback is in steps of the encoder for any resolution factor (30). A value; owned by the caller
// that feeds it; times are bus-clock instants.
#pragma once

#include "device/servo.h"

namespace device {
/// Bit of the phase register: the servo reports the angle over several turns.
inline constexpr std::int64_t fullAnglePhaseBit = 1 << 4;

struct Turns {
    int turns = 0;         ///< whole ones, rounded down
    double degrees = 0;    ///< in total
    bool absolute = false; ///< as the servo counts; else since the first reading
    bool isCertain = true; ///< false: readings were once too far apart to count turns reliably
    bool operator==(const Turns&) const = default;
};

/// What a position reading means; counting begins anew when it changes.
struct TurnBasis {
    int steps = 0; ///< of one turn; 0: the feedback shows no turns (step mode, potentiometers)
    bool countsTurns = false;
    QString mode{};
    std::int64_t offset = 0; ///< of the zero, which centering moves
    bool operator==(const TurnBasis&) const = default;
};
TurnBasis turnBasis(const Servo& servo);

class TurnCounter {
public:
    void on(const TurnBasis& basis);
    /// `degreesPerSecond`: as measured by the servo, if it is known.
    void reading(std::int64_t raw, std::optional<double> degreesPerSecond, base::Duration at);
    /// After a restart, a new connection, a silence: the next reading may be another turn.
    void reset();
    /// Nullopt: nothing has been read yet, or the feedback shows no turns.
    std::optional<Turns> value() const { return m_value; }

private:
    bool isUnambiguous(std::int64_t moved, std::optional<double> speed, base::Duration gap) const;

    TurnBasis m_basis;
    std::optional<Turns> m_value;
    std::int64_t m_raw = 0;   ///< latest reading
    std::int64_t m_total = 0; ///< steps, turns included
    double m_speed = 0;       ///< at the latest reading, if it was known
    base::Duration m_at{};
};
} // namespace device
