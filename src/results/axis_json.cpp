// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/axis_json.h"

#include "files/json_text.h"
#include "results/sweep_fields.h"

#include <cmath>

namespace results {
namespace {
constexpr double maxMilliseconds = 1e12; // thirty years
} // namespace

QByteArray encodeAxis(const SweepAxis& axis, AxisFields fields)
{
    files::JsonObjectWriter line;
    line.number("from", axis.from).number("to", axis.to);
    if (fields == AxisFields::Path) {
        line.number("step", axis.step).raw("points", files::jsonList(axis.points, [](double point) {
                                               return files::jsonNumber(point);
                                           }));
    }
    return line.number("steps_per_turn", axis.stepsPerTurn)
        .number("tolerance", axis.tolerance)
        .number("speed", axis.speed)
        .number("acceleration", axis.acceleration)
        .done();
}

SweepAxis readAxis(const files::JsonReader& json, AxisFields fields)
{
    SweepAxis axis;
    axis.from = json.number("from");
    axis.to = json.number("to");
    if (fields == AxisFields::Path) {
        axis.step = json.number("step");
        axis.points = json.numbers("points");
    }
    axis.stepsPerTurn = json.number("steps_per_turn");
    axis.tolerance = json.number("tolerance");
    axis.speed = json.numberOrNull("speed");
    axis.acceleration = json.numberOrNull("acceleration");
    return axis;
}

base::Duration readMilliseconds(const files::JsonReader& json, const char* key, double ms)
{
    if (std::abs(ms) <= maxMilliseconds)
        return base::Duration(std::llround(ms * usPerMs));
    json.reportError(key, QStringLiteral("number too large"));
    return {};
}
} // namespace results
