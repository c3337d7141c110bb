// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of the history as files for other programs: CSV (RFC 4180, one header line, UTC times in
// ISO 8601, UTF-8) and JSON ({"format": "servodesk-history", "version": 1, "servos": […] …}).
// Written page by page, so that a million rows need little memory; the file is replaced in one
// step. Borrows the connection of a record::History (its thread). Fails as record/history_file.h
// and record/text_file.h.
#pragma once

#include "history/history.h"
#include "history/history_log.h"

namespace record {
enum class HistoryKind : std::uint8_t { Servos, Writes, Snapshots, Alarms, Recordings, Runs };
QString historyKindName(HistoryKind kind); ///< "servos", "writes" …
std::optional<HistoryKind> historyKindFromName(const QString& name);

/// The runs of the servos a filter means: by model, firmware and ID, as a run knows no more.
base::Result<RunFilter> runFilterOf(const History& history, const HistoryFilter& filter);

/// What a file says of each row, and the names of it: times as QDateTime, what is not known null.
QStringList historyColumns(HistoryKind kind);
QVariantList valuesOf(const HistoryServo& servo);
QVariantList valuesOf(const HistoryWrite& write);
QVariantList valuesOf(const HistorySnapshot& snapshot);
QVariantList valuesOf(const HistoryAlarm& alarm);
QVariantList valuesOf(const HistoryRecording& recording);
QVariantList valuesOf(const TestRun& run);

/// All that fits the filter (its `most` and `after` do not count). Answers the number of rows.
base::Result<std::int64_t> exportHistoryCsv(const History& history, HistoryKind kind,
                                            const HistoryFilter& filter, const QString& path);
/// Several lists in one document.
base::Result<std::int64_t> exportHistoryJson(const History& history,
                                             const std::vector<HistoryKind>& kinds,
                                             const HistoryFilter& filter, const QString& path);
} // namespace record
