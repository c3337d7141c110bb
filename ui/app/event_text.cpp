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
    const QString name = reg != nullptr ? reg->name.in(text::isUiChinese()) : write.key;
    const QString old = write.oldRaw ? QString::number(*write.oldRaw) : QStringLiteral("–");
    return text::translate("EventWords", "%1 %2 → %3, %4")
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

EventText written(const Event& event, const session::Desk& desk)
{
    const session::ServoEntry* servo = desk.servo(event.servo);
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
    eventText.message = text::translate("EventWords", "ID %1 · %2")
                            .arg(event.report->id)
                            .arg(changes.join(QStringLiteral("; ")));
    if (event.isUndo)
        eventText.message = text::translate("EventWords", "Taken back: %1").arg(eventText.message);
    if (event.isRedo)
        eventText.message = text::translate("EventWords", "Redone: %1").arg(eventText.message);
    switch (event.report->lock) {
    case device::LockState::Closed:
        eventText.message += text::translate("EventWords", ", lock closed");
        break;
    case device::LockState::Open:
        eventText.message += text::translate("EventWords", ", THE LOCK IS OPEN");
        eventText.tone = Tone::Bad;
        break;
    case device::LockState::Unknown:
        eventText.message += text::translate("EventWords", ", lock not proven closed");
        eventText.tone = Tone::Bad;
        break;
    case device::LockState::None:
        break;
    }
    return eventText;
}

EventText searchEnded(const Event& event, const session::Desk& desk)
{
    if (event.error)
        return failed(*event.error);
    const auto& report = desk.lastSearch();
    if (!report)
        return {};
    const QString line = text::translate("EventWords", "Search ended after %2 s, servos found: %1")
                             .arg(report->found.size())
                             .arg(double(report->elapsed.count()) / 1e6, 0, 'f', 1);
    if (event.missing.empty())
        return report->found.empty() ? withWarning(line) : good(line);
    QStringList missing;
    for (const int id : event.missing)
        missing << QString::number(id);
    EventText eventText = withWarning(line + text::translate("EventWords", ". No answer: ID %1")
                                                 .arg(missing.join(QStringLiteral(", "))));
    eventText.details << text::translate("EventWords",
                                         "These were expected and asked several times.");
    return eventText;
}

EventText exchanged(const Event& event, const session::Desk& desk)
{
    const session::ServoEntry* servo = desk.servo(event.servo);
    const QString model = servo != nullptr && servo->servo.profile
                              ? servo->servo.profile->modelName
                              : text::translate("EventWords", "unknown model");
    EventText eventText =
        withWarning(text::translate("EventWords", "Another servo answers under ID %1: %2")
                        .arg(event.id)
                        .arg(model));
    eventText.details << text::translate("EventWords",
                                         "It takes the place of %1 in the list. Unfinished "
                                         "writes stay noted for that servo.")
                             .arg(event.task);
    return eventText;
}

QString idsOf(const std::vector<session::ServoRef>& servos, const session::Desk& desk)
{
    QStringList ids;
    for (const session::ServoRef ref : servos) {
        if (const session::ServoEntry* servo = desk.servo(ref))
            ids << QString::number(servo->servo.id);
    }
    return ids.join(QStringLiteral(", "));
}

/// What reading the torque switches back has shown.
EventText stopChecked(const Event& event, const session::Desk& desk)
{
    const session::StopResult& stop = event.stop;
    const auto say = [&](const QString& eventText, const std::vector<session::ServoRef>& servos) {
        return servos.empty() ? QStringList() : QStringList(eventText.arg(idsOf(servos, desk)));
    };
    QStringList bad =
        say(text::translate("EventWords", "TORQUE IS STILL ON: ID %1"), stop.stillOn) +
        say(text::translate("EventWords", "no answer: ID %1"), stop.silent) +
        say(text::translate("EventWords", "at another rate, not reached: ID %1"), stop.otherBaud) +
        say(text::translate("EventWords", "a goal may still wait for its start: ID %1"),
            stop.stillHeld);
    if (bad.isEmpty())
        return good(text::translate("EventWords", "Stop checked: torque is off, ID %1")
                        .arg(idsOf(stop.off, desk)));
    EventText eventText{
        text::translate("EventWords", "Stop checked: %1").arg(bad.join(QStringLiteral("; "))),
        {},
        Tone::Bad,
        QStringLiteral("✗")};
    if (!stop.stillOn.empty() || !stop.silent.empty())
        eventText.details << text::translate("EventWords",
                                             "Keep clear, and switch the supply off if in doubt.");
    return eventText;
}

