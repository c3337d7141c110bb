// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_compare_text.h"

#include "report/bilingual.h"
#include "report/html_page.h"
#include "report/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
constexpr double noticeable = 0.1; ///< of the larger one

Text same(const QString& text)
{
    return {text, text};
}

Text yesNo(const QString& value)
{
    return value == QStringLiteral("true") ? both("yes", "是") : both("no", "否");
}

double share(const record::FigureDifference& figure)
{
    const double larger = std::max(std::abs(*figure.a), std::abs(*figure.b));
    return larger > 0 ? std::abs(*figure.difference) / larger : 0;
}
} // namespace

const CompareTexts& compareTexts()
{
    static const CompareTexts words{
        both("Two sweep tests compared", "两次扫描测试对比"),
        both("A", "A"),
        both("B", "B"),
        both("Test run", "测试记录"),
        both("B − A", "B − A"),
        both("Better", "更优"),
        both("Grade A", "A 结论"),
        both("Grade B", "B 结论"),
        both("What differs in the tests", "测试之间的差异"),
        both("The servos were told to do different things: the figures cannot be compared.",
             "两次测试的运动不同：指标不可比较。"),
        both("Some figures depend on what is different below.", "部分指标受下列差异影响。"),
        both("The limits differ: figures can be compared, grades cannot.",
             "限值不同：指标可以比较，结论不可比较。"),
        both("Both did the same test.", "两次测试内容相同。"),
        both("Part", "项目"),
        both("Settings that differ", "不同的参数"),
        both("No setting differs.", "参数全部相同。"),
        both("Setting", "参数"),
        both("Steady errors of the legs", "各程静差分布"),
    };
    return words;
}

Text testItemText(record::TestItem item)
{
    using record::TestItem;
    const SweepTexts& words = sweepTexts();
    switch (item) {
    case TestItem::Model:
        return words.model;
    case TestItem::Firmware:
        return words.firmware;
    case TestItem::Resolution:
        return both("Steps per turn", "每圈步数");
    case TestItem::Simulated:
        return both("Simulated", "模拟");
    case TestItem::Shape:
        return words.shape;
    case TestItem::Range:
        return both("Range, step", "范围，步");
    case TestItem::Step:
        return both("Step, step", "步长，步");
    case TestItem::Points:
        return words.points;
    case TestItem::Seed:
        return words.seed;
    case TestItem::Period:
        return both("Period, ms", "周期，ms");
    case TestItem::Pace:
        return words.pace;
    case TestItem::Pause:
        return both("Time, ms", "时间，ms");
    case TestItem::Speed:
        return both("Speed, step/s", "速度，步/s");
    case TestItem::Acceleration:
        return both("Acceleration, step/s²", "加速度，步/s²");
    case TestItem::MoveTime:
        return words.moveTime;
    case TestItem::WarmUp:
        return both("Warm-up, ms", "预热，ms");
    case TestItem::Tolerance:
        return words.tolerance;
    case TestItem::Cycles:
        return words.cycles;
    case TestItem::SampleRate:
        return words.sampling;
    case TestItem::Limits:
        return words.limits;
    case TestItem::End:
        break;
    }
    return words.end;
}

Text testValueText(record::TestItem item, const QString& value)
{
    using record::TestItem;
    if (item == TestItem::Simulated)
        return yesNo(value);
    if (value.isEmpty())
        return item == TestItem::Speed || item == TestItem::Acceleration ||
                       item == TestItem::MoveTime
                   ? sweepTexts().asTheServoHasIt
                   : same(QStringLiteral("–"));
    if (item == TestItem::Shape)
        return shapeText(record::sweepShapeFromName(value).value_or(record::SweepShape::Points));
    if (item == TestItem::Pace)
        return paceText(record::sweepPaceFromName(value).value_or(record::SweepPace::Delay));
    if (item == TestItem::End)
        return endText(record::sweepEndFromName(value).value_or(record::SweepEnd::LinkLost));
    return same(value);
}

QString betterSign(const record::FigureDifference& figure)
{
    switch (figure.better) {
    case record::Better::A:
        return QStringLiteral("A");
    case record::Better::B:
        return QStringLiteral("B");
    case record::Better::Neither:
        break;
    }
    return figure.difference ? QStringLiteral("=") : QStringLiteral("–");
}

QString differenceText(const record::FigureDifference& difference)
{
    if (!difference.difference)
        return QStringLiteral("–");
    const QString text = figure(*difference.difference);
    if (text.startsWith(u'-'))
        return QStringLiteral("−") + text.mid(1);
    return text == QStringLiteral("0") ? text : u'+' + text;
}

std::vector<Text> referenceLines(const record::SweepComparison& comparison, std::size_t maxCount)
{
    std::vector<const record::FigureDifference*> chosen;
    for (const record::FigureDifference& one : comparison.figures) {
        if (one.difference && share(one) >= noticeable)
            chosen.push_back(&one);
    }
    std::stable_sort(chosen.begin(), chosen.end(),
                     [](const auto* a, const auto* b) { return share(*a) > share(*b); });
    chosen.resize(std::min(chosen.size(), maxCount));
    std::vector<Text> lines;
    for (const record::FigureDifference* one : chosen) {
        const Text name = metricLabel(one->key);
        const Text unit = unitText(one->unit);
        const QString number = differenceText(*one);
        const bool better = one->better == record::Better::B;
        lines.push_back({QStringLiteral("%1 %2 %3 (%4)")
                             .arg(name.en, number, unit.en,
                                  better ? QStringLiteral("better") : QStringLiteral("worse"))
                             .replace(QStringLiteral("  "), QStringLiteral(" ")),
                         QStringLiteral("%1 %2 %3（%4）")
                             .arg(name.zh, number, unit.zh,
                                  better ? QStringLiteral("更优") : QStringLiteral("更差"))
                             .replace(QStringLiteral(" （"), QStringLiteral("（"))});
    }
    return lines;
}
} // namespace report
