// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/event_text.h"

#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/editors/register_text.h"

#include <QDir>

namespace ui {
namespace {
using session::Event;

EventText good(const QString& line)
{
    return {line, {}, Tone::Good, QStringLiteral("✓")};
}

EventText plain(const QString& line)
{
    return {line, {}, Tone::Quiet, QStringLiteral("·")};
}

EventText withWarning(const QString& line)
{
    return {line, {}, Tone::Warn, QStringLiteral("!")};
}

EventText failed(const base::Error& error)
{
    const text::Description eventText = text::describe(error);
    EventText result{eventText.message, {}, Tone::Bad, QStringLiteral("✗")};
    if (error.code == base::ErrorCode::Stopped)
        result = plain(eventText.message);
    for (const QString& sentence : {eventText.cause, eventText.remedy}) {
        if (!sentence.isEmpty())
            result.details << sentence;
    }
    return result;
}

const catalog::Register* registerOf(const session::ServoEntry* servo, const QString& key)
{
    return servo != nullptr && servo->servo.profile ? servo->servo.profile->find(key) : nullptr;
}

EventText failed(const base::Error& error, const session::ServoEntry* servo)
{
    return failed(withName(error, registerOf(servo, error.registerKey)));
}

/// "minimum angle limit 0 → 300, kept".
QString changeText(const device::WriteResult& write, const session::ServoEntry* servo)
{
    const catalog::Register* reg = registerOf(servo, write.key);
    const QString name = reg != nullptr ? text::localized(reg->name) : write.key;
    const QString old = write.oldRaw ? QString::number(*write.oldRaw) : QStringLiteral("–");
    return text::translate("EventText", "%1 %2 → %3, %4")
        .arg(name, old, QString::number(write.newRaw),
             text::outcomeLabel(device::outcomeName(write.outcome)));
}

Tone toneOf(device::WriteOutcome outcome)
{
    switch (outcome) {
    case device::WriteOutcome::Kept:
        return Tone::Good;
    case device::WriteOutcome::Temporary:
        return Tone::Warn;
    default:
        return Tone::Bad;
    }
}

QString lockText(device::LockState lock)
{
    switch (lock) {
    case device::LockState::Closed:
        return text::translate("EventText", ", EPROM locked");
    case device::LockState::Open:
        return text::translate("EventText", ", EPROM UNLOCKED");
    case device::LockState::Unknown:
        return text::translate("EventText", ", EPROM lock not confirmed");
    case device::LockState::None:
        break;
    }
    return {};
}

EventText written(const Event& event, const session::ServoRegistry& registry)
{
    const session::ServoEntry* servo = registry.servo(event.servo);
    if (event.error && !event.report)
        return failed(*event.error, servo);
    EventText eventText = good({});
    QStringList changes;
    for (const device::WriteResult& write : event.report->writes) {
        changes << changeText(write, servo);
        const Tone tone = toneOf(write.outcome);
        if (eventText.tone != Tone::Bad && tone != Tone::Good)
            eventText.tone = tone;
        if (write.error)
            eventText.details += failed(*write.error, servo).details;
    }
    eventText.symbol = eventText.tone == Tone::Good   ? QStringLiteral("✓")
                       : eventText.tone == Tone::Warn ? QStringLiteral("!")
                                                      : QStringLiteral("✗");
    eventText.message = text::translate("EventText", "ID %1 · %2")
                            .arg(event.report->id)
                            .arg(text::joinClauses(changes));
    if (event.isUndo)
        eventText.message = text::translate("EventText", "Undone: %1").arg(eventText.message);
    if (event.isRedo)
        eventText.message = text::translate("EventText", "Redone: %1").arg(eventText.message);
    const device::LockState lock = event.report->lock;
    eventText.message += lockText(lock);
    if (lock == device::LockState::Open || lock == device::LockState::Unknown)
        eventText.tone = Tone::Bad;
    return eventText;
}

EventText searchEnded(const Event& event)
{
    if (event.error)
        return failed(*event.error);
    const QString line = text::translate("EventText", "Search ended after %1 s, %n servo(s) found",
                                         nullptr, event.found)
                             .arg(double(event.elapsed.count()) / 1e6, 0, 'f', 1);
    if (event.missing.empty())
        return event.found == 0 ? withWarning(line) : good(line);
    QStringList missing;
    for (const int id : event.missing)
        missing << QString::number(id);
    EventText eventText = withWarning(
        line + text::translate("EventText", ". No reply: ID %1").arg(text::joinItems(missing)));
    eventText.details << text::translate(
        "EventText", "These servos were expected but did not reply despite several queries.");
    return eventText;
}

EventText exchanged(const Event& event, const session::ServoRegistry& registry)
{
    const session::ServoEntry* servo = registry.servo(event.servo);
    const QString model = servo != nullptr && servo->servo.profile
                              ? servo->servo.profile->modelName
                              : text::translate("EventText", "unknown model");
    EventText eventText =
        withWarning(text::translate("EventText", "A different servo now replies with ID %1: %2")
                        .arg(event.id)
                        .arg(model));
    eventText.details << text::translate("EventText",
                                         "The new servo replaces %1 in the list. Unfinished writes "
                                         "remain assigned to the previous servo.")
                             .arg(event.task);
    return eventText;
}

QString idsOf(const std::vector<session::ServoRef>& servos, const session::ServoRegistry& registry)
{
    QStringList ids;
    for (const session::ServoRef ref : servos) {
        if (const session::ServoEntry* servo = registry.servo(ref))
            ids << QString::number(servo->servo.id);
    }
    return text::joinItems(ids);
}

/// The result of reading the torque switches back.
EventText stopChecked(const Event& event, const session::ServoRegistry& registry)
{
    const session::StopResult& stop = event.stop;
    const auto say = [&](const QString& eventText, const std::vector<session::ServoRef>& servos) {
        return servos.empty() ? QStringList() : QStringList(eventText.arg(idsOf(servos, registry)));
    };
    QStringList bad =
        say(text::translate("EventText", "TORQUE IS STILL ON: ID %1"), stop.stillOn) +
        say(text::translate("EventText", "no reply: ID %1"), stop.silent) +
        say(text::translate("EventText", "not reachable (different baud rate): ID %1"),
            stop.otherBaud) +
        say(text::translate("EventText",
                            "a goal may still be waiting for the Execute command: ID %1"),
            stop.stillHeld);
    if (bad.isEmpty())
        return good(text::translate("EventText", "Emergency stop confirmed: torque is off, ID %1")
                        .arg(idsOf(stop.off, registry)));
    EventText eventText{text::translate("EventText", "Emergency stop not confirmed: %1")
                            .arg(text::joinClauses(bad)),
                        {},
                        Tone::Bad,
                        QStringLiteral("✗")};
    if (!stop.stillOn.empty() || !stop.silent.empty())
        eventText.details << text::translate("EventText",
                                             "Keep clear. If in doubt, turn off the power supply.");
    return eventText;
}

QString supplyOff()
{
    return text::translate("EventText", "Servos may still be moving. Turn off their power supply.");
}

EventText stopSent(const Event& event)
{
    if (!event.isPending)
        return withWarning(
            text::translate("EventText", "Emergency stop: torque-off command sent to all servos"));
    return {text::translate("EventText", "Emergency stop not sent yet: the connection is lost."),
            {supplyOff(),
             text::translate(
                 "EventText",
                 "When the connection is restored, the emergency stop will be sent first.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText stopNotSent(const Event& event)
{
    if (!event.isRepeated)
        return {text::translate("EventText", "Emergency stop not sent: no port is open."),
                {supplyOff()},
                Tone::Bad,
                QStringLiteral("✗")};
    return {text::translate("EventText", "The emergency stop was not sent: no port was open."),
            {text::translate("EventText", "Servos may still be moving. Press Esc to stop them "
                                          "now.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText stopUnconfirmed(const Event& event, const session::ServoRegistry& registry)
{
    return {text::translate("EventText", "Emergency stop sent, but not confirmed yet: ID %1")
                .arg(idsOf(event.stop.silent, registry)),
            {text::translate("EventText", "Keep clear. If in doubt, turn off the power supply.")},
            Tone::Bad,
            QStringLiteral("!")};
}

EventText notLeft(const Event& event, const session::ServoRegistry& registry)
{
    if (!event.moving.empty())
        return {text::translate("EventText", "Closing canceled: ID %1 could not be stopped.")
                    .arg(idsOf(event.moving, registry)),
                {text::translate("EventText",
                                 "Press Esc to turn torque off, or turn off the power supply.")},
                Tone::Bad,
                QStringLiteral("✗")};
    return {text::translate("EventText", "Closing canceled: the EPROM of ID %1 is still unlocked.")
                .arg(idsOf(event.unlocked, registry)),
            {text::translate("EventText", "Check the cable and try again. The unfinished write "
                                          "stays in the journal.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText disconnected(const Event& event, const session::ServoRegistry& registry)
{
    EventText eventText = plain(text::translate("EventText", "Port closed: %1").arg(event.task));
    if (!event.halted.empty())
        eventText.message += text::translate("EventText", ". Stopped before closing: ID %1")
                                 .arg(idsOf(event.halted, registry));
    if (!event.moving.empty()) {
        eventText = {
            eventText.message + text::translate("EventText", ". STILL MOVING: ID %1")
                                    .arg(idsOf(event.moving, registry)),
            {text::translate("EventText", "Turn off the power supply to stop the motion.")},
            Tone::Bad,
            QStringLiteral("✗")};
    }
    if (!event.locked.empty())
        eventText.message += text::translate("EventText", ". EPROM locked: ID %1")
                                 .arg(idsOf(event.locked, registry));
    if (!event.unlocked.empty()) {
        eventText.message += text::translate("EventText", ". EPROM STILL UNLOCKED: ID %1")
                                 .arg(idsOf(event.unlocked, registry));
        eventText.details << text::translate("EventText",
                                             "Connect again to finish or undo the write.");
        eventText.tone = Tone::Bad;
        eventText.symbol = QStringLiteral("✗");
    }
    return eventText;
}

QString about(const Event& event, const QString& what)
{
    return event.id < 0 ? what : text::translate("EventText", "ID %1 · %2").arg(event.id).arg(what);
}

/// A new action replaces the message about the previous one.
EventText moved(const Event& event)
{
    return plain(about(event, event.path.isEmpty()
                                  ? text::translate("EventText", "goal follows the slider")
                                  : text::translate("EventText", "goal sent: %1").arg(event.path)));
}

EventText ended(const Event& event, const session::ServoRegistry& registry)
{
    if (event.error && event.error->code == base::ErrorCode::Preempted)
        return {}; // the stop has been reported
    if (event.error && event.error->code != base::ErrorCode::Stopped)
        return failed(*event.error, registry.servo(event.servo));
    return plain(
        event.error
            ? text::translate("EventText", "%1: stopped").arg(about(event, taskLabel(event.task)))
            : text::translate("EventText", "%1: ended").arg(about(event, taskLabel(event.task))));
}

EventText sentence(const Event& event, const session::ServoRegistry& registry)
{
    switch (event.kind) {
    case Event::Kind::Connected:
        return good(text::translate("EventText", "Connected: %1").arg(event.task));
    case Event::Kind::Disconnected:
        return disconnected(event, registry);
    case Event::Kind::Replaced:
        return exchanged(event, registry);
    case Event::Kind::CloseCanceled:
        return notLeft(event, registry);
    case Event::Kind::StopUnconfirmed:
        return stopUnconfirmed(event, registry);
    case Event::Kind::LinkLost:
        return failed({base::ErrorCode::LinkLost, QStringLiteral("read"), event.task});
    case Event::Kind::SearchEnded:
        return searchEnded(event);
    case Event::Kind::TableSaved:
        return plain(
            text::translate("EventText", "ID %1 · memory table saved before the first change: %2")
                .arg(event.id)
                .arg(QDir::toNativeSeparators(event.path)));
    case Event::Kind::Written:
        return written(event, registry);
    case Event::Kind::Task:
        return event.error ? failed(*event.error, registry.servo(event.servo))
                           : good(text::translate("EventText", "%1: done")
                                      .arg(about(event, taskLabel(event.task))));
    case Event::Kind::GoalSent:
        return moved(event);
    case Event::Kind::Started:
        return plain(
            text::translate("EventText", "%1: running").arg(about(event, taskLabel(event.task))));
    case Event::Kind::Finished:
        return ended(event, registry);
    case Event::Kind::Stopped:
        return stopSent(event);
    case Event::Kind::StopNotSent:
        return stopNotSent(event);
    case Event::Kind::StopVerified:
        return stopChecked(event, registry);
    case Event::Kind::Failed:
        return event.error ? failed(*event.error, registry.servo(event.servo)) : EventText{};
    }
    return {};
}
} // namespace

QString taskLabel(const QString& task)
{
    static const std::pair<const char*, const char*> eventText[] = {
        {"center", QT_TRANSLATE_NOOP("EventText", "set midpoint")},
        {"reboot", QT_TRANSLATE_NOOP("EventText", "reboot")},
        {"record-ranges", QT_TRANSLATE_NOOP("EventText", "record joint ranges")},
        {"calibrate-arm", QT_TRANSLATE_NOOP("EventText", "calibrate arm")},
        {"move-test", QT_TRANSLATE_NOOP("EventText", "move test")},
        {"check-firmware", QT_TRANSLATE_NOOP("EventText", "check before the firmware update")},
        {"update-firmware", QT_TRANSLATE_NOOP("EventText", "update firmware")},
        {"rescue-firmware", QT_TRANSLATE_NOOP("EventText", "rescue firmware")},
        {"restore-defaults", QT_TRANSLATE_NOOP("EventText", "reset to factory defaults")},
        {"identify", QT_TRANSLATE_NOOP("EventText", "blink LED")},
        {"move", QT_TRANSLATE_NOOP("EventText", "move")},
        {"execute", QT_TRANSLATE_NOOP("EventText", "execute waiting goals")},
        {"torque", QT_TRANSLATE_NOOP("EventText", "torque")},
        {"halt", QT_TRANSLATE_NOOP("EventText", "stop motion")},
        {"mode", QT_TRANSLATE_NOOP("EventText", "change mode")},
        {"plan-mode", QT_TRANSLATE_NOOP("EventText", "preview mode change")},
        {"clear-alarm", QT_TRANSLATE_NOOP("EventText", "clear alarm")},
        {"close-lock", QT_TRANSLATE_NOOP("EventText", "lock the EPROM")},
        {"recover", QT_TRANSLATE_NOOP("EventText", "interrupted writes")},
        {"read", QT_TRANSLATE_NOOP("EventText", "read memory table")},
        {"write", QT_TRANSLATE_NOOP("EventText", "write")},
        {"sweep", QT_TRANSLATE_NOOP("EventText", "sweep test")},
        {"step-response", QT_TRANSLATE_NOOP("EventText", "step response")},
        {"commission", QT_TRANSLATE_NOOP("EventText", "commissioning")},
        {"restore", QT_TRANSLATE_NOOP("EventText", "restore")},
        {"snapshot", QT_TRANSLATE_NOOP("EventText", "take snapshot")},
        {"dry-run", QT_TRANSLATE_NOOP("EventText", "dry run")},
        {"free-ids", QT_TRANSLATE_NOOP("EventText", "search for unused IDs")},
        {"stop-check", QT_TRANSLATE_NOOP("EventText", "verify emergency stop")},
        {"motion", QT_TRANSLATE_NOOP("EventText", "check for motion")},
        {"lock", QT_TRANSLATE_NOOP("EventText", "lock the EPROM")},
    };
    for (const auto& [name, word] : eventText) {
        if (task == QLatin1String(name))
            return text::translate("EventText", word);
    }
    return task;
}

EventText describe(const Event& event, const session::ServoRegistry& registry)
{
    EventText eventText = sentence(event, registry);
    for (const base::Notice& notice : event.notices) {
        const QString about =
            notice.id >= 0 ? text::translate("EventText", "ID %1: ").arg(notice.id) : QString();
        eventText.details << about + text::describe(notice);
        if (notice.code != base::NoticeCode::NotRecorded)
            continue;
        eventText.message += text::translate("EventText", ", NOT RECORDED");
        eventText.symbol = QStringLiteral("✗");
        eventText.tone = Tone::Bad;
    }
    return eventText;
}
} // namespace ui
