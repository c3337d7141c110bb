// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a restore (why a row is selected or not, steps, verdicts) and of a comparison, by
// the stable English names of jobs and snapshot, in the language of the interface. Pure; any
// thread.
#pragma once

#include <QStringList>

namespace text {
/// jobs::restoreReasonName: "identity" → "identity: not written by default"; unknown: as it is.
QString restoreReasonText(const QString& reason);
/// The same for several, joined with semicolons.
QString restoreReasonText(const QStringList& reasons);
/// A sentence that explains it, for a tooltip.
QString restoreReasonHelp(const QString& reason);

/// "voltage", "8.0 V", "12.0 V" → "immediate voltage alarm: limit 8.0 V, present supply 12.0 V".
QString restoreAlarmText(const QString& fault, const QString& limit, const QString& reading);

QString restoreStepText(const QString& step);       ///< "unlock" → "unlock the EPROM"
QString restoreVerdictText(const QString& verdict); ///< "rolled-back", "no-answer" …
QString compareVerdictText(const QString& verdict); ///< "read-only" → "read-only"
/// Shown beside the text, because color alone is not enough: "≠", "=", "?", "–", "·".
QString compareVerdictSymbol(const QString& verdict);
} // namespace text
