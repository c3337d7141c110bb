// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/test_text.h"

#include "report/html_page.h"
#include "report/sweep_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/translate.h"

#include <cmath>

namespace ui {
using results::Grade;

QString sweepNumber(const std::optional<double>& value)
{
    return value && std::isfinite(*value) ? report::figure(*value) : QStringLiteral("–");
}

QString unitName(const QString& unit)
{
    return text::localized(report::unitText(unit));
}

QString sweepValue(const std::optional<double>& value, const QString& unit,
                   const results::VerdictLine* line)
{
    if (!value || !std::isfinite(*value))
        return text::localized(report::sweepTexts().notMeasured);
    const QString number = line == nullptr
                               ? report::figure(*value)
                               : report::figure(*value, {line->limit.warn, line->limit.fail});
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unitName(unit);
}

QString metricName(const QString& key)
{
    return text::localized(report::metricLabel(key));
}

QString gradeText(Grade grade)
{
    return report::gradeSign(grade) + QLatin1Char(' ') + text::localized(report::gradeLabel(grade));
}

QString lineGradeText(Grade grade)
{
    return report::gradeSign(grade) + QLatin1Char(' ') +
           text::localized(report::lineGradeLabel(grade));
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

QString limitText(const results::SweepLimit& limit, const std::optional<double>& bound)
{
    if (!bound)
        return QStringLiteral("–");
    return (limit.atLeast ? QStringLiteral("< ") : QStringLiteral("> ")) +
           report::exactNumber(*bound);
}

QString reasonText(const results::VerdictLine& line)
{
    const report::SweepTexts& words = report::sweepTexts();
    if (line.grade == Grade::NotMeasured)
        return text::localized(words.noFeedback);
    if (line.grade == Grade::Pass)
        return text::localized(words.within);
    const auto bound = line.grade == Grade::Fail ? line.limit.fail : line.limit.warn;
    const QString& form = text::localized(line.limit.atLeast ? words.under : words.over);
    if (!bound)
        return form.arg(QString());
    const QString number = report::exactNumber(*bound);
    return form.arg(
        line.limit.unit.isEmpty() ? number : number + QLatin1Char(' ') + unitName(line.limit.unit));
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
        sentences << text::translate("ui::SweepPage", "Torque could not be turned off: %1.")
                         .arg(torque.join(comma));
    if (!moving.isEmpty())
        sentences << text::translate("ui::SweepPage", "Movement could not be stopped: %1.")
                         .arg(moving.join(comma));
    return text::joinSentences(sentences);
}

QString unreleasedTorqueRemedy()
{
    return text::translate("ui::SweepPage",
                           "These servos may still be holding their position or moving to their "
                           "last goal. Press the emergency stop or disconnect the power supply.");
}

QString unrevertedSettingsRemedy()
{
    return text::translate(
        "ui::StepPage",
        "The old values are recorded in the journal. When the servo replies again, restore them "
        "under Port → Interrupted writes. At power-off, the servo discards the trial values.");
}

BannerText notStartedText()
{
    return {Tone::Warn, text::translate("ui::SweepPage", "The test was not started."),
            text::translate("ui::SweepPage", "The servo to be tested is no longer in the list "
                                             "or was replaced."),
            text::translate("ui::SweepPage", "Select the servo and start again.")};
}

BannerText failureText(const base::Error& error, const std::vector<jobs::UnreleasedTorque>& left)
{
    const text::Description why = text::describe(error);
    return {Tone::Bad, why.message, unreleasedTorqueText(left), unreleasedTorqueRemedy()};
}
} // namespace ui
