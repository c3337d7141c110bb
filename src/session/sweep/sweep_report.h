// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a sweep test: the report in the format of its extension, and next to it the readings
// as a recording. Any thread, of which a PDF needs a QGuiApplication. FileUnwritable,
// DiskFull.
#pragma once

#include "jobs/sweep/sweep_recording.h"

namespace session {
enum class SweepFormat : std::uint8_t { Html, Pdf, Json, Csv };

/// By the end of its name; nullopt: none that is known.
std::optional<SweepFormat> sweepFormatOf(const QString& path);

/// The file of the readings: next to the report, under its name.
QString sweepReadingsPath(const QString& report);

/// Copies a file of readings next to the report, under its name; nothing to do where it is there
/// already, or `from` is empty.
base::Result<void> copySweepReadings(const QString& from, const QString& report);

/// `chinese`: the language a report opens in.
base::Result<void> saveSweepReport(const results::SweepRun& run,
                                   const jobs::SweepRecording& readings, SweepFormat format,
                                   bool chinese, const QString& path);
} // namespace session
