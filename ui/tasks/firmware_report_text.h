// SPDX-License-Identifier: GPL-3.0-or-later
// The result of firmware updates and rescues as a dialog shows it. Pure, in the current language;
// main thread.
#pragma once

#include "jobs/firmware/firmware_update.h"
#include "ui/widgets/task_text.h"

namespace ui {
/// Of one servo.
struct FirmwareUpdate {
    int id = 0;
    std::optional<snapshot::Snapshot> before{}; ///< none: not known, as for a rescued one
    jobs::FirmwareReport report{};
    std::optional<base::Error> refusal{}; ///< why it was not begun; else the report counts
};
bool isUpdated(const FirmwareUpdate& update);

TaskText firmwareReportText(const FirmwareUpdate& update);
/// Of several servos: a line for each. `notStarted`: IDs of those that were left out.
TaskText firmwareReportText(const std::vector<FirmwareUpdate>& updates,
                            const std::vector<int>& notStarted);
} // namespace ui
