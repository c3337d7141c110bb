// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of the memory table: clipboard, CSV or HTML file, printer. Its dialogs do not block.
// What cannot be written is reported by failed(). Owned by the page; main thread.
#pragma once

#include "session/servos/servo_registry.h"
#include "ui/memory/memory_sheet.h"

#include <QPointer>

class QTableView;

namespace ui {
class MemoryOutput final : public QObject {
    Q_OBJECT

public:
    MemoryOutput(session::ServoRegistry& registry, const MemoryModel& model, QTableView& view);

    void copyRows();
    void exportTable();
    void printTable();

    /// HTML for a file name ending in .html, else CSV. Errors: FileUnwritable, DiskFull.
    static base::Result<void> save(const TableSheet& sheet, const QString& path);

Q_SIGNALS:
    void failed(const base::Error& error);
    void saved(const QString& path);

private:
    std::optional<TableSheet> sheet(bool selectedOnly) const;
    std::vector<int> shownRows(bool selectedOnly) const;

    session::ServoRegistry& m_registry;
    const MemoryModel& m_model;
    QTableView& m_view;
};
} // namespace ui
