// SPDX-License-Identifier: GPL-3.0-or-later
// The trend panel's files: recordings, replay, pictures, kept views.
#include "catalog/units.h"
#include "text/error_text.h"
#include "ui/charts/palette.h"
#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_preset.h"
#include "ui/trends/record_dialog.h"
#include "ui/trends/trend_panel.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/replay_bar.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr QSize pictureSize(1600, 900);
const QString folderKey = QStringLiteral("trend/record_folder");

QString clock(Duration span)
{
    const auto seconds = int(span.count() / 1'000'000);
    return QStringLiteral("%1:%2")
        .arg(seconds / 60, 2, 10, QLatin1Char('0'))
        .arg(seconds % 60, 2, 10, QLatin1Char('0'));
}
} // namespace

void TrendPanel::toggleRecording()
{
    if (m_liveData.isRecording()) {
        m_liveData.stopRecording();
        return;
    }
    auto* dialog = new RecordDialog(m_settings, this);
    m_recordDialog = dialog;
    connect(dialog, &RecordDialog::recordingRequested, this, &TrendPanel::startRecording);
    dialog->open();
}

void TrendPanel::startRecording(const RecordRequest& request)
{
    session::RecordingRequest order;
    order.path = request.path;
    order.length = std::chrono::seconds(request.seconds);
    if (request.onlyShown) {
        for (const TrendChannel& channel : m_chart->channels()) {
            if (channel.visible && channel.id >= 0)
                order.channels.push_back(channel.id);
        }
    }
    const auto started = request.onlyShown && order.channels.empty()
                             ? base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                                          QStringLiteral("nothing-read"))
                             : m_liveData.startRecording(order);
    if (!started)
        recordingFailed(started.error());
}

void TrendPanel::recordingFailed(const base::Error& error)
{
    const text::Description words = text::describe(error);
    if (m_recordDialog)
        m_recordDialog->showError(words.message + QLatin1Char(' ') + words.remedy);
    else
        showError(words.message, words.remedy);
}

void TrendPanel::showRecording()
{
    if (!m_liveData.isRecording()) {
        m_toolbar->setRecording({});
        return;
    }
    const record::RecorderStatus status = m_liveData.recordingStatus();
    m_toolbar->setRecording(tr("%1 · %2 rows", "time, number")
                                .arg(clock(status.elapsed))
                                .arg(locale().toString(qulonglong(status.rows))));
}

void TrendPanel::recordingEnded(const record::RecorderStatus& status, const QString& path)
{
    const QString rows = locale().toString(qulonglong(status.rows));
    const QString file = QDir::toNativeSeparators(path);
    if (status.error) {
        const text::Description words = text::describe(*status.error);
        showError(tr("The recording has ended: %1").arg(words.message),
                  tr("%1 rows are safe in %2. %3").arg(rows, file, words.remedy));
        return;
    }
    QString more;
    if (status.lost > 0)
        more = tr("%1 rows found no room and are missing: the disk was too slow.")
                   .arg(locale().toString(qulonglong(status.lost)));
    const Tone tone = status.lost > 0 ? Tone::Warn : Tone::Good;
    m_banner->showMessage([rows, file, more, tone] {
        return BannerText{tone, tr("%1 rows recorded in %2").arg(rows, file), more};
    });
}

void TrendPanel::openRecording()
{
    auto* dialog = new QFileDialog(this, tr("Open a recording"));
    dialog->setObjectName(QStringLiteral("openRecordingDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Recordings (*.csv *.jsonl)"), tr("All files (*)")});
    dialog->setDirectory(m_settings.pageValue(folderKey, QString()).toString());
    connect(dialog, &QFileDialog::fileSelected, this, &TrendPanel::load);
    dialog->open();
}

void TrendPanel::load(const QString& path)
{
    m_replay.load(path);
}