QString supplyOff()
{
    return text::translate("EventWords", "Servos may still be moving; switch off their supply.");
}

EventText stopSent(const Event& event)
{
    if (!event.isPending)
        return withWarning(
            text::translate("EventWords", "Stop sent: torque off for everybody on the bus"));
    return {text::translate("EventWords", "Not sent yet: the link is lost."),
            {supplyOff(),
             text::translate("EventWords", "The stop is sent first when the link is back.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText stopNotSent(const Event& event)
{
    if (!event.isRepeated)
        return {text::translate("EventWords", "Not sent: no port is open."),
                {supplyOff()},
                Tone::Bad,
                QStringLiteral("✗")};
    return {text::translate("EventWords", "The emergency stop was not sent: no port was open."),
            {text::translate("EventWords", "Servos may still be moving. Press Esc to stop them "
                                           "now.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText stopUnconfirmed(const Event& event, const session::Desk& desk)
{
    return {text::translate("EventWords", "Stop sent, but not confirmed yet: ID %1")
                .arg(idsOf(event.stop.silent, desk)),
            {text::translate("EventWords", "Keep clear, and switch the supply off if in doubt.")},
            Tone::Bad,
            QStringLiteral("!")};
}

EventText notLeft(const Event& event, const session::Desk& desk)
{
    if (!event.moving.empty())
        return {
            text::translate("EventWords", "Not closed: ID %1 could not be stopped.")
                .arg(idsOf(event.moving, desk)),
            {text::translate("EventWords", "Press Esc for torque off, or switch off the supply.")},
            Tone::Bad,
            QStringLiteral("✗")};
    return {text::translate("EventWords", "Not closed: the EPROM lock of ID %1 is still open.")
                .arg(idsOf(event.unlocked, desk)),
            {text::translate("EventWords", "Check the cable and try again. The unfinished write "
                                           "stays in the journal.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventText disconnected(const Event& event, const session::Desk& desk)
{
    EventText eventText = plain(text::translate("EventWords", "Port closed: %1").arg(event.task));
    if (!event.halted.empty())
        eventText.message +=
            text::translate("EventWords", ". Stopped before: ID %1").arg(idsOf(event.halted, desk));
    if (!event.moving.empty()) {
        eventText = {eventText.message + text::translate("EventWords", ". STILL MOVING: ID %1")
                                             .arg(idsOf(event.moving, desk)),
                     {text::translate("EventWords", "Switch off the supply to stop it.")},
                     Tone::Bad,
                     QStringLiteral("✗")};
    }
    if (!event.locked.empty())
        eventText.message += text::translate("EventWords", ". EPROM lock closed: ID %1")
                                 .arg(idsOf(event.locked, desk));
    if (!event.unlocked.empty()) {
        eventText.message += text::translate("EventWords", ". EPROM LOCK STILL OPEN: ID %1")
                                 .arg(idsOf(event.unlocked, desk));
        eventText.details << text::translate("EventWords",
                                             "Connect again to finish or undo the write.");
        eventText.tone = Tone::Bad;
        eventText.symbol = QStringLiteral("✗");
    }
    return eventText;
}

QString about(const Event& event, const QString& what)
{
    return event.id < 0 ? what
                        : text::translate("EventWords", "ID %1 · %2").arg(event.id).arg(what);
}

/// A new action takes the place of what was said of the one before.
EventText moved(const Event& event)
{
    return plain(
        about(event, event.path.isEmpty()
                         ? text::translate("EventWords", "the goal follows the control")
                         : text::translate("EventWords", "goal sent: %1").arg(event.path)));
}

EventText ended(const Event& event, const session::Desk& desk)
{
    if (event.error && event.error->code == base::ErrorCode::Preempted)
        return {}; // the stop has been said
    if (event.error && event.error->code != base::ErrorCode::Stopped)
        return failed(*event.error, desk.servo(event.servo));
    return plain(
        event.error
            ? text::translate("EventWords", "%1: stopped").arg(about(event, taskLabel(event.task)))
            : text::translate("EventWords", "%1: ended").arg(about(event, taskLabel(event.task))));
}

EventText sentence(const Event& event, const session::Desk& desk)
{
    switch (event.kind) {
    case Event::Kind::Connected:
        return good(text::translate("EventWords", "Connected: %1").arg(event.task));
    case Event::Kind::Disconnected:
        return disconnected(event, desk);
    case Event::Kind::Replaced:
        return exchanged(event, desk);
    case Event::Kind::CloseCanceled:
        return notLeft(event, desk);
    case Event::Kind::StopUnconfirmed:
        return stopUnconfirmed(event, desk);
    case Event::Kind::LinkLost:
        return failed({base::ErrorCode::LinkLost, QStringLiteral("read"), event.task});
    case Event::Kind::SearchEnded:
        return searchEnded(event, desk);
    case Event::Kind::TableSaved:
        return plain(
            text::translate("EventWords", "ID %1 · table saved before the first change: %2")
                .arg(event.id)
                .arg(QDir::toNativeSeparators(event.path)));
    case Event::Kind::Written:
        return written(event, desk);
    case Event::Kind::Task:
        return event.error ? failed(*event.error, desk.servo(event.servo))
                           : good(text::translate("EventWords", "%1: done")
                                      .arg(about(event, taskLabel(event.task))));
    case Event::Kind::GoalSent:
        return moved(event);
    case Event::Kind::Started:
        return plain(
            text::translate("EventWords", "%1: running").arg(about(event, taskLabel(event.task))));
    case Event::Kind::Finished:
        return ended(event, desk);
    case Event::Kind::Stopped:
        return stopSent(event);
    case Event::Kind::StopNotSent:
        return stopNotSent(event);
    case Event::Kind::StopVerified:
        return stopChecked(event, desk);
    case Event::Kind::Failed:
        return event.error ? failed(*event.error, desk.servo(event.servo)) : EventText{};
    }
    return {};
}
} // namespace

QString taskLabel(const QString& task)
{
    static const std::pair<const char*, const char*> eventText[] = {
        {"center", QT_TRANSLATE_NOOP("EventWords", "centre here")},
        {"reboot", QT_TRANSLATE_NOOP("EventWords", "restart")},
        {"restore-defaults", QT_TRANSLATE_NOOP("EventWords", "restore defaults")},
        {"identify", QT_TRANSLATE_NOOP("EventWords", "identify")},
        {"move", QT_TRANSLATE_NOOP("EventWords", "move")},
        {"execute", QT_TRANSLATE_NOOP("EventWords", "start the goals that wait")},
        {"torque", QT_TRANSLATE_NOOP("EventWords", "torque")},
        {"halt", QT_TRANSLATE_NOOP("EventWords", "halt")},
        {"mode", QT_TRANSLATE_NOOP("EventWords", "switch the mode")},
        {"plan-mode", QT_TRANSLATE_NOOP("EventWords", "look at the mode")},
        {"clear-alarm", QT_TRANSLATE_NOOP("EventWords", "clear alarm")},
        {"close-lock", QT_TRANSLATE_NOOP("EventWords", "close the EPROM lock")},
        {"recover", QT_TRANSLATE_NOOP("EventWords", "interrupted writes")},
        {"read", QT_TRANSLATE_NOOP("EventWords", "read the table")},
        {"write", QT_TRANSLATE_NOOP("EventWords", "write")},
        {"sweep", QT_TRANSLATE_NOOP("EventWords", "sweep test")},
        {"step-response", QT_TRANSLATE_NOOP("EventWords", "step response")},
        {"commission", QT_TRANSLATE_NOOP("EventWords", "commissioning")},
    };
    for (const auto& [name, word] : eventText) {
        if (task == QLatin1String(name))
            return text::translate("EventWords", word);
    }
    return task;
}

EventText describe(const Event& event, const session::Desk& desk)
{
    EventText eventText = sentence(event, desk);
    for (const base::Notice& notice : event.notices) {
        const QString about =
            notice.id >= 0 ? text::translate("EventWords", "ID %1: ").arg(notice.id) : QString();
        eventText.details << about + text::describe(notice);
        if (notice.code != base::NoticeCode::NotRecorded)
            continue;
        eventText.message += text::translate("EventWords", ", NOT RECORDED");
        eventText.symbol = QStringLiteral("✗");
        eventText.tone = Tone::Bad;
    }
    return eventText;
}
} // namespace ui
