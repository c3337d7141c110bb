// SPDX-License-Identifier: GPL-3.0-or-later
// The trend panel's files: recordings, replay, pictures, kept views.
#include "catalog/units.h"
#include "text/error_words.h"
#include "ui/charts/palette.h"
#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_preset.h"
#include "ui/dialogs/record_dialog.h"
#include "ui/pages/trend_panel.h"
#include "ui/pages/trend_toolbar.h"
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
const QString folderChoice = QStringLiteral("trend/record_folder");

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
    if (m_scope.recording()) {
        m_scope.stopRecording();
        return;
    }
    auto* dialog = new RecordDialog(m_settings, this);
    m_recordDialog = dialog;
    connect(dialog, &RecordDialog::wished, this, &TrendPanel::startRecording);
    dialog->open();
}

void TrendPanel::startRecording(const RecordWish& wish)
{
    session::RecordingOrder order;
    order.path = wish.path;
    order.length = std::chrono::seconds(wish.seconds);
    if (wish.onlyShown) {
        for (const TrendChannel& channel : m_chart->channels()) {
            if (channel.visible && channel.id >= 0)
                order.channels.push_back(channel.id);
        }
    }
    const auto started = wish.onlyShown && order.channels.empty()
                             ? base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                                          QStringLiteral("nothing-read"))
                             : m_scope.record(order);
    if (!started)
        recordingFailed(started.error());
}

void TrendPanel::recordingFailed(const base::Error& error)
{
    const text::Description words = text::describe(error);
    if (m_recordDialog)
        m_recordDialog->complain(words.what + QLatin1Char(' ') + words.remedy);
    else
        complain(words.what, words.remedy);
}

void TrendPanel::showRecording()
{
    if (!m_scope.recording()) {
        m_toolbar->setRecording({});
        return;
    }
    const record::RecorderStatus status = m_scope.recordingStatus();
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
        complain(tr("The recording has ended: %1").arg(words.what),
                 tr("%1 rows are safe in %2. %3").arg(rows, file, words.remedy));
        return;
    }
    QString more;
    if (status.lost > 0)
        more = tr("%1 rows found no room and are missing: the disk was too slow.")
                   .arg(locale().toString(qulonglong(status.lost)));
    const Tone tone = status.lost > 0 ? Tone::Warn : Tone::Good;
    m_banner->present([rows, file, more, tone] {
        return BannerWords{tone, tr("%1 rows recorded in %2").arg(rows, file), more};
    });
}

void TrendPanel::openRecording()
{
    auto* dialog = new QFileDialog(this, tr("Open a recording"));
    dialog->setObjectName(QStringLiteral("openRecordingDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Recordings (*.csv *.jsonl)"), tr("All files (*)")});
    dialog->setDirectory(m_settings.choice(folderChoice, QString()).toString());
    connect(dialog, &QFileDialog::fileSelected, this, &TrendPanel::load);
    dialog->open();
}

void TrendPanel::load(const QString& path)
{
    m_replay.load(path);
}

void TrendPanel::showReplay(const std::shared_ptr<session::Replayed>& recording)
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
        channel.name = recordedName(m_desk, from);
        channel.unit = catalog::unitSuffix(from.unit).trimmed();
        channel.colour = trendColour(int(i), ground());
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
    m_chart->fit();
    Q_EMIT replayShown();
    const QString name = QFileInfo(recording->path).fileName();
    const record::RecordingReport report = content.report;
    m_banner->present([this, name, report] {
        BannerWords words{Tone::Accent, tr("Recording %1: %2 rows").arg(name).arg(report.rows)};
        if (report.cutOff)
            words.cause = tr("Its last line is cut off: what was measured before is shown.");
        if (report.badLines > 0)
            words.remedy = tr("Lines that could not be understood: %1").arg(report.badLines);
        return words;
    });
}

void TrendPanel::leaveReplay()
{
    if (!replaying())
        return;
    m_replayBar->setPlaying(false);
    m_replayBar->setVisible(false);
    m_toolbar->setReplaying(false);
    m_banner->clear();
    m_chart->setMarks(&m_scope.marks());
    m_chart->setStore(&m_scope.store());
    m_chart->setLive(true);
    const auto before = std::exchange(m_replayed, nullptr); // see showReplay
    showCurves();
    m_chart->setWidth(usualWidth());
    m_chart->setFollowing(true);
    grown();
}

/// The place is the right edge of what is shown, as "now" is while following.
void TrendPanel::followReplay(Duration place)
{
    if (!replaying())
        return;
    // All of it at once leaves nothing to play: then as much as is shown of live readings.
    const auto all = m_replayed->store.span().value_or(record::TimeSpan{});
    const bool whole = m_chart->width() >= all.to - all.from;
    const Duration width = whole ? usualWidth() : std::max<Duration>(m_chart->width(), 1ms);
    m_chart->look(record::TimeSpan{place - width, place});
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
        complain(tr("The picture could not be saved: %1").arg(trouble),
                 tr("Check the folder and the space on the disk."));
        return;
    }
    m_banner->present([path] { return BannerWords{Tone::Good, tr("Saved as %1").arg(path)}; });
}

void TrendPanel::showPresets()
{
    m_toolbar->setPresets(presetNames(m_settings));
}

void TrendPanel::keepPreset()
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
        for (const TrendChoice& choice : m_choices)
            preset.channels.push_back(
                {choice.id(), choice.visible, choice.colour, choice.scale, choice.offset});
        savePreset(m_settings, name, preset);
        showPresets();
    });
    dialog->open();
}

void TrendPanel::usePreset(const QString& name)
{
    const auto preset = loadPreset(m_settings, name);
    if (!preset)
        return;
    std::vector<TrendChoice> choices;
    for (const auto& curve : preset->channels) {
        TrendChoice choice = TrendChoice::fromId(curve.key);
        choice.visible = curve.visible;
        choice.colour = curve.colour;
        choice.scale = curve.scale;
        choice.offset = curve.offset;
        choices.push_back(choice);
    }
    setChoices(choices);
    m_chart->setWidth(preset->width);
}
} // namespace ui