void TrendPanel::showReplay(const std::shared_ptr<session::ReplayData>& recording)
{
    // The chart borrows from the one before until it has all of the new one.
    const auto before = std::exchange(m_replayed, recording);
    const record::LoadedRecording& content = recording->content;
    std::vector<TrendChannel> channels;
    for (std::size_t i = 0; i < content.ids.size(); ++i) {
        const record::RecordingChannel& from = content.head.channels[i];
        TrendChannel channel;
        channel.id = content.ids[i];
        channel.key = QStringLiteral("%1/%2").arg(from.servoId).arg(from.key);
        channel.name = recordedChannelName(m_desk, from);
        channel.unit = catalog::unitSuffix(from.unit).trimmed();
        channel.color = trendColor(int(i), backgroundColor());
        channels.push_back(std::move(channel));
    }
    m_chart->setMarks(&content.marks);
    m_chart->setStore(&recording->store);
    m_chart->setChannels(std::move(channels));
    m_chart->setLive(false);
    m_chart->setOrigin({});
    m_toolbar->setReplaying(true);
    m_replayBar->setVisible(true);
    const record::TimeSpan span = recording->store.span().value_or(record::TimeSpan{});
    m_replayBar->setRecording(QFileInfo(recording->path).fileName(), span);
    m_chart->zoomToFit();
    Q_EMIT replayShown();
    const QString name = QFileInfo(recording->path).fileName();
    const record::RecordingReport report = content.report;
    m_banner->showMessage([this, name, report] {
        BannerText words{Tone::Accent, tr("Recording %1: %2 rows").arg(name).arg(report.rows)};
        if (report.isTruncated)
            words.cause = tr("Its last line is cut off: what was measured before is shown.");
        if (report.badLines > 0)
            words.remedy = tr("Lines that could not be understood: %1").arg(report.badLines);
        return words;
    });
}

void TrendPanel::closeReplay()
{
    if (!isReplaying())
        return;
    m_replayBar->setPlaying(false);
    m_replayBar->setVisible(false);
    m_toolbar->setReplaying(false);
    m_banner->hideMessage();
    m_chart->setMarks(&m_liveData.marks());
    m_chart->setStore(&m_liveData.store());
    m_chart->setLive(true);
    const auto before = std::exchange(m_replayed, nullptr); // see showReplay
    showCurves();
    m_chart->setWidth(defaultWidth());
    m_chart->setFollowing(true);
    samplesAdded();
}

/// The place is the right edge of what is shown, as "now" is while following.
void TrendPanel::followReplay(Duration place)
{
    if (!isReplaying())
        return;
    // All of it at once leaves nothing to play: then as much as is shown of live readings.
    const auto all = m_replayed->store.span().value_or(record::TimeSpan{});
    const bool whole = m_chart->width() >= all.to - all.from;
    const Duration width = whole ? defaultWidth() : std::max<Duration>(m_chart->width(), 1ms);
    m_chart->setShownSpan(record::TimeSpan{place - width, place});
}

void TrendPanel::saveImage()
{
    const QString png = tr("Picture (*.png)");
    const QString svg = tr("Drawing (*.svg)");
    auto* dialog = new QFileDialog(this, tr("Save the picture"));
    dialog->setObjectName(QStringLiteral("saveImageDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({png, svg});
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, svg](const QString& filter) {
        dialog->setDefaultSuffix(filter == svg ? QStringLiteral("svg") : QStringLiteral("png"));
    });
    connect(dialog, &QFileDialog::fileSelected, this, &TrendPanel::writeImage);
    dialog->open();
}

void TrendPanel::writeImage(const QString& path)
{
    QString trouble;
    const bool drawing = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
    const bool saved = drawing ? m_chart->saveSvg(path, pictureSize, &trouble)
                               : m_chart->savePng(path, pictureSize, &trouble);
    if (!saved) {
        showError(tr("The picture could not be saved: %1").arg(trouble),
                  tr("Check the folder and the space on the disk."));
        return;
    }
    m_banner->showMessage([path] { return BannerText{Tone::Good, tr("Saved as %1").arg(path)}; });
}

void TrendPanel::showPresets()
{
    m_toolbar->setPresets(presetNames(m_settings));
}

void TrendPanel::savePresetAs()
{
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("presetDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keep this view"));
    dialog->setLabelText(tr("Its name:"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& typed) {
        const QString name = typed.trimmed();
        if (name.isEmpty())
            return;
        TrendPreset preset;
        preset.width = m_chart->width();
        for (const TrendCurve& choice : m_curves)
            preset.channels.push_back(
                {choice.id(), choice.visible, choice.color, choice.scale, choice.offset});
        savePreset(m_settings, name, preset);
        showPresets();
    });
    dialog->open();
}

void TrendPanel::applyPreset(const QString& name)
{
    const auto preset = loadPreset(m_settings, name);
    if (!preset)
        return;
    std::vector<TrendCurve> curves;
    for (const auto& curve : preset->channels) {
        TrendCurve choice = TrendCurve::fromId(curve.key);
        choice.visible = curve.visible;
        choice.color = curve.color;
        choice.scale = curve.scale;
        choice.offset = curve.offset;
        curves.push_back(choice);
    }
    setCurves(curves);
    m_chart->setWidth(preset->width);
}
} // namespace ui
