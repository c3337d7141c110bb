// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/export_control.h"

#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_export.h"
#include "ui/common/file_dialog.h"
#include "ui/widgets/banner.h"

#include <QDateTime>
#include <QWidget>

namespace ui {
namespace {
constexpr QSize imageSize(1600, 900);
}

ExportControl::ExportControl(TrendChart& chart, Banner& banner, session::Settings& settings,
                             QWidget* parent)
    : QObject(parent)
    , m_chart(chart)
    , m_banner(banner)
    , m_settings(settings)
    , m_parent(parent)
{}

ExportControl::~ExportControl()
{
    m_stop = true;
}

void ExportControl::choose()
{
    const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HHmmss"));
    askForSavePath(
        m_parent,
        {QStringLiteral("exportViewDialog"),
         tr("Export view"),
         {tr("Image (*.png)"), tr("Vector graphic (*.svg)"), tr("Table for spreadsheets (*.csv)")},
         tr("Trend %1").arg(now),
         &m_settings,
         recordingFolderKey()},
        [this](const QString& path) { save(path); });
}

void ExportControl::save(const QString& path)
{
    const auto is = [&](const char* suffix) {
        return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
    };
    if (is(".csv")) {
        saveTable(path);
        return;
    }
    QString error;
    if (is(".svg"))
        m_chart.saveSvg(path, imageSize, &error);
    else
        m_chart.savePng(path, imageSize, &error);
    showResult(path, error);
}

void ExportControl::saveTable(const QString& path)
{
    m_thread.start([this, path, table = m_chart.shownTable()] {
        const QByteArray text = trendCsv(table, m_stop);
        if (m_stop)
            return;
        const QString error = writeTrendFile(path, text);
        QMetaObject::invokeMethod(this, [this, path, error] { showResult(path, error); });
    });
}

void ExportControl::showResult(const QString& path, const QString& error)
{
    m_banner.showMessage([path, error] {
        return error.isEmpty() ? BannerText{Tone::Good, tr("Saved as %1").arg(path)}
                               : BannerText{Tone::Bad,
                                            tr("The view could not be exported: %1").arg(error),
                                            {},
                                            tr("Check the folder and the free disk space.")};
    });
}
} // namespace ui
