// SPDX-License-Identifier: GPL-3.0-or-later
// The files a sweep test leaves behind. Owned by the command; main thread. FileUnwritable,
// DiskFull; BadArgument for an ending nobody knows.
#pragma once

#include "jobs/sweep_recording.h"

namespace cli {
enum class SweepFormat : std::uint8_t { None, Html, Pdf, Json, Csv };

/// By the end of its name. None: no report is wanted.
base::Result<SweepFormat> sweepFormat(const std::optional<QString>& path);

/// Where the readings go: beside the report, under its name.
QString sweepReadingsPath(const QString& report);

base::Result<void> saveSweepReport(const record::SweepRun& run,
                                   const jobs::SweepRecording& readings, SweepFormat format,
                                   const QString& path);
} // namespace cli
