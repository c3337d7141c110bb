// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the step-response lab in both languages at once: figures, what is wrong with a
// response, what to try. Constant; any thread.
#pragma once

#include "catalog/register.h"
#include "results/step_run.h"

namespace report {
catalog::Text stepFigureText(const QString& key); ///< an unknown key comes back as it is
QString stepUnit(const record::StepFigure& figure, bool chinese);
/// "5.2", "12.25"; a dash where nothing was measured.
QString stepValue(std::optional<double> value);
catalog::Text stepChangeText(record::StepChange change);    ///< "better"; Same: "–"
catalog::Text stepSymptomText(record::StepSymptom symptom); ///< "It overshoots: D is too small."
catalog::Text stepRemedyText(record::StepRemedy remedy);    ///< "Raise D"
/// "Raise D: position_d 32 → 36"
catalog::Text stepAdviceLine(const record::StepAdvice& advice);
/// What is wrong, once, and below it, indented, what may help: a line each.
QString stepAdviceText(const std::vector<record::StepAdvice>& advice, bool chinese);
} // namespace report
