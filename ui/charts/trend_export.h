// SPDX-License-Identifier: GPL-3.0-or-later
// What a trend chart shows as a table for spreadsheets. Values; any thread.
#pragma once

#include "recording/sample_store.h"

#include <QByteArray>
#include <QString>

#include <atomic>
#include <vector>

namespace ui {
struct TrendTable {
    struct Column {
        QString name; ///< with its unit
        std::vector<recording::SamplePoint> points;
    };
    base::Duration zero{}; ///< times are counted from here
    std::vector<Column> columns;
};

/// CSV with a byte order mark, so that Excel reads the names: a line for each instant at which
/// anything was measured, in seconds; cells are empty where a channel was not.
/// Ends early, with what there is, once `stop` is set.
QByteArray trendCsv(const TrendTable& table, const std::atomic_bool& stop = false);

/// Writes a temporary file first. A device is written to. The system's message; empty: done.
QString writeTrendFile(const QString& path, const QByteArray& bytes);
} // namespace ui
