// SPDX-License-Identifier: GPL-3.0-or-later
// The memory table of one servo, one row per register, in the order of the table. Shows what a
// ServoEntry holds; setEntry() is called after every change and every second, and announces only
// the rows that have changed. Raw data has roles of its own; texts come from memory_text.h. Editing
// does not change the model: it emits writeRequested. Owned by the page; main thread.
#pragma once

#include "ui/memory/memory_text.h"

#include <QAbstractTableModel>

namespace ui {
class MemoryModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role : int {
        KeyRole = Qt::UserRole + 1, ///< register key
        RawRole,                    ///< qlonglong; invalid: no number is known
        StateRole,                  ///< RowState as int
        StaleRole,                  ///< bool
        ChangedRole,                ///< bool: differs from the first reading
        DiffersRole,                ///< bool; invalid: default or value not known
        AreaRole,                   ///< catalog::Area as int
        SearchRole,                 ///< everything a search may find
    };

    explicit MemoryModel(QObject* parent = nullptr);

    /// Null, or a servo without a map: an empty table. The entry is not kept.
    void setEntry(const session::ServoEntry* entry, const RowContext& clock);
    void setPhysicalFirst(bool on);
    bool physicalFirst() const { return m_physicalFirst; }
    /// After a change of language.
    void retranslate();

    session::ServoRef servo() const { return m_ref; }
    const MemoryRow& row(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    int rowOf(const QString& key) const; ///< -1: no such register
    const catalog::ProfilePtr& profile() const { return m_profile; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    void writeRequested(const QString& key, qint64 raw, bool temporary);

private:
    void emitAllChanged();
    QVariant rawData(const MemoryRow& row, int role) const;

    session::ServoRef m_ref = 0;
    catalog::ProfilePtr m_profile; ///< keeps the registers alive
    std::vector<MemoryRow> m_rows;
    bool m_physicalFirst = false;
};

inline MemoryColumn memoryColumn(const QModelIndex& index)
{
    return static_cast<MemoryColumn>(index.column());
}
} // namespace ui
