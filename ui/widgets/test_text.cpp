// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/test_text.h"

#include "report/html_page.h"
#include "report/sweep_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/translate.h"

#include <cmath>

namespace ui {
using record::Grade;

namespace {
QString localized(const catalog::Text& words)
{
    return words.in(text::isUiChinese());
}
} // namespace

QString sweepNumber(const std::optional<double>& value)
{
    return value && std::isfinite(*value) ? report::figure(*value) : QStringLiteral("–");
}

QString unitName(const QString& unit)
{
    return localized(report::unitText(unit));
}

QString sweepValue(const std::optional<double>& value, const QString& unit)
{
    if (!value || !std::isfinite(*value))
        return localized(report::sweepTexts().notMeasured);
    const QString number = report::figure(*value);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unitName(unit);
}

QString metricName(const QString& key)
{
    return localized(report::metricLabel(key));
}

QString gradeText(Grade grade)
{
    return report::gradeSign(grade) + QLatin1Char(' ') + localized(report::gradeLabel(grade));
}

QString lineGradeText(Grade grade)
{
    return report::gradeSign(grade) + QLatin1Char(' ') + localized(report::lineGradeLabel(grade));
}

Tone gradeTone(Grade grade)
{
    switch (grade) {
    case Grade::Pass:
        return Tone::Good;
    case Grade::Warn:
        return Tone::Warn;
    case Grade::Fail:
        return Tone::Bad;
    case Grade::NotMeasured:
        break;
    }
    return Tone::Quiet;
}

QString limitText(const record::SweepLimit& limit, const std::optional<double>& bound)
{
    if (!bound)
        return QStringLiteral("–");
    return (limit.atLeast ? QStringLiteral("< ") : QStringLiteral("> ")) + report::figure(*bound);
}

QString reasonText(const record::VerdictLine& line)
{
    const report::SweepTexts& words = report::sweepTexts();
    if (line.grade == Grade::NotMeasured)
        return localized(words.noFeedback);
    if (line.grade == Grade::Pass)
        return localized(words.within);
    const auto bound = line.grade == Grade::Fail ? line.limit.fail : line.limit.warn;
    const QString& form = localized(line.limit.atLeast ? words.under : words.over);
    return form.arg(bound ? sweepValue(bound, line.limit.unit) : QString());
}

QString unreleasedTorqueText(const std::vector<jobs::UnreleasedTorque>& left)
{
    QStringList torque;
    QStringList moving;
    for (const jobs::UnreleasedTorque& one : left)
        (one.holding ? moving : torque).append(QStringLiteral("ID %1").arg(one.id));
    const QString comma = QStringLiteral(", ");
    QStringList sentences;
    if (!torque.isEmpty())
        sentences << text::translate("ui::SweepPage", "Torque could not be switched off: %1.")
                         .arg(torque.join(comma));
    if (!moving.isEmpty())
        sentences << text::translate("ui::SweepPage", "Motion could not be stopped: %1.")
                         .arg(moving.join(comma));
    return sentences.join(QLatin1Char(' '));
}

QString unreleasedTorqueRemedy()
{
    return text::translate("ui::SweepPage", "Such a servo may still hold or move to its last goal. "
                                            "Press the emergency stop or cut the supply.");
}

QString unrevertedSettingsRemedy()
{
    return text::translate("ui::StepPage",
                           "It is noted in the journal: when the servo answers again, put it back "
                           "under Port → Interrupted writes. At power-off the servo forgets it by "
                           "itself.");
}

BannerText notStartedText()
{
    return {Tone::Warn, text::translate("ui::SweepPage", "The test was not started."),
            text::translate("ui::SweepPage", "A servo it was meant for has left the list or was "
                                             "exchanged."),
            text::translate("ui::SweepPage", "Choose the servo and start again.")};
}

BannerText failureText(const base::Error& error, const std::vector<jobs::UnreleasedTorque>& left)
{
    const text::Description why = text::describe(error);
    return {Tone::Bad, why.message, unreleasedTorqueText(left), unreleasedTorqueRemedy()};
}
} // namespace ui
