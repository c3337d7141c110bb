// SPDX-License-Identifier: GPL-3.0-or-later
// An event as text for the message line and the log: one sentence, its details, and how serious it
// is. In the language of the installed translator. Pure; main thread.
#pragma once

#include "session/event.h"
#include "session/servos/servo_registry.h"
#include "ui/common/theme.h"

#include <QStringList>

namespace ui {
struct EventText {
    QString message;     ///< one sentence; empty: nothing worth a line
    QStringList details; ///< cause, remedy, notices: one sentence each
    Tone tone = Tone::Quiet;
    QString symbol; ///< stands beside the color: "✓", "!", "✗", "·"
};
EventText describe(const session::Event& event, const session::ServoRegistry& registry);

/// "set ID" for "set-id": the technical names of tasks and operations.
QString taskLabel(const QString& task);
} // namespace ui
