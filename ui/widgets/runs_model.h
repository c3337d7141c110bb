// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier tests as rows, one for each servo of a run, newest first. Values as the history listed
// them; main thread. Every cell has a tooltip with all of it.
#pragma once

#include "history/history.h"

#include <QAbstractTableModel>

namespace ui {
enum class RunColumn : std::uint8_t {
    Number,
    When,
    Servo,
    Model,
    Firmware,
    Verdict,
    Reference,
    Label,
    Note,
    Count
};

/// One servo in a run.
struct RunRow {
    std::int64_t number = 0;
    int servo = -1;
    bool operator==(const RunRow&) const = default;
};

class RunsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(std::vector<history::TestRun> runs);
    void retranslate();

    const history::TestRun& run(int row) const { return m_runs[m_rows.at(std::size_t(row)).run]; }
    const history::TestServo& servo(int row) const;
    RunRow at(int row) const { return {run(row).number, servo(row).id}; }
    int rowOf(const RunRow& wantedRow) const; ///< -1: it is not shown

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

private:
    struct RowIndex {
        std::size_t run = 0;
        std::size_t servo = 0;
    };
    QString cell(int row, RunColumn column) const;
    QString toolTipText(int row) const;

    std::vector<history::TestRun> m_runs;
    std::vector<RowIndex> m_rows;
};
} // namespace ui
