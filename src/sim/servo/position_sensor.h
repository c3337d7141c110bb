// SPDX-License-Identifier: GPL-3.0-or-later
// Position and speed of the shaft as the firmware knows them: the encoder's count, corrected by the
// offset, the direction and the turns the servo counts. Owned by a ServoDrive; one thread. Steps
// and step/s in the servo's own coordinate.
#pragma once

#include "sim/faults/defect_trajectory.h"
#include "sim/servo/encoder.h"
#include "sim/servo/settings.h"

namespace sim {
class PositionSensor {
public:
    /// `settings` must outlive the sensor.
    PositionSensor(const ServoTraits& traits, const Settings& settings, std::uint64_t seed);

    void powerOn(double angle, std::uint64_t tick);
    void measure(double angle, std::uint64_t tick); ///< once a millisecond while the shaft may move
    void stop() { m_speed = m_reportedSpeed = 0; }  ///< the shaft has come to rest
    /// The position counts from the present turn. Returns by how much it changed.
    double resetTurns();

    double position() const { return m_position; }
    double speed() const { return m_speed; }                 ///< smoothed for the loops
    double reportedSpeed() const { return m_reportedSpeed; } ///< smoothed for its register
    bool isStill() const;                                    ///< slower than the register can show
    bool isContinuous() const { return m_encoder.isContinuous(); }
    /// −1 if larger positions are counter-clockwise.
    double sign() const { return isContinuous() && m_settings.reversed ? -1.0 : 1.0; }
    Shaft shaft(double radiansPerSecond) const; ///< finer than whole steps
    /// The offset that makes the present position read as `wanted`.
    int offsetFor(int wanted) const;
    double noise(double deviation, std::uint64_t tick) const; ///< whole steps

    static constexpr double speedResolution = 50; ///< step/s, of the measured speed

private:
    double read() const;
    std::int64_t directedCount() const;

    const Settings& m_settings;
    Encoder m_encoder;
    int m_turnSteps;
    double m_stepsPerRadian;
    std::int64_t m_count = 0;    ///< encoder steps through all turns
    std::int64_t m_turnBase = 0; ///< multiple of a turn: the position counts from here
    double m_position = 0;
    double m_speed = 0;
    double m_reportedSpeed = 0;
};
} // namespace sim
