// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/multi_servo_restore.h"
#include "cli/output/restore_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/restore/take_snapshot.h"
#include "session/snapshot/safety_snapshot.h"
#include "snapshot/snapshot_template.h"
#include "text/language.h"

namespace cli {
namespace {
/// Loads a file or reads a servo.
base::Result<snapshot::Snapshot> sourceOf(Run& run, const QString& word)
{
    bool number = false;
    word.toInt(&number);
    if (!number)
        return snapshot::loadSnapshot(word);
    const auto id = parseId(word);
    if (!id)
        return tl::unexpected(id.error());
    auto servo = run.servo(*id);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    return jobs::takeSnapshot(*context, *servo, session::programName());
}

tl::unexpected<base::Error> whyNot(const base::Error& error, const snapshot::Snapshot& from)
{
    const QString& key = error.registerKey;
    if (error.code == base::ErrorCode::UnknownRegister) {
        QStringList known;
        for (const snapshot::SnapshotRegister& reg : from.registers)
            known << reg.key;
        base::Error named = error;
        named.detail = text::joinItems(nearest(key, known));
        return tl::unexpected(named);
    }
    switch (error.reason) {
    case base::Reason::IdentityRegister:
        return badArgument(
            translate("cli",
                      "%1 identifies the servo and is included in a template only with --identity")
                .arg(key));
    case base::Reason::ReadOnlyRegister:
        return badArgument(translate("cli", "%1 is read-only").arg(key));
    case base::Reason::NoValue:
        return badArgument(translate("cli", "the snapshot or servo has no value for %1").arg(key));
    default:
        return tl::unexpected(error);
    }
}

base::Result<Exit> runMake(Run& run, const Values& values)
{
    const auto from = sourceOf(run, values.argument("FROM"));
    if (!from)
        return tl::unexpected(from.error());
    auto chosen = snapshot::makeTemplate(*from, values.arguments("KEY"), values.has("--identity"));
    if (!chosen)
        return whyNot(chosen.error(), *from);
    chosen->program = session::programName();
    if (const auto label = values.option("--label"))
        chosen->label = *label;
    if (const auto note = values.option("--note"))
        chosen->note = *note;
    const QString file = values.argument("FILE");
    if (const auto saved = snapshot::saveSnapshot(*chosen, file); !saved)
        return tl::unexpected(saved.error());
    const auto count = static_cast<int>(chosen->registers.size());
    run.finish(Json::object().add("file", file).add("registers", count),
               translate("cli", "%n register(s) saved to %1", nullptr, count).arg(file) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> runApply(Run& run, const Values& values)
{
    const QString file = values.argument("FILE");
    const auto snapshot = loadToRestore(values, file);
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    const auto ids = parseIds(values.arguments("ID"));
    if (!ids)
        return tl::unexpected(ids.error());
    const auto connection = run.connect();
    if (!connection)
        return tl::unexpected(connection.error());
    const auto context = run.context();
    MultiServoRestore several(run, values);
    jobs::ApplyOptions options = several.options();
    if (options.protocols.empty())
        options.protocols = (*connection)->protocols();
    const auto all = jobs::applyToServos(*context, *ids, *snapshot, options, several.progress());
    return several.finish(all, file);
}
} // namespace

Command templateMakeCommand()
{
    return {
        "template make",
        QT_TRANSLATE_NOOP("cli", "save selected registers as a template to write to other servos"),
        {{"FROM", QT_TRANSLATE_NOOP("cli", "snapshot file, or ID (reads the servo)")},
         outputFileArgument,
         {"KEY", QT_TRANSLATE_NOOP("cli", "register names"), 1, many}},
        {{"--identity", QT_TRANSLATE_NOOP("cli", "allow ID and baud rate in the template")},
         {"--label", QT_TRANSLATE_NOOP("cli", "label saved in the file"), "TEXT"},
         {"--note", QT_TRANSLATE_NOOP("cli", "note saved in the file"), "TEXT"}},
        runMake};
}

Command templateApplyCommand()
{
    return {"template apply",
            QT_TRANSLATE_NOOP("cli", "write a template or snapshot to several servos and report "
                                     "the result for each; never writes the ID or baud rate"),
            {{"FILE", QT_TRANSLATE_NOOP("cli", "template or snapshot")},
             {"ID", QT_TRANSLATE_NOOP("cli", "servo IDs: 1, 1-6 or 1,3,5"), 1, many}},
            restoreOptions(),
            runApply};
}
} // namespace cli
