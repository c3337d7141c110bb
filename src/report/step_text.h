// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the step test in both languages: figures, what is wrong with a response, what to
// try. Constant; any thread.
#pragma once

#include "catalog/register.h"
#include "results/step_run.h"

namespace report {
catalog::Text stepFigureText(const QString& key); ///< an unknown key: the key itself
QString stepUnit(const results::StepFigure& figure, bool chinese);
/// "5.25", "12.3", "3455"; a dash where nothing was measured.
QString stepValue(std::optional<double> value);
/// A pair and its difference with the same decimals, so that the three agree as they are shown.
struct StepPairText {
    QString before;
    QString after;
    QString difference; ///< "−17.1", "+0.5", "0"; a dash: not both were measured
};
StepPairText stepPairText(std::optional<double> before, std::optional<double> after);
catalog::Text stepChangeText(results::StepChange change);    ///< "better"; Neither: "–"
catalog::Text stepSymptomText(results::StepSymptom symptom); ///< "It overshoots: D is too low."
catalog::Text stepRemedyText(results::StepRemedy remedy);    ///< "Raise D"
/// "Raise D: Position loop D 32 → 36"; `registerName`: what the reader calls the register.
catalog::Text stepAdviceLine(const results::StepAdvice& advice, const catalog::Text& registerName);
/// One line per symptom, and below it, indented, one line per remedy.
QString stepAdviceText(const std::vector<results::StepAdvice>& advice, bool chinese);
} // namespace report
