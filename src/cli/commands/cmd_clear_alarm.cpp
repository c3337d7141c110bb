// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/change/clear_alarm.h"
#include "text/alarm_text.h"
#include "text/language.h"

namespace cli {
namespace {
Json jsonAlarmPlan(const jobs::AlarmPlan& plan)
{
    Json::Array alarms;
    for (const jobs::Alarm& alarm : plan.alarms) {
        alarms.push_back(Json::object()
                             .add("key", alarm.key)
                             .add("release", jobs::clearMethodName(alarm.release))
                             .add("derived", alarm.derived)
                             .add("register", alarm.measured.isEmpty() ? Json() : alarm.measured)
                             .add("value", alarm.value)
                             .add("min", alarm.min)
                             .add("max", alarm.max));
    }
    return alarms;
}

QString shown(const device::Servo& servo, const jobs::Alarm& alarm,
              const std::optional<std::int64_t>& raw)
{
    const catalog::Register* reg = servo.profile->find(alarm.measured);
    return raw && reg != nullptr
               ? catalog::formatValue(*raw, *reg, servo.meaning(*reg), text::isUiChinese())
               : noValue();
}

QString alarmText(const device::Servo& servo, const jobs::AlarmPlan& plan)
{
    Table table({translate("cli", "Alarm"), translate("cli", "Value"), translate("cli", "Minimum"),
                 translate("cli", "Maximum")});
    table.alignRight({1, 2, 3});
    for (const jobs::Alarm& alarm : plan.alarms) {
        table.add({text::alarmLabel(alarm.key), shown(servo, alarm, alarm.value),
                   shown(servo, alarm, alarm.min), shown(servo, alarm, alarm.max)});
    }
    return (plan.alarms.empty() ? QString() : table.text()) +
           text::releaseText(jobs::clearMethodName(plan.next)) + QLatin1Char('\n');
}

bool writes(const jobs::AlarmPlan& plan)
{
    return !plan.refused &&
           (plan.next == jobs::ClearMethod::BackOff || plan.next == jobs::ClearMethod::NewGoal ||
            plan.next == jobs::ClearMethod::FaultReset);
}

base::Result<Exit> runClearAlarm(Run& run, const Values& values)
{
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    const auto plan = jobs::planClearAlarm(*context, *servo);
    if (!plan)
        return tl::unexpected(plan.error());
    if (plan->needsConsent() && !values.has("--move")) {
        run.finish(Json::object()
                       .add("id", servo->id)
                       .add("alarms", jsonAlarmPlan(*plan))
                       .add("next", jobs::clearMethodName(plan->next))
                       .add("acted", false)
                       .add("cleared", false),
                   alarmText(*servo, *plan) +
                       translate("cli", "Nothing was written. Keep clear of the mechanism and "
                                        "run the command again with --move.") +
                       QLatin1Char('\n'));
        return Exit::Failed;
    }
    if (writes(*plan)) {
        if (const auto saved = run.backupTable(*servo); !saved)
            return tl::unexpected(saved.error());
    }
    const auto report = jobs::clearAlarm(*context, *servo, *plan);
    if (!report)
        return tl::unexpected(report.error());
    run.finish(Json::object()
                   .add("id", servo->id)
                   .add("alarms", jsonAlarmPlan(report->after))
                   .add("next", jobs::clearMethodName(report->after.next))
                   .add("acted", report->isExecuted)
                   .add("cleared", report->isCleared()),
               report->isExecuted && report->isCleared()
                   ? translate("cli", "The alarm has cleared.") + QLatin1Char('\n')
                   : alarmText(*servo, report->after));
    return report->isCleared() ? Exit::Success : Exit::Failed;
}
} // namespace

Command clearAlarmCommand()
{
    return {"clear-alarm",
            QT_TRANSLATE_NOOP("cli", "show the cause of an alarm and clear it"),
            {servoIdArgument},
            {{"--move", QT_TRANSLATE_NOOP(
                            "cli", "allow torque to be turned on and the servo to move slightly")}},
            runClearAlarm};
}
} // namespace cli
