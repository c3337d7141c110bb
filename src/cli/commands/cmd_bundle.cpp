// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/multi_servo_restore.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/write_access.h"
#include "jobs/scan/scan_all.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"

#include <QFileInfo>

namespace cli {
namespace {
/// All servos on the bus, at the baud rate of the port.
base::Result<std::vector<device::Servo>> allServos(Run& run, const device::Context& context)
{
    std::vector<base::Protocol> protocols;
    if (run.globals().protocol)
        protocols = {*run.globals().protocol};
    ProgressLine line(run.console(), translate("cli", "Searching"));
    return jobs::scanAll(context, protocols,
                         [&line](const jobs::Progress& progress) { line.update(progress); });
}

base::Result<std::vector<device::Servo>> namedServos(Run& run, const QStringList& words)
{
    const auto ids = parseIds(words);
    if (!ids)
        return tl::unexpected(ids.error());
    std::vector<device::Servo> servos;
    for (const int id : *ids) {
        auto servo = run.servo(id);
        if (!servo)
            return tl::unexpected(servo.error());
        servos.push_back(std::move(*servo));
    }
    return servos;
}

base::Result<Exit> runSave(Run& run, const Values& values)
{
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    const QStringList words = values.arguments("ID");
    auto servos = words.isEmpty() ? allServos(run, *context) : namedServos(run, words);
    if (!servos)
        return tl::unexpected(servos.error());
    if (servos->empty())
        return base::fail(base::ErrorCode::NoReply, QStringLiteral("bundle"));
    for (const device::Servo& servo : *servos) {
        const auto alone = device::requireUniqueId(*context, servo, QStringLiteral("bundle"));
        if (!alone)
            return tl::unexpected(alone.error());
    }
    auto bundle = jobs::takeBundle(*context, *servos, session::programName());
    if (!bundle)
        return tl::unexpected(bundle.error());
    bundle->label = values.option("--label").value_or(QString());
    bundle->note = values.option("--note").value_or(QString());
    const QString file = values.argument("FILE");
    if (const auto saved = snapshot::saveBundle(*bundle, file); !saved)
        return tl::unexpected(saved.error());
    Json::Array ids;
    QStringList names;
    for (const snapshot::Snapshot& snapshot : bundle->servos) {
        session::addToHistory(snapshot, history::SnapshotReason::Bundle,
                              QFileInfo(file).absoluteFilePath());
        names.push_back(QString::number(snapshot.servo.id));
        ids.push_back(Json::object()
                          .add("id", snapshot.servo.id)
                          .add("model", snapshot.servo.model)
                          .add("registers", static_cast<int>(snapshot.registers.size())));
    }
    run.finish(Json::object().add("file", file).add("servos", std::move(ids)),
               translate("cli", "Settings of %n servo(s) saved to %1 (ID %2)", nullptr,
                         int(bundle->servos.size()))
                       .arg(file, text::joinItems(names)) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> runRestore(Run& run, const Values& values)
{
    const QString file = values.argument("FILE");
    const auto bundle = snapshot::loadBundle(file);
    if (!bundle)
        return tl::unexpected(bundle.error());
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    MultiServoRestore several(run, values);
    jobs::ApplyOptions options = several.options();
    options.otherModel = values.has("--other-model");
    const auto all = jobs::restoreBundle(*context, *bundle, options, several.progress());
    return several.finish(all, file);
}
} // namespace

Command bundleSaveCommand()
{
    return {"bundle save",
            QT_TRANSLATE_NOOP("cli", "save the settings of all servos on the bus to one file"),
            {{"FILE", QT_TRANSLATE_NOOP("cli", "output file, for example NAME.bundle.json; an "
                                               "existing file is replaced")},
             {"ID", QT_TRANSLATE_NOOP("cli", "only these servos: 1, 1-6 or 1,3,5"), 0, many}},
            {{"--label", QT_TRANSLATE_NOOP("cli", "label saved in the file"), "TEXT"},
             {"--note", QT_TRANSLATE_NOOP("cli", "note saved in the file"), "TEXT"}},
            runSave};
}

Command bundleRestoreCommand()
{
    return {
        "bundle restore",
        QT_TRANSLATE_NOOP("cli", "restore the servos saved in a bundle, matching them by ID"),
        {{"FILE", QT_TRANSLATE_NOOP("cli", "file created by \"bundle save\"")}},
        restoreOptions(
            {{"--other-model",
              QT_TRANSLATE_NOOP(
                  "cli", "also write to IDs that now belong to a servo of a different model")}}),
        runRestore};
}
} // namespace cli
