// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms and what releases them, in words, in the language of the installed translator. Stable
// English names come in (jobs::Alarm::key, jobs::clearMethodName), words go out. Pure; any thread.
#pragma once

#include <QString>

namespace text {
/// "overload" → "overload" / "过载"; a name without words comes back as it is.
QString alarmLabel(const QString& key);

/// What likely raised it, and what to look at: one or two sentences; empty for unknown names.
QString alarmCause(const QString& key);

/// "turn-back" → "A small goal away from the stall releases it; the shaft turns a little."
QString releaseText(const QString& release);
} // namespace text
