// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps every column of a table in sight: each is as wide as its contents, and where that is more
// than the table has, the widest are shortened first; their cells elide, the tooltips have them
// whole. The last column takes what is left. Lives on the main thread as long as its table.
#pragma once

#include <QObject>

class QTableView;

namespace ui {
class FitColumns final : public QObject {
    Q_OBJECT

public:
    explicit FitColumns(QTableView* table);

    /// Also by itself when the table is resized or filled anew.
    void fit();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int minWidthOf(int column) const;

    QTableView* m_table;
    int m_width = 0; ///< of the viewport when the columns were fitted last
};
} // namespace ui
