// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/report_words.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/recover.h"
#include "jobs/restore.h"
#include "text/error_words.h"
#include "text/notice_words.h"

namespace cli {
namespace {
constexpr int shownUuid = 8; ///< enough to tell a handful of changes apart

QString kindName(const base::Intent& intent)
{
    switch (intent.kind) {
    case base::IntentKind::Write:
        return QStringLiteral("write");
    case base::IntentKind::SetId:
        return QStringLiteral("set-id");
    case base::IntentKind::SetBaud:
        return QStringLiteral("set-baud");
    case base::IntentKind::Mode:
        return QStringLiteral("mode");
    case base::IntentKind::Calibrate:
        return QStringLiteral("center");
    case base::IntentKind::Restore:
        return jobs::restoresSnapshot(intent) ? QStringLiteral("snapshot-restore")
                                              : QStringLiteral("restore-defaults");
    case base::IntentKind::Identify:
        return QStringLiteral("identify");
    case base::IntentKind::Trial:
        return QStringLiteral("trial");
    case base::IntentKind::Undo:
        return QStringLiteral("undo");
    }
    return {};
}

struct FindingWord {
    const char* name;
    const char* shown;
};

FindingWord findingWord(jobs::Finding finding)
{
    switch (finding) {
    case jobs::Finding::AllOld:
        return {"all-old", QT_TRANSLATE_NOOP("cli", "the old values")};
    case jobs::Finding::AllNew:
        return {"all-new", QT_TRANSLATE_NOOP("cli", "the new values")};
    case jobs::Finding::Mixed:
        return {"mixed", QT_TRANSLATE_NOOP("cli", "some new, some old values")};
    case jobs::Finding::OtherServo:
        return {"other-servo", QT_TRANSLATE_NOOP("cli", "another servo answers: left alone")};
    case jobs::Finding::NoAnswer:
        return {"no-answer", QT_TRANSLATE_NOOP("cli", "it does not answer")};
    case jobs::Finding::Unreadable:
        return {"unreadable", QT_TRANSLATE_NOOP("cli", "something answers, but nothing readable")};
    case jobs::Finding::Replaced:
        return {"replaced", QT_TRANSLATE_NOOP("cli", "other values since, which stay")};
    }
    return {"", ""};
}

Json jsonIntent(const base::Intent& intent)
{
    Json::Array items;
    for (const base::JournalItem& item : intent.items) {
        items.push_back(Json::object()
                            .add("key", item.key)
                            .add("address", item.address)
                            .add("old", item.oldRaw)
                            .add("new", item.newRaw));
    }
    Json json = Json::object();
    json.add("uuid", intent.uuid)
        .add("at", intent.at.toString(Qt::ISODateWithMs))
        .add("kind", kindName(intent))
        .add("id", intent.servo.id)
        .add("port", intent.servo.port)
        .add("baud", intent.servo.baud)
        .add("items", std::move(items));
    return json;
}

Json jsonRecovered(const jobs::Recovered& one)
{
    Json json = jsonIntent(one.before.intent);
    json.add("finding", QString::fromLatin1(findingWord(one.before.finding).name))
        .add("found_id", one.before.foundId >= 0 ? Json(one.before.foundId) : Json())
        .add("found_baud", one.before.foundBaud > 0 ? Json(one.before.foundBaud) : Json())
        .add("lock_open", one.before.lockOpen)
        .add("done", one.done);
    if (!one.left.isEmpty())
        json.add("left", one.left);
    if (one.action != jobs::RecoverAction::Look)
        json.add("action", one.action == jobs::RecoverAction::Undo ? QStringLiteral("undo")
                                                                   : QStringLiteral("finish"));
    if (one.report)
        json.add("result", jsonWrites(*one.report));
    if (one.error)
        json.add("error", jsonError(*one.error));
    return json;
}

QStringList changesOf(const base::Intent& intent)
{
    QStringList changes;
    for (const base::JournalItem& item : intent.items) {
        if (item.oldRaw != item.newRaw)
            changes << QStringLiteral("%1 %2 → %3").arg(item.key).arg(item.oldRaw).arg(item.newRaw);
    }
    return changes;
}

/// In one cell of a table: many rows as their number, those whose new value is not known
/// beforehand (calibration, restored defaults) by their names.
QString changesCell(const base::Intent& intent)
{
    constexpr int shownInOneLine = 3;
    const QStringList changes = changesOf(intent);
    const int count = static_cast<int>(intent.items.size());
    if (count > shownInOneLine)
        return translate("cli", "%1 registers").arg(count);
    if (!changes.isEmpty())
        return changes.join(QStringLiteral(", "));
    QStringList keys;
    for (const base::JournalItem& item : intent.items)
        keys << item.key;
    return keys.join(QStringLiteral(", "));
}

/// What the cell only counts, one a line.
QString changesBelow(const base::Intent& intent)
{
    const QStringList changes = changesOf(intent);
    if (changesCell(intent) == changes.join(QStringLiteral(", ")) || changes.isEmpty())
        return {};
    QString lines =
        translate("cli", "Change %1:").arg(intent.uuid.left(shownUuid)) + QLatin1Char('\n');
    for (const QString& change : changes)
        lines += QStringLiteral("  %1\n").arg(change);
    return lines;
}

QString lockShown(const std::optional<bool>& open)
{
    return text::lockWord(!open   ? QStringLiteral("unknown")
                          : *open ? QStringLiteral("open")
                                  : QStringLiteral("closed"));
}

/// A restore whose way back had begun is undone even if finishing was asked for.
QString settledWord(const jobs::Recovered& one, jobs::RecoverAction asked)
{
    if (!one.done)
        return translate("cli", "no");
    if (one.allLeft)
        return translate("cli", "left as it is");
    const bool undone = asked == jobs::RecoverAction::Finish && one.action != asked;
    return undone ? translate("cli", "undone") : translate("cli", "yes");
}

/// What was not written although it reads another value than was asked for.
QString leftLine(const jobs::Recovered& one)
{
    if (one.left.isEmpty())
        return {};
    return translate("cli", "Change %1, left as they are, because they have another value since or "
                            "would move the servo: %2")
               .arg(one.before.intent.uuid.left(shownUuid), one.left.join(QStringLiteral(", "))) +
           QLatin1Char('\n');
}

Table recoveredTable(const std::vector<jobs::Recovered>& all, jobs::RecoverAction action)
{
    Table table({translate("cli", "Change"), translate("cli", "When"), translate("cli", "ID"),
                 translate("cli", "What"), translate("cli", "Changes"), translate("cli", "Found"),
                 translate("cli", "Lock"), translate("cli", "Settled")});
    table.right({2});
    for (const jobs::Recovered& one : all) {
        const base::Intent& intent = one.before.intent;
        table.add({intent.uuid.left(shownUuid),
                   intent.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
                   QString::number(intent.servo.id), kindName(intent), changesCell(intent),
                   translate("cli", findingWord(one.before.finding).shown),
                   lockShown(one.before.lockOpen), settledWord(one, action)});
    }
    return table;
}

/// Where changes are open that were begun on other ports, and how to look at them.
struct Elsewhere {
    std::vector<base::Intent> intents{};
    QString port{}; ///< of this run; empty where none was opened

