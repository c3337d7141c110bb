// SPDX-License-Identifier: GPL-3.0-or-later
// A report of one section as a file: a page of both languages, or a PDF of one. Any thread; a PDF
// needs a QGuiApplication. Fails with FileUnwritable or DiskFull, and the old file stays.
#pragma once

#include "base/error.h"
#include "report/html_page.h"

#include <functional>

namespace report {
struct ReportHead {
    catalog::Text title;
    QString program;
    QDateTime at;
};

/// Markup that shows this SVG.
using EmbedChart = std::function<QString(const QString& svg)>;
using ReportBody = std::function<QString(const HtmlWriter& htmlWriter, const EmbedChart& place)>;

QString endingOf(const QString& path); ///< "html", in lower case
/// Html or Pdf by the end of the file's name.
bool isReportPath(const QString& path);
/// `chinese`: the language a report opens in. `path` is a name for which isReportPath() holds.
base::Result<void> saveReport(const ReportHead& head, const ReportBody& body, bool chinese,
                              const QString& path);
} // namespace report
