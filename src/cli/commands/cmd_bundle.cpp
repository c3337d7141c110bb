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

#include <QFileInfo>

namespace cli {
namespace {
/// Everybody on the line, at the rate the port has.
base::Result<std::vector<device::Servo>> everybody(Run& run, const device::Context& context)
{
    std::vector<base::Protocol> protocols;
    if (run.globals().protocol)
        protocols = {*run.globals().protocol};
    ProgressLine line(run.console(), translate("cli", "Searching"));
    return jobs::scanAll(context, protocols,
                         [&line](const jobs::Progress& progress) { line.update(progress); });
}

base::Result<std::vector<device::Servo>> named(Run& run, const QStringList& words)
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
    auto servos = words.isEmpty() ? everybody(run, *context) : named(run, words);
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
    if (const auto saved = record::saveBundle(*bundle, file); !saved)
        return tl::unexpected(saved.error());
    Json::Array ids;
    QStringList names;
    for (const record::Snapshot& snapshot : bundle->servos) {
        session::addToHistory(snapshot, record::SnapshotReason::Bundle,
                              QFileInfo(file).absoluteFilePath());
        names.push_back(QString::number(snapshot.servo.id));
        ids.push_back(Json::object()
                          .add("id", snapshot.servo.id)
                          .add("model", snapshot.servo.model)
                          .add("registers", static_cast<int>(snapshot.registers.size())));
    }
    run.finish(Json::object().add("file", file).add("servos", std::move(ids)),
               translate("cli", "Servos saved to %1: %2 (ID %3)")
                       .arg(file)
                       .arg(bundle->servos.size())
                       .arg(names.join(QStringLiteral(", "))) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> runRestore(Run& run, const Values& values)
{
    const QString file = values.argument("FILE");
    const auto bundle = record::loadBundle(file);
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
            QT_TRANSLATE_NOOP("cli", "save all servos of the bus to one file"),
            {{"FILE", QT_TRANSLATE_NOOP("cli", "usually NAME.bundle.json; replaced if it exists")},
             {"ID", QT_TRANSLATE_NOOP("cli", "only these: 1, 1-6 or 1,3,5"), 0, many}},
            {{"--label", QT_TRANSLATE_NOOP("cli", "a name for it"), "TEXT"},
             {"--note", QT_TRANSLATE_NOOP("cli", "a remark"), "TEXT"}},
            runSave};
}

Command bundleRestoreCommand()
{
    return {"bundle restore",
            QT_TRANSLATE_NOOP("cli", "write a saved bus back, each servo by its ID"),
            {{"FILE", QT_TRANSLATE_NOOP("cli", "a file made by bundle save")}},
            restoreOptions({{"--other-model", QT_TRANSLATE_NOOP("cli", "also where another model "
                                                                       "has the ID now")}}),
            runRestore};
}
} // namespace cli
