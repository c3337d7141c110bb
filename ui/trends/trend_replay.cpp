// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_replay.h"

#include "catalog/units.h"
#include "text/error_text.h"
#include "ui/charts/trend_chart.h"
#include "ui/common/file_dialog.h"
#include "ui/common/palette.h"
#include "ui/trends/row_count.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/replay_bar.h"

#include <QFileInfo>

#include <utility>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

TrendReplay::TrendReplay(const session::ServoRegistry& registry, const TrendSettings& settings,
                         const Views& views, QWidget* parent)
    : QObject(parent)
    , m_registry(registry)
    , m_settings(settings)
    , m_views(views)
    , m_parent(parent)
{
    connect(&m_reader, &session::Replay::loaded, this, &TrendReplay::show);
    connect(&m_reader, &session::Replay::failed, this, [this](const base::Error& error) {
        m_views.banner.showMessage([error] {
            const text::Description words = text::describe(error);
            return BannerText{Tone::Bad, words.message, {}, words.remedy};
        });
    });
    connect(&views.bar, &ReplayBar::positionChanged, this, &TrendReplay::moveTo);
}

void TrendReplay::open()
{
    askForFile(m_parent,
               {QStringLiteral("openRecordingDialog"),
                tr("Open a recording"),
                {tr("Recordings (*.csv *.jsonl)"), tr("All files (*)")},
                {},
                &m_settings.all(),
                recordingFolderKey()},
               [this](const QString& path) { load(path); });
}

void TrendReplay::load(const QString& path)
{
    m_reader.load(path);
}

void TrendReplay::show(const std::shared_ptr<session::ReplayData>& recording)
{
    // The chart uses the previous recording until it has all of the new one.
    const auto previous = std::exchange(m_data, recording);
    m_views.chart.setMarks(&recording->content.marks);
    m_views.chart.setStore(&recording->store);
    showChannels();
    m_views.chart.setLive(false);
    m_views.chart.setOrigin({});
    m_views.toolbar.setReplaying(true);
    m_views.bar.setVisible(true);
    const recording::TimeSpan span = recording->store.span().value_or(recording::TimeSpan{});
    m_views.bar.setRecording(QFileInfo(recording->path).fileName(), span);
    m_views.chart.zoomToFit();
    Q_EMIT shown();
    showReport();
}

void TrendReplay::showChannels()
{
    const recording::LoadedRecording& content = m_data->content;
    QStringList keys;
    for (const recording::RecordingChannel& column : content.head.channels)
        keys << column.key;
    const std::vector<QColor> colors = trendColors(keys, m_parent->palette().color(QPalette::Base));
    std::vector<TrendChannel> channels;
    for (std::size_t i = 0; i < content.ids.size(); ++i) {
        const recording::RecordingChannel& column = content.head.channels[i];
        TrendChannel channel;
        channel.id = content.ids[i];
        channel.key = QStringLiteral("%1/%2").arg(column.servoId).arg(column.key);
        channel.name = recordedChannelName(m_registry, column);
        channel.unit = catalog::unitSuffix(column.unit).trimmed();
        channel.color = colors[i];
        channel.dashed = isGoalKey(column.key);
        channels.push_back(std::move(channel));
    }
    m_views.chart.setChannels(std::move(channels));
}

void TrendReplay::showReport()
{
    const QString name = QFileInfo(m_data->path).fileName();
    m_views.banner.showMessage([name, report = m_data->content.report] {
        BannerText words{Tone::Accent,
                         tr("Recording %1: %Ln row(s)", nullptr, rowCount(report.rows)).arg(name)};
        if (report.isTruncated)
            words.cause = tr("The last line is incomplete and is not shown.");
        if (report.badLines > 0)
            words.remedy = tr("%Ln line(s) could not be read", nullptr, rowCount(report.badLines));
        return words;
    });
}

void TrendReplay::close()
{
    if (!isActive())
        return;
    m_views.bar.setPlaying(false);
    m_views.bar.setVisible(false);
    m_views.toolbar.setReplaying(false);
    m_views.banner.hideMessage();
    const auto previous = std::exchange(m_data, nullptr); // see closed()
    Q_EMIT closed();
}

void TrendReplay::togglePlaying()
{
    m_views.bar.setPlaying(!m_views.bar.isPlaying());
}

/// The position is the right edge of the chart, as the present is while following.
void TrendReplay::moveTo(Duration position)
{
    if (!isActive())
        return;
    // When the whole recording is shown, nothing is left to play: show the width of live readings.
    const auto all = m_data->store.span().value_or(recording::TimeSpan{});
    const bool whole = m_views.chart.width() >= all.to - all.from;
    const Duration width =
        whole ? m_settings.width() : std::max<Duration>(m_views.chart.width(), 1ms);
    m_views.chart.setShownSpan(recording::TimeSpan{position - width, position});
}
} // namespace ui
