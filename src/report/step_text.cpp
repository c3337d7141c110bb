// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_text.h"

#include "report/bilingual.h"
#include "report/sweep_text.h"
#include "text/text_table.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace report {
using catalog::Text;
using results::StepChange;
using results::StepRemedy;
using results::StepSymptom;
using text::NamedText;

namespace {
constexpr std::array figureTexts{
    NamedText{"dead_time", QT_TRANSLATE_NOOP("StepText", "Dead time")},
    NamedText{"rise_time", QT_TRANSLATE_NOOP("StepText", "Rise time 10–90 %")},
    NamedText{"time_to_target", QT_TRANSLATE_NOOP("StepText", "Time to goal")},
    NamedText{"settling", QT_TRANSLATE_NOOP("StepText", "Settling time")},
    NamedText{"overshoot", QT_TRANSLATE_NOOP("StepText", "Overshoot")},
    NamedText{"steady_error", QT_TRANSLATE_NOOP("StepText", "Steady-state error")},
    NamedText{"swings", QT_TRANSLATE_NOOP("StepText", "Oscillations after arrival")},
    NamedText{"swing_frequency", QT_TRANSLATE_NOOP("StepText", "Oscillation frequency")},
    NamedText{"swing_amplitude", QT_TRANSLATE_NOOP("StepText", "Oscillation amplitude")},
    NamedText{"peak_speed", QT_TRANSLATE_NOOP("StepText", "Peak speed")},
    NamedText{"peak_current", QT_TRANSLATE_NOOP("StepText", "Peak current")},
    NamedText{"peak_load", QT_TRANSLATE_NOOP("StepText", "Peak load")},
};

/// Three digits that count: readings and responses scatter by more than the rest.
double partsFor(double value)
{
    const double size = std::abs(value);
    return size >= 100 ? 1 : size >= 10 ? 10 : 100;
}

QString number(double value, double parts)
{
    const double rounded = std::round(value * parts) / parts;
    return QString::number(rounded == 0 ? 0 : rounded, 'g', QLocale::FloatingPointShortest);
}
} // namespace

Text stepFigureText(const QString& key)
{
    if (key == QLatin1String("overshoot_steps"))
        return translate("StepText", "Overshoot", "in steps");
    const NamedText* entry = text::entryFor(figureTexts, key);
    return entry != nullptr ? translate("StepText", entry->text) : inBoth(key);
}

QString stepUnit(const results::StepFigure& figure, bool chinese)
{
    return unitText(QString::fromUtf8(figure.unit)).in(chinese);
}

QString stepValue(std::optional<double> value)
{
    return value && std::isfinite(*value) ? number(*value, partsFor(*value)) : QStringLiteral("–");
}

StepPairText stepPairText(std::optional<double> before, std::optional<double> after)
{
    if (!before || !after || !std::isfinite(*before) || !std::isfinite(*after))
        return {stepValue(before), stepValue(after), QStringLiteral("–")};
    const double parts = partsFor(std::max(std::abs(*before), std::abs(*after)));
    const double change = (std::round(*after * parts) - std::round(*before * parts)) / parts;
    const QString sign = change < 0   ? QStringLiteral("−")
                         : change > 0 ? QStringLiteral("+")
                                      : QString();
    return {number(*before, parts), number(*after, parts), sign + number(std::abs(change), parts)};
}

Text stepChangeText(StepChange change)
{
    switch (change) {
    case StepChange::Better:
        return translate("StepText", "better");
    case StepChange::Worse:
        return translate("StepText", "worse");
    case StepChange::Same:
        return translate("StepText", "unchanged");
    case StepChange::Neither:
        return inBoth(QStringLiteral("–"));
    case StepChange::NotMeasured:
        break;
    }
    return translate("StepText", "not measured");
}

Text stepSymptomText(StepSymptom symptom)
{
    switch (symptom) {
    case StepSymptom::NotSeen:
        return translate("StepText", "Readings were lost while the servo was moving, so the times "
                                     "and speeds of the affected responses are unknown.");
    case StepSymptom::NoMotion:
        return translate("StepText", "The servo did not move, so its gains cannot be judged.");
    case StepSymptom::Blocked:
        return translate("StepText", "The servo stopped far from its goal because its movement is "
                                     "blocked, so its gains cannot be judged.");
    case StepSymptom::Lag:
        return translate("StepText", "The servo lags behind: P is too low.");
    case StepSymptom::SpeedLimit:
        return translate(
            "StepText",
            "The servo moved as fast as its settings allow: speed or acceleration is limited.");
    case StepSymptom::Overshoot:
        return translate("StepText", "The servo overshoots: D is too low.");
    case StepSymptom::StaticError:
        return translate("StepText", "The servo stops short of its goal: I is too low to overcome "
                                     "static friction. Gear backlash cannot be tuned out.");
    case StepSymptom::Jitter:
        return translate("StepText",
                         "The servo jitters: D or the startup force is too high, I is above 0, the "
                         "dead zone is too small, or the mechanism has backlash.");
    case StepSymptom::Oscillation:
        return translate("StepText", "The servo oscillates strongly: P is far too high.");
    }
    return {};
}

Text stepRemedyText(StepRemedy remedy)
{
    switch (remedy) {
    case StepRemedy::RepeatRun:
        return translate("StepText",
                         "Check the cable, adapter and CPU load, then run the test again");
    case StepRemedy::RemoveObstacle:
        return translate("StepText",
                         "Check the mechanism, end stops, torque limit and power supply");
    case StepRemedy::FreeMotion:
        return translate(
            "StepText",
            "Check the power supply, torque limit, alarms and mechanism, or use a larger step");
    case StepRemedy::RaiseP:
        return translate("StepText", "Raise P");
    case StepRemedy::LowerP:
        return translate("StepText", "Lower P");
    case StepRemedy::RaiseD:
        return translate("StepText", "Raise D");
    case StepRemedy::LowerD:
        return translate("StepText", "Lower D");
    case StepRemedy::RaiseI:
        return translate("StepText", "Raise I in small steps until the error is small enough");
    case StepRemedy::DisableI:
        return translate("StepText", "Set I to 0");
    case StepRemedy::LowerStartupForce:
        return translate("StepText", "Lower the startup force");
    case StepRemedy::WidenDeadZone:
        return translate("StepText", "Increase the dead zone");
    case StepRemedy::NarrowDeadZone:
        return translate("StepText", "Reduce the dead zone");
    case StepRemedy::RaiseSpeed:
        return translate("StepText", "Allow a higher speed");
    case StepRemedy::RaiseAcceleration:
        return translate("StepText", "Allow a higher acceleration");
    }
    return {};
}

Text stepAdviceLine(const results::StepAdvice& advice, const Text& registerName)
{
    const Text remedy = stepRemedyText(advice.remedy);
    if (advice.key.isEmpty())
        return remedy;
    const Text values = inBoth(QStringLiteral("%1 → %2").arg(advice.now).arg(advice.proposed));
    return filled(translate("StepText", "%1: %2 %3"), remedy, registerName, values);
}

QString stepAdviceText(const std::vector<results::StepAdvice>& advice, bool chinese)
{
    QString text;
    for (std::size_t i = 0; i < advice.size(); ++i) {
        if (i == 0 || advice[i].symptom != advice[i - 1].symptom)
            text += stepSymptomText(advice[i].symptom).in(chinese) + QLatin1Char('\n');
        text += QStringLiteral("  ") +
                stepAdviceLine(advice[i], inBoth(advice[i].key)).in(chinese) + QLatin1Char('\n');
    }
    return text;
}
} // namespace report
