// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/limits_model.h"

#include "report/sweep_text.h"
#include "text/language.h"
#include "ui/widgets/test_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui {
using results::SweepLimit;
using results::SweepMetricKind;

namespace {
const SweepMetricKind& kindOf(const QString& metric)
{
    static const SweepMetricKind none;
    const auto& kinds = results::sweepMetricKinds();
    const auto it = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const SweepMetricKind& kind) { return kind.key == metric; });
    return it == kinds.end() ? none : *it;
}

/// Which tests a line is for, where that is not all of them.
QString pathNote(const QString& metric)
{
    if (metric == QLatin1StringView("phase_lag") ||
        metric == QLatin1StringView("readings_per_period"))
        return LimitsModel::tr("Only for sine tests; ignored in other tests");
    if (metric == QLatin1StringView("following_error_relative"))
        return LimitsModel::tr("Only for sine tests (% of the amplitude) and random tests (% of "
                               "the range); ignored in other tests");
    return {};
}

/// All digits it has, unlike the two decimals of a report: nothing is lost by opening a file.
QString typed(const std::optional<double>& bound)
{
    return bound ? QString::number(*bound, 'g', QLocale::FloatingPointShortest) : QString();
}
} // namespace

std::optional<double> numberFromText(const QString& text)
{
    bool number = false;
    const double value = QString(text).trimmed().replace(u',', u'.').toDouble(&number);
    return number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString limitDirection(bool atLeast)
{
    return atLeast ? LimitsModel::tr("at least") : LimitsModel::tr("at most");
}

void LimitsModel::setLines(const std::vector<SweepLimit>& lines)
{
    beginResetModel();
    m_lines.clear();
    for (const SweepLimit& line : lines)
        m_lines.push_back({line.metric, line.atLeast, typed(line.warn), typed(line.fail)});
    endResetModel();
    Q_EMIT edited();
}

std::vector<SweepLimit> LimitsModel::lines() const
{
    std::vector<SweepLimit> lines;
    for (const Line& line : m_lines)
        lines.push_back({line.metric, kindOf(line.metric).unit, numberFromText(line.warn),
                         numberFromText(line.fail), line.atLeast});
    return lines;
}

int LimitsModel::add()
{
    const auto& kinds = results::sweepMetricKinds();
    const auto unused = std::find_if(kinds.begin(), kinds.end(), [&](const SweepMetricKind& kind) {
        return std::none_of(m_lines.begin(), m_lines.end(),
                            [&](const Line& line) { return line.metric == kind.key; });
    });
    const SweepMetricKind& kind = unused == kinds.end() ? kinds.front() : *unused;
    const int row = rowCount();
    beginInsertRows({}, row, row);
    m_lines.push_back({kind.key, kind.atLeast, {}, {}});
    endInsertRows();
    Q_EMIT edited();
    return row;
}

void LimitsModel::remove(int row)
{
    if (row < 0 || row >= rowCount())
        return;
    beginRemoveRows({}, row, row);
    m_lines.erase(m_lines.begin() + row);
    endRemoveRows();
    Q_EMIT edited();
}

QString LimitsModel::boundError(const Line& line) const
{
    for (const QString& text : {line.warn, line.fail}) {
        if (text.trimmed().isEmpty())
            continue;
        const auto number = numberFromText(text);
        if (!number)
            return tr("\"%1\" is not a number.").arg(text);
        if (*number < 0)
            return tr("A limit cannot be negative: errors are judged by their absolute value.");
    }
    const auto warn = numberFromText(line.warn);
    const auto fail = numberFromText(line.fail);
    if (!warn && !fail)
        return tr("Enter a warning limit, a failure limit, or both.");
    if (!warn || !fail)
        return {};
    if (line.atLeast ? *warn < *fail : *warn > *fail)
        return tr(
            "The failure limit would be reached before the warning limit. Change one of them.");
    return {};
}

QString LimitsModel::problem(int row) const
{
    const Line& line = m_lines[static_cast<std::size_t>(row)];
    const auto same = std::count_if(m_lines.begin(), m_lines.end(), [&](const Line& other) {
        return other.metric == line.metric && other.atLeast == line.atLeast;
    });
    if (same > 1)
        return tr("This metric already has a limit of this kind (at least or at most).");
    return boundError(line);
}

void LimitsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (!m_lines.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int LimitsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int LimitsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(LimitColumn::Count);
}

Qt::ItemFlags LimitsModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const bool fixed = static_cast<LimitColumn>(index.column()) == LimitColumn::Unit;
    const Qt::ItemFlags defaultFlags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return fixed ? defaultFlags : defaultFlags | Qt::ItemIsEditable;
}

QString LimitsModel::cell(const Line& line, LimitColumn column) const
{
    switch (column) {
    case LimitColumn::Metric:
        return metricName(line.metric);
    case LimitColumn::Direction:
        return limitDirection(line.atLeast);
    case LimitColumn::Warn:
        return line.warn;
    case LimitColumn::Fail:
        return line.fail;
    case LimitColumn::Unit:
        return unitName(kindOf(line.metric).unit);
    case LimitColumn::Count:
        break;
    }
    return {};
}

QVariant LimitsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Line& line = m_lines[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<LimitColumn>(index.column());
    const bool bound = column == LimitColumn::Warn || column == LimitColumn::Fail;
    switch (role) {
    case Qt::DisplayRole:
        return cell(line, column);
    case Qt::EditRole:
        if (column == LimitColumn::Metric)
            return line.metric;
        return column == LimitColumn::Direction ? QVariant(line.atLeast) : cell(line, column);
    case Qt::ToolTipRole: {
        const QString wrong = problem(index.row());
        if (!wrong.isEmpty())
            return wrong;
        if (bound)
            return tr("Limit in the unit of the metric; leave empty for no limit");
        const QString note = pathNote(line.metric);
        return note.isEmpty() ? QVariant() : QVariant(note);
    }
    case toneRole:
        return problem(index.row()).isEmpty() ? QVariant() : int(Tone::Bad);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (bound ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

bool LimitsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    Line& line = m_lines[static_cast<std::size_t>(index.row())];
    switch (static_cast<LimitColumn>(index.column())) {
    case LimitColumn::Metric:
        if (kindOf(value.toString()).key.isEmpty())
            return false;
        line.metric = value.toString();
        line.atLeast = kindOf(line.metric).atLeast;
        break;
    case LimitColumn::Direction:
        line.atLeast = value.toBool();
        break;
    case LimitColumn::Warn:
        line.warn = value.toString().trimmed();
        break;
    case LimitColumn::Fail:
        line.fail = value.toString().trimmed();
        break;
    case LimitColumn::Unit:
    case LimitColumn::Count:
        return false;
    }
    // The errors of a line may depend on another line.
    Q_EMIT dataChanged(this->index(0, 0), this->index(rowCount() - 1, columnCount() - 1));
    Q_EMIT edited();
    return true;
}

QVariant LimitsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const auto column = static_cast<LimitColumn>(section);
    const bool bound = column == LimitColumn::Warn || column == LimitColumn::Fail;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (bound ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const report::SweepTexts& words = report::sweepTexts();
    const bool chinese = text::isUiChinese();
    switch (column) {
    case LimitColumn::Metric:
        return words.figure.in(chinese);
    case LimitColumn::Direction:
        return tr("Must be");
    case LimitColumn::Warn:
        return words.warnLimit.in(chinese);
    case LimitColumn::Fail:
        return words.failLimit.in(chinese);
    case LimitColumn::Unit:
        return words.unit.in(chinese);
    case LimitColumn::Count:
        break;
    }
    return {};
}
} // namespace ui
