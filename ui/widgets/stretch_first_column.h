// SPDX-License-Identifier: GPL-3.0-or-later
// The first column of a table takes the room the others leave, but never less than its words need:
// where the table is too narrow for all, it scrolls sideways. Lives on the main thread as long as
// its table.
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
