// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/paper.h"

#include "report/svg_images.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QEventLoop>
#include <QLocale>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QTextFormat>

#include <memory>

namespace report {
namespace {
constexpr double marginMm = 12;
constexpr double footPoints = 7;
constexpr QColor footColor(0x57, 0x60, 0x6a);

QPageSize pageSize()
{
    const bool letter = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    return QPageSize(letter ? QPageSize::Letter : QPageSize::A4);
}

/// Puts sections on pages, and a line below each.
class Pages {
public:
    Pages(QPdfWriter& writer, const PaperCharts& charts)
        : m_writer(writer)
        , m_images(charts, writer.width())
        , m_footFont(paperFont())
    {
        m_footFont.setPointSizeF(footPoints);
        m_footHeight = QFontMetricsF(m_footFont, &writer).height() * 2;
    }

    void add(const QString& html)
    {
        auto& document = *m_sections.emplace_back(std::make_unique<QTextDocument>());
        QAbstractTextDocumentLayout& layout = *document.documentLayout();
        layout.registerHandler(QTextFormat::ImageObject, &m_images);
        layout.setPaintDevice(&m_writer);
        document.setDefaultFont(paperFont());
        document.setDocumentMargin(0);
        document.setHtml(html);
        document.setPageSize(QSizeF(m_writer.width(), m_writer.height() - m_footHeight));
        m_count += document.pageCount();
    }

    void paint(const PaperTitle& title)
    {
        QPainter painter(&m_writer);
        int number = 0;
        for (const auto& section : m_sections) {
            for (int page = 0; page < section->pageCount(); ++page) {
                if (number++ > 0)
                    m_writer.newPage();
                paintBody(painter, *section, page);
                paintFoot(painter, title, number);
            }
        }
    }

private:
    void paintBody(QPainter& painter, const QTextDocument& section, int page)
    {
        const QSizeF size = section.pageSize();
        const QRectF shown(0, page * size.height(), size.width(), size.height());
        painter.save();
        painter.translate(0, -shown.top());
        painter.setClipRect(shown);
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = shown;
        context.palette.setColor(QPalette::Text, Qt::black);
        section.documentLayout()->draw(&painter, context);
        painter.restore();
    }

    void paintFoot(QPainter& painter, const PaperTitle& title, int number)
    {
        const QRectF foot(0, m_writer.height() - m_footHeight, m_writer.width(), m_footHeight);
        painter.setFont(m_footFont);
        painter.setPen(footColor);
        painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom,
                         title.title + QStringLiteral(" · ") + title.at);
        painter.drawText(foot, Qt::AlignHCenter | Qt::AlignBottom, title.program);
        painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
                         QStringLiteral("%1 / %2").arg(number).arg(m_count));
    }

    QPdfWriter& m_writer;
    SvgImages m_images;
    QFont m_footFont;
    double m_footHeight = 0;
    std::vector<std::unique_ptr<QTextDocument>> m_sections;
    int m_count = 0;
};
} // namespace

QString PaperCharts::add(const QString& svg)
{
    m_charts.push_back(svg.toUtf8());
    return QStringLiteral("<p><img src=\"%1\"/></p>\n").arg(m_charts.size() - 1);
}

QByteArray PaperCharts::svg(const QString& name) const
{
    bool ok = false;
    const std::size_t place = name.toULongLong(&ok);
    return ok && place < m_charts.size() ? m_charts[place] : QByteArray();
}

QByteArray paperPdf(const QStringList& sections, const PaperCharts& charts, const PaperTitle& title)
{
    const QEventLoop timers; // that a QTextDocument sets, on a thread that has no events otherwise
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setPageLayout({pageSize(),
                              QPageLayout::Portrait,
                              {marginMm, marginMm, marginMm, marginMm},
                              QPageLayout::Millimeter});
        writer.setTitle(title.title);
        writer.setCreator(title.program);
        Pages pages(writer, charts);
        for (const QString& section : sections)
            pages.add(section);
        pages.paint(title);
    }
    return buffer.data();
}
} // namespace report
