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
catalog::Text stepChangeText(results::StepChange change);    ///< "better"; Neither: "–"
catalog::Text stepSymptomText(results::StepSymptom symptom); ///< "It overshoots: D is too low."
catalog::Text stepRemedyText(results::StepRemedy remedy);    ///< "Raise D"
/// "Raise D: position_d 32 → 36"
catalog::Text stepAdviceLine(const results::StepAdvice& advice);
/// One line per symptom, and below it, indented, one line per remedy.
QString stepAdviceText(const std::vector<results::StepAdvice>& advice, bool chinese);
} // namespace report
