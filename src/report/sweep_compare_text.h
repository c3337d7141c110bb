// SPDX-License-Identifier: GPL-3.0-or-later
// Words of the comparison of two sweep tests, in both languages at once; see sweep_words.h.
// Constant; any thread.
#pragma once

#include "catalog/register.h"
#include "results/sweep_compare.h"

namespace report {
using catalog::Text;

struct CompareTexts {
    Text title, a, b, run, difference, better, gradeA, gradeB, warnings, notComparable, someDiffer,
        gradesDiffer, sameTest, testPart, settings, noSettings, setting, steadyErrors;
};
const CompareTexts& compareTexts();

Text testItemText(record::TestItem item);
/// The value of one side, in words where it is a technical name.
Text testValueText(record::TestItem item, const QString& value);
/// "A" or "B"; "=" where they are the same; "–" where one was not measured.
QString betterSign(const record::FigureDifference& figure);
/// "+2.5", "−8", "–".
QString differenceText(const record::FigureDifference& figure);

/// "Hysteresis +5 step (worse)", figures that differ by a tenth or more, the largest first, at most
/// `most`; how one servo compares with its reference.
std::vector<Text> referenceLines(const record::SweepComparison& comparison,
                                 std::size_t maxCount = 5);
} // namespace report
