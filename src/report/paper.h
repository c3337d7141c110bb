// SPDX-License-Identifier: GPL-3.0-or-later
// Markup on paper, as PDF: A4, or Letter where that is usual, upright, with page numbers below and
// charts as drawings. Needs a QGuiApplication for the fonts (the platform "offscreen" is enough)
// and its thread.
#pragma once

#include "report/html_page.h"

#include <QByteArray>

#include <vector>

namespace report {
/// The drawings of a document, and the markup that shows them. Lives as long as its document.
class PaperCharts {
public:
    /// The <img> that stands for this SVG, as wide as the page.
    QString add(const QString& svg);
    /// By the name in an <img>; empty: unknown.
    QByteArray svg(const QString& name) const;

private:
    std::vector<QByteArray> m_charts;
};

struct PaperTitle {
    QString title;
    QString program; ///< below every page, and as the creator
    QString at;      ///< below every page
};

/// Each section is HTML in one language, with its head, and begins a page.
QByteArray paperPdf(const QStringList& sections, const PaperCharts& charts,
                    const PaperTitle& title);
} // namespace report
