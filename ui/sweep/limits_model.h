// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a limits file while the user edits them: cells are kept as typed, so that errors can
// be corrected, and trouble() describes them. Owned by its dialog; main thread.
#pragma once

#include "results/sweep_limits.h"

#include <QAbstractTableModel>

namespace ui {
enum class LimitColumn : std::uint8_t { Metric, Direction, Warn, Fail, Unit, Count };

class LimitsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setLines(const std::vector<results::SweepLimit>& lines);
    /// Call trouble() first: cells that are not numbers are left out.
    std::vector<results::SweepLimit> lines() const;
    /// With a figure that has no line yet. The new row.
    int add();
    void remove(int row);
    /// The error of this line; empty: none.
    QString problem(int row) const;
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void edited(); ///< something is not as it was: look for trouble again

private:
    struct Line {
        QString metric;
        bool atLeast = false;
        QString warn; ///< as typed; empty: none
        QString fail;
    };
    QString boundError(const Line& line) const;
    QString cell(const Line& line, LimitColumn column) const;

    std::vector<Line> m_lines;
};

/// With a point or a comma. None: empty, or no number.
std::optional<double> numberFromText(const QString& text);
/// "at most", "at least"
QString limitDirection(bool atLeast);
} // namespace ui
