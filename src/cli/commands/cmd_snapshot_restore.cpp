// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/reader.h"
#include "session/snapshot/safety_snapshot.h"

namespace cli {
namespace {
Json head(const device::Servo& servo, const QString& file, bool dryRun)
{
    return Json::object()
        .add("id", servo.id)
        .add("model", servo.profile->modelName)
        .add("file", file)
        .add("dry_run", dryRun);
}

base::Result<Exit> carryOut(Run& run, const Values& values, device::Servo& servo,
                            const jobs::RestorePlan& plan, Json document)
{
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    jobs::RestoreOptions options = restoreOptionsOf(values);
    options.beforeWrite = [&run](const device::Context& with, device::Servo& which) {
        return run.backupTable(with, which);
    };
    std::optional<ProgressLine> line;
    line.emplace(run.console(), translate("cli", "Restoring"));
    const auto outcome =
        jobs::restore(*context, servo, plan, options,
                      [&line](const jobs::Progress& progress) { line->update(progress); });
    line.reset();
    if (!outcome)
        return tl::unexpected(outcome.error());
    addOutcome(document, *outcome);
    QString text = outcomeText(*outcome, servo) + leftOutText(plan);
    if (const auto file = values.option("--result")) {
        const auto result =
            jobs::toRestoreResult(*outcome, servo, values.argument("FILE"), session::programName());
        if (const auto saved = snapshot::saveRestoreResults({result}, *file); !saved)
            return tl::unexpected(saved.error());
        document.add("result", *file);
        text += translate("cli", "Result saved to %1").arg(*file) + QLatin1Char('\n');
    }
    run.finish(std::move(document), text);
    return exitCode(*outcome, plan);
}

base::Result<Exit> runRestore(Run& run, const Values& values)
{
    const QString file = values.argument("FILE");
    const auto snapshot = loadToRestore(values, file);
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto read = device::readAll(*context, *servo); !read)
        return tl::unexpected(read.error());
    const jobs::RestorePlan plan = jobs::planRestore(*context, *servo, *snapshot, choiceOf(values));
    const bool dryRun = values.has("--dry-run");
    Json document = head(*servo, file, dryRun);
    addPlan(document, plan);
    if (dryRun) {
        run.finish(std::move(document), planText(plan) + stepsText(plan));
        return Exit::Success;
    }
    if (!run.console().isJson())
        run.console().print(planText(plan));
    return carryOut(run, values, *servo, plan, std::move(document));
}
} // namespace

Command snapshotRestoreCommand()
{
    return {"snapshot restore",
            QT_TRANSLATE_NOOP("cli", "write a saved file back to a servo: turn torque off, write "
                                     "only the differences, read each row back"),
            {servoIdArgument,
             {"FILE", QT_TRANSLATE_NOOP("cli", "snapshot or template; may be from another servo")}},
            restoreOptions(
                {{"--identity",
                  QT_TRANSLATE_NOOP("cli", "also write the ID and baud rate, as the last step")}}),
            runRestore};
}
} // namespace cli
