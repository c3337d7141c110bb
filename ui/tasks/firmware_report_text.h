// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a firmware update or rescue as a dialog shows it. Pure, in the current language;
// main thread.
#pragma once

#include "jobs/firmware/firmware_update.h"
#include "ui/widgets/task_text.h"

namespace ui {
/// `before`: the servo's memory table as it was; none: not known.
TaskText firmwareReportText(const jobs::FirmwareReport& report,
                            const std::optional<snapshot::Snapshot>& before);
} // namespace ui
