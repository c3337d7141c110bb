// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/compare_model.h"

#include "catalog/units.h"
#include "catalog/value.h"
#include "text/language.h"
#include "text/restore_text.h"
#include "ui/widgets/test_text.h"

namespace ui {
using snapshot::CompareRow;
using snapshot::RowVerdict;

namespace {
const QString separator = QStringLiteral(" · ");
constexpr int valueDigits = 6;

const jobs::RestoreRow* rowOf(const std::optional<jobs::RestorePlan>& plan, const QString& key)
{
    return plan ? plan->find(key) : nullptr;
}

bool isTemporary(const jobs::RestoreRow* row)
{
    return row != nullptr && row->reasons.testFlag(jobs::RestoreReason::OnlyTemporary);
}

/// The value as the profile of this table formats it; its unit may depend on other rows.
QString formattedIn(const CompareColumn& in, const catalog::Register& reg, std::int64_t raw)
{
    const auto lookup = [&](const QString& key) -> std::optional<std::int64_t> {
        const snapshot::SnapshotRegister* other = in.table->find(key);
        return other != nullptr ? other->raw : std::nullopt;
    };
    return catalog::formatValue(raw, reg, catalog::valueFormat(reg, *in.profile, lookup),
                                text::isUiChinese());
}
} // namespace

namespace {
bool hasSameRows(const snapshot::SnapshotComparison& one, const snapshot::SnapshotComparison& other)
{
    return std::equal(one.rows.begin(), one.rows.end(), other.rows.begin(), other.rows.end(),
                      [](const CompareRow& a, const CompareRow& b) {
                          return a.key == b.key && a.verdict == b.verdict;
                      });
}
} // namespace

/// If only values have changed, the selection and the scroll position stay.
void CompareModel::show(std::vector<CompareColumn> tables, std::optional<jobs::RestorePlan> plan)
{
    std::vector<const snapshot::Snapshot*> compared;
    for (const CompareColumn& one : tables)
        compared.push_back(one.table.get());
    auto found =
        compared.empty() ? snapshot::SnapshotComparison{} : snapshot::compareSnapshots(compared);
    const bool same = tables.size() == m_tables.size() && hasSameRows(found, m_found);
    if (!same)
        beginResetModel();
    m_tables = std::move(tables);
    m_plan = std::move(plan);
    m_found = std::move(found);
    if (same)
        retranslate();
    else
        endResetModel();
}

void CompareModel::retranslate()
{
    if (!m_found.rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

QStringList CompareModel::unrestorableRows() const
{
    QStringList rows;
    for (const CompareRow& row : m_found.rows) {
        const jobs::RestoreRow* planned =
            row.verdict == RowVerdict::Different ? rowOf(m_plan, row.key) : nullptr;
        if (planned != nullptr && !planned->isSelectable)
            rows << QStringLiteral("%1: %2").arg(
                nameOf(row.key),
                text::restoreReasonText(jobs::restoreReasonNames(planned->reasons)));
    }
    return rows;
}

void CompareModel::setAllSelected(jobs::RestoreReason reason, bool on)
{
    if (!m_plan)
        return;
    const std::vector<jobs::RestoreRow> rows = m_plan->rows;
    for (const jobs::RestoreRow& row : rows) {
        if (row.reasons.testFlag(reason) && row.isSelectable)
            m_plan->setSelected(row.key, on);
    }
    retranslate();
    Q_EMIT selectedRowsChanged();
}

const catalog::Register* CompareModel::registerOf(const QString& key) const
{
    for (const CompareColumn& one : m_tables) {
        if (const catalog::Register* reg = one.profile ? one.profile->find(key) : nullptr)
            return reg;
    }
    return nullptr;
}

QString CompareModel::nameOf(const QString& key) const
{
    const catalog::Register* reg = registerOf(key);
    return reg != nullptr ? text::localized(reg->name) : key;
}

QString CompareModel::formatted(const QString& key, std::int64_t raw) const
{
    const QString number = QString::number(raw);
    if (m_tables.empty() || !m_tables.front().profile)
        return number;
    const catalog::Register* reg = m_tables.front().profile->find(key);
    const QString words = reg != nullptr ? formattedIn(m_tables.front(), *reg, raw) : number;
    return words == number ? number : number + separator + words;
}

int CompareModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_found.rows.size());
}

int CompareModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : stateColumn() + 1;
}

Qt::ItemFlags CompareModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && index.column() == Name && m_plan) {
        const jobs::RestoreRow* row = rowOf(m_plan, m_found.rows[std::size_t(index.row())].key);
        if (row != nullptr && row->isSelectable)
            flags |= Qt::ItemIsUserCheckable;
    }
    return flags;
}

QString CompareModel::cellText(const CompareRow& row, std::size_t table) const
{
    const snapshot::CompareCell& cell = row.cells[table];
    switch (cell.state) {
    case snapshot::CellState::Unknown:
        return tr("unknown");
    case snapshot::CellState::Missing:
        return tr("no such register");
    case snapshot::CellState::NotChosen:
        return tr("not written");
    case snapshot::CellState::Known:
        break;
    }
    if (!cell.raw)
        return {};
    const QString number = QString::number(qint64(*cell.raw));
    const CompareColumn& in = m_tables[table];
    const catalog::Register* reg = in.profile ? in.profile->find(row.key) : nullptr;
    QString words;
    if (reg != nullptr)
        words = formattedIn(in, *reg, *cell.raw);
    else if (cell.value && !cell.unit.isEmpty())
        words = QString::number(*cell.value, 'g', valueDigits) + catalog::unitSuffix(cell.unit);
    return words.isEmpty() || words == number ? number : number + separator + words;
}

