// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/change/blink.h"

#include <utility>

namespace cli {
namespace {
base::Result<Exit> runIdentify(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    bool reported = false;
    const auto report = jobs::blink(*context, *servo, jobs::blinkTime, [&](const jobs::Progress&) {
        if (!std::exchange(reported, true))
            run.console().printNote(
                translate("cli", "The LED of servo %1 is blinking. Press Ctrl-C to stop.")
                    .arg(servo->id));
    });
    if (!report)
        return tl::unexpected(report.error());
    run.finish(
        Json::object()
            .add("id", servo->id)
            .add("register", report->key)
            .add("blinks", report->blinks)
            .add("stopped", report->stopped),
        translate("cli", "The LED of servo %1 is back in its previous state.").arg(servo->id) +
            QLatin1Char('\n'));
    return Exit::Success;
}
} // namespace

Command identifyCommand()
{
    return {"identify",
            QT_TRANSLATE_NOOP("cli", "blink the LED of a servo for a few seconds"),
            {servoIdArgument},
            {},
            runIdentify};
}
} // namespace cli