    /// On this port: the adapter may only have another name now.
    QString command() const
    {
        const bool here = !port.isEmpty() && !port.startsWith(QLatin1String("sim:"));
        const QString on = here ? port : QStringLiteral("PORT");
        return QStringLiteral("servodesk-cli recover --any-port --port %1").arg(on);
    }
    Json json() const
    {
        Json::Array all;
        for (const base::Intent& intent : intents)
            all.push_back(jsonIntent(intent));
        return all;
    }
    QString text() const;
};

QString Elsewhere::text() const
{
    if (intents.empty())
        return {};
    Table table({translate("cli", "Change"), translate("cli", "When"), translate("cli", "ID"),
                 translate("cli", "What"), translate("cli", "Changes"), translate("cli", "Port")});
    table.right({2});
    for (const base::Intent& intent : intents) {
        table.add({intent.uuid.left(shownUuid),
                   intent.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
                   QString::number(intent.servo.id), kindName(intent), changesCell(intent),
                   intent.servo.port});
    }
    QString lines = translate("cli", "Changes that were begun on other ports are open:") +
                    QLatin1Char('\n') + table.text() +
                    translate("cli", "An adapter that is plugged in again may have another name. "
                                     "Where the servo is connected now, look at them with: %1")
                        .arg(command()) +
                    QLatin1Char('\n');
    return lines;
}

QString nothingOpen(const Elsewhere& elsewhere)
{
    return elsewhere.intents.empty()
               ? translate("cli", "No change was left open.") + QLatin1Char('\n')
               : translate("cli", "No change was left open on %1.").arg(elsewhere.port) +
                     QLatin1Char('\n');
}

void show(Run& run, const std::vector<jobs::Recovered>& all, jobs::RecoverAction action,
          const Elsewhere& elsewhere)
{
    Json::Array intents;
    for (const jobs::Recovered& one : all)
        intents.push_back(jsonRecovered(one));
    QString text = all.empty() ? nothingOpen(elsewhere) : recoveredTable(all, action).text();
    for (const jobs::Recovered& one : all)
        text += changesBelow(one.before.intent) + leftLine(one);
    for (const jobs::Recovered& one : all) {
        if (one.error)
            text += text::describe(*one.error).what + QLatin1Char('\n');
    }
    if (!all.empty() && action == jobs::RecoverAction::Look)
        text += translate("cli", "Nothing was written. --finish completes what was begun, --undo "
                                 "puts the old values back, --forget gives up a change whose servo "
                                 "will not come back.") +
                QLatin1Char('\n');
    Json document = Json::object().add("intents", std::move(intents));
    if (!elsewhere.intents.empty())
        document.add("elsewhere", elsewhere.json()).add("try", elsewhere.command());
    run.finish(std::move(document), text + elsewhere.text());
}

/// The port cannot be opened: what is open is named all the same.
base::Result<Exit> showWithoutPort(Run& run, const std::vector<base::Intent>& open,
                                   const base::Error& why)
{
    const Elsewhere elsewhere{jobs::begunElsewhere(open, {}), {}};
    if (elsewhere.intents.empty())
        return tl::unexpected(why);
    if (!run.console().json()) {
        run.console().print(elsewhere.text());
        return tl::unexpected(why);
    }
    run.finish(Json::object()
                   .add("elsewhere", elsewhere.json())
                   .add("try", elsewhere.command())
                   .add("error", jsonError(why)),
               {});
    return exitCode(why.code);
}

Exit exitOf(const std::vector<jobs::Recovered>& all, jobs::RecoverAction action)
{
    Exit exit = Exit::Done;
    for (const jobs::Recovered& one : all) {
        if (one.done || action == jobs::RecoverAction::Look || exit != Exit::Done)
            continue;
        exit = one.error                                       ? exitCode(one.error->code)
               : one.before.finding == jobs::Finding::NoAnswer ? Exit::NoAnswer
                                                               : Exit::NotDone;
    }
    return exit;
}

/// Ends intents as abandoned; for servos that are gone for good. Needs no port.
base::Result<Exit> forget(Run& run, const std::vector<base::Intent>& open, const QString& which)
{
    QStringList forgotten;
    for (const base::Intent& intent : open) {
        if (which != QLatin1String("all") && !intent.uuid.startsWith(which))
            continue;
        const auto ended =
            run.session().journal().end(intent.uuid, {QStringLiteral("abandoned"), {}});
        if (!ended)
            return tl::unexpected(ended.error());
        forgotten << intent.uuid;
    }
    if (forgotten.isEmpty() && which != QLatin1String("all"))
        return badArgument(translate("cli", "there is no open change \"%1\"").arg(which));
    run.finish(Json::object().add("forgotten", forgotten),
               translate("cli", "Changes given up: %1").arg(forgotten.size()) + QLatin1Char('\n'));
    return Exit::Done;
}

base::Result<Exit> run(Run& run, const Values& values)
{
    if (values.has("--finish") && values.has("--undo"))
        return badArgument(translate("cli", "give --finish or --undo, not both"));
    const auto action = values.has("--finish") ? jobs::RecoverAction::Finish
                        : values.has("--undo") ? jobs::RecoverAction::Undo
                                               : jobs::RecoverAction::Look;
    const auto open = run.session().journal().open();
    if (!open)
        return tl::unexpected(open.error());
    if (const auto which = values.option("--forget"))
        return forget(run, *open, *which);
    if (open->empty()) {
        show(run, {}, action, {});
        return Exit::Done;
    }
    run.listsOpenChanges();
    const auto context = run.context();
    if (!context)
        return showWithoutPort(run, *open, context.error());
    const auto recovered = jobs::recover(
        *context, action,
        {values.has("--any-port"), {}, [&run](const device::Context& inner, device::Servo& servo) {
             return run.saveFirst(inner, servo);
         }});
    if (!recovered)
        return tl::unexpected(recovered.error());
    Elsewhere elsewhere{{}, context->bus.portName()};
    base::ServoIdentity here;
    here.port = elsewhere.port;
    if (!values.has("--any-port") || here.isSimulated())
        elsewhere.intents = jobs::begunElsewhere(*open, elsewhere.port);
    show(run, *recovered, action, elsewhere);
    const Exit exit = exitOf(*recovered, action);
    return exit == Exit::Done && !elsewhere.intents.empty() ? Exit::NotDone : exit;
}
} // namespace

Command recoverCommand()
{
    return {"recover",
            QT_TRANSLATE_NOOP("cli", "show changes that were interrupted; finish or undo them"),
            {},
            {{"--finish", QT_TRANSLATE_NOOP("cli", "complete them")},
             {"--undo", QT_TRANSLATE_NOOP("cli", "put the old values back")},
             {"--forget",
              QT_TRANSLATE_NOOP("cli", "give up a change whose servo will not come back (the first "
                                       "letters of its name will do)"),
              "CHANGE|all"},
             {"--any-port",
              QT_TRANSLATE_NOOP("cli",
                                "also changes begun on another port than this one; without it the "
                                "exit code is 1 while any of those is open")}},
            run};
}
} // namespace cli
