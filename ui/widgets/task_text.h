// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the dialogs of the servo menu about servos, writes and results. Pure functions, in
// the current language; main thread.
#pragma once

#include "base/error.h"
#include "device/writer.h"
#include "session/servos/servo_entry.h"
#include "ui/common/theme.h"

namespace ui {
/// The result shown by a dialog: a headline with its sign, and details.
struct TaskText {
    Tone tone = Tone::Quiet;
    QString message;
    QStringList details{};
};

QString servoTitle(const session::ServoEntry& entry); ///< "ID 3 · STS3250 · firmware 3.10"
QString modelName(const session::ServoEntry& entry);

/// A register's number as a person reads it, or a dash.
QString valueText(const device::Servo& servo, const QString& key,
                  const std::optional<std::int64_t>& raw);

QString registerText(const device::Servo& servo, const QString& key); ///< its name, else the key

QString lockLine(device::LockState lock); ///< "EPROM lock: closed"
QStringList noticeLines(const device::Notices& notices);
TaskText errorText(const base::Error& error); ///< what, likely cause, what to do
TaskText refusedText(const base::Error& error, const QString& what);

/// How a write ended, with where the servo answers now. `done` is the headline if all is well.
TaskText writeText(const session::ServoEntry& entry, const device::WriteReport& report,
                   const QString& done);
} // namespace ui
