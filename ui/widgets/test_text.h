// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the tables of a sweep test, in the language of the interface; the words are those of
// the report. Numbers are written as in the report, so that screen and paper agree. Main thread.
#pragma once

#include "jobs/sweep/sweep.h"
#include "ui/common/theme.h"
#include "ui/widgets/banner.h"

namespace ui {
/// The role under which a model gives ToneDelegate the tone of a cell, as int.
constexpr int toneRole = Qt::UserRole + 100;

QString sweepNumber(const std::optional<double>& value); ///< "3048"; "–" for none
/// "9.75 step"; exact enough to see on which side of the limits of its line it is.
QString sweepValue(const std::optional<double>& value, const QString& unit,
                   const results::VerdictLine* line = nullptr);
QString metricName(const QString& key);
QString unitName(const QString& unit);
QString gradeText(results::Grade grade);     ///< of a servo or a run: "✔ Pass"
QString lineGradeText(results::Grade grade); ///< of one figure: "✔ OK"
Tone gradeTone(results::Grade grade);
/// "> 8": above this it warns or fails; "–" for no limit.
QString limitText(const results::SweepLimit& limit, const std::optional<double>& bound);
QString reasonText(const results::VerdictLine& line); ///< "above 8 step"
/// Of servos that could not be left at the end as they were to be.
QString unreleasedTorqueText(const std::vector<jobs::UnreleasedTorque>& left);
QString unreleasedTorqueRemedy();
/// The way back of what a test has set and could not put back.
QString unrevertedSettingsRemedy();
/// A test was agreed to, and its servo has left the list meanwhile.
BannerText notStartedText();
/// Why a test failed, and the servos that it has left so.
BannerText failureText(const base::Error& error, const std::vector<jobs::UnreleasedTorque>& left);
} // namespace ui
