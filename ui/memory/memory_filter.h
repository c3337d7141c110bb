// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of the memory table are shown: by typed words, by group, only changed ones, only those
// different from a known default. Rows stay in the order of the table. Owned by the page; main
// thread.
#pragma once

#include "catalog/register.h"

#include <QSortFilterProxyModel>

#include <optional>

namespace ui {
enum class RowFilter : std::uint8_t {
    All,
    Changed,   ///< not what was read first in this session
    Different, ///< not the factory's default, where that is known
};

class MemoryFilter final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// Every word must occur in the address, a name of either language, the key or the help. A
    /// short number alone is an address, or the beginning of one.
    void setText(const QString& text);
    void setGroup(std::optional<catalog::Area> group);
    void setRowFilter(RowFilter rowFilter);
    bool isActive() const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    bool matchesText(const QModelIndex& index) const;

    QStringList m_words;
    std::optional<catalog::Area> m_group;
    RowFilter m_rowFilter = RowFilter::All;
};
} // namespace ui
