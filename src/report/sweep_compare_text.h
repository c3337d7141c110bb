// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the comparison of two sweep tests, in both languages; see sweep_text.h. Constant;
// any thread.
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

Text testItemText(results::TestItem item);
/// The value of one side; a technical name becomes a text.
Text testValueText(results::TestItem item, const QString& value);
/// "A" or "B"; "=" where neither is better, "–" where one was not measured.
QString betterSign(const results::FigureDifference& figure);
/// "+2.5", "−8", "–".
QString differenceText(const results::FigureDifference& figure);

/// How a servo compares with its reference: "Hysteresis +5 step (worse)" for each figure that
/// differs by a tenth or more, the largest difference first, at most `maxCount`.
std::vector<Text> referenceLines(const results::SweepComparison& comparison,
                                 std::size_t maxCount = 5);
/// Of a register that is set differently: its name, by the map of a test that has it.
catalog::Text settingName(const results::SweepSide& a, const results::SweepSide& b,
                          const QString& key);
} // namespace report
