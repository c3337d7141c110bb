// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/channel_list.h"

#include "ui/charts/palette.h"

#include <QEvent>
#include <QHeaderView>
#include <QPixmap>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>

namespace ui {
namespace {
enum Column { Name, Scale, Offset, ColumnCount };
} // namespace

ChannelList::ChannelList(TrendChart* chart, QWidget* parent)
    : QWidget(parent)
    , m_chart(chart)
    , m_tree(new QTreeWidget(this))
{
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_tree);
    setFocusProxy(m_tree);
    m_tree->setObjectName(QStringLiteral("channelList"));
    m_tree->setColumnCount(ColumnCount);
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    connect(m_tree, &QTreeWidget::itemChanged, this, &ChannelList::edited);
    connect(chart, &TrendChart::channelsChanged, this, &ChannelList::refresh);
    retranslate();
}

void ChannelList::retranslate()
{
    m_tree->setHeaderLabels({tr("Channel"), tr("Scale"), tr("Offset")});
    m_tree->setAccessibleName(tr("Channels of the chart"));
    m_tree->setToolTip(tr("Tick what is to be drawn. Drawn is value × scale + offset; readings "
                          "stay those of the value."));
    refresh();
}

void ChannelList::refresh()
{
    m_filling = true;
    const auto& channels = m_chart->channels();
    while (m_tree->topLevelItemCount() > int(channels.size()))
        delete m_tree->takeTopLevelItem(m_tree->topLevelItemCount() - 1);
    const QColor ground = palette().color(QPalette::Base);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const TrendChannel& channel = channels[i];
        QTreeWidgetItem* item = m_tree->topLevelItem(int(i));
        if (item == nullptr) {
            item = new QTreeWidgetItem(m_tree);
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        }
        QPixmap chip(10, 10);
        chip.fill(trendColourOn(channel.colour, ground));
        item->setIcon(Name, QIcon(chip));
        item->setText(Name, channel.name);
        item->setCheckState(Name, channel.visible ? Qt::Checked : Qt::Unchecked);
        item->setText(Scale, QString::number(channel.scale));
        item->setText(Offset, QString::number(channel.offset));
    }
    m_filling = false;
}

void ChannelList::edited(QTreeWidgetItem* item, int column)
{
    if (m_filling)
        return;
    const int row = m_tree->indexOfTopLevelItem(item);
    if (column == Name) {
        const bool shown = item->checkState(Name) == Qt::Checked;
        m_chart->setChannelVisible(row, shown);
    } else {
        bool scaleIs = false;
        bool offsetIs = false;
        const double scale = item->text(Scale).toDouble(&scaleIs);
        const double offset = item->text(Offset).toDouble(&offsetIs);
        if (scaleIs && offsetIs && scale != 0 && std::isfinite(scale) && std::isfinite(offset))
            m_chart->setChannelScale(row, scale, offset);
    }
    refresh(); // what was nonsense, or a name, is as before
}

void ChannelList::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}
} // namespace ui
