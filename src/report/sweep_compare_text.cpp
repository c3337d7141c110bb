// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_compare_text.h"

#include "report/bilingual.h"
#include "report/html_page.h"
#include "report/register_name.h"
#include "report/sweep_text.h"
#include "text/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace report {
namespace {
constexpr double noticeable = 0.1; ///< of the larger one

Text yesNo(const QString& value)
{
    return value == QStringLiteral("true") ? translate("SweepCompareText", "yes")
                                           : translate("SweepCompareText", "no");
}

double share(const results::FigureDifference& figure)
{
    const double larger = std::max(std::abs(*figure.a), std::abs(*figure.b));
    return larger > 0 ? std::abs(*figure.difference) / larger : 0;
}

/// Items with the names that they have in the report.
struct ReportItem {
    results::TestItem key;
    Text SweepTexts::*text;
};

constexpr std::array reportItems{
    ReportItem{results::TestItem::Model, &SweepTexts::model},
    ReportItem{results::TestItem::Firmware, &SweepTexts::firmware},
    ReportItem{results::TestItem::Shape, &SweepTexts::shape},
    ReportItem{results::TestItem::Points, &SweepTexts::points},
    ReportItem{results::TestItem::Seed, &SweepTexts::seed},
    ReportItem{results::TestItem::Pace, &SweepTexts::pace},
    ReportItem{results::TestItem::MoveTime, &SweepTexts::moveTime},
    ReportItem{results::TestItem::Tolerance, &SweepTexts::tolerance},
    ReportItem{results::TestItem::Cycles, &SweepTexts::cycles},
    ReportItem{results::TestItem::SampleRate, &SweepTexts::sampling},
    ReportItem{results::TestItem::Limits, &SweepTexts::limits},
    ReportItem{results::TestItem::End, &SweepTexts::end},
};

struct OwnItem {
    results::TestItem key;
    const char* text;
};

constexpr std::array ownItems{
    OwnItem{results::TestItem::Resolution, QT_TRANSLATE_NOOP("SweepCompareText", "Steps per turn")},
    OwnItem{results::TestItem::Simulated, QT_TRANSLATE_NOOP("SweepCompareText", "Simulated")},
    OwnItem{results::TestItem::Range, QT_TRANSLATE_NOOP("SweepCompareText", "Range, steps")},
    OwnItem{results::TestItem::Step, QT_TRANSLATE_NOOP("SweepCompareText", "Step size, steps")},
    OwnItem{results::TestItem::Period, QT_TRANSLATE_NOOP("SweepCompareText", "Period, ms")},
    OwnItem{results::TestItem::Pause, QT_TRANSLATE_NOOP("SweepCompareText", "Dwell or delay, ms")},
    OwnItem{results::TestItem::Speed, QT_TRANSLATE_NOOP("SweepCompareText", "Speed, step/s")},
    OwnItem{results::TestItem::Acceleration,
            QT_TRANSLATE_NOOP("SweepCompareText", "Acceleration, step/s²")},
    OwnItem{results::TestItem::WarmUp, QT_TRANSLATE_NOOP("SweepCompareText", "Warm-up, ms")},
};
} // namespace

const CompareTexts& compareTexts()
{
    static const CompareTexts words{
        translate("SweepCompareText", "Comparison of two sweep tests"),
        inBoth(QStringLiteral("A")),
        inBoth(QStringLiteral("B")),
        translate("SweepCompareText", "Test run"),
        inBoth(QStringLiteral("B − A")),
        translate("SweepCompareText", "Better"),
        translate("SweepCompareText", "Grade, test A"),
        translate("SweepCompareText", "Grade, test B"),
        translate("SweepCompareText", "Differences between the tests"),
        translate("SweepCompareText",
                  "The tests used different movements, so the metrics cannot be compared."),
        translate("SweepCompareText", "Some metrics depend on the differences below."),
        translate("SweepCompareText",
                  "The limits differ: the metrics can be compared, but the grades cannot."),
        translate("SweepCompareText", "Both tests used the same settings."),
        translate("SweepCompareText", "Item"),
        translate("SweepCompareText", "Different settings"),
        translate("SweepCompareText", "All settings are the same."),
        translate("SweepCompareText", "Setting"),
        translate("SweepCompareText", "Distribution of steady-state error"),
    };
    return words;
}

