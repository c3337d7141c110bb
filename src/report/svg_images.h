// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the images of a text document, which cannot show SVG by itself, as drawings over its whole
// width. Registered with the document's layout, which it outlives. On the thread of the document.
#pragma once

#include <QObject>
#include <QTextObjectInterface>

class QFont;

#ifdef Q_MOC_RUN // moc is not told where Qt's headers are
Q_DECLARE_INTERFACE(QTextObjectInterface, "org.qt-project.Qt.QTextObjectInterface")
#endif

namespace report {
class PaperCharts;

/// With the fonts of the program.
QFont paperFont();

class SvgImages final : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    SvgImages(const PaperCharts& charts, double width);

    QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int position,
                    const QTextFormat& format) override;

private:
    const PaperCharts& m_charts;
    double m_width;
};
} // namespace report
