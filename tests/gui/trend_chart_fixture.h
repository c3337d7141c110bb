// SPDX-License-Identifier: GPL-3.0-or-later
// A trend chart with two channels on a store of its own, and input. Positions are fractions of the
// plot, 0 … 1 from its lower left. Checks what has been painted. Main thread.
#pragma once

#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_view.h"
#include "ui/common/palette.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <functional>

namespace gui {
class TrendChartFixture {
public:
    TrendChartFixture()
    {
        for (int i = 0; i < 2; ++i) {
            ids.push_back(store.open());
            ui::TrendChannel channel;
            channel.id = ids.back();
            channel.key = i == 0 ? QStringLiteral("1/a") : QStringLiteral("1/b");
            channel.name = i == 0 ? QStringLiteral("Alpha") : QStringLiteral("Beta");
            channel.color = ui::trendColor(2 * i, Qt::white); // blue and amber, far apart
            channels.push_back(channel);
        }
        chart.resize(800, 500);
        chart.setStore(&store);
        chart.setChannels(channels);
        chart.show();
        plot = chart.findChild<ui::TrendView*>(QStringLiteral("trendPlot"));
        if (plot == nullptr || !QTest::qWaitForWindowExposed(&chart))
            qFatal("no chart");
    }

    void put(std::size_t channel, base::Duration at, double value)
    {
        store.append(ids[channel], at, value);
        sent[channel].push_back({at, value});
    }

    /// 100 a second, from where the channel ends; `value` of the seconds.
    void fill(std::size_t channel, base::Duration to, const std::function<double(double)>& value)
    {
        const auto latest = store.latest(ids[channel]);
        fillFrom(channel, latest ? latest->at + std::chrono::milliseconds(10) : base::Duration{},
                 to, value);
    }
    void fillFrom(std::size_t channel, base::Duration from, base::Duration to,
                  const std::function<double(double)>& value)
    {
        for (base::Duration at = from; at <= to; at += std::chrono::milliseconds(10))
            put(channel, at, value(double(at.count()) / 1e6));
    }

    /// Draws the channel as value × scale + offset.
    void setScale(std::size_t channel, double scale, double offset)
    {
        channels[channel].scale = scale;
        channels[channel].offset = offset;
        chart.setChannels(channels);
    }

    /// Until every requested frame has been painted.
    void waitForFrames()
    {
        chart.flush();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }

    QRectF area() const { return plot->picture().plot(); }
    QPoint at(const QPointF& share) const
    {
        const QRectF plotArea = area();
        return plot->mapFromScene(plotArea.left() + share.x() * plotArea.width(),
                                  plotArea.bottom() - share.y() * plotArea.height());
    }

    static void moveTo(QWidget* widget, const QPoint& place, Qt::MouseButton held,
                       Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, held,
                         with);
        QCoreApplication::sendEvent(widget, &move);
    }

    void drag(Qt::MouseButton button, Qt::KeyboardModifiers with, const QPointF& from,
              const QPointF& to)
    {
        QTest::mousePress(plot->viewport(), button, with, at(from));
        moveTo(plot->viewport(), at((from + to) / 2), button, with);
        moveTo(plot->viewport(), at(to), button, with);
        QTest::mouseRelease(plot->viewport(), button, with, at(to));
    }

    void wheel(const QPointF& share, int turn, Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        const QPointF place = at(share);
        QWheelEvent event(place, plot->viewport()->mapToGlobal(place), {}, {0, turn}, Qt::NoButton,
                          with, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot->viewport(), &event);
    }

    QImage picture() { return plot->viewport()->grab().toImage(); }

    /// Is the channel's color anywhere in this part of the plot?
    bool paintedIn(const QRectF& shares, int channel)
    {
        const QRgb wanted = ui::trendColorOn(channels[std::size_t(channel)].color,
                                             chart.palette().color(QPalette::Base))
                                .rgb();
        const QImage image = picture();
        const QPoint low = at(shares.topLeft());
        const QPoint high = at(shares.bottomRight());
        for (int y = std::max(high.y(), 0); y <= std::min(low.y(), image.height() - 1); ++y) {
            for (int x = std::max(low.x(), 0); x <= std::min(high.x(), image.width() - 1); ++x) {
                if (near(image.pixel(x, y), wanted))
                    return true;
            }
        }
        return false;
    }

    /// A line between two rows of pixels is paler than its color.
    static bool near(QRgb one, QRgb other)
    {
        return std::abs(qRed(one) - qRed(other)) < 70 &&
               std::abs(qGreen(one) - qGreen(other)) < 70 &&
               std::abs(qBlue(one) - qBlue(other)) < 70;
    }

    recording::SampleStore store;
    std::vector<recording::ChannelId> ids;
    std::vector<recording::SamplePoint> sent[2];
    std::vector<ui::TrendChannel> channels;
    ui::TrendChart chart;
    ui::TrendView* plot = nullptr;
};
} // namespace gui
