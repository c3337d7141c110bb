// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_filter.h"

#include "ui/memory/memory_model.h"

namespace ui {
void MemoryFilter::setText(const QString& text)
{
    m_words = text.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

void MemoryFilter::setGroup(std::optional<catalog::Area> group)
{
    m_group = group;
    invalidateFilter();
}

void MemoryFilter::setRowFilter(RowFilter rowFilter)
{
    m_rowFilter = rowFilter;
    invalidateFilter();
}

bool MemoryFilter::isActive() const
{
    return !m_words.isEmpty() || m_group || m_rowFilter != RowFilter::All;
}

bool MemoryFilter::matchesText(const QModelIndex& index) const
{
    if (m_words.isEmpty())
        return true;
    const QString found = index.data(MemoryModel::SearchRole).toString();
    const QString address = found.section(QLatin1Char('\n'), 0, 0);
    constexpr int longestAddress = 3;
    bool number = false;
    m_words.front().toUInt(&number);
    if (number && m_words.size() == 1 && m_words.front().size() <= longestAddress)
        return address.startsWith(m_words.front());
    return std::all_of(m_words.begin(), m_words.end(), [&found](const QString& word) {
        return found.contains(word, Qt::CaseInsensitive);
    });
}

bool MemoryFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    if (m_group && index.data(MemoryModel::AreaRole).toInt() != static_cast<int>(*m_group))
        return false;
    if (m_rowFilter == RowFilter::Changed && !index.data(MemoryModel::ChangedRole).toBool())
        return false;
    if (m_rowFilter == RowFilter::Different && !index.data(MemoryModel::DiffersRole).toBool())
        return false;
    return matchesText(index);
}
} // namespace ui
