// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/register_input.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/write_access.h"

namespace cli {
namespace {
base::Result<Exit> run(Run& run, const Values& values)
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
    options.dangerous = values.has("--dangerous");
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = device::write(*context, *servo, *items, options);
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
        {{"ID", QT_TRANSLATE_NOOP("cli", "the servo")},
         {"KEY=VALUE",
          QT_TRANSLATE_NOOP("cli", "value raw (85), physical with its unit (8.5V, 90deg) or by "
                                   "name (position)"),
          1, many}},
        {{"--temporary", QT_TRANSLATE_NOOP("cli", "keep the lock closed: lost at power-off")},
         {"--dangerous", QT_TRANSLATE_NOOP("cli", "yes, also registers that can make the servo "
                                                  "unreachable or turn the other way")}},
        run};
}
} // namespace cli
