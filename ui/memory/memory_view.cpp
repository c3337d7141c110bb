// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_view.h"

#include "ui/common/widget_style.h"
#include "ui/memory/memory_model.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QStyledItemDelegate>

#include <numeric>
#include <utility>

namespace ui {
namespace {
// Hidden in this order where the table is narrow. The panel beside it shows the same.
constexpr std::array hideOrder{MemoryColumn::Area, MemoryColumn::Range, MemoryColumn::Default,
                               MemoryColumn::Access};

// What the table can do without, by its key in the settings.
constexpr std::array optionalColumns{
    std::pair{MemoryColumn::Address, "address"}, std::pair{MemoryColumn::Physical, "physical"},
    std::pair{MemoryColumn::Area, "area"},       std::pair{MemoryColumn::Access, "access"},
    std::pair{MemoryColumn::Default, "default"}, std::pair{MemoryColumn::Range, "range"},
    std::pair{MemoryColumn::State, "state"}};

// In characters: "temporary · 12 s" with its sign. Longer states must not hide columns.
constexpr int defaultStateChars = 17;

int section(MemoryColumn column)
{
    return static_cast<int>(column);
}
} // namespace

MemoryView::MemoryView(QWidget* parent)
    : QTableView(parent)
{
    setObjectName(QStringLiteral("memoryTable"));
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    styleTable(this);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(8);
    horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(horizontalHeader(), &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) {
                auto* menu = new QMenu(this);
                menu->setAttribute(Qt::WA_DeleteOnClose);
                fillColumnMenu(*menu);
                menu->popup(horizontalHeader()->mapToGlobal(at));
            });
}

void MemoryView::setPhysicalFirst(bool on)
{
    m_physicalFirst = on;
    QHeaderView* header = horizontalHeader();
    const int value = header->visualIndex(section(MemoryColumn::Value));
    const int physical = header->visualIndex(section(MemoryColumn::Physical));
    if ((physical < value) != on)
        header->moveSection(std::max(value, physical), std::min(value, physical));
}

void MemoryView::setHiddenColumns(const QStringList& keys)
{
    m_hiddenColumns.clear();
    for (const auto& [column, key] : optionalColumns) {
        if (keys.contains(QLatin1StringView(key)))
            m_hiddenColumns.insert(column);
    }
    fitColumns();
}

QStringList MemoryView::hiddenColumns() const
{
    QStringList keys;
    for (const auto& [column, key] : optionalColumns) {
        if (m_hiddenColumns.count(column) > 0)
            keys << QLatin1StringView(key);
    }
    return keys;
}

void MemoryView::fillColumnMenu(QMenu& menu)
{
    menu.clear();
    for (const auto& [column, key] : optionalColumns) {
        QAction* one = menu.addAction(memoryHeader(column));
        one->setObjectName(QStringLiteral("column_") + QLatin1StringView(key));
        one->setCheckable(true);
        one->setChecked(m_hiddenColumns.count(column) == 0);
        connect(one, &QAction::toggled, this, [this, column = column](bool shown) {
            if (shown) {
                m_hiddenColumns.erase(column);
                setColumnHidden(section(column), false); // a hidden header has no width to measure
                resizeColumns();
            } else {
                m_hiddenColumns.insert(column);
                fitColumns();
            }
            Q_EMIT hiddenColumnsChanged();
        });
    }
}

QStringList MemoryView::visibleKeys() const
{
    QStringList keys;
    if (model() == nullptr)
        return keys;
    const int first = std::max(rowAt(0), 0);
    const int below = rowAt(viewport()->height() - 1);
    const int last = below < 0 ? model()->rowCount() - 1 : below;
    for (int row = first; row <= last; ++row)
        keys << model()->index(row, 0).data(MemoryModel::KeyRole).toString();
    return keys;
}

/// The cell of this row that can be edited: the one under the cursor, else the one shown first.
QModelIndex MemoryView::editableCell(const QModelIndex& index) const
{
    const auto first = m_physicalFirst ? MemoryColumn::Physical : MemoryColumn::Value;
    const auto second = m_physicalFirst ? MemoryColumn::Value : MemoryColumn::Physical;
    const auto can = [this](const QModelIndex& cell) {
        return (cell.flags() & Qt::ItemIsEditable) != 0 && !isColumnHidden(cell.column());
    };
    if (can(index))
        return index;
    for (const MemoryColumn column : {first, second}) {
        const QModelIndex cell = index.siblingAtColumn(section(column));
        if (can(cell))
            return cell;
    }
    return {};
}

bool MemoryView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event)
{
    const bool mine = (trigger & editTriggers()) != 0 && index.isValid();
    if (!mine || state() == EditingState)
        return QTableView::edit(index, trigger, event);
    if (trigger == AnyKeyPressed && event != nullptr) {
        static const QString begins = QStringLiteral("0123456789-+.");
        const QString text = static_cast<QKeyEvent*>(event)->text();
        if (text.isEmpty() || !begins.contains(text.front()))
            return false;
    }
    const QModelIndex cell = editableCell(index);
    if (!cell.isValid()) {
        Q_EMIT readOnlyActivated(index);
        return false;
    }
    return QTableView::edit(cell, trigger, event);
}

void MemoryView::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && state() != EditingState && currentIndex().isValid()) {
        edit(currentIndex(), EditKeyPressed, event);
        event->accept();
        return;
    }
    QTableView::keyPressEvent(event);
}

/// Letters go to the find field.
void MemoryView::keyboardSearch(const QString&) {}

