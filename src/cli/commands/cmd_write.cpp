// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/register_input.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/write_access.h"
#include "jobs/change/ordered_write.h"

#include <algorithm>

namespace cli {
namespace {
/// Without --dangerous, ID, baud rate, torque and midpoint are refused, with the command to use. If
/// the job ends early, the report also has the registers that were not written.
base::Result<device::WriteReport> writeItems(const device::Context& context, device::Servo& servo,
                                             const std::vector<device::WriteItem>& items,
                                             const device::WriteOptions& options)
{
    const auto special =
        options.consent ? jobs::SpecialRegisters::Write : jobs::SpecialRegisters::Refuse;
    std::optional<device::WriteReport> report;
    const auto written = jobs::writeInOrder(context, servo, items, options, special, report);
    if (!report)
        return written ? base::Result<device::WriteReport>{} : tl::unexpected(written.error());
    const auto isReported = [&](const device::WriteItem& item) {
        return std::any_of(report->writes.begin(), report->writes.end(),
                           [&](const device::WriteResult& one) { return one.key == item.key; });
    };
    for (const device::WriteItem& item : items) {
        if (written || isReported(item))
            continue;
        const catalog::Register* reg = servo.profile->find(item.key);
        report->writes.push_back({item.key, reg != nullptr ? reg->address : 0, servo.raw(item.key),
                                  item.raw, std::nullopt,
                                  device::outcomeBeforeSending(written.error()), written.error()});
    }
    return *report;
}

base::Result<Exit> runWrite(Run& run, const Values& values)
{
    for (const QString& word : values.arguments("KEY=VALUE")) {
        if (const auto assignment = parseAssignment(word); !assignment)
            return tl::unexpected(assignment.error());
    }
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    if (const auto writable = device::requireWritable(*servo, QStringLiteral("write")); !writable)
        return tl::unexpected(writable.error());
    const auto items = parseWriteItems(*servo, values.arguments("KEY=VALUE"));
    if (!items)
        return tl::unexpected(items.error());
    device::WriteOptions options;
    options.temporary = values.has("--temporary");
    options.consent = device::Consent::byOption(values.has("--dangerous"));
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = writeItems(*context, *servo, *items, options);
    if (!report)
        return tl::unexpected(report.error());
    run.finish(jsonWrites(*report), writeText(*servo, *report));
    return exitCode(*report);
}
} // namespace

Command writeCommand()
{
    return {
        "write",
        QT_TRANSLATE_NOOP("cli", "change registers safely: record, unlock, write, read back, lock"),
        {servoIdArgument,
         {"KEY=VALUE",
          QT_TRANSLATE_NOOP("cli", "raw value (85), physical value with unit (8.5V, 90deg) or "
                                   "name (position)"),
          1, many}},
        {{"--temporary", QT_TRANSLATE_NOOP("cli", "leave the EPROM locked: changes are lost at "
                                                  "power-off")},
         {"--dangerous", QT_TRANSLATE_NOOP("cli", "allow writing dangerous registers: ID, baud "
                                                  "rate, torque, midpoint, mode, and what can "
                                                  "make the servo unreachable, shift its "
                                                  "positions or take its limits away")}},
        runWrite};
}
} // namespace cli
