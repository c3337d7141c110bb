// SPDX-License-Identifier: GPL-3.0-or-later
// The words for a robot arm's joints, in the language of the interface. Pure; any thread.
#pragma once

#include "base/arm.h"

namespace text {
/// What to do with the joint while its range is recorded: "keep moving".
QString jointStateText(base::JointState state);
QString moveTestStateText(base::MoveTestState state); ///< "reached both ends"
/// One sentence with the cause; the remedy differs between window and command line.
QString armRemarkText(const base::ArmRemark& remark);
} // namespace text
