// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_text.h"

#include "report/bilingual.h"
#include "report/sweep_text.h"

#include <QLocale>

#include <array>
#include <cmath>

namespace report {
using catalog::Text;
using record::StepChange;
using record::StepRemedy;
using record::StepSymptom;

namespace {
struct FigureText {
    const char* key;
    const char* english;
    const char* chinese;
};

constexpr std::array figureTexts{
    FigureText{"dead_time", "Dead time", "延迟时间"},
    FigureText{"rise_time", "Rise time 10–90 %", "上升时间 10–90 %"},
    FigureText{"time_to_target", "Time to target", "到位时间"},
    FigureText{"settling", "Settling time", "整定时间"},
    FigureText{"overshoot", "Overshoot", "超调"},
    FigureText{"overshoot_steps", "Overshoot", "超调步数"},
    FigureText{"steady_error", "Steady-state error", "静差"},
    FigureText{"swings", "Turns after arrival", "到位后往复次数"},
    FigureText{"swing_frequency", "Oscillation frequency", "振荡频率"},
    FigureText{"swing_amplitude", "Oscillation amplitude", "振荡幅度"},
    FigureText{"peak_speed", "Peak speed", "峰值速度"},
    FigureText{"peak_current", "Peak current", "峰值电流"},
    FigureText{"peak_load", "Peak load", "峰值负载"},
};
} // namespace

Text stepFigureText(const QString& key)
{
    for (const FigureText& words : figureTexts) {
        if (key == QLatin1String(words.key))
            return both(words.english, words.chinese);
    }
    return {key, key};
}

QString stepUnit(const record::StepFigure& figure, bool chinese)
{
    return unitText(QString::fromUtf8(figure.unit)).in(chinese);
}

QString stepValue(std::optional<double> value)
{
    if (!value || !std::isfinite(*value))
        return QStringLiteral("–");
    const double rounded = std::round(*value * 100) / 100;
    return QString::number(rounded == 0 ? 0 : rounded, 'g', QLocale::FloatingPointShortest);
}

Text stepChangeText(StepChange change)
{
    switch (change) {
    case StepChange::Better:
        return both("better", "变好");
    case StepChange::Worse:
        return both("worse", "变差");
    case StepChange::Same:
        return both("within the scatter", "在离散范围内");
    case StepChange::Neither:
        return both("–", "–");
    case StepChange::NotMeasured:
        break;
    }
    return both("not measured", "未测量");
}

Text stepSymptomText(StepSymptom symptom)
{
    switch (symptom) {
    case StepSymptom::NotSeen:
        return both("Readings were missing while the servo moved, so the times and speeds of those "
                    "responses are not known.",
                    "运动过程中有读数缺失，因此这些响应的时间和速度未知。");
    case StepSymptom::NoMotion:
        return both("The servo did not move, so nothing is known about its gains.",
                    "舵机没有运动，因此无法评价其增益。");
    case StepSymptom::Blocked:
        return both(
            "It stood still far from its target, so something holds it back, and nothing is "
            "known about its gains.",
            "舵机停在远离目标处，说明运动受阻，因此无法评价其增益。");
    case StepSymptom::Lag:
        return both("It lags behind: P is too small.", "跟随滞后：P 偏小。");
    case StepSymptom::SpeedLimit:
        return both("It is as fast as it was allowed to be: speed or acceleration is limited.",
                    "已达到给定上限：速度或加速度受限。");
    case StepSymptom::Overshoot:
        return both("It overshoots: D is too small.", "超调：D 偏小。");
    case StepSymptom::StaticError:
        return both("It rests beside its target: static friction without enough I. Gear play "
                    "remains in any case.",
                    "停在目标附近：积分不足，存在静差；齿轮间隙不可消除。");
    case StepSymptom::Jitter:
        return both("It jitters: I above 0, D or startup force too large, dead zone too small, or "
                    "play in the mechanism.",
                    "抖动：I 不为 0、D 或启动力过大、死区过小，或机构有间隙。");
    case StepSymptom::Oscillation:
        return both("It oscillates strongly: P is far too large.", "强烈振荡：P 过大。");
    }
    return {};
}

Text stepRemedyText(StepRemedy remedy)
{
    switch (remedy) {
    case StepRemedy::RepeatRun:
        return both("Check cable, adapter and computer load, then run it again",
                    "检查线缆、适配器和电脑负载，然后重新运行");
    case StepRemedy::RemoveObstacle:
        return both("Check mechanism, end stops, torque limit and supply",
                    "检查机构、机械限位、扭矩限制和供电");
    case StepRemedy::FreeMotion:
        return both("Check supply, torque limit, alarms and mechanism, or use a larger step",
                    "检查供电、扭矩限制、报警和机构，或加大阶跃幅度");
    case StepRemedy::RaiseP:
        return both("Raise P", "加大 P");
    case StepRemedy::LowerP:
        return both("Lower P", "减小 P");
    case StepRemedy::RaiseD:
        return both("Raise D", "加大 D");
    case StepRemedy::LowerD:
        return both("Lower D", "减小 D");
    case StepRemedy::RaiseI:
        return both("Raise I in small steps until the error shrinks", "I 由小到大逐步调整");
    case StepRemedy::DisableI:
        return both("Set I to 0", "I 设为 0");
    case StepRemedy::LowerStartupForce:
        return both("Lower the startup force", "减小启动扭矩");
    case StepRemedy::WidenDeadZone:
        return both("Make the dead zone larger", "加大死区");
    case StepRemedy::NarrowDeadZone:
        return both("Make the dead zone smaller", "减小死区");
    case StepRemedy::RaiseSpeed:
        return both("Allow a higher speed", "提高速度上限");
    case StepRemedy::RaiseAcceleration:
        return both("Allow more acceleration", "提高加速度上限");
    }
    return {};
}

Text stepAdviceLine(const record::StepAdvice& advice)
{
    const Text remedy = stepRemedyText(advice.remedy);
    if (advice.key.isEmpty())
        return remedy;
    const QString values =
        QStringLiteral("%1 %2 → %3").arg(advice.key).arg(advice.now).arg(advice.proposed);
    return {remedy.en + QStringLiteral(": ") + values, remedy.zh + QStringLiteral("：") + values};
}

QString stepAdviceText(const std::vector<record::StepAdvice>& advice, bool chinese)
{
    QString text;
    for (std::size_t i = 0; i < advice.size(); ++i) {
        if (i == 0 || advice[i].symptom != advice[i - 1].symptom)
            text += stepSymptomText(advice[i].symptom).in(chinese) + QLatin1Char('\n');
        text += QStringLiteral("  ") + stepAdviceLine(advice[i]).in(chinese) + QLatin1Char('\n');
    }
    return text;
}
} // namespace report
