// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/tour/tour.h"
#include "cli/translate.h"

namespace cli {
namespace {
base::Result<Exit> runTour(Run& run, const Values&)
{
    run.setDefaultPort(QStringLiteral("sim:demo"));
    if (!run.globals().port.startsWith(QLatin1String("sim:"))) {
        return badArgument(translate("cli", "the tour writes to servos and moves them, so it "
                                            "only runs on a simulated bus: --port sim:demo"));
    }
    return Tour(run).run();
}
} // namespace

Command tourCommand()
{
    return {"tour",
            QT_TRANSLATE_NOOP("cli", "run a guided tour on a simulated bus; no servo is needed"),
            {},
            {},
            runTour};
}
} // namespace cli
