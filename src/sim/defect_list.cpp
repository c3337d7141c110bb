// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/defect_list.h"

#include <QSet>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
struct Word {
    const char* name;
    double least;
    double most;
    void (*set)(ServoRecipe&, double);
    bool isSwitch = false; ///< 0 or 1
};
constexpr Word words[] = {
    {"rest-hysteresis", 0, 400, [](ServoRecipe& r, double v) { r.defects.restHysteresis = v; }},
    {"static-error", -400, 400, [](ServoRecipe& r, double v) { r.defects.staticError = v; }},
    {"overshoot", 0, 50, [](ServoRecipe& r, double v) { r.defects.overshootPercent = v; }},
    {"speed", 0.05, 1, [](ServoRecipe& r, double v) { r.defects.speedFactor = v; }},
    {"speed-per-load", 0, 10, [](ServoRecipe& r, double v) { r.defects.speedPerLoad = v; }},
    {"noise", 0, 50, [](ServoRecipe& r, double v) { r.defects.positionNoise = v; }},
    {"moving", 0, 1, [](ServoRecipe& r, double v) { r.defects.movingFlagStuck = v != 0.0; }, true},
    {"load-friction", 0, 100, [](ServoRecipe& r, double v) { r.load.coulombFriction = v; }},
    {"stop", -3600, 3600,
     [](ServoRecipe& r, double v) { r.load.stopHigh = v * std::numbers::pi / 180.0; }},
    {"supply-ohms", 0, 100, [](ServoRecipe& r, double v) { r.supplyOhms = v; }},
    {"ambient", -40, 150, [](ServoRecipe& r, double v) { r.ambientCelsius = v; }},
    {"eprom-ms", 0, 10'000,
     [](ServoRecipe& r, double v) {
         r.epromTime = base::Duration(static_cast<base::Duration::rep>(v * 1000));
     }},
    {"deaf", 0, 1, [](ServoRecipe& r, double v) { r.behavior.deafWhileWriting = v != 0.0; }, true},
    {"new-id-reply", 0, 1,
     [](ServoRecipe& r, double v) { r.behavior.acknowledgesWithNewId = v != 0.0; }, true},
    {"run-to-goal", 0, 1, [](ServoRecipe& r, double v) { r.behavior.runsToOldGoal = v != 0.0; },
     true},
    {"late-baud", 0, 1, [](ServoRecipe& r, double v) { r.behavior.baudAfterRestart = v != 0.0; },
     true},
    {"staggered-ping", 0, 1,
     [](ServoRecipe& r, double v) { r.behavior.staggersBroadcastPing = v != 0.0; }, true},
};

tl::unexpected<base::Error> badDefect(const QString& detail)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("simulate"), detail);
}

base::Result<void> addDefect(ServoRecipe& recipe, const QString& item, const QString& name,
                             const QString& value)
{
    const auto* word = std::find_if(std::begin(words), std::end(words), [&name](const Word& known) {
        return name == QLatin1String(known.name);
    });
    if (word == std::end(words))
        return badDefect(QStringLiteral("%1: unknown name; known are %2")
                             .arg(item, defectNames().join(QLatin1String(", "))));
    bool ok = false;
    const double figure = value.toDouble(&ok);
    const bool whole = !word->isSwitch || figure == std::floor(figure);
    if (!ok || !whole || !(figure >= word->least && figure <= word->most))
        return badDefect(QStringLiteral("%1: a number from %2 to %3")
                             .arg(item)
                             .arg(word->least)
                             .arg(word->most));
    word->set(recipe, figure);
    return {};
}
} // namespace

base::Result<void> addDefects(ServoRecipe& recipe, const QStringList& items)
{
    QSet<QString> said;
    for (const QString& item : items) {
        const auto equals = item.indexOf(QLatin1Char('='));
        if (equals <= 0)
            return badDefect(QStringLiteral("%1: expected NAME=VALUE").arg(item));
        const QString name = item.left(equals);
        if (said.contains(name))
            return badDefect(QStringLiteral("%1: said twice").arg(item));
        said.insert(name);
        if (auto added = addDefect(recipe, item, name, item.mid(equals + 1)); !added)
            return added;
    }
    return {};
}

QStringList defectNames()
{
    QStringList names;
    for (const Word& word : words)
        names << QString::fromLatin1(word.name);
    return names;
}
} // namespace sim
