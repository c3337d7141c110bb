// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/sweep_outlook.h"

#include "jobs/sweep_path.h"
#include "text/error_words.h"
#include "ui/pages/sweep_page.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui {
using base::Duration;
using record::SweepPace;
using record::SweepShape;

namespace {
double seconds(Duration span)
{
    return std::chrono::duration<double>(span).count();
}

/// "1.45 s", "3 min", "2 h 5 min"
QString spanWords(Duration span)
{
    const double s = seconds(span);
    if (s < 100)
        return SweepPage::tr("%1 s").arg(QLocale().toString(s, 'f', s < 10 ? 2 : 0));
    const auto minutes = std::llround(s / 60);
    if (minutes < 120)
        return SweepPage::tr("%1 min").arg(minutes);
    return SweepPage::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString shortSpan(Duration span)
{
    const auto s = std::llround(seconds(span));
    return s < 60     ? SweepPage::tr("%1 s").arg(s)
           : s < 3600 ? SweepPage::tr("%1 min %2 s").arg(s / 60).arg(s % 60)
                      : SweepPage::tr("%1 h %2 min").arg(s / 3600).arg(s % 3600 / 60);
}

/// Of the whole test; 0: nothing tells.
Duration wholeLength(const session::SweepLook& look, const record::SweepSpec& spec)
{
    const Duration byTime = spec.warmUp + spec.length;
    if (spec.cycles <= 0 || !look.outlook)
        return byTime;
    const jobs::SweepPath path(spec, look.outlook->axis);
    const int legs = path.legsPerCycle() * spec.cycles;
    Duration each = spec.pause;
    if (spec.shape == SweepShape::Sine)
        each = spec.period / 2;
    else if (spec.pace == SweepPace::Dwell)
        each += look.outlook->travel.value_or(Duration{});
    return spec.warmUp + legs * each;
}

OutlookWords timeWords(const session::SweepLook& look, const record::SweepSpec& spec,
                       const session::Desk& desk)
{
    const jobs::SweepOutlook& outlook = *look.outlook;
    const bool sine = spec.shape == SweepShape::Sine;
    const QString link = QStringLiteral("<a href=\"enough\">%1</a>")
                             .arg(SweepPage::tr("Take %1").arg(spanWords(outlook.enough)));
    const session::ServoEntry* entry = desk.servo(look.servo);
    const QString who =
        entry != nullptr ? QStringLiteral("ID %1: ").arg(entry->servo.id) : QString();
    if (outlook.tooShort && sine)
        return {
            Tone::Warn,
            who +
                SweepPage::tr("the sine is faster than the servo can turn; it needs a period of "
                              "at least %1.")
                    .arg(spanWords(outlook.enough)) +
                QLatin1Char(' ') + link};
    if (outlook.tooShort)
        return {Tone::Warn,
                who +
                    SweepPage::tr("the longest way takes %1 at this speed: the servo would turn "
                                  "round before it arrives.")
                        .arg(spanWords(*outlook.travel)) +
                    QLatin1Char(' ') + link};
    if (outlook.minMove > 0)
        return {Tone::Warn,
                who + SweepPage::tr("most moves are too short for a verdict: targets count as "
                                    "reached within %1 steps, so moves need at least %2 steps.")
                          .arg(QLocale().toString(outlook.axis.tolerance, 'g', 4),
                               QLocale().toString(std::ceil(outlook.minMove), 'f', 0))};
    if (!outlook.travel)
        return {Tone::Quiet,
                who + SweepPage::tr("nothing tells how fast it goes, so the delay cannot be "
                                    "judged.")};
    if (sine || spec.pace == SweepPace::Dwell)
        return {Tone::Quiet, who + SweepPage::tr("the longest way takes %1 at this speed.")
                                       .arg(spanWords(*outlook.travel))};
    return {Tone::Good,
            who + SweepPage::tr("the longest way takes %1 at this speed: the delay is long enough.")
                      .arg(spanWords(*outlook.travel))};
}
} // namespace

OutlookWords outlookWords(const std::vector<session::SweepLook>& looks,
                          const record::SweepSpec& spec, const session::Desk& desk, bool switching)
{
    if (looks.empty())
        return {};
    for (const session::SweepLook& look : looks) {
        if (!look.error)
            continue;
        const bool mode = look.error->detail == QLatin1StringView("not-position");
        if (mode && switching)
            continue;
        const text::Description words = text::describe(*look.error);
        const QString who =
            look.error->id >= 0 ? QStringLiteral("ID %1: ").arg(look.error->id) : QString();
        return {Tone::Bad, (who + words.what + QLatin1Char(' ') + words.remedy).toHtmlEscaped()};
    }
    OutlookWords worst;
    Duration whole{};
    for (const session::SweepLook& look : looks) {
        if (!look.outlook)
            continue;
        const OutlookWords words = timeWords(look, spec, desk);
        const bool first = worst.text.isEmpty();
        if (first || (words.tone == Tone::Warn && worst.tone != Tone::Warn))
            worst = words;
        whole = std::max(whole, wholeLength(look, spec));
    }
    if (whole > Duration::zero())
        worst.text += QLatin1Char(' ') + SweepPage::tr("About %1 in all.").arg(shortSpan(whole));
    return worst;
}

namespace {
/// "No answer from ID 1, ID 2 for 3 s"
QString silenceWords(const jobs::SweepProgress& progress)
{
    QStringList names;
    for (const int id : progress.silent)
        names.append(QStringLiteral("ID %1").arg(id));
    return SweepPage::tr("No answer from %1 for %2")
        .arg(names.join(QStringLiteral(", ")), shortSpan(progress.silentFor));
}
} // namespace

QString progressWords(const jobs::SweepProgress& progress, const record::SweepRun* run)
{
    if (progress.ended)
        return SweepPage::tr("The test has ended; stopping the servos");
    if (!progress.silent.empty())
        return silenceWords(progress);
    if (run == nullptr || (progress.leg == 0 && run->spec.warmUp <= Duration::zero()))
        return SweepPage::tr("On the way to the start");
    if (progress.warmingUp)
        return SweepPage::tr("Warming up; nothing is measured yet");
    const QString cycle =
        run->spec.cycles > 0
            ? SweepPage::tr("cycle %1 of %2").arg(progress.cycle).arg(run->spec.cycles)
            : SweepPage::tr("cycle %1").arg(progress.cycle);
    if (progress.fraction <= 0)
        return cycle;
    return SweepPage::tr("%1 · %2 left").arg(cycle, shortSpan(progress.remaining));
}
} // namespace ui
