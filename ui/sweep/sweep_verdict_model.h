// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of one servo in a sweep test and how they are graded: a row a limit, what failed on
// top, and if wished a row for each figure without a limit. A figure that was not measured keeps
// its row and says so. Updated while the test runs; equal rows change nothing. Owned by the page;
// main thread.
#pragma once

#include "results/sweep_run.h"

#include <QAbstractTableModel>

namespace ui {
enum class VerdictColumn : std::uint8_t { Metric, Grade, Value, Warn, Fail, Count };

class SweepVerdictModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role : int {
        MetricRole = Qt::UserRole + 1, ///< SweepMetric::key
        GradeRole,                     ///< results::Grade as int; invalid: not evaluated
        ReasonRole,                    ///< why, in words
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::vector<results::SweepMetric>& metrics,
              const std::vector<results::VerdictLine>& lines);
    void clear() { show({}, {}); }
    /// Also the figures without a limit. Off at first.
    void setShowAll(bool all);
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

private:
    struct Row {
        results::SweepMetric figure;
        std::optional<results::VerdictLine> line{};
        bool operator==(const Row&) const = default;
        bool sameLine(const Row& other) const;
        const std::optional<double>& value() const { return line ? line->value : figure.value; }
    };
    std::vector<Row> rowsOf() const;
    void refresh();
    QString cell(const Row& row, VerdictColumn column) const;
    QString tip(const Row& row) const;

    std::vector<results::SweepMetric> m_metrics;
    std::vector<results::VerdictLine> m_lines;
    std::vector<Row> m_rows;
    bool m_showAll = false;
};
} // namespace ui
