// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/recording_control.h"

#include "text/error_text.h"
#include "text/language.h"
#include "ui/charts/trend_chart.h"
#include "ui/trends/record_dialog.h"
#include "ui/trends/row_count.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/widgets/banner.h"

#include <QDir>

namespace ui {
namespace {
QString clock(base::Duration span)
{
    const auto seconds = int(span.count() / 1'000'000);
    return QStringLiteral("%1:%2")
        .arg(seconds / 60, 2, 10, QLatin1Char('0'))
        .arg(seconds % 60, 2, 10, QLatin1Char('0'));
}
} // namespace

RecordingControl::RecordingControl(session::LiveRecording& recording, session::Settings& settings,
                                   const Views& views, QWidget* parent)
    : QObject(parent)
    , m_recording(recording)
    , m_settings(settings)
    , m_views(views)
    , m_parent(parent)
{
    using session::LiveRecording;
    connect(&m_recording, &LiveRecording::changed, this, &RecordingControl::showProgress);
    connect(&m_recording, &LiveRecording::failed, this, &RecordingControl::showFailure);
    connect(&m_recording, &LiveRecording::ended, this, &RecordingControl::showResult);
    connect(&m_recording, &LiveRecording::began, this, [this] {
        if (m_dialog)
            m_dialog->close();
    });
}

void RecordingControl::toggle()
{
    if (m_recording.isRunning()) {
        m_recording.stop();
        return;
    }
    m_dialog = new RecordDialog(m_settings, m_parent);
    connect(m_dialog, &RecordDialog::recordingRequested, this, &RecordingControl::start);
    m_dialog->open();
}

void RecordingControl::start(const RecordRequest& request)
{
    session::RecordingRequest recording;
    recording.path = request.path;
    recording.length = std::chrono::seconds(request.seconds);
    if (request.onlyShown) {
        for (const TrendChannel& channel : m_views.chart.channels()) {
            if (channel.visible && channel.id >= 0)
                recording.channels.push_back(channel.id);
        }
    }
    const auto started = request.onlyShown && recording.channels.empty()
                             ? base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                                          QStringLiteral("nothing-read"))
                             : m_recording.start(recording);
    if (!started)
        showFailure(started.error());
}

void RecordingControl::showFailure(const base::Error& error)
{
    const text::Description words = text::describe(error);
    if (m_dialog)
        m_dialog->showError(text::joinSentences({words.message, words.remedy}));
    else
        m_views.banner.showMessage([words] {
            return BannerText{Tone::Bad, words.message, {}, words.remedy};
        });
}

void RecordingControl::showProgress()
{
    if (!m_recording.isRunning()) {
        m_views.toolbar.setRecording({});
        return;
    }
    const recording::RecorderStatus status = m_recording.status();
    m_views.toolbar.setRecording(
        tr("%1 · %Ln row(s)", "time", rowCount(status.rows)).arg(clock(status.elapsed)));
}

void RecordingControl::showResult(const recording::RecorderStatus& status, const QString& path)
{
    m_views.banner.showMessage([status, file = QDir::toNativeSeparators(path)] {
        const int rows = rowCount(status.rows);
        if (status.error) {
            const text::Description words = text::describe(*status.error);
            return BannerText{
                Tone::Bad,
                tr("The recording stopped: %1").arg(words.message),
                {},
                tr("%Ln row(s) saved in %1. %2", nullptr, rows).arg(file, words.remedy)};
        }
        BannerText words{Tone::Good, tr("%Ln row(s) recorded in %1", nullptr, rows).arg(file)};
        if (status.lost > 0) {
            words.tone = Tone::Warn;
            words.cause = tr("%Ln row(s) could not be stored because the disk was too slow.",
                             nullptr, rowCount(status.lost));
        }
        return words;
    });
}
} // namespace ui
