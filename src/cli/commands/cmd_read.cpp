// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/reader.h"

namespace cli {
namespace {
using Registers = std::vector<const catalog::Register*>;

void show(Run& run, const device::Servo& servo, const Registers& registers, const QString& title)
{
    Json::Array rows;
    for (const catalog::Register* reg : registers)
        rows.push_back(jsonRegister(servo, *reg));
    run.finish(Json::object().add("id", servo.id).add("registers", std::move(rows)),
               title + registerTable(servo, registers).text());
}

base::Result<Exit> runDump(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto read = device::readAll(*context, *servo); !read)
        return tl::unexpected(read.error());
    run.reportDuplicates(*servo);
    Registers all;
    for (const catalog::Register& reg : servo->profile->registers)
        all.push_back(&reg);
    const QString title =
        translate("cli", "Servo %1: %2").arg(servo->id).arg(servoTitle(*servo)) + QLatin1Char('\n');
    show(run, *servo, all, title);
    return Exit::Success;
}

base::Result<Exit> runRead(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    Registers requested;
    for (const QString& key : values.arguments("KEY")) {
        const auto reg = findRegister(*servo->profile, key, servo->id);
        if (!reg)
            return tl::unexpected(reg.error());
        requested.push_back(*reg);
    }
    const auto context = run.context();
    // The settings determine the units of values; the requested registers are read last.
    if (const auto read = device::readSettings(*context, *servo); !read)
        return tl::unexpected(read.error());
    if (const auto read = device::read(*context, *servo, requested); !read)
        return tl::unexpected(read.error());
    run.reportDuplicates(*servo);
    show(run, *servo, requested, {});
    return Exit::Success;
}
} // namespace

Command dumpCommand()
{
    return {"dump",
            QT_TRANSLATE_NOOP("cli", "read the whole memory table"),
            {servoIdArgument},
            {},
            runDump};
}

Command readCommand()
{
    return {"read",
            QT_TRANSLATE_NOOP("cli", "read individual registers"),
            {servoIdArgument,
             {"KEY", QT_TRANSLATE_NOOP("cli", "register names, as shown by dump"), 1, many}},
            {},
            runRead};
}
} // namespace cli
