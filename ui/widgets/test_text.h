// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of a sweep test say, in the interface's language; the words themselves are the
// report's. Numbers are written as in the report, so that page and paper read alike. Main thread.
#pragma once

#include "jobs/sweep/sweep.h"
#include "ui/common/theme.h"
#include "ui/widgets/banner.h"

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
