// SPDX-License-Identifier: GPL-3.0-or-later
// A paint device that keeps what is painted on it: texts with their place, and straight lines,
// which may be filled rectangles of one pixel. For tests of what lies on what, without looking at
// pixels. Main thread.
#pragma once

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QString>

#include <vector>

namespace gui {
struct PaintedText {
    QString text;
    QRectF ink; ///< as high as its capital letters
};

class RecordedPainting final : public QPaintDevice {
public:
    explicit RecordedPainting(QSize size)
        : m_size(size)
    {}

    QPaintEngine* paintEngine() const override { return &m_engine; }
    const std::vector<PaintedText>& texts() const { return m_engine.texts; }
    const std::vector<QLineF>& lines() const { return m_engine.lines; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return int(devicePixelRatioFScale());
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    class Engine final : public QPaintEngine {
    public:
        Engine()
            : QPaintEngine(AllFeatures)
        {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState& state) override
        {
            if (state.state().testFlag(DirtyTransform))
                m_transform = state.transform();
        }
        Type type() const override { return User; }
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
        void drawImage(const QRectF&, const QImage&, const QRectF&,
                       Qt::ImageConversionFlags) override
        {}
        void drawPath(const QPainterPath&) override {}
        void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
        void drawRects(const QRectF* drawn, int count) override
        {
            for (int i = 0; i < count; ++i) {
                const QRectF rect = m_transform.mapRect(drawn[i]);
                if (rect.height() == 1)
                    lines.push_back(
                        {rect.left(), rect.center().y(), rect.right(), rect.center().y()});
                else if (rect.width() == 1)
                    lines.push_back(
                        {rect.center().x(), rect.top(), rect.center().x(), rect.bottom()});
            }
        }
        void drawTextItem(const QPointF& at, const QTextItem& item) override
        {
            const double height = QFontMetricsF(item.font()).capHeight();
            texts.push_back({item.text(), m_transform.mapRect(QRectF(at.x(), at.y() - height,
                                                                     item.width(), height))});
        }
        void drawLines(const QLineF* drawn, int count) override
        {
            for (int i = 0; i < count; ++i)
                lines.push_back(m_transform.map(drawn[i]));
        }
        std::vector<PaintedText> texts;
        std::vector<QLineF> lines;

    private:
        QTransform m_transform;
    };

    QSize m_size;
    mutable Engine m_engine;
};
} // namespace gui
