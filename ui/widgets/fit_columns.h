// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps every column of a table visible, except an optional one: each is as wide as its contents;
// if that does not fit, the widest are shortened first. Their cells are elided, the tooltips have
// the whole text. The last column takes the rest. Main thread; lives as long as its table.
#pragma once

#include <QObject>

#include <vector>

class QTableView;

namespace ui {
class FitColumns final : public QObject {
    Q_OBJECT

public:
    /// The `optional` column is hidden where the first one would be shortened; -1: none.
    explicit FitColumns(QTableView* table, int optional = -1);

    /// Also by itself when the table is resized or filled anew.
    void fit();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int minWidthOf(int column) const;
    std::vector<int> shortened(std::vector<int> widths) const;

    QTableView* m_table;
    int m_optional;
    int m_width = 0; ///< of the viewport when the columns were fitted last
};
} // namespace ui
