// SPDX-License-Identifier: GPL-3.0-or-later
// The legs of one servo in a sweep test, oldest first, as they are measured. Only the latest are
// kept, so that a night costs no more than an hour; all of them are in the run's CSV, and notice()
// says so. Owned by the page; main thread.
#pragma once

#include "results/sweep_run.h"

#include <QAbstractTableModel>

#include <array>
#include <deque>
#include <span>

namespace ui {
enum class LegColumn : std::uint8_t {
    Leg,
    Cycle,
    Target,
    Reached,
    Time,
    Overshoot,
    Settling,
    SteadyError,
    MeanSpeed,
    Following,
    Current,
    Load,
    Voltage,
    Temperature,
    Remarks,
    Count,
};

class SweepLegsModel final : public QAbstractTableModel {
    Q_OBJECT
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged)

public:
    static constexpr std::size_t maxLegs = 1000;

    using QAbstractTableModel::QAbstractTableModel;

    void append(std::span<const results::SweepLeg> legs);
    void append(const results::SweepLeg& leg) { append({&leg, 1}); }
    void clear();
    void retranslate();

    std::size_t total() const { return m_total; } ///< also those no longer here
    /// "The latest 1000 of 2300 legs …"; empty while all are here.
    QString notice() const;
    /// Nothing was measured in any leg so far: views hide it. Always false for what every leg has.
    bool isColumnEmpty(LegColumn column) const;
    const results::SweepLeg& leg(int row) const { return m_legs[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void noticeChanged();
    void emptyColumnsChanged();

private:
    using MeasuredColumns = std::array<bool, std::size_t(LegColumn::Count)>;
    QString remarks(const results::SweepLeg& leg) const;
    QString tip(const results::SweepLeg& leg) const;
    void setMeasured(const MeasuredColumns& measured);

    std::deque<results::SweepLeg> m_legs;
    std::size_t m_total = 0;
    MeasuredColumns m_measured{};
};
} // namespace ui
