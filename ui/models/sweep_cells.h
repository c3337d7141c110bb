// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of a sweep test say, in the interface's language; the words themselves are the
// report's. Numbers are written as in the report, so that page and paper read alike. Main thread.
#pragma once

#include "record/sweep_run.h"
#include "ui/app/theme.h"

namespace ui {
/// The role by which a model tells ToneDelegate the tone of a cell, as int.
constexpr int toneRole = Qt::UserRole + 100;

QString sweepNumber(const std::optional<double>& value); ///< "3047.75"; "–" for none
QString sweepValue(const std::optional<double>& value, const QString& unit); ///< "9.75 step"
QString metricName(const QString& key);
QString unitName(const QString& unit);
QString gradeText(record::Grade grade);     ///< of a servo or a run: "✔ Passed"
QString lineGradeText(record::Grade grade); ///< of one figure: "✔ OK"
Tone gradeTone(record::Grade grade);
/// "> 8": above this it warns or fails; "–" for no limit.
QString limitText(const record::SweepLimit& limit, const std::optional<double>& bound);
QString reasonText(const record::VerdictLine& line); ///< "above 8 step"
/// Torque was to be switched off at the end, which could not be proved.
QString torqueLeftText(const std::vector<int>& ids);
QString torqueLeftRemedy();
} // namespace ui
