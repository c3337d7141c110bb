// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_input.h"

#include "cli/arguments.h"
#include "cli/translate.h"
#include "record/sweep_points.h"

#include <cmath>

namespace cli {
using record::SweepPace;
using record::SweepShape;
using record::SweepSpec;

namespace {
constexpr int mostCycles = 1'000'000;
constexpr int longestPause = 3'600'000; ///< ms

base::Result<void> takeSpan(const Values& values, const char* flag, double unit,
                            base::Duration& into)
{
    const auto word = values.option(flag);
    if (!word)
        return {};
    const auto number = parsePositive(*word);
    if (!number)
        return tl::unexpected(number.error());
    into = base::Duration(std::llround(*number * unit));
    return {};
}

constexpr double seconds = 1e6;

/// What makes the path; at most one of them.
base::Result<void> takeShape(const Values& values, SweepSpec& spec)
{
    const std::pair<bool, SweepShape> shapes[]{
        {values.option("--step").has_value(), SweepShape::Stairs},
        {values.has("--both-sides"), SweepShape::BothSides},
        {values.option("--random").has_value(), SweepShape::Random},
        {values.option("--sine").has_value(), SweepShape::Sine},
        {values.option("--points").has_value(), SweepShape::Points}};
    int asked = 0;
    for (const auto& [given, shape] : shapes) {
        asked += given ? 1 : 0;
        spec.shape = given ? shape : spec.shape;
    }
    if (asked > 1)
        return badArgument(translate(
            "cli", "--step, --both-sides, --random, --sine and --points exclude each other"));
    spec.step = values.option("--step").value_or(QString());
    if (const auto seed = values.option("--random")) {
        const auto number = parseWhole(*seed, 0, std::numeric_limits<int>::max());
        if (!number)
            return tl::unexpected(number.error());
        spec.seed = static_cast<std::uint32_t>(*number);
    }
    if (const auto file = values.option("--points")) {
        auto points = record::loadSweepPoints(*file);
        if (!points)
            return tl::unexpected(points.error());
        spec.points = std::move(*points);
    }
    return takeSpan(values, "--sine", seconds, spec.period);
}

base::Result<void> takeRange(const Values& values, SweepSpec& spec)
{
    const auto from = values.option("--from");
    const auto to = values.option("--to");
    if (spec.shape == SweepShape::Points) {
        if (from || to)
            return badArgument(translate("cli", "with --points there is no --from and no --to"));
        return {};
    }
    if (!from || !to)
        return badArgument(translate("cli", "--from and --to are needed"));
    spec.range = {*from, *to};
    return {};
}

base::Result<void> takePace(const Values& values, SweepSpec& spec)
{
    const bool delay = values.option("--delay").has_value();
    const bool dwell = values.option("--dwell").has_value();
    const bool needed = spec.shape != SweepShape::Sine;
    if (delay && dwell)
        return badArgument(translate("cli", "--delay and --dwell exclude each other"));
    if (needed && !delay && !dwell)
        return badArgument(translate("cli", "--delay or --dwell is needed"));
    spec.pace = dwell ? SweepPace::Dwell : SweepPace::Delay;
    const auto word = values.option(dwell ? "--dwell" : "--delay");
    if (!word)
        return {};
    const auto pause = parseWhole(*word, 1, longestPause);
    if (!pause)
        return tl::unexpected(pause.error());
    spec.pause = std::chrono::milliseconds(*pause);
    return {};
}

base::Result<void> takeEnd(const Values& values, SweepSpec& spec)
{
    if (const auto taken = takeSpan(values, "--for", seconds, spec.length); !taken)
        return taken;
    const auto word = values.option("--cycles");
    // A length alone is the length.
    spec.cycles = spec.length > base::Duration::zero() ? 0 : 10;
    if (!word)
        return {};
    const auto cycles = parseWhole(*word, 1, mostCycles);
    if (!cycles)
        return tl::unexpected(cycles.error());
    spec.cycles = *cycles;
    return {};
}
} // namespace

std::vector<Option> sweepOptions()
{
    return {
        {"--from", QT_TRANSLATE_NOOP("cli", "start: raw, or with its unit (90deg)"), "POS"},
        {"--to", QT_TRANSLATE_NOOP("cli", "end: raw, or with its unit"), "POS"},
        {"--delay", QT_TRANSLATE_NOOP("cli", "from one goal to the next, arrived or not"), "MS"},
        {"--dwell", QT_TRANSLATE_NOOP("cli", "rest after arrival instead"), "MS"},
        {"--cycles", QT_TRANSLATE_NOOP("cli", "there and back so many times (usual: 10)"), "N"},
        {"--for", QT_TRANSLATE_NOOP("cli", "end after so many seconds"), "S"},
        {"--step", QT_TRANSLATE_NOOP("cli", "go in steps of this size, up and down"), "N"},
        {"--both-sides", QT_TRANSLATE_NOOP("cli", "come to the middle from both sides too")},
        {"--random", QT_TRANSLATE_NOOP("cli", "random targets, the same for the same number"),
         "SEED"},
        {"--sine", QT_TRANSLATE_NOOP("cli", "follow a sine with this period"), "S"},
        {"--points", QT_TRANSLATE_NOOP("cli", "targets from a CSV file: target,pause in ms"),
         "FILE"},
        {"--speed", QT_TRANSLATE_NOOP("cli", "raw or with its unit"), "V"},
        {"--acceleration", QT_TRANSLATE_NOOP("cli", "raw or with its unit"), "A"},
        {"--time", QT_TRANSLATE_NOOP("cli", "travel time in milliseconds (SCS, LX)"), "MS"},
        {"--warm-up", QT_TRANSLATE_NOOP("cli", "move for so many seconds before measuring"), "S"},
        {"--switch-mode", QT_TRANSLATE_NOOP("cli", "a servo in another mode is in position mode "
                                                   "while the test lasts, and back afterwards")},
        {"--release", QT_TRANSLATE_NOOP("cli", "torque off at the end (usual: hold)")},
        {"--stop-on-failure", QT_TRANSLATE_NOOP("cli", "end with the first limit that is failed")},
        {"--limits", QT_TRANSLATE_NOOP("cli", "limits to judge by (usual: the built-in ones)"),
         "FILE"},
        {"--report",
         QT_TRANSLATE_NOOP("cli", "write the report; the readings go to a CSV beside it"),
         "FILE.html|pdf|json|csv"},
        {"--operator", QT_TRANSLATE_NOOP("cli", "who tests, for the report"), "NAME"},
        {"--note", QT_TRANSLATE_NOOP("cli", "a remark for the report"), "TEXT"},
    };
}

base::Result<SweepSpec> sweepSpec(const Values& values)
{
    SweepSpec spec;
    for (const auto take : {takeShape, takeRange, takePace, takeEnd}) {
        if (const auto taken = take(values, spec); !taken)
            return tl::unexpected(taken.error());
    }
    if (const auto warm = takeSpan(values, "--warm-up", seconds, spec.warmUp); !warm)
        return tl::unexpected(warm.error());
    spec.speed = values.option("--speed").value_or(QString());
    spec.acceleration = values.option("--acceleration").value_or(QString());
    spec.time = values.option("--time").value_or(QString());
    spec.releaseAtEnd = values.has("--release");
    spec.stopOnFailure = values.has("--stop-on-failure");
    spec.operatorName = values.option("--operator").value_or(QString());
    spec.note = values.option("--note").value_or(QString());
    return spec;
}

base::Result<std::optional<record::SweepLimits>> sweepLimits(const Values& values)
{
    const auto file = values.option("--limits");
    if (!file)
        return std::optional<record::SweepLimits>();
    auto limits = record::loadSweepLimits(*file);
    if (!limits)
        return tl::unexpected(limits.error());
    return std::optional(std::move(*limits));
}
} // namespace cli
