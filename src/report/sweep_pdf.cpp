// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_pdf.h"

#include "files/text_file.h"
#include "report/fonts.h"
#include "report/sweep_text.h"

#include <QBuffer>
#include <QFont>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

namespace report {
namespace {
constexpr int imageScale = 2;
constexpr int shownWidth = 620;

QFont paperFont()
{
    QFont font;
    if (const QStringList families = textFamilies(); !families.isEmpty())
        font.setFamilies(families);
    return font;
}

/// A text document cannot show SVG, so a chart becomes an image, sharp enough for paper.
QImage pictureOf(const QString& svg)
{
    QSvgRenderer renderer(svg.toUtf8());
    QImage image(renderer.defaultSize() * imageScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(paperFont());
    renderer.render(&painter);
    return image;
}
} // namespace

QByteArray sweepPdf(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                    bool chinese)
{
    const HtmlWriter htmlWriter(chinese ? ReportLanguage::Chinese : ReportLanguage::English);
    QTextDocument document;
    document.setDefaultFont(paperFont());
    int charts = 0;
    const QString body = sweepBody(htmlWriter, run, series, [&](const QString& svg) {
        const QString name = QStringLiteral("chart-%1").arg(++charts);
        document.addResource(QTextDocument::ImageResource, QUrl(name), pictureOf(svg));
        return QStringLiteral("<p><img src=\"%1\" width=\"%2\"/></p>\n").arg(name).arg(shownWidth);
    });
    document.setHtml(page(htmlWriter, sweepTexts().title, body, chinese));

    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        // The table of legs is wide.
        writer.setPageLayout({QPageSize(QPageSize::A4), QPageLayout::Landscape, {}});
        writer.setTitle(sweepTexts().title.in(chinese));
        writer.setCreator(run.program);
        document.print(&writer);
    }
    return buffer.data();
}

base::Result<void> saveSweepPdf(const results::SweepRun& run,
                                const std::vector<SweepSeries>& series, bool chinese,
                                const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-report"), sweepPdf(run, series, chinese), path);
}
} // namespace report
