// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/recover_text.h"

#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "jobs/restore/restore.h"
#include "text/language.h"
#include "text/notice_text.h"

#include <map>

namespace cli {
namespace {
constexpr int uuidDigits = 8; ///< enough to distinguish a few changes

QString kindName(const base::Intent& intent)
{
    switch (intent.kind) {
    case base::IntentKind::Calibrate:
        return QStringLiteral("center");
    case base::IntentKind::Restore:
        return jobs::isSnapshotRestore(intent) ? QStringLiteral("snapshot-restore")
                                               : QStringLiteral("restore-defaults");
    default:
        return base::intentKindName(intent.kind);
    }
}

struct FindingText {
    const char* name;
    const char* shown;
};

FindingText findingText(jobs::Finding finding)
{
    switch (finding) {
    case jobs::Finding::AllOld:
        return {"all-old", QT_TRANSLATE_NOOP("cli", "the old values")};
    case jobs::Finding::AllNew:
        return {"all-new", QT_TRANSLATE_NOOP("cli", "the new values")};
    case jobs::Finding::Mixed:
        return {"mixed", QT_TRANSLATE_NOOP("cli", "some old and some new values")};
    case jobs::Finding::OtherServo:
        return {"other-servo", QT_TRANSLATE_NOOP("cli", "different servo; not changed")};
    case jobs::Finding::NoReply:
        return {"no-answer", QT_TRANSLATE_NOOP("cli", "no reply")};
    case jobs::Finding::Unreadable:
        return {"unreadable", QT_TRANSLATE_NOOP("cli", "replies cannot be decoded")};
    case jobs::Finding::UnderWay:
        return {"under-way", QT_TRANSLATE_NOOP("cli", "still in progress in another program")};
    case jobs::Finding::Replaced:
        return {"replaced",
                QT_TRANSLATE_NOOP("cli", "value has changed in the meantime; left as is")};
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
        .add("under_way", intent.isActiveElsewhere)
        .add("items", std::move(items));
    return json;
}

} // namespace

Json jsonRecovered(const jobs::RecoveryResult& one)
{
    Json json = jsonIntent(one.before.intent);
    json.add("finding", QString::fromLatin1(findingText(one.before.finding).name))
        .add("found_id", one.before.foundId >= 0 ? Json(one.before.foundId) : Json())
        .add("found_baud", one.before.foundBaud > 0 ? Json(one.before.foundBaud) : Json())
        .add("lock_open", one.before.lockOpen)
        .add("done", one.done);
    if (!one.skippedKeys.isEmpty())
        json.add("left", one.skippedKeys);
    if (one.action != jobs::RecoveryAction::Preview)
        json.add("action", one.action == jobs::RecoveryAction::Undo ? QStringLiteral("undo")
                                                                    : QStringLiteral("finish"));
    if (one.report)
        json.add("result", jsonWrites(*one.report));
    if (one.error)
        json.add("error", jsonError(*one.error));
    return json;
}

namespace {
QStringList changesOf(const base::Intent& intent)
{
    QStringList changes;
    for (const base::JournalItem& item : intent.items) {
        if (item.oldRaw != item.newRaw)
            changes << QStringLiteral("%1 %2 → %3").arg(item.key).arg(item.oldRaw).arg(item.newRaw);
    }
    return changes;
}

/// For one cell of a table: the number of registers if there are many; the names if the new values
/// are not known beforehand (calibration, factory defaults).
QString changesCell(const base::Intent& intent)
{
    constexpr int maxItemsInLine = 3;
    const QStringList changes = changesOf(intent);
    const int count = static_cast<int>(intent.items.size());
    if (count > maxItemsInLine)
        return translate("cli", "%n register(s)", nullptr, count);
    if (!changes.isEmpty())
        return text::joinItems(changes);
    QStringList keys;
    for (const base::JournalItem& item : intent.items)
        keys << item.key;
    return text::joinItems(keys);
}

} // namespace

QString changesBelow(const base::Intent& intent)
{
    const QStringList changes = changesOf(intent);
    if (changesCell(intent) == text::joinItems(changes) || changes.isEmpty())
        return {};
    QString lines = translate("cli", "Unfinished change %1:").arg(intent.uuid.left(uuidDigits)) +
                    QLatin1Char('\n');
    for (const QString& change : changes)
        lines += QStringLiteral("  %1\n").arg(change);
    return lines;
}

QString discardedText(const base::Intent& intent)
{
    const QStringList changes = changesOf(intent);
    QString lines = translate("cli", "Abandoned: change %1, servo %2 (%3, %4)")
                        .arg(intent.uuid.left(uuidDigits))
                        .arg(intent.servo.id)
                        .arg(kindName(intent), localTime(intent.at));
    lines += QLatin1Char('\n');
    for (const QString& change : changes.isEmpty() ? QStringList{changesCell(intent)} : changes)
        lines += QStringLiteral("  %1\n").arg(change);
    lines +=
        QStringLiteral("  ") +
        translate(
            "cli",
            "The servo was not read, so each register may hold either its old or its new value.") +
        QLatin1Char('\n');
    if (intent.lockOpened)
        lines += QStringLiteral("  ") +
                 translate("cli", "The EPROM may be unlocked. To check, use \"info %1\". To lock "
                                  "the EPROM, turn the servo off and on.")
                     .arg(intent.servo.id) +
                 QLatin1Char('\n');
    return lines;
}

Json jsonDiscarded(const base::Intent& intent)
{
    return jsonIntent(intent).add("lock_may_be_open", intent.lockOpened);
}

namespace {
QString formatLock(const std::optional<bool>& open)
{
    return text::lockLabel(!open   ? QStringLiteral("unknown")
                           : *open ? QStringLiteral("open")
                                   : QStringLiteral("closed"));
}

/// A restore whose rollback had begun is undone even if it should be finished.
QString recoveryText(const jobs::RecoveryResult& one, jobs::RecoveryAction asked)
{
    if (!one.done)
        return translate("cli", "no");
    if (one.isAllSkipped)
        return translate("cli", "not changed");
    const bool undone = asked == jobs::RecoveryAction::Finish && one.action != asked;
    return undone ? translate("cli", "undone") : translate("cli", "yes");
}

} // namespace

QString notWrittenLine(const jobs::RecoveryResult& one)
{
    if (one.skippedKeys.isEmpty())
        return {};
    return translate("cli",
                     "In change %1, these registers were not written because their values have "
                     "changed in the meantime or because writing them would move the servo: %2")
               .arg(one.before.intent.uuid.left(uuidDigits), text::joinItems(one.skippedKeys)) +
           QLatin1Char('\n');
}

Table recoveredTable(const std::vector<jobs::RecoveryResult>& all, jobs::RecoveryAction action)
{
    Table table({translate("cli", "Change"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Operation"), translate("cli", "Changes"),
                 translate("cli", "State"), translate("cli", "EPROM lock"),
                 translate("cli", "Result")});
    table.alignRight({2});
    for (const jobs::RecoveryResult& one : all) {
        const base::Intent& intent = one.before.intent;
        table.add({intent.uuid.left(uuidDigits), localTime(intent.at),
                   QString::number(intent.servo.id), kindName(intent), changesCell(intent),
                   translate("cli", findingText(one.before.finding).shown),
                   formatLock(one.before.lockOpen), recoveryText(one, action)});
    }
    return table;
}

namespace {
QString namesOf(const std::vector<base::Intent>& intents)
{
    QStringList names;
    for (const base::Intent& intent : intents)
        names << intent.uuid.left(uuidDigits);
    return text::joinItems(names);
}

QString commandOn(const QString& port)
{
    return QStringLiteral("servodesk-cli recover --port %1").arg(port);
}

} // namespace

/// Preferably of a change whose servo may be on this port.
QString UncheckedChanges::command() const
{
    QString there;
    for (const base::Intent& intent : intents) {
        if (intent.isActiveElsewhere)
            continue;
        if (!jobs::isPortPresent(intent))
            return commandForThisPort();
        if (there.isEmpty())
            there = commandOn(intent.servo.port);
    }
    return there;
}

Json UncheckedChanges::json() const
{
    Json::Array all;
    for (const base::Intent& intent : intents)
        all.push_back(jsonIntent(intent).add("port_present", jobs::isPortPresent(intent)));
    return all;
}

void UncheckedChanges::addTo(Json& document, const char* name) const
{
    if (!intents.empty())
        document.add(name, json());
}

void addRecoverCommand(Json& document, const UncheckedChanges& first,
                       const UncheckedChanges& second)
{
    const QString command = first.command().isEmpty() ? second.command() : first.command();
    if (!command.isEmpty())
        document.add("try", command);
}

QString UncheckedChanges::advice() const
{
    std::vector<base::Intent> running;
    std::map<QString, std::vector<base::Intent>> present;
    bool gone = false;
    for (const base::Intent& intent : intents) {
        if (intent.isActiveElsewhere)
            running.push_back(intent);
        else if (jobs::isPortPresent(intent))
            present[intent.servo.port].push_back(intent);
        else
            gone = true;
    }
    QStringList lines;
    if (!running.empty())
        lines << translate("cli",
                           "Still in progress in another program, which will finish the change: %1")
                     .arg(namesOf(running));
    for (const auto& [there, its] : present) {
        if (there == port)
            continue;
        lines << translate("cli", "Port %1 still exists. To list its changes (%2): %3")
                     .arg(there, namesOf(its), commandOn(there));
        if (hasRealPort())
            lines << translate("cli", "ServoDesk cannot distinguish the servo from another one "
                                      "with the same model and ID. Run the following only if you "
                                      "are sure that the same servo is now connected to %1: %2")
                         .arg(port, commandForThisPort() + QStringLiteral(" --change ") +
                                        its.front().uuid.left(uuidDigits));
    }
    if (gone)
        lines << translate(
                     "cli",
                     "An adapter may get a different port name when it is plugged in again. To "
                     "list the changes, use the port to which the servo is now connected: %1")
                     .arg(commandForThisPort());
    return lines.isEmpty() ? QString() : lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString UncheckedChanges::text(const QString& title) const
{
    if (intents.empty())
        return {};
    Table table({translate("cli", "Change"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Operation"), translate("cli", "Changes"),
                 translate("cli", "Port")});
    table.alignRight({2});
    for (const base::Intent& intent : intents) {
        table.add({intent.uuid.left(uuidDigits), localTime(intent.at),
                   QString::number(intent.servo.id), kindName(intent), changesCell(intent),
                   intent.servo.port});
    }
    return title + QLatin1Char('\n') + table.text() + advice();
}

QString otherPortsTitle()
{
    return translate("cli", "Unfinished changes from other ports:");
}

QString userConfirmedText(const jobs::RecoveryResult& one, const QString& port)
{
    const base::Intent& intent = one.before.intent;
    if (intent.servo.port == port || !jobs::isPortPresent(intent))
        return {};
    return translate("cli", "Change %1 was started on %2, which still exists. You have confirmed "
                            "that the servo on %3 is the same servo.")
               .arg(intent.uuid.left(uuidDigits), intent.servo.port, port) +
           QLatin1Char('\n');
}

} // namespace cli
