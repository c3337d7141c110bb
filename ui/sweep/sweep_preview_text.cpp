// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_preview_text.h"

#include "jobs/sweep/sweep_path.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/progress_text.h"
#include "ui/sweep/sweep_page.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui {
using base::Duration;
using results::SweepPace;
using results::SweepShape;

namespace {
double seconds(Duration span)
{
    return std::chrono::duration<double>(span).count();
}

/// "1.45 s", "3 min", "2 h 5 min"
QString durationText(Duration span)
{
    const double s = seconds(span);
    if (s < 100)
        return SweepPage::tr("%1 s").arg(QLocale().toString(s, 'f', s < 10 ? 2 : 0));
    const auto minutes = std::llround(s / 60);
    if (minutes < 120)
        return SweepPage::tr("%1 min").arg(minutes);
    return SweepPage::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

/// Of the whole test; 0: unknown.
Duration totalDuration(const session::SweepPreview& preview, const results::SweepSpec& spec)
{
    const Duration byTime = spec.warmUp + spec.length;
    if (spec.cycles <= 0 || !preview.estimate)
        return byTime;
    const jobs::SweepPath path(spec, preview.estimate->axis);
    const int legs = path.legsPerCycle() * spec.cycles;
    Duration each = spec.pause;
    if (spec.shape == SweepShape::Sine)
        each = spec.period / 2;
    else if (spec.pace == SweepPace::Dwell)
        each += preview.estimate->travel.value_or(Duration{});
    return spec.warmUp + legs * each;
}

PreviewText durationCheckText(const session::SweepPreview& preview, const results::SweepSpec& spec,
                              const session::ServoRegistry& registry)
{
    const jobs::SweepEstimate& estimate = *preview.estimate;
    const bool sine = spec.shape == SweepShape::Sine;
    const QString link =
        QStringLiteral("<a href=\"enough\">%1</a>")
            .arg(SweepPage::tr("Use %1").arg(durationText(estimate.proposedDelay)));
    const session::ServoEntry* entry = registry.servo(preview.servo);
    const QString who =
        entry != nullptr ? SweepPage::tr("ID %1: ").arg(entry->servo.id) : QString();
    if (estimate.tooShort && sine)
        return {Tone::Warn,
                who + text::joinSentences(
                          {SweepPage::tr("the sine wave is faster than the servo can move. Use a "
                                         "period of at least %1.")
                               .arg(durationText(estimate.proposedDelay)),
                           link})};
    if (estimate.tooShort)
        return {Tone::Warn, who + text::joinSentences(
                                      {SweepPage::tr("the longest move takes %1 at this speed, so "
                                                     "the servo would turn back before it arrives.")
                                           .arg(durationText(*estimate.travel)),
                                       link})};
    if (estimate.minMove > 0)
        return {
            Tone::Warn,
            who + SweepPage::tr("most moves are too short for a verdict; a goal counts as reached "
                                "within %1 steps, so each move must be at least %2 steps long.")
                      .arg(QLocale().toString(estimate.axis.tolerance, 'g', 4),
                           QLocale().toString(std::ceil(estimate.minMove), 'f', 0))};
    if (!estimate.travel)
        return {Tone::Quiet,
                who + SweepPage::tr("the speed is unknown, so the delay cannot be checked.")};
    if (sine || spec.pace == SweepPace::Dwell)
        return {Tone::Quiet, who + SweepPage::tr("the longest move takes %1 at this speed.")
                                       .arg(durationText(*estimate.travel))};
    return {Tone::Good,
            who +
                SweepPage::tr("the longest move takes %1 at this speed; the delay is long enough.")
                    .arg(durationText(*estimate.travel))};
}
} // namespace

PreviewText previewText(const std::vector<session::SweepPreview>& previews,
                        const results::SweepSpec& spec, const session::ServoRegistry& registry,
                        bool switching)
{
    if (previews.empty())
        return {};
    for (const session::SweepPreview& preview : previews) {
        if (!preview.error)
            continue;
        const bool mode = preview.error->reason == base::Reason::NotInPositionMode;
        if (mode && switching)
            continue;
        const text::Description words = text::describe(*preview.error);
        const QString who =
            preview.error->id >= 0 ? SweepPage::tr("ID %1: ").arg(preview.error->id) : QString();
        return {Tone::Bad,
                (who + text::joinSentences({words.message, words.remedy})).toHtmlEscaped()};
    }
    PreviewText worst;
    Duration whole{};
    for (const session::SweepPreview& preview : previews) {
        if (!preview.estimate)
            continue;
        const PreviewText words = durationCheckText(preview, spec, registry);
        const bool first = worst.text.isEmpty();
        if (first || (words.tone == Tone::Warn && worst.tone != Tone::Warn))
            worst = words;
        whole = std::max(whole, totalDuration(preview, spec));
    }
    if (whole > Duration::zero())
        worst.text = text::joinSentences(
            {worst.text, SweepPage::tr("About %1 in total.").arg(text::durationText(whole))});
    return worst;
}

namespace {
/// "No answer from ID 1, ID 2 for 3 s"
QString silenceText(const jobs::SweepProgress& progress)
{
    QStringList names;
    for (const int id : progress.silent)
        names.append(QStringLiteral("ID %1").arg(id));
    return SweepPage::tr("No reply from %1 for %2")
        .arg(text::joinItems(names), text::durationText(progress.silentFor));
}
} // namespace

QString progressText(const jobs::SweepProgress& progress, const results::SweepRun* run)
{
    if (progress.ended)
        return SweepPage::tr("The test has ended; stopping the servos");
    if (!progress.silent.empty())
        return silenceText(progress);
    if (run == nullptr || (progress.leg == 0 && run->spec.warmUp <= Duration::zero()))
        return SweepPage::tr("Moving to the start");
    if (progress.warmingUp)
        return SweepPage::tr("Warming up; not measuring yet");
    const QString cycle =
        run->spec.cycles > 0
            ? SweepPage::tr("cycle %1 of %2").arg(progress.cycle).arg(run->spec.cycles)
            : SweepPage::tr("cycle %1").arg(progress.cycle);
    if (!progress.remaining)
        return cycle;
    return SweepPage::tr("%1 · %2 left").arg(cycle, text::durationText(*progress.remaining));
}
} // namespace ui
