// SPDX-License-Identifier: GPL-3.0-or-later
// The first column of a table takes the space the others leave. Where that is too little for its
// texts, up to half of them is elided, so that the last columns stay in sight; in a narrower
// table nothing is elided, and it scrolls sideways. Main thread; lives as long as its table.
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
