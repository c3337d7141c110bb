// SPDX-License-Identifier: GPL-3.0-or-later
// The ways out of the memory table: the clipboard, a CSV or HTML file, paper. Dialogs are opened,
// never waited for. What cannot be written is told by `failed`. Owned by the page; main thread.
#pragma once

#include "session/desk.h"
#include "ui/memory/memory_sheet.h"

#include <QPointer>

class QTableView;

namespace ui {
class MemoryOutput final : public QObject {
    Q_OBJECT

public:
    MemoryOutput(session::Desk& desk, const MemoryModel& model, QTableView& view);

    void copyRows();
    void exportTable();
    void printTable();

    /// HTML where the name says so, else CSV. Errors: FileUnwritable, DiskFull.
    static base::Result<void> save(const TableSheet& sheet, const QString& path);

Q_SIGNALS:
    void failed(const base::Error& error);
    void saved(const QString& path);

private:
    std::optional<TableSheet> sheet(bool selectedOnly) const;
    std::vector<int> shownRows(bool selectedOnly) const;

    session::Desk& m_desk;
    const MemoryModel& m_model;
    QTableView& m_view;
};
} // namespace ui
