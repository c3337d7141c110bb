// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/change/change.h"
#include "text/language.h"
#include "text/notice_text.h"

namespace cli {
namespace {
base::Result<Exit> runSetId(Run& run, const Values& values)
{
    const auto oldId = parseId(values.argument("OLD"));
    const auto newId = parseId(values.argument("NEW"));
    if (!oldId || !newId)
        return tl::unexpected(oldId ? newId.error() : oldId.error());
    auto servo = run.servoWithSettings(*oldId);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = jobs::changeId(*context, *servo, *newId);
    if (!report)
        return tl::unexpected(report.error());
    run.finish(jsonWrites(*report), writeText(*servo, *report));
    return exitCode(*report);
}

base::Result<Exit> runSetBaud(Run& run, const Values& values)
{
    const auto rates = parseBauds(values.argument("RATE"));
    if (!rates)
        return tl::unexpected(rates.error());
    if (rates->size() != 1)
        return badArgument(translate("cli", "specify exactly one baud rate"));
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = jobs::changeBaud(*context, *servo, rates->front());
    if (!report)
        return tl::unexpected(report.error());
    run.finish(jsonWrites(*report).add("baud", servo->baud), writeText(*servo, *report));
    return exitCode(*report);
}

base::Result<Exit> runCenter(Run& run, const Values& values)
{
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = jobs::center(*context, *servo);
    if (!report)
        return tl::unexpected(report.error());
    Table table({translate("cli", "Servo %1").arg(servo->id), translate("cli", "Before"),
                 translate("cli", "After")});
    table.alignRight({1, 2});
    const auto row = [&](const QString& name, catalog::Role role, auto before, auto after) {
        const catalog::Register* reg = servo->profile->byRole(role);
        const auto shown = [&](const std::optional<std::int64_t>& raw) {
            return raw && reg != nullptr
                       ? catalog::formatValue(*raw, *reg, servo->meaning(*reg), text::isUiChinese())
                       : noValue();
        };
        table.add({name, shown(before), shown(after)});
    };
    row(translate("cli", "Position"), catalog::Role::PresentPosition, report->positionBefore,
        report->positionAfter);
    row(translate("cli", "Position correction"), catalog::Role::PositionOffset,
        report->offsetBefore, report->offsetAfter);
    run.finish(Json::object()
                   .add("id", servo->id)
                   .add("position_before", report->positionBefore)
                   .add("position_after", report->positionAfter)
                   .add("offset_before", report->offsetBefore)
                   .add("offset_after", report->offsetAfter)
                   .add("lock", device::lockName(report->lock)),
               table.text() +
                   translate("cli", "EPROM lock: %1")
                       .arg(text::lockLabel(device::lockName(report->lock))) +
                   QLatin1Char('\n'));
    return exitCode(report->lock);
}

base::Result<Exit> runReboot(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    const auto elapsed = jobs::reboot(*context, *servo);
    if (!elapsed)
        return tl::unexpected(elapsed.error());
    run.finish(Json::object().add("id", servo->id).add("elapsed_ms", *elapsed),
               translate("cli", "Servo %1 has rebooted.").arg(servo->id) + QLatin1Char('\n'));
    return Exit::Success;
}
} // namespace

Command setIdCommand()
{
    return {
        "set-id",
        QT_TRANSLATE_NOOP("cli", "change the ID of a servo after checking that the new ID is free"),
        {{"OLD", QT_TRANSLATE_NOOP("cli", "current ID")},
         {"NEW", QT_TRANSLATE_NOOP("cli", "new ID, 0 to 253 (Modbus: 1 to 247)")}},
        {},
        runSetId};
}

Command setBaudCommand()
{
    return {"set-baud",
            QT_TRANSLATE_NOOP("cli", "change the baud rate of a servo"),
            {servoIdArgument, {"RATE", QT_TRANSLATE_NOOP("cli", "new baud rate")}},
            {},
            runSetBaud};
}

Command centerCommand()
{
    return {"center",
            QT_TRANSLATE_NOOP("cli", "set the present position as the midpoint"),
            {servoIdArgument},
            {},
            runCenter};
}

Command rebootCommand()
{
    return {"reboot",
            QT_TRANSLATE_NOOP("cli", "reboot a servo and wait for its reply"),
            {servoIdArgument},
            {},
            runReboot};
}
} // namespace cli
