// SPDX-License-Identifier: GPL-3.0-or-later
// Why a row of a restore is ticked, off or impossible, what the steps and verdicts are called, and
// what a comparison says of a row, in the language of the installed translator. The stable English
// names of jobs and record come in, words go out. Pure; any thread.
#pragma once

#include <QStringList>

namespace text {
/// jobs::restoreReasonName: "identity" → "identity: off unless you ask"; unknown: as it is.
QString restoreReasonText(const QString& reason);
/// The same for several, joined with semicolons.
QString restoreReasonText(const QStringList& reasons);
/// A sentence that explains it, for a tooltip.
QString restoreReasonHelp(const QString& reason);

/// "voltage", "8.0 V", "12.0 V" → "voltage alarm at once: limit 8.0 V, supply 12.0 V now".
QString restoreAlarmText(const QString& fault, const QString& limit, const QString& reading);

QString restoreStepText(const QString& step);       ///< "torque-off" → "torque off; it stays off"
QString restoreVerdictText(const QString& verdict); ///< "rolled-back", "no-answer" …
QString compareVerdictText(const QString& verdict); ///< "read-only" → "read-only"
/// A sign beside the word, so that color is never alone: "≠", "=", "?", "–", "·".
QString compareVerdictSymbol(const QString& verdict);
} // namespace text
