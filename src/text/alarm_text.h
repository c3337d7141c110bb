// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of alarms and of how to clear them, by their stable English names (jobs::Alarm::key,
// jobs::clearMethodName), in the language of the interface. Pure; any thread.
#pragma once

#include <QString>

namespace text {
/// "overload" → "overload" / "过载"; a name without a text comes back as it is.
QString alarmLabel(const QString& key);

/// The likely cause and what to check: one or two sentences; empty for unknown names.
QString alarmCause(const QString& key);

/// "turn-back" → "A small goal away from the stall clears it: the shaft turns back a little …"
QString releaseText(const QString& release);
} // namespace text
