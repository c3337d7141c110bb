// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a step-response run: a step there and back, repeated, with every reading, the
// figures of each response and their means. Plain values, kept in files; any thread. Positions in
// steps of the servo's feedback, the other units as in results/sweep_run.h; times from the moment
// the goal had been sent. A value that could not be measured is nullopt. As JSON and CSV:
// step_json.h.
#pragma once

#include "results/sweep_run.h"
#include "snapshot/snapshot.h"

#include <array>

namespace results {
/// A register of the loop: gain, startup force, integral limit, dead zone.
struct StepGain {
    QString key;
    std::int64_t raw = 0;
    bool operator==(const StepGain&) const = default;
};

/// The requested test. Texts as the user typed them: "200", "30deg", "1500".
struct StepSpec {
    QString size{};                ///< negative: downwards first
    QString from{};                ///< empty: the present position, or the nearest one with room
    int repeats = 3;               ///< there and back
    base::Duration hold{};         ///< from one goal to the next; 0: proposed
    QString speed{};               ///< empty: as fast as allowed
    QString acceleration{};        ///< empty: as high as allowed
    std::vector<StepGain> trial{}; ///< in force during this run only
    QString operatorName{};
    QString note{};
    bool operator==(const StepSpec&) const = default;
};

struct StepSample {
    base::Duration at{}; ///< since the goal
    double position = 0;
    std::optional<double> speed{};
    std::optional<double> load{};
    std::optional<double> current{};
    bool operator==(const StepSample&) const = default;
};

/// Defined in jobs/step/step_meter.h; as of a mean: of the responses in which it was measured,
/// steady errors by their magnitude.
struct StepFigures {
    std::optional<double> deadTime{};       ///< ms
    std::optional<double> riseTime{};       ///< ms, 10 to 90 %
    std::optional<double> timeToTarget{};   ///< ms
    std::optional<double> settling{};       ///< ms, from arrival on
    std::optional<double> overshoot{};      ///< %
    std::optional<double> overshootSteps{}; ///< steps
    std::optional<double> steadyError{};    ///< steps
    std::optional<double> swings{};         ///< number of reversals after arrival
    std::optional<double> swingFrequency{}; ///< Hz
    std::optional<double> swingAmplitude{}; ///< steps
    std::optional<double> peakSpeed{};      ///< steps/s
    std::optional<double> peakCurrent{};    ///< mA
    std::optional<double> peakLoad{};       ///< %
    bool operator==(const StepFigures&) const = default;
};

struct StepFigure {
    const char* key;
    const char* unit; ///< UTF-8
    std::optional<double> StepFigures::*member;
    bool lessIsBetter;
};

inline constexpr std::array<StepFigure, 13> stepFigures{{
    {"dead_time", "ms", &StepFigures::deadTime, true},
    {"rise_time", "ms", &StepFigures::riseTime, true},
    {"time_to_target", "ms", &StepFigures::timeToTarget, true},
    {"settling", "ms", &StepFigures::settling, true},
    {"overshoot", "%", &StepFigures::overshoot, true},
    {"overshoot_steps", "step", &StepFigures::overshootSteps, true},
    {"steady_error", "step", &StepFigures::steadyError, true},
    {"swings", "", &StepFigures::swings, true},
    {"swing_frequency", "Hz", &StepFigures::swingFrequency, false},
    {"swing_amplitude", "step", &StepFigures::swingAmplitude, true},
    {"peak_speed", "step/s", &StepFigures::peakSpeed, false},
    {"peak_current", "mA", &StepFigures::peakCurrent, false},
    {"peak_load", "%", &StepFigures::peakLoad, false},
}};

struct StepResponse {
    int number = 0; ///< from 1; odd ones go there, even ones back
    double start = 0;
    double target = 0;
    bool missed = false; ///< never within tolerance
    int lost = 0;        ///< readings without an answer
    bool seen = true;    ///< false: readings were missing in its motion, so its figures are
    std::uint8_t alarms = 0;
    StepFigures figures{};
    std::vector<StepSample> samples{};
    bool operator==(const StepResponse&) const = default;
};

struct StepRun {
    QString program{};
    QDateTime at{}; ///< start, UTC
    QString port{};
    int baud = 0;
    bool simulated = false;
    StepSpec spec{};                 ///< with the hold that was used
    snapshot::Snapshot parameters{}; ///< identity and memory table while it ran
    SweepAxis axis{};
    std::vector<StepGain> gains{}; ///< in force
    std::vector<StepResponse> responses{};
    StepFigures mean{};
    SweepEnd end = SweepEnd::Finished;
    double sampleRate = 0;  ///< readings a second
    bool isReverted = true; ///< false: the settings of the run are still in effect, see the journal
    bool operator==(const StepRun&) const = default;
};

StepFigures meanOf(const std::vector<StepResponse>& responses);

enum class StepChange : std::uint8_t { Same, Better, Worse, Neither, NotMeasured };

/// Same: not more than the scatter of the responses, or below the resolution of the readings.
/// Neither: no way is the better one.
struct StepDifference {
    StepFigure figure;
    std::optional<double> before{};
    std::optional<double> after{};
    std::optional<double> difference{}; ///< after − before
    StepChange change = StepChange::NotMeasured;
};

/// A step of the same size.
bool isSameMotion(const StepRun& one, const StepRun& other);

/// In the order of stepFigures; those that neither run measured are left out.
std::vector<StepDifference> compareSteps(const StepRun& before, const StepRun& after);

/// A fault of a response, and the advice of the sheet against it (error-diagnosis rows
/// 10 to 14).
enum class StepSymptom : std::uint8_t {
    NotSeen, ///< readings were missing while it moved
    NoMotion,
    Blocked, ///< stands still far from its target
    Lag,
    SpeedLimit,
    Overshoot,
    StaticError,
    Jitter,
    Oscillation
};
enum class StepRemedy : std::uint8_t {
    RepeatRun,
    RemoveObstacle,
    FreeMotion, ///< power, torque limit and mechanism come before any gain
    RaiseP,
    LowerP, ///< back to the stored one, or less
    RaiseD,
    LowerD,
    RaiseI, ///< in small steps
    DisableI,
    LowerStartupForce,
    WidenDeadZone,
    NarrowDeadZone,
    RaiseSpeed,
    RaiseAcceleration,
};
QString stepSymptomName(StepSymptom symptom); ///< "lag", "speed-limit" …
QString stepRemedyName(StepRemedy remedy);    ///< "raise-p" …

/// Never applied automatically. Without a key there is no register to try: the speed belongs to
/// the move.
struct StepAdvice {
    StepSymptom symptom = StepSymptom::Lag;
    StepRemedy remedy = StepRemedy::RaiseP;
    QString key{};
    std::int64_t now = 0;
    std::int64_t proposed = 0;
    bool operator==(const StepAdvice&) const = default;
};
} // namespace results
