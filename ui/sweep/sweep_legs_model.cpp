// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_legs_model.h"

#include "report/sweep_text.h"
#include "text/language.h"
#include "ui/widgets/test_text.h"

#include <QLocale>

#include <algorithm>

namespace ui {
using results::SweepLeg;

namespace {
std::optional<double> milliseconds(const std::optional<base::Duration>& span)
{
    return span ? std::optional(double(span->count()) / 1000) : std::nullopt;
}

std::optional<double> number(const SweepLeg& leg, LegColumn column)
{
    switch (column) {
    case LegColumn::Leg:
        return leg.number;
    case LegColumn::Cycle:
        return leg.cycle;
    case LegColumn::Target:
        return leg.target;
    case LegColumn::Reached:
        return leg.reached;
    case LegColumn::Time:
        return milliseconds(leg.timeToTarget);
    case LegColumn::Overshoot:
        return leg.overshoot;
    case LegColumn::Settling:
        return milliseconds(leg.settling);
    case LegColumn::SteadyError:
        return leg.steadyError;
    case LegColumn::MeanSpeed:
        return leg.meanSpeed;
    case LegColumn::Following:
        return leg.followingError;
    case LegColumn::Current:
        return leg.currentPeak;
    case LegColumn::Load:
        return leg.loadPeak;
    case LegColumn::Voltage:
        return leg.voltageMin;
    case LegColumn::Temperature:
        return leg.temperatureMax;
    case LegColumn::Remarks:
    case LegColumn::Count:
        break;
    }
    return {};
}

const catalog::Text& heading(LegColumn column)
{
    static const catalog::Text none;
    const report::SweepTexts& words = report::sweepTexts();
    const std::array<const catalog::Text*, std::size_t(LegColumn::Count)> all{
        &words.leg,          &words.cycle,       &words.target,   &words.reached,
        &words.timeToTarget, &words.overshoot,   &words.settling, &words.steadyError,
        &words.meanSpeed,    &words.following,   &words.current,  &words.load,
        &words.voltage,      &words.temperature, &words.remarks};
    return column < LegColumn::Count ? *all[std::size_t(column)] : none;
}

std::optional<Tone> remarkTone(const SweepLeg& leg)
{
    if (leg.missed)
        return Tone::Bad;
    const bool noted = leg.flagWrong.value_or(false) || leg.alarms != 0 || leg.lost > 0;
    return noted ? std::optional(Tone::Warn) : std::nullopt;
}
} // namespace

void SweepLegsModel::append(std::span<const SweepLeg> legs)
{
    if (legs.empty())
        return;
    const bool wasFull = m_total > maxLegs;
    m_total += legs.size();
    MeasuredColumns measured = m_measured;
    for (const SweepLeg& leg : legs) {
        for (std::size_t i = 0; i < measured.size(); ++i)
            measured[i] = measured[i] || number(leg, LegColumn(i)).has_value();
    }
    legs = legs.last(std::min(legs.size(), maxLegs));
    const std::size_t capacity = maxLegs - legs.size();
    if (m_legs.size() > capacity) {
        const auto excess = std::ptrdiff_t(m_legs.size() - capacity);
        beginRemoveRows({}, 0, int(excess) - 1);
        m_legs.erase(m_legs.begin(), m_legs.begin() + excess);
        endRemoveRows();
    }
    const int first = rowCount();
    beginInsertRows({}, first, first + int(legs.size()) - 1);
    m_legs.insert(m_legs.end(), legs.begin(), legs.end());
    endInsertRows();
    setMeasured(measured);
    if (wasFull || m_total > maxLegs)
        Q_EMIT noticeChanged();
}

void SweepLegsModel::setMeasured(const MeasuredColumns& measured)
{
    if (measured == m_measured)
        return;
    m_measured = measured;
    Q_EMIT emptyColumnsChanged();
}

void SweepLegsModel::clear()
{
    beginResetModel();
    m_legs.clear();
    m_total = 0;
    endResetModel();
    setMeasured({});
    Q_EMIT noticeChanged();
}

void SweepLegsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (!m_legs.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    Q_EMIT noticeChanged();
}

QString SweepLegsModel::notice() const
{
    if (m_total <= m_legs.size())
        return {};
    const QLocale locale;
    return tr("The last %1 of %2 moves are shown; the CSV and JSON files contain all moves.")
        .arg(locale.toString(qulonglong(m_legs.size())), locale.toString(qulonglong(m_total)));
}

bool SweepLegsModel::isColumnEmpty(LegColumn column) const
{
    if (column == LegColumn::Remarks || column >= LegColumn::Count || m_total == 0)
        return false;
    return !m_measured[std::size_t(column)];
}

int SweepLegsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_legs.size());
}

int SweepLegsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(LegColumn::Count);
}

QString SweepLegsModel::remarks(const SweepLeg& leg) const
{
    const report::SweepTexts& words = report::sweepTexts();
    const bool chinese = text::isUiChinese();
    QStringList parts;
    if (leg.missed)
        parts << QStringLiteral("✘ ") + words.missed.in(chinese);
    if (leg.flagWrong.value_or(false))
        parts << QStringLiteral("⚠ ") + words.flagWrong.in(chinese);
    if (leg.alarms != 0)
        parts << QStringLiteral("⚠ ") + report::alarmBitsText(leg.alarms).in(chinese);
    if (leg.lost > 0)
        parts << QStringLiteral("⚠ ") + tr("%n reading(s) lost", nullptr, int(leg.lost));
    return parts.join(chinese ? QStringLiteral("，") : QStringLiteral(", "));
}

QString SweepLegsModel::tip(const SweepLeg& leg) const
{
    QStringList lines;
    for (std::size_t i = 0; i < std::size_t(LegColumn::Remarks); ++i) {
        if (const auto value = number(leg, LegColumn(i)))
            lines << QStringLiteral("%1: %2").arg(text::localized(heading(LegColumn(i))),
                                                  sweepNumber(value));
    }
    if (const QString noted = remarks(leg); !noted.isEmpty())
        lines << noted;
    return lines.join(QLatin1Char('\n'));
}

QVariant SweepLegsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const SweepLeg& leg = m_legs[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<LegColumn>(index.column());
    const bool words = column == LegColumn::Remarks;
    switch (role) {
    case Qt::DisplayRole:
        return words ? remarks(leg) : sweepNumber(number(leg, column));
    case Qt::ToolTipRole:
        return tip(leg);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight));
    case toneRole: {
        const auto noted = remarkTone(leg);
        if (words && noted)
            return int(*noted);
        return words || number(leg, column) ? QVariant() : int(Tone::Quiet);
    }
    default:
        return {};
    }
}

QVariant SweepLegsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const auto column = static_cast<LegColumn>(section);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter |
                   (column == LegColumn::Remarks ? Qt::AlignLeft : Qt::AlignRight));
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    return text::localized(heading(column));
}
} // namespace ui
