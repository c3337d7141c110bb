// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_start_question.h"

#include "text/translate.h"
#include "ui/widgets/question_dialog.h"

#include <algorithm>

namespace ui {
using text::translate;

namespace {
/// "1500 … 2500" as typed; for a list its outermost targets, as far as they are known.
QString rangeText(const session::ServoEntry& entry, session::ServoRef ref,
                  const results::SweepSpec& spec,
                  const std::vector<session::SweepPreview>& previews)
{
    const auto words = [](const QString& from, const QString& to) {
        return translate("ui::SweepPage", "range %1 … %2").arg(from, to);
    };
    if (spec.shape != results::SweepShape::Points) {
        const auto own = spec.ranges.find(entry.servo.id);
        const results::SweepRange& range = own != spec.ranges.end() ? own->second : spec.range;
        return words(range.from, range.to);
    }
    const auto preview = std::find_if(previews.begin(), previews.end(), [ref](const auto& one) {
        return one.servo == ref && one.estimate;
    });
    if (preview == previews.end())
        return translate("ui::SweepPage", "goals from the list");
    const auto& axis = preview->estimate->axis;
    return words(QString::number(axis.from), QString::number(axis.to));
}

/// However the test ends, except by a fault or the emergency stop; also for servos that had no
/// torque before.
QString torqueAfterwards(const SweepConsent& consent)
{
    if (consent.released)
        return translate(
            "ui::SweepPage",
            "Afterwards, torque is off, even if you stop the test or close the window.");
    const QString held =
        translate("ui::SweepPage", "Afterwards, the servos hold their position with torque on, "
                                   "even if you stop the test or close the window.");
    return consent.switchMode
               ? held + QLatin1Char('\n') +
                     translate(
                         "ui::SweepPage",
                         "Afterwards, torque is off on servos that switch back to another mode.")
               : held;
}
} // namespace

SweepConsent consentFor(const session::SweepTestRequest& request)
{
    return {request.servos, request.spec.releaseAtEnd, request.switchMode};
}

void askBeforeSweep(QWidget* page, const session::ServoRegistry& registry,
                    const session::SweepTestRequest& request,
                    const std::vector<session::SweepPreview>& previews,
                    const std::function<void()>& accepted)
{
    QStringList names;
    for (const session::ServoRef ref : request.servos) {
        const session::ServoEntry* entry = registry.servo(ref);
        names.append(QStringLiteral("ID %1 · %2, %3")
                         .arg(QString::number(entry->servo.id), entry->servo.profile->modelName,
                              rangeText(*entry, ref, request.spec, previews)));
    }
    Question question;
    question.title = translate("ui::SweepPage", "Start the test?");
    question.text =
        translate(
            "ui::SweepPage",
            "Torque is turned on, and these servos move by themselves until the test has ended: %1")
            .arg(QLatin1Char('\n') + names.join(QLatin1Char('\n'))) +
        QLatin1Char('\n') + torqueAfterwards(consentFor(request));
    question.risk = translate("ui::SweepPage", "Keep hands and objects away from the servos. Esc "
                                               "immediately turns torque off on all servos.");
    question.acceptText = translate("ui::SweepPage", "Start");
    question.guard = page;
    ask(page, question, accepted);
}
} // namespace ui