QString CompareModel::stateText(const CompareRow& row) const
{
    if (m_tables.size() < 2)
        return {}; // nothing to be different from
    const QString verdict = snapshot::verdictName(row.verdict);
    const QString word =
        text::compareVerdictSymbol(verdict) + QLatin1Char(' ') + text::compareVerdictText(verdict);
    const jobs::RestoreRow* planned = rowOf(m_plan, row.key);
    if (planned == nullptr || (row.verdict == RowVerdict::Identical && !isTemporary(planned)))
        return word;
    const auto reasons = planned->reasons & ~jobs::RestoreReasons(jobs::RestoreReason::Same) &
                         ~jobs::RestoreReasons(jobs::RestoreReason::ReadOnly);
    const QString why = text::restoreReasonText(jobs::restoreReasonNames(reasons));
    return why.isEmpty() ? word : word + separator + why;
}

QString CompareModel::tip(const CompareRow& row, int column) const
{
    if (column == Name || column == Address) {
        const QString name = nameOf(row.key);
        const QString title = name == row.key ? name : QStringLiteral("%1 (%2)").arg(name, row.key);
        const catalog::Register* reg = registerOf(row.key);
        const QString help = reg != nullptr ? text::localized(reg->help) : QString();
        return help.isEmpty() ? title : title + QLatin1Char('\n') + help;
    }
    if (column == stateColumn()) {
        QStringList lines{stateText(row)};
        if (const jobs::RestoreRow* planned = rowOf(m_plan, row.key)) {
            for (const QString& reason : jobs::restoreReasonNames(planned->reasons))
                lines << text::restoreReasonHelp(reason);
        }
        return lines.join(QLatin1Char('\n'));
    }
    const auto table = std::size_t(column - FirstTable);
    return m_tables[table].title + QStringLiteral(": ") + cellText(row, table);
}

/// Highlights what differs from the first column; the last column has the sign for it.
QVariant CompareModel::toneOf(const CompareRow& row, int column) const
{
    if (row.verdict == RowVerdict::Identical || row.verdict == RowVerdict::ReadOnly)
        return column == stateColumn() ? QVariant(int(Tone::Quiet)) : QVariant();
    if (column == stateColumn())
        return int(row.verdict == RowVerdict::Different ? Tone::Accent : Tone::Quiet);
    if (column < FirstTable)
        return {};
    const snapshot::CompareCell& cell = row.cells[std::size_t(column - FirstTable)];
    if (cell.state != snapshot::CellState::Known)
        return int(Tone::Quiet);
    const snapshot::CompareCell& first = row.cells.front();
    const bool other = first.state == snapshot::CellState::Known &&
                       (first.raw != cell.raw || first.value != cell.value);
    return other && row.verdict == RowVerdict::Different ? QVariant(int(Tone::Accent)) : QVariant();
}

QVariant CompareModel::checkState(const CompareRow& row) const
{
    const jobs::RestoreRow* planned = rowOf(m_plan, row.key);
    if (planned == nullptr || !planned->isSelectable)
        return {};
    return planned->selected ? Qt::Checked : Qt::Unchecked;
}

QVariant CompareModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const CompareRow& row = m_found.rows[std::size_t(index.row())];
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return column == Name            ? nameOf(row.key)
               : column == Address       ? QString::number(row.address)
               : column == stateColumn() ? stateText(row)
                                         : cellText(row, std::size_t(column - FirstTable));
    case Qt::CheckStateRole:
        return column == Name ? checkState(row) : QVariant();
    case Qt::ToolTipRole:
        return tip(row, column);
    case Qt::TextAlignmentRole:
        return int((column == Address || (column >= FirstTable && column < stateColumn())
                        ? Qt::AlignRight
                        : Qt::AlignLeft) |
                   Qt::AlignVCenter);
    case toneRole:
        return toneOf(row, column);
    case OpenRole:
        return row.verdict == RowVerdict::Different || row.verdict == RowVerdict::Missing ||
               isTemporary(rowOf(m_plan, row.key));
    case KeyRole:
        return row.key;
    default:
        return {};
    }
}

bool CompareModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::CheckStateRole || index.column() != Name || !m_plan)
        return false;
    const QString key = m_found.rows[std::size_t(index.row())].key;
    if (!m_plan->setSelected(key, value.toInt() == Qt::Checked))
        return false;
    Q_EMIT dataChanged(index, index.siblingAtColumn(stateColumn()));
    Q_EMIT selectedRowsChanged();
    return true;
}

QVariant CompareModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const bool table = section >= FirstTable && section < stateColumn();
    if (role == Qt::DisplayRole) {
        return section == Name      ? tr("Register")
               : section == Address ? tr("Address")
               : table              ? m_tables[std::size_t(section - FirstTable)].title
                                    : tr("State");
    }
    if (role == Qt::ToolTipRole && table)
        return m_tables[std::size_t(section - FirstTable)].tip;
    if (role == Qt::TextAlignmentRole)
        return int((section == Address || table ? Qt::AlignRight : Qt::AlignLeft) |
                   Qt::AlignVCenter);
    return {};
}

QString readingText(const jobs::RestoreRow& row)
{
    return QString::number(row.reading, 'g', 4) + catalog::unitSuffix(row.readingUnit);
}

QString alarmLine(const CompareModel& model, const jobs::RestoreRow& row)
{
    const QString limit = model.formatted(row.key, *row.newRaw);
    return model.nameOf(row.key) + QStringLiteral(": ") +
           text::restoreAlarmText(row.alarm, limit, readingText(row));
}

void CompareFilter::setAll(bool all)
{
    m_all = all;
    invalidateFilter();
}

bool CompareFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    if (m_all)
        return true;
    return sourceModel()->index(row, 0, parent).data(CompareModel::OpenRole).toBool();
}
} // namespace ui
