// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/sweep_input.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "results/sweep_points.h"

#include <cmath>

namespace cli {
using results::SweepPace;
using results::SweepShape;
using results::SweepSpec;

namespace {
constexpr int maxCycles = 1'000'000;
constexpr int maxPause = 3'600'000; ///< ms
constexpr int maxTime = 65'535;     ///< ms, the maximum of the registers
constexpr double usPerSecond = 1e6;
constexpr double minPeriod = 0.1; ///< s
constexpr double maxPeriod = 3600;
constexpr double minSpan = 0.1;
constexpr double maxSpan = 1e6; ///< eleven days

base::Result<void> takeSpan(const Values& values, const char* flag, double min, double max,
                            base::Duration& into)
{
    const auto span = secondsOption(values, flag, min, max);
    if (!span)
        return tl::unexpected(span.error());
    into = span->value_or(into);
    return {};
}

bool belowZero(const QString& text)
{
    return text.trimmed().startsWith(u'-') || text.trimmed().startsWith(QChar(0x2212));
}

base::Result<void> takeStep(const Values& values, SweepSpec& spec)
{
    spec.step = values.option("--step").value_or(QString());
    if (belowZero(spec.step))
        return badArgument(
            translate("cli", "--step \"%1\": specify a step greater than 0, raw (100) or with its "
                             "unit (10deg); to reverse the direction, swap --from and --to")
                .arg(spec.step));
    return {};
}

/// The options that determine the path; at most one of them may be given.
base::Result<void> takeShape(const Values& values, SweepSpec& spec)
{
    const std::pair<bool, SweepShape> shapes[]{
        {values.option("--step").has_value(), SweepShape::Stairs},
        {values.has("--both-sides"), SweepShape::BothSides},
        {values.option("--random").has_value(), SweepShape::Random},
        {values.option("--sine").has_value(), SweepShape::Sine},
        {values.option("--points").has_value(), SweepShape::Points}};
    int count = 0;
    for (const auto& [given, shape] : shapes) {
        count += given ? 1 : 0;
        spec.shape = given ? shape : spec.shape;
    }
    if (count > 1)
        return badArgument(translate(
            "cli", "use only one of --step, --both-sides, --random, --sine and --points"));
    if (const auto step = takeStep(values, spec); !step)
        return step;
    const auto seed = intOption(values, "--random", 0, std::numeric_limits<int>::max());
    if (!seed)
        return tl::unexpected(seed.error());
    spec.seed = static_cast<std::uint32_t>(seed->value_or(int(spec.seed)));
    if (const auto file = values.option("--points")) {
        auto points = results::loadSweepPoints(*file);
        if (!points)
            return tl::unexpected(points.error());
        spec.points = std::move(*points);
    }
    return takeSpan(values, "--sine", minPeriod, maxPeriod, spec.period);
}

base::Result<void> takeRange(const Values& values, SweepSpec& spec)
{
    const auto from = values.option("--from");
    const auto to = values.option("--to");
    if (spec.shape == SweepShape::Points) {
        if (from || to)
            return badArgument(translate("cli", "--points cannot be combined with --from or --to"));
        return {};
    }
    if (!from || !to)
        return badArgument(translate("cli", "--from and --to are required"));
    spec.range = {*from, *to};
    return {};
}

base::Result<void> takePace(const Values& values, SweepSpec& spec)
{
    const bool delay = values.option("--delay").has_value();
    const bool dwell = values.option("--dwell").has_value();
    const bool needed = spec.shape != SweepShape::Sine;
    if (delay && dwell)
        return badArgument(translate("cli", "use either --delay or --dwell, not both"));
    if (needed && !delay && !dwell)
        return badArgument(translate("cli", "--delay or --dwell is required"));
    spec.pace = dwell ? SweepPace::Dwell : SweepPace::Delay;
    const auto pause = intOption(values, dwell ? "--dwell" : "--delay", 1, maxPause);
    if (!pause)
        return tl::unexpected(pause.error());
    spec.pause = std::chrono::milliseconds(pause->value_or(0));
    return {};
}

base::Result<void> takeEnd(const Values& values, SweepSpec& spec)
{
    if (const auto taken = takeSpan(values, "--duration", minSpan, maxSpan, spec.length); !taken)
        return taken;
    // With a duration, the number of cycles is unlimited unless it is given too.
    spec.cycles = spec.length > base::Duration::zero() ? 0 : 10;
    const auto cycles = intOption(values, "--cycles", 1, maxCycles);
    if (!cycles)
        return tl::unexpected(cycles.error());
    spec.cycles = cycles->value_or(spec.cycles);
    return {};
}

base::Result<void> takeMotion(const Values& values, SweepSpec& spec)
{
    if (const auto warm = takeSpan(values, "--warm-up", minSpan, maxSpan, spec.warmUp); !warm)
        return warm;
    const auto speed = nonNegativeOption(values, "--speed");
    if (!speed)
        return tl::unexpected(speed.error());
    const auto acceleration = nonNegativeOption(values, "--acceleration");
    if (!acceleration)
        return tl::unexpected(acceleration.error());
    const auto time = intOption(values, "--time", 1, maxTime);
    if (!time)
        return tl::unexpected(time.error());
    spec.speed = *speed;
    spec.acceleration = *acceleration;
    spec.time = *time ? QString::number(**time) : QString();
    return {};
}
} // namespace

base::Result<std::optional<int>> intOption(const Values& values, const char* flag, int min, int max)
{
    const auto word = values.option(flag);
    if (!word)
        return std::optional<int>();
    const auto number = parseInt(*word, min, max);
    if (!number)
        return badArgument(
            translate("cli", "%1 \"%2\": specify a whole number from %3 to %4")
                .arg(QString::fromLatin1(flag), *word, QString::number(min), QString::number(max)));
    return std::optional(*number);
}

base::Result<std::optional<base::Duration>> secondsOption(const Values& values, const char* flag,
                                                          double min, double max)
{
    const auto word = values.option(flag);
    if (!word)
        return std::optional<base::Duration>();
    bool isNumber = false;
    const double number = word->toDouble(&isNumber);
    if (!isNumber || !(number >= min && number <= max))
        return badArgument(translate("cli", "%1 \"%2\": specify a number of seconds from %3 to %4")
                               .arg(QString::fromLatin1(flag), *word, QString::number(min),
                                    QString::number(max, 'f', 0)));
    return std::optional(base::Duration(std::llround(number * usPerSecond)));
}

base::Result<QString> nonNegativeOption(const Values& values, const char* flag)
{
    QString word = values.option(flag).value_or(QString());
    if (belowZero(word))
        return badArgument(translate("cli", "%1 \"%2\": specify a value of 0 or more, raw or with "
                                            "its unit; the goals determine the direction")
                               .arg(QString::fromLatin1(flag), word));
    return word;
}

std::vector<Option> sweepOptions()
{
    return {
        {"--from",
         QT_TRANSLATE_NOOP("cli",
                           "start position: raw value (1024), or value with its unit (90deg)"),
         "POS"},
        {"--to", QT_TRANSLATE_NOOP("cli", "end position: raw value, or value with its unit"),
         "POS"},
        {"--delay",
         QT_TRANSLATE_NOOP("cli",
                           "time from one goal to the next, whether or not the goal is reached"),
         "MS"},
        {"--dwell",
         QT_TRANSLATE_NOOP("cli", "pause after each goal is reached, instead of "
                                  "--delay"),
         "MS"},
        {"--cycles",
         QT_TRANSLATE_NOOP("cli", "number of cycles (default: 10; with --duration: unlimited)"),
         "N"},
        {"--duration", QT_TRANSLATE_NOOP("cli", "end after this many seconds"), "S"},
        {"--step", QT_TRANSLATE_NOOP("cli", "move in steps of this size, up and down"), "N"},
        {"--both-sides",
         QT_TRANSLATE_NOOP("cli", "also approach the middle of the range from both directions")},
        {"--random",
         QT_TRANSLATE_NOOP("cli", "move to random goals; the same seed gives the same goals"),
         "SEED"},
        {"--sine", QT_TRANSLATE_NOOP("cli", "follow a sine wave with this period"), "S"},
        {"--points", QT_TRANSLATE_NOOP("cli", "read goals from a CSV file: goal,pause in ms"),
         "FILE"},
        {"--speed", QT_TRANSLATE_NOOP("cli", "raw value, or value with its unit"), "V"},
        {"--acceleration", QT_TRANSLATE_NOOP("cli", "raw value, or value with its unit"), "A"},
        {"--time", QT_TRANSLATE_NOOP("cli", "travel time in milliseconds (SCS, LX)"), "MS"},
        {"--warm-up", QT_TRANSLATE_NOOP("cli", "warm-up time in seconds before measuring"), "S"},
        {"--switch-mode",
         QT_TRANSLATE_NOOP(
             "cli", "switch servos in other modes to position mode for the test, then back")},
        {"--torque-off", QT_TRANSLATE_NOOP("cli", "turn torque off at the end (default: hold)")},
        {"--stop-on-failure",
         QT_TRANSLATE_NOOP("cli", "end after the first cycle in which a servo fails a limit")},
        {"--limits", QT_TRANSLATE_NOOP("cli", "limits for the verdict (default: built-in limits)"),
         "FILE"},
        {"--report",
         QT_TRANSLATE_NOOP("cli", "write the report to this file, and the readings to a CSV "
                                  "file next to it"),
         "FILE.html|pdf|json|csv"},
        {"--operator", QT_TRANSLATE_NOOP("cli", "operator name for the report"), "NAME"},
        {"--note", QT_TRANSLATE_NOOP("cli", "note for the report"), "TEXT"},
    };
}

base::Result<SweepSpec> sweepSpec(const Values& values)
{
    SweepSpec spec;
    for (const auto take : {takeShape, takeRange, takePace, takeEnd, takeMotion}) {
        if (const auto taken = take(values, spec); !taken)
            return tl::unexpected(taken.error());
    }
    spec.releaseAtEnd = values.has("--torque-off");
    spec.stopOnFailure = values.has("--stop-on-failure");
    spec.operatorName = values.option("--operator").value_or(QString());
    spec.note = values.option("--note").value_or(QString());
    return spec;
}

base::Result<std::optional<results::SweepLimits>> sweepLimits(const Values& values)
{
    const auto file = values.option("--limits");
    if (!file)
        return std::optional<results::SweepLimits>();
    auto limits = results::loadSweepLimits(*file);
    if (!limits)
        return tl::unexpected(limits.error());
    return std::optional(std::move(*limits));
}
} // namespace cli
