// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_model.h"

#include "report/commission_text.h"
#include "text/language.h"
#include "ui/widgets/test_text.h"

#include <QDir>

namespace ui {
namespace {
Tone toneOf(results::CommissionVerdict verdict)
{
    switch (verdict) {
    case results::CommissionVerdict::Good:
        return Tone::Good;
    case results::CommissionVerdict::Remark:
        return Tone::Warn;
    case results::CommissionVerdict::Failed:
        return Tone::Bad;
    case results::CommissionVerdict::Skipped:
        break;
    }
    return Tone::Quiet;
}

QString idAndRateText(int id, int baud)
{
    return id < 0 ? QStringLiteral("–")
                  : QStringLiteral("%1 · %2").arg(id).arg(results::rateLabel(baud));
}
} // namespace

void CommissionModel::show(const results::CommissionBatch& batch)
{
    if (batch.rows.size() < m_rows.size() ||
        !std::equal(m_rows.begin(), m_rows.end(), batch.rows.begin())) {
        beginResetModel();
        m_rows = batch.rows;
        endResetModel();
    } else if (batch.rows.size() > m_rows.size()) {
        beginInsertRows({}, int(m_rows.size()), int(batch.rows.size()) - 1);
        m_rows = batch.rows;
        endInsertRows();
    }
}

void CommissionModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(int(m_rows.size()) - 1, ColumnCount - 1));
}

QStringList CommissionModel::labels(const QList<int>& rows) const
{
    QStringList found;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool isSelected = rows.isEmpty() || rows.contains(int(i));
        if (isSelected && !m_rows[i].label.isEmpty())
            found.append(m_rows[i].label);
    }
    return found;
}

int CommissionModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int CommissionModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(ColumnCount);
}

QString CommissionModel::text(const results::CommissionRow& row, int column) const
{
    const bool chinese = text::isUiChinese();
    switch (column) {
    case Verdict:
        return report::commissionVerdictSign(row.verdict) + QLatin1Char(' ') +
               report::commissionVerdictText(row.verdict).in(chinese);
    case Label:
        return row.label;
    case Model:
        return row.servo.model;
    case Before:
        return idAndRateText(row.servo.id, row.oldBaud);
    case After:
        return idAndRateText(row.newId, row.newBaud);
    case Written:
        return row.templateName.isEmpty() ? QStringLiteral("–") : QString::number(row.written);
    case Voltage:
        return row.volts ? QStringLiteral("%1 V").arg(*row.volts, 0, 'f', 1) : QStringLiteral("–");
    default:
        return report::commissionIssuesText(row.issues).in(chinese);
    }
}

QString CommissionModel::tip(const results::CommissionRow& row) const
{
    QStringList lines{row.label.isEmpty() ? row.servo.model : row.label};
    if (!row.issues.empty())
        lines.append(text(row, Remarks));
    lines.append(row.snapshot.isEmpty() ? tr("Nothing was written")
                                        : tr("Memory table saved before the first write: %1")
                                              .arg(QDir::toNativeSeparators(row.snapshot)));
    return lines.join(QLatin1Char('\n'));
}

QVariant CommissionModel::data(const QModelIndex& index, int role) const
{
    const results::CommissionRow& row = m_rows.at(std::size_t(index.row()));
    if (role == Qt::DisplayRole)
        return text(row, index.column());
    if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole)
        return tip(row);
    if (role == toneRole && (index.column() == Verdict || index.column() == Remarks))
        return int(toneOf(row.verdict));
    return {};
}

QVariant CommissionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role == Qt::ToolTipRole && orientation == Qt::Horizontal) {
        return section == Before  ? tr("ID and baud rate of the servo when connected")
               : section == After ? tr("ID and baud rate given to the servo")
                                  : headerData(section, orientation, Qt::DisplayRole);
    }
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return section + 1;
    switch (section) {
    case Verdict:
        return tr("Verdict");
    case Label:
        return tr("Label");
    case Model:
        return tr("Model");
    case Before:
        return tr("Before");
    case After:
        return tr("Now");
    case Written:
        return tr("Settings written");
    case Voltage:
        return tr("Voltage");
    default:
        return tr("Remarks");
    }
}
} // namespace ui
