// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulated servo truly does, found without a bus and without the code that tests servos:
// the servo is stepped millisecond by millisecond, and what its position register shows is kept
// beside the angle of its shaft. For any test that knows sim::VirtualServo; its thread.
#pragma once

#include "sim/servo/virtual_servo.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <vector>

namespace probe {
using std::chrono::milliseconds;

struct Sample {
    std::int64_t reported = 0; ///< steps
    double shaft = 0;          ///< steps of the sensor, true
};

/// One move as it was seen, in steps, step/s and ms.
struct Move {
    std::int64_t start = 0; ///< reported when the goal was written
    std::int64_t goal = 0;
    std::vector<Sample> samples; ///< a millisecond apart, the first 1 ms after the goal

    double way() const { return double(goal - start); }
    double direction() const { return goal < start ? -1.0 : 1.0; }

    /// Mean of what was reported in the last 200 ms.
    double restPosition() const
    {
        return mean([](const Sample& sample) { return double(sample.reported); });
    }
    double shaftRestPosition() const
    {
        return mean([](const Sample& sample) { return sample.shaft; });
    }
    /// Standard deviation of what was reported in the last 200 ms.
    double restDeviation() const
    {
        const double middle = restPosition();
        return std::sqrt(mean([middle](const Sample& sample) {
            return (double(sample.reported) - middle) * (double(sample.reported) - middle);
        }));
    }
    /// The farthest report beyond the goal; negative: it never got there.
    double peakBeyondGoal() const
    {
        double maximum = -HUGE_VAL;
        for (const Sample& sample : samples) {
            maximum = std::max(maximum, direction() * double(sample.reported - goal));
        }
        return maximum;
    }
    /// Until it is within `steps` of the goal and stays there; the whole time if it does not.
    int timeToWithin(double steps) const
    {
        int last = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (std::abs(double(samples[i].reported - goal)) > steps) {
                last = int(i) + 1;
            }
        }
        return last;
    }
    /// The fastest the shaft was over this long, towards the goal.
    double topSpeed(std::size_t window = 100) const
    {
        double maximum = 0;
        for (std::size_t i = window; i < samples.size(); ++i) {
            const double way = samples[i].shaft - samples[i - window].shaft;
            maximum = std::max(maximum, direction() * way * 1000.0 / double(window));
        }
        return maximum;
    }

private:
    template <typename Value>
    double mean(Value&& value) const
    {
        const std::size_t count = std::min<std::size_t>(200, samples.size());
        double sum = 0;
        for (std::size_t i = samples.size() - count; i < samples.size(); ++i) {
            sum += value(samples[i]);
        }
        return sum / double(count);
    }
};

class ServoPlant {
public:
    explicit ServoPlant(sim::VirtualServo& servo)
        : m_servo(servo)
        , m_position(servo.profile().byRole(catalog::Role::PresentPosition)->key)
        , m_goal(servo.profile().byRole(catalog::Role::GoalPosition)->key)
        , m_stepDegrees(stepOf(servo.profile()))
    {}

    std::int64_t reported() const { return m_servo.raw(m_position); }

    /// Writes the goal and watches for so long.
    Move move(std::int64_t goal, milliseconds span)
    {
        Move move{reported(), goal, {}};
        m_servo.poke(m_goal, goal);
        watch(move, span);
        return move;
    }
    /// Goes on watching what has been written already.
    void watch(Move& move, milliseconds span)
    {
        move.samples.reserve(move.samples.size() + std::size_t(span.count()));
        for (milliseconds at{}; at < span; at += milliseconds(1)) {
            m_servo.step(milliseconds(1));
            move.samples.push_back({reported(), m_servo.shaftDegrees() / m_stepDegrees});
        }
    }

private:
    static double stepOf(const catalog::Profile& profile)
    {
        const catalog::Register* position = profile.byRole(catalog::Role::PresentPosition);
        if (position->unit == QLatin1String("deg")) {
            return position->scale;
        }
        return profile.angleRangeDeg.value_or(300.0) / profile.stepsPerTurn;
    }

    sim::VirtualServo& m_servo;
    QString m_position;
    QString m_goal;
    double m_stepDegrees;
};
} // namespace probe
