// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/cursor_table.h"

#include "ui/charts/axis_ticks.h"
#include "ui/common/palette.h"
#include "ui/common/widget_style.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPixmap>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
enum Column { Name, AtA, AtB, Difference, Slope, Mean, Min, Max, Sigma, Count, ColumnCount };

/// Decimals of the numbers follow the larger of the values and a thousandth of their range.
double sizeOf(const CursorReading& reading)
{
    const double span = reading.between.max - reading.between.min;
    const double height = std::max(std::abs(reading.between.max), std::abs(reading.between.min));
    return std::max(span, height * 1e-3);
}

QIcon chip(const QColor& color)
{
    QPixmap pixmap(10, 10);
    pixmap.fill(color);
    return QIcon(pixmap);
}
} // namespace

CursorTable::CursorTable(TrendChart* chart, QWidget* parent)
    : QWidget(parent)
    , m_chart(chart)
    , m_times(new QLabel(this))
    , m_table(new QTableWidget(0, ColumnCount, this))
    , m_copy(new QAction(m_table))
{
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_times);
    layout->addWidget(m_table);
    m_times->setObjectName(QStringLiteral("cursorTimes"));
    m_times->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setObjectName(QStringLiteral("cursorTable"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::ResizeToContents);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_copy->setObjectName(QStringLiteral("copyCursorReadings"));
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetShortcut);
    m_table->addAction(m_copy);
    connect(m_copy, &QAction::triggered, this, &CursorTable::copy);
    connect(chart, &TrendChart::cursorsChanged, this, &CursorTable::refresh);
    connect(chart, &TrendChart::channelsChanged, this, &CursorTable::refresh);
    retranslate();
}

void CursorTable::retranslate()
{
    m_copy->setText(tr("Copy readings"));
    m_copy->setToolTip(tr("Copies the whole table for pasting into a spreadsheet"));
    m_table->setAccessibleName(tr("Readings at the cursors"));
    m_table->setToolTip(
        tr("Values at cursors A and B, and statistics of the samples between them"));
    m_table->setHorizontalHeaderLabels({tr("Channel"), tr("At A"), tr("At B"), tr("Δ"), tr("Slope"),
                                        tr("Mean"), tr("Min"), tr("Max"), tr("σ"), tr("n")});
    m_table->horizontalHeaderItem(Slope)->setToolTip(
        tr("Slope of the least-squares line through the samples, per second"));
    m_table->horizontalHeaderItem(Sigma)->setToolTip(tr("Standard deviation of the samples"));
    m_table->horizontalHeaderItem(Count)->setToolTip(
        tr("Number of samples between A and B; ≈ means that only the extremes of some of them are "
           "stored"));
    for (int column = AtA; column < ColumnCount; ++column)
        m_table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    refresh();
}

/// As high as its rows, up to a few.
void CursorTable::fitHeight()
{
    constexpr int maxRows = 6;
    const int rows = std::clamp(m_table->rowCount(), 1, maxRows);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() +
                            rows * m_table->verticalHeader()->defaultSectionSize() + 4);
}

void CursorTable::refresh()
{
    const auto places = m_chart->cursors();
    const std::vector<CursorReading> readings = m_chart->cursorReadings();
    m_table->setRowCount(int(readings.size()));
    fitHeight();
    if (!places) {
        m_times->setText(tr("No cursors. Press C in the chart to show them, then drag A and B."));
        return;
    }
    const auto seconds = [](base::Duration span) { return double(span.count()) / 1e6; };
    const auto pair = m_chart->cursorTimes();
    m_times->setText(tr("A %1 · B %2 · Δt %3")
                         .arg(spanText(seconds(pair->first)), spanText(seconds(pair->second)),
                              spanText(seconds(places->to - places->from))));
    int row = 0;
    for (const CursorReading& reading : readings) {
        const auto& channels = m_chart->channels();
        const auto found =
            std::find_if(channels.begin(), channels.end(),
                         [&](const TrendChannel& c) { return c.key == reading.channel; });
        if (found != channels.end())
            fillRow(row++, *found, reading);
    }
}

void CursorTable::fillRow(int row, const TrendChannel& channel, const CursorReading& reading)
{
    const recording::SampleStatistics& between = reading.between;
    const double size = sizeOf(reading);
    const bool any = between.count > 0;
    const auto number = [&](const std::optional<double>& value) {
        return value ? readingText(*value, size) : QStringLiteral("\u2013");
    };
    const auto known = [&](double value) { return any ? std::optional(value) : std::nullopt; };
    const QString name = channel.unit.isEmpty()
                             ? channel.name
                             : QStringLiteral("%1 [%2]").arg(channel.name, channel.unit);
    const auto difference =
        reading.a && reading.b ? std::optional(*reading.b - *reading.a) : std::nullopt;
    QString count = QString::number(between.count);
    if (!between.exact)
        count.prepend(QStringLiteral("≈ "));
    const QStringList texts{name,
                            number(reading.a),
                            number(reading.b),
                            number(difference),
                            number(between.count > 1 ? std::optional(between.slope) : std::nullopt),
                            number(known(between.mean)),
                            number(known(between.min)),
                            number(known(between.max)),
                            number(known(between.sigma)),
                            count};
    for (int column = 0; column < ColumnCount; ++column) {
        QTableWidgetItem* item = m_table->item(row, column);
        if (item == nullptr) {
            item = new QTableWidgetItem;
            m_table->setItem(row, column, item);
            if (column != Name)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        if (item->text() != texts[column])
            item->setText(texts[column]);
    }
    const QColor background = palette().color(QPalette::Base);
    m_table->item(row, Name)->setIcon(chip(trendColorOn(channel.color, background)));
}

QString CursorTable::text() const
{
    QStringList lines{m_times->text()};
    QStringList cells;
    for (int column = 0; column < ColumnCount; ++column)
        cells << m_table->horizontalHeaderItem(column)->text();
    lines << cells.join(QLatin1Char('\t'));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        cells.clear();
        for (int column = 0; column < ColumnCount; ++column)
            cells << m_table->item(row, column)->text();
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void CursorTable::copy() const
{
    QGuiApplication::clipboard()->setText(text());
}

void CursorTable::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}
} // namespace ui
