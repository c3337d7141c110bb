// SPDX-License-Identifier: GPL-3.0-or-later
// The table itself: Enter and double-click open the editor of a row from any of its cells, digits
// begin a new value. Columns that do not fit are hidden, the least important first; the help panel
// shows their contents. Owned by the page; main thread.
#pragma once

#include "ui/memory/memory_text.h"

#include <QTableView>

#include <array>
#include <set>

namespace ui {
class MemoryView final : public QTableView {
    Q_OBJECT

public:
    explicit MemoryView(QWidget* parent);

    /// The unit's column before the raw one, and the one that Enter edits.
    void setPhysicalFirst(bool on);
    /// Registers in sight.
    QStringList visibleKeys() const;
    /// After another servo, language or font: columns as wide as what is in them.
    void resizeColumns();
    /// Columns the user does without; the others go by themselves where there is no room.
    void setHiddenColumns(const QStringList& keys);
    QStringList hiddenColumns() const;
    /// Checkable, one a column that can be hidden; refilled by each call.
    void fillColumnMenu(QMenu& menu);
    /// Columns grow where a value has become longer; they never jump back while one is watching.
    void growColumns();

Q_SIGNALS:
    void scrolled();             ///< other rows may be in sight
    void hiddenColumnsChanged(); ///< by the user
    void readOnlyActivated(const QModelIndex& index);

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyboardSearch(const QString& search) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void rowsInserted(const QModelIndex& parent, int first, int last) override;
    void changeEvent(QEvent* event) override;

private:
    QModelIndex editableCell(const QModelIndex& index) const;
    void measureColumn(MemoryColumn column, bool canShrink);
    void fitColumns();
    void fitRows(bool canShrink);
    void fitRow(int row, bool canShrink);
    int cellHeight(const QModelIndex& index) const; ///< of its text, in as many lines as it needs

    bool m_physicalFirst = false;
    std::set<MemoryColumn> m_hiddenColumns; ///< by the user
    std::array<int, memoryColumns> m_columnWidths{};
};
} // namespace ui
