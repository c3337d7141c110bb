// SPDX-License-Identifier: GPL-3.0-or-later
// The first column of a table takes the space the others leave, but never less than its text needs:
// where the table is too narrow for all, it scrolls sideways. Main thread; lives as long as its
// table.
#pragma once

#include <QObject>

class QTableView;

namespace ui {
class StretchFirstColumn final : public QObject {
    Q_OBJECT

public:
    /// The other columns fit their contents.
    explicit StretchFirstColumn(QTableView* table);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void distribute();

    QTableView* m_table;
    bool m_distributing = false;
};
} // namespace ui
