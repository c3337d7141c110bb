// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/faults/defect_list.h"

#include <QSet>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
struct DefectOption {
    const char* name;
    double min;
    double max;
    void (*set)(ServoSpec&, double);
    bool isWhole = false;
};
constexpr DefectOption defectOptions[] = {
    {"rest-hysteresis", 0, 400, [](ServoSpec& r, double v) { r.defects.restHysteresis = v; }},
    {"static-error", -400, 400, [](ServoSpec& r, double v) { r.defects.staticError = v; }},
    {"overshoot", 0, 50, [](ServoSpec& r, double v) { r.defects.overshootPercent = v; }},
    {"speed", 0.05, 1, [](ServoSpec& r, double v) { r.defects.speedFactor = v; }},
    {"speed-per-load", 0, 10, [](ServoSpec& r, double v) { r.defects.speedPerLoad = v; }},
    {"noise", 0, 50, [](ServoSpec& r, double v) { r.defects.positionNoise = v; }},
    {"moving", 0, 1, [](ServoSpec& r, double v) { r.defects.movingFlagStuck = v != 0.0; }, true},
    {"firmware-lost", 0, 1, [](ServoSpec& r, double v) { r.defects.firmwareLost = v != 0.0; },
     true},
    {"load-friction", 0, 100, [](ServoSpec& r, double v) { r.load.coulombFriction = v; }},
    {"stop", -3600, 3600,
     [](ServoSpec& r, double v) { r.load.stopHigh = v * std::numbers::pi / 180.0; }},
    {"hand", 0, 720,
     [](ServoSpec& r, double v) { r.load.handSpeed = v * std::numbers::pi / 180.0; }},
    {"supply-ohms", 0, 100, [](ServoSpec& r, double v) { r.supplyOhms = v; }},
    {"ambient", -40, 150, [](ServoSpec& r, double v) { r.ambientCelsius = v; }},
    {"eprom-ms", 0, 10'000,
     [](ServoSpec& r, double v) {
         r.epromTime = base::Duration(static_cast<base::Duration::rep>(v * 1000));
     }},
    {"firmware-minor", 0, 255, [](ServoSpec& r, double v) { r.firmwareMinor = int(v); }, true},
    {"deaf", 0, 1, [](ServoSpec& r, double v) { r.behavior.deafWhileWriting = v != 0.0; }, true},
    {"new-id-reply", 0, 1,
     [](ServoSpec& r, double v) { r.behavior.acknowledgesWithNewId = v != 0.0; }, true},
    {"run-to-goal", 0, 1, [](ServoSpec& r, double v) { r.behavior.runsToOldGoal = v != 0.0; },
     true},
    {"late-baud", 0, 1, [](ServoSpec& r, double v) { r.behavior.baudAfterRestart = v != 0.0; },
     true},
    {"staggered-ping", 0, 1,
     [](ServoSpec& r, double v) { r.behavior.staggersBroadcastPing = v != 0.0; }, true},
};

tl::unexpected<base::Error> invalidDefect(const QString& detail)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("simulate"), detail);
}

base::Result<void> addDefect(ServoSpec& servoSpec, const QString& item, const QString& name,
                             const QString& value)
{
    const auto* option = std::find_if(
        std::begin(defectOptions), std::end(defectOptions),
        [&name](const DefectOption& known) { return name == QLatin1String(known.name); });
    if (option == std::end(defectOptions))
        return invalidDefect(QStringLiteral("%1: unknown name; known are %2")
                                 .arg(item, defectOptionNames().join(QLatin1String(", "))));
    bool ok = false;
    const double number = value.toDouble(&ok);
    const bool whole = !option->isWhole || number == std::floor(number);
    if (!ok || !whole || !(number >= option->min && number <= option->max))
        return invalidDefect(QStringLiteral("%1: a number from %2 to %3")
                                 .arg(item)
                                 .arg(option->min)
                                 .arg(option->max));
    option->set(servoSpec, number);
    return {};
}
} // namespace

base::Result<void> addDefects(ServoSpec& servoSpec, const QStringList& items)
{
    QSet<QString> seen;
    for (const QString& item : items) {
        const auto equals = item.indexOf(QLatin1Char('='));
        if (equals <= 0)
            return invalidDefect(QStringLiteral("%1: expected NAME=VALUE").arg(item));
        const QString name = item.left(equals);
        if (seen.contains(name))
            return invalidDefect(QStringLiteral("%1: said twice").arg(item));
        seen.insert(name);
        if (auto added = addDefect(servoSpec, item, name, item.mid(equals + 1)); !added)
            return added;
    }
    return {};
}

QStringList defectOptionNames()
{
    QStringList names;
    for (const DefectOption& option : defectOptions)
        names << QString::fromLatin1(option.name);
    return names;
}
} // namespace sim
