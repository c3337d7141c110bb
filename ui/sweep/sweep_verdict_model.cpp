// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_verdict_model.h"

#include "report/sweep_text.h"
#include "text/language.h"
#include "ui/widgets/test_text.h"

#include <algorithm>

namespace ui {
using results::SweepMetric;
using results::VerdictLine;

namespace {
bool isNumber(VerdictColumn column)
{
    return column == VerdictColumn::Value || column == VerdictColumn::Warn ||
           column == VerdictColumn::Fail;
}

/// The reasons of the verdict stand above what is in order.
int place(const std::optional<VerdictLine>& line)
{
    if (line && line->grade == results::Grade::Fail)
        return 0;
    return line && line->grade == results::Grade::Warn ? 1 : 2;
}
} // namespace

bool SweepVerdictModel::Row::sameLine(const Row& other) const
{
    return figure.key == other.figure.key && line.has_value() == other.line.has_value() &&
           (!line || line->limit.atLeast == other.line->limit.atLeast);
}

/// What failed, what warns, then the rest, each in the order of the figures. A line whose figure is
/// not there comes at the end: nothing that was judged is left out.
std::vector<SweepVerdictModel::Row> SweepVerdictModel::rowsOf() const
{
    std::vector<Row> rows;
    for (const SweepMetric& figure : m_metrics) {
        const std::size_t before = rows.size();
        for (const VerdictLine& line : m_lines) {
            if (line.limit.metric == figure.key)
                rows.push_back({figure, line});
        }
        if (rows.size() == before && m_showAll)
            rows.push_back({figure});
    }
    for (const VerdictLine& line : m_lines) {
        const bool known =
            std::any_of(m_metrics.begin(), m_metrics.end(),
                        [&](const SweepMetric& one) { return one.key == line.limit.metric; });
        if (!known)
            rows.push_back({{line.limit.metric, line.limit.unit}, line});
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return place(a.line) < place(b.line); });
    return rows;
}

void SweepVerdictModel::refresh()
{
    std::vector<Row> fresh = rowsOf();
    const bool sameSet = std::equal(fresh.begin(), fresh.end(), m_rows.begin(), m_rows.end(),
                                    [](const Row& a, const Row& b) { return a.sameLine(b); });
    if (!sameSet) {
        beginResetModel();
        m_rows = std::move(fresh);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        if (fresh[i] == m_rows[i])
            continue;
        m_rows[i] = std::move(fresh[i]);
        Q_EMIT dataChanged(index(int(i), 0), index(int(i), columnCount() - 1));
    }
}

void SweepVerdictModel::show(const std::vector<SweepMetric>& metrics,
                             const std::vector<VerdictLine>& lines)
{
    m_metrics = metrics;
    m_lines = lines;
    refresh();
}

void SweepVerdictModel::setShowAll(bool all)
{
    m_showAll = all;
    refresh();
}

void SweepVerdictModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int SweepVerdictModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int SweepVerdictModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(VerdictColumn::Count);
}

QString SweepVerdictModel::cell(const Row& row, VerdictColumn column) const
{
    switch (column) {
    case VerdictColumn::Metric:
        return metricName(row.figure.key);
    case VerdictColumn::Value:
        return row.value()
                   ? sweepValue(row.value(), row.figure.unit, row.line ? &*row.line : nullptr)
                   : QStringLiteral("–");
    case VerdictColumn::Warn:
        return row.line ? limitText(row.line->limit, row.line->limit.warn) : QString();
    case VerdictColumn::Fail:
        return row.line ? limitText(row.line->limit, row.line->limit.fail) : QString();
    case VerdictColumn::Grade:
        if (!row.value())
            return lineGradeText(results::Grade::NotMeasured);
        return row.line ? lineGradeText(row.line->grade) : tr("no limit");
    case VerdictColumn::Count:
        break;
    }
    return {};
}

QString SweepVerdictModel::tip(const Row& row) const
{
    const report::SweepTexts& words = report::sweepTexts();
    const bool chinese = text::isUiChinese();
    const QString& unit = row.figure.unit;
    QStringList lines{
        QStringLiteral("%1: %2").arg(metricName(row.figure.key), sweepValue(row.value(), unit))};
    const auto add = [&](const catalog::Text& name, const QString& value) {
        lines << QStringLiteral("%1: %2").arg(name.in(chinese), value);
    };
    if (row.figure.mean)
        add(words.mean, sweepValue(row.figure.mean, unit));
    if (row.figure.min)
        add(words.lowest, sweepValue(row.figure.min, unit));
    if (row.figure.max)
        add(words.highest, sweepValue(row.figure.max, unit));
    add(words.count, QString::number(row.figure.count));
    if (row.line)
        lines << lineGradeText(row.line->grade) + QStringLiteral(": ") + reasonText(*row.line);
    return lines.join(QLatin1Char('\n'));
}

QVariant SweepVerdictModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<VerdictColumn>(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return cell(row, column);
    case Qt::ToolTipRole:
        return tip(row);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    case toneRole:
        if (column == VerdictColumn::Grade)
            return int(row.line ? gradeTone(row.line->grade) : Tone::Quiet);
        return column == VerdictColumn::Metric || (column == VerdictColumn::Value && row.value())
                   ? QVariant()
                   : int(Tone::Quiet);
    case MetricRole:
        return row.figure.key;
    case GradeRole:
        return row.line ? QVariant(int(row.line->grade)) : QVariant();
    case ReasonRole:
        return row.line ? reasonText(*row.line) : QVariant();
    default:
        return {};
    }
}

QVariant SweepVerdictModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const auto column = static_cast<VerdictColumn>(section);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const report::SweepTexts& words = report::sweepTexts();
    const bool chinese = text::isUiChinese();
    switch (column) {
    case VerdictColumn::Metric:
        return words.figure.in(chinese);
    case VerdictColumn::Value:
        return words.value.in(chinese);
    case VerdictColumn::Warn:
        return words.warnLimit.in(chinese);
    case VerdictColumn::Fail:
        return words.failLimit.in(chinese);
    case VerdictColumn::Grade:
        return words.result.in(chinese);
    case VerdictColumn::Count:
        break;
    }
    return {};
}
} // namespace ui
