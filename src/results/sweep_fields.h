// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a leg by name and unit, once for JSON, CSV and report. Constant; any thread.
#pragma once

#include "results/sweep_run.h"

#include <array>

namespace results {
struct LegFigure {
    const char* key;  ///< in JSON, and in CSV before its unit
    const char* unit; ///< UTF-8
    std::optional<double> SweepLeg::*member;
    bool isLater = false; ///< earlier files do not have it
};

inline constexpr std::array<LegFigure, 14> legFigures{{
    {"reached", "step", &SweepLeg::reached},
    {"overshoot", "%", &SweepLeg::overshoot},
    {"overshoot_steps", "step", &SweepLeg::overshootSteps},
    {"steady_error", "step", &SweepLeg::steadyError},
    {"mean_speed", "step/s", &SweepLeg::meanSpeed},
    {"top_speed", "step/s", &SweepLeg::topSpeed},
    {"following_error", "step", &SweepLeg::followingError},
    {"phase_lag", "°", &SweepLeg::phaseLag, true},
    {"current_peak", "mA", &SweepLeg::currentPeak},
    {"current_mean", "mA", &SweepLeg::currentMean},
    {"load_peak", "%", &SweepLeg::loadPeak},
    {"load_mean", "%", &SweepLeg::loadMean},
    {"voltage_min", "V", &SweepLeg::voltageMin},
    {"temperature_max", "°C", &SweepLeg::temperatureMax},
}};

constexpr double usPerMs = 1000.0;

inline std::optional<double> inMs(std::optional<base::Duration> span)
{
    return span ? std::optional<double>(double(span->count()) / usPerMs) : std::nullopt;
}
} // namespace results