Text testItemText(results::TestItem item)
{
    if (const ReportItem* entry = text::entryFor(reportItems, item))
        return sweepTexts().*entry->text;
    const OwnItem* entry = text::entryFor(ownItems, item);
    return entry != nullptr ? translate("SweepCompareText", entry->text) : Text();
}

Text testValueText(results::TestItem item, const QString& value)
{
    using results::TestItem;
    if (item == TestItem::Simulated)
        return yesNo(value);
    if (value.isEmpty())
        return item == TestItem::Speed || item == TestItem::Acceleration ||
                       item == TestItem::MoveTime
                   ? sweepTexts().asTheServoHasIt
                   : inBoth(QStringLiteral("–"));
    if (item == TestItem::Limits) {
        const QString second = QStringLiteral(" (2)"); // of two with one name
        if (!value.endsWith(second))
            return limitsName(value);
        const Text form{QStringLiteral("%1 (2)"), QStringLiteral("%1（2）")};
        return filled(form, limitsName(value.chopped(second.size())));
    }
    if (item == TestItem::Shape)
        return shapeText(results::sweepShapeFromName(value).value_or(results::SweepShape::Points));
    if (item == TestItem::Pace)
        return paceText(results::sweepPaceFromName(value).value_or(results::SweepPace::Delay));
    if (item == TestItem::End)
        return endText(results::sweepEndFromName(value).value_or(results::SweepEnd::LinkLost));
    return inBoth(value);
}

QString betterSign(const results::FigureDifference& figure)
{
    switch (figure.better) {
    case results::Better::A:
        return QStringLiteral("A");
    case results::Better::B:
        return QStringLiteral("B");
    case results::Better::Neither:
        break;
    }
    return figure.difference ? QStringLiteral("=") : QStringLiteral("–");
}

QString differenceText(const results::FigureDifference& difference)
{
    if (!difference.difference)
        return QStringLiteral("–");
    const QString text = figure(*difference.difference);
    if (text.startsWith(u'-'))
        return QStringLiteral("−") + text.mid(1);
    return text == QStringLiteral("0") ? text : u'+' + text;
}

std::vector<Text> referenceLines(const results::SweepComparison& comparison, std::size_t maxCount)
{
    std::vector<const results::FigureDifference*> chosen;
    for (const results::FigureDifference& one : comparison.figures) {
        if (one.difference && share(one) >= noticeable)
            chosen.push_back(&one);
    }
    std::stable_sort(chosen.begin(), chosen.end(),
                     [](const auto* a, const auto* b) { return share(*a) > share(*b); });
    chosen.resize(std::min(chosen.size(), maxCount));
    std::vector<Text> lines;
    for (const results::FigureDifference* one : chosen) {
        const Text name = metricLabel(one->key);
        const Text unit = unitText(one->unit);
        const Text number = inBoth(differenceText(*one));
        const bool better = one->better == results::Better::B;
        Text line = filled(translate("SweepCompareText", "%1 %2 %3 (%4)", "figure, number, unit"),
                           name, number, unit,
                           better ? translate("SweepCompareText", "better")
                                  : translate("SweepCompareText", "worse"));
        // A figure without a unit leaves two spaces.
        line.en.replace(QStringLiteral("  "), QStringLiteral(" "));
        line.zh.replace(QStringLiteral(" （"), QStringLiteral("（"));
        lines.push_back(line);
    }
    return lines;
}

catalog::Text settingName(const results::SweepSide& a, const results::SweepSide& b,
                          const QString& key)
{
    const catalog::Text name = registerName(a.servo.parameters.servo, key);
    return name.en != key ? name : registerName(b.servo.parameters.servo, key);
}
} // namespace report
