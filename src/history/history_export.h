// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of the history as files for other programs: CSV (RFC 4180, one header line, UTC times in
// ISO 8601, UTF-8) and JSON ({"format": "servodesk-history", "version": 1, "servos": […] …}).
// Written page by page, so that a million rows need little memory; the file is replaced in one
// step. Borrows the connection of a history::History (its thread). Fails as history/history_file.h
// and files/text_file.h.
#pragma once

#include "files/csv_text.h"
#include "history/history.h"
#include "history/history_log.h"

namespace history {
enum class HistoryKind : std::uint8_t { Servos, Writes, Snapshots, Alarms, Recordings, Runs };
QString historyKindName(HistoryKind kind); ///< "servos", "writes" …
std::optional<HistoryKind> historyKindFromName(const QString& name);

/// The runs of the servos that match the filter: by model, firmware and ID, which is all that a run
/// contains of a servo.
base::Result<RunFilter> runFilterOf(const History& history, const HistoryFilter& filter);

/// What a file contains of a row: times as QDateTime; an unknown value is null.
struct HistoryField {
    const char* name; ///< the column in CSV, the key in JSON
    QVariant value;
};
using HistoryFields = std::vector<HistoryField>;
HistoryFields fieldsOf(const HistoryServo& servo);
HistoryFields fieldsOf(const HistoryWrite& write);
HistoryFields fieldsOf(const HistorySnapshot& snapshot);
HistoryFields fieldsOf(const HistoryAlarm& alarm);
HistoryFields fieldsOf(const HistoryRecording& recording);
HistoryFields fieldsOf(const TestRun& run);

/// All rows that match the filter (its `limit` and `after` are ignored); returns their number.
base::Result<std::int64_t> exportHistoryCsv(const History& history, HistoryKind kind,
                                            const HistoryFilter& filter, const QString& path,
                                            files::CsvReader reader = files::CsvReader::Program);
/// Several lists in one document.
base::Result<std::int64_t> exportHistoryJson(const History& history,
                                             const std::vector<HistoryKind>& kinds,
                                             const HistoryFilter& filter, const QString& path);
} // namespace history
