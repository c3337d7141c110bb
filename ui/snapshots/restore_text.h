// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a restore in words: what was written, which old values could not be restored and
// what to do then. Pure functions, in the current language; main thread.
#pragma once

#include "jobs/restore/restore.h"
#include "ui/widgets/banner.h"

#include <functional>

namespace ui {
/// How a register and its value are shown.
struct RegisterNames {
    std::function<QString(const QString& key)> name;
    std::function<QString(const QString& key, std::int64_t raw)> value;
};

/// Written and read back, at least until power-off.
bool isRowApplied(const jobs::RestoreRowResult& row);
/// The result for one servo.
BannerText restoreOutcomeText(const jobs::RestoreOutcome& outcome, const RegisterNames& names);
/// Empty: no old value had to be restored, or all were.
QString notRolledBackText(const jobs::RestoreOutcome& outcome, const RegisterNames& names);
/// What to do after a restore that failed, rolled back or not.
QString restoreRemedy(const jobs::RestoreOutcome& outcome);
/// Empty: the EPROM lock is closed, or there is none.
QString openLockText(device::LockState lock);
} // namespace ui