void MemoryView::measureColumn(MemoryColumn column, bool canShrink)
{
    const int index = section(column);
    const int em = fontMetrics().averageCharWidth();
    int width = sizeHintForColumn(index);
    // Values change; space for a common one is always reserved. Long lists of names are cut.
    if (column == MemoryColumn::Value)
        width = std::max(width, 9 * em);
    if (column == MemoryColumn::Physical)
        width = std::clamp(width, 11 * em, 60 * em);
    if (column == MemoryColumn::State)
        width = std::clamp(width, defaultStateChars * em, 28 * em);
    if (column == MemoryColumn::Name)
        width = std::min(width, 34 * em);
    width = std::max(width, horizontalHeader()->sectionSizeHint(index));
    int& columnWidth = m_columnWidths[static_cast<std::size_t>(index)];
    columnWidth = canShrink ? width : std::max(columnWidth, width);
}

void MemoryView::resizeColumns()
{
    ensurePolished();
    horizontalHeader()->ensurePolished();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + rowPadding);
    for (int column = 0; column < memoryColumns; ++column)
        measureColumn(static_cast<MemoryColumn>(column), true);
    fitColumns();
}

void MemoryView::growColumns()
{
    const auto before = m_columnWidths;
    for (const MemoryColumn column :
         {MemoryColumn::Value, MemoryColumn::Physical, MemoryColumn::State})
        measureColumn(column, false);
    if (m_columnWidths != before)
        fitColumns();
    else
        fitRows(false);
}

/// Long columns give way first, then the spare ones go; what is left over goes back to the long
/// ones.
void MemoryView::fitColumns()
{
    const int em = fontMetrics().averageCharWidth();
    const int room = viewport()->width();
    const auto name = static_cast<std::size_t>(MemoryColumn::Name);
    const auto physical = static_cast<std::size_t>(MemoryColumn::Physical);
    const auto state = static_cast<std::size_t>(MemoryColumn::State);
    auto widths = m_columnWidths;
    for (const MemoryColumn column : m_hiddenColumns)
        widths[static_cast<std::size_t>(column)] = 0;
    const auto atLeast = [&](MemoryColumn column, int minWidth) {
        const auto index = static_cast<std::size_t>(column);
        const int header = horizontalHeader()->sectionSizeHint(section(column));
        widths[index] = std::min(widths[index], std::max(minWidth, header));
    };
    atLeast(MemoryColumn::Name, 21 * em);
    atLeast(MemoryColumn::Physical, 17 * em);
    atLeast(MemoryColumn::State, 13 * em);
    int needed = std::accumulate(widths.begin(), widths.end(), 0);
    for (const MemoryColumn column : hideOrder) {
        if (needed <= room)
            break;
        needed -= std::exchange(widths[static_cast<std::size_t>(column)], 0); // hidden
    }
    for (const auto& [column, minWidth] :
         {std::pair{MemoryColumn::Physical, 11 * em}, std::pair{MemoryColumn::Name, 19 * em},
          std::pair{MemoryColumn::State, 13 * em}}) {
        int& width = widths[static_cast<std::size_t>(column)];
        const int header = horizontalHeader()->sectionSizeHint(section(column));
        const int less =
            std::clamp(needed - room, 0, std::max(0, width - std::max(minWidth, header)));
        width -= less;
        needed -= less;
    }
    int left = std::max(0, room - needed);
    for (const auto index : {name, physical, state}) {
        if (m_hiddenColumns.count(static_cast<MemoryColumn>(index)) > 0)
            continue;
        const int more = std::min(left, m_columnWidths[index] - widths[index]);
        widths[index] += more;
        left -= more;
    }
    widths[name] += left;
    for (int column = 0; column < memoryColumns; ++column) {
        const int width = widths[static_cast<std::size_t>(column)];
        setColumnHidden(column, width == 0);
        if (width > 0)
            setColumnWidth(column, width);
    }
    fitRows(true);
}

void MemoryView::fitRows(bool canShrink)
{
    for (int row = 0; model() != nullptr && row < model()->rowCount(); ++row)
        fitRow(row, canShrink);
}

/// Names and lists of flags that are longer than their column get a second line.
void MemoryView::fitRow(int row, bool canShrink)
{
    const int oneLine = fontMetrics().height();
    int text = oneLine;
    for (const MemoryColumn column : {MemoryColumn::Name, MemoryColumn::Physical}) {
        if (!isColumnHidden(section(column)))
            text = std::max(text, cellHeight(model()->index(row, section(column))));
    }
    const bool moreLines = text > oneLine * 3 / 2; // another font is a little higher
    const int height = verticalHeader()->defaultSectionSize() + (moreLines ? text - oneLine : 0);
    if (canShrink ? height != rowHeight(row) : height > rowHeight(row))
        setRowHeight(row, height);
}

int MemoryView::cellHeight(const QModelIndex& index) const
{
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    option.rect = QRect(0, 0, columnWidth(index.column()), rowHeight(index.row()));
    return itemDelegateForIndex(index)->sizeHint(option, index).height();
}

void MemoryView::rowsInserted(const QModelIndex& parent, int first, int last)
{
    QTableView::rowsInserted(parent, first, last);
    for (int row = first; row <= last; ++row)
        fitRow(row, true);
}

void MemoryView::showEvent(QShowEvent* event)
{
    QTableView::showEvent(event);
    resizeColumns(); // the style's fonts are known now
}

void MemoryView::resizeEvent(QResizeEvent* event)
{
    QTableView::resizeEvent(event);
    fitColumns();
    Q_EMIT scrolled();
}

void MemoryView::scrollContentsBy(int dx, int dy)
{
    QTableView::scrollContentsBy(dx, dy);
    if (dy != 0)
        Q_EMIT scrolled();
}

void MemoryView::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        resizeColumns();
}
} // namespace ui
