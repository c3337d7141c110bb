// SPDX-License-Identifier: GPL-3.0-or-later
// What became of a restore whose old values were to be put back and could not: which registers,
// what was last read of each, and where to go on. Pure functions; any thread.
#pragma once

#include "jobs/restore/restore.h"

#include <functional>

namespace ui {
/// How a register and its value are shown.
struct RegisterNames {
    std::function<QString(const QString& key)> name;
    std::function<QString(const QString& key, std::int64_t raw)> value;
};

/// Empty: nothing had to be put back, or all of it was.
QString notRolledBackText(const jobs::RestoreOutcome& outcome, const RegisterNames& names);
/// What to do when it failed, put back or not.
QString restoreRemedy(const jobs::RestoreOutcome& outcome);
/// Empty: it is closed, or there is none.
QString openLockText(device::LockState lock);
} // namespace ui
