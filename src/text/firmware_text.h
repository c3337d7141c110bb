// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a firmware update: its checks, its outcome, and what to do next, in the language of
// the interface. Pure; any thread.
#pragma once

#include "base/firmware_update.h"

namespace text {
QString firmwareCheckLabel(base::FirmwareCheck check);
/// What was found, as one sentence; where the check has failed, also why it matters.
QString firmwareCheckText(const base::FirmwareCheckResult& result);

QString firmwareOutcomeText(base::FirmwareOutcome outcome);
/// Empty: nothing to do.
QString firmwareOutcomeRemedy(base::FirmwareOutcome outcome);

/// How many settings differ afterwards; a list may follow.
QString firmwareChangesText(int count);

/// The settings could not be read afterwards.
QString firmwareTableUnreadText();

/// Not tried on real hardware by us.
QString firmwareUntriedText();
} // namespace text
