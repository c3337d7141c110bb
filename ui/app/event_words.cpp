// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/event_words.h"

#include "text/error_words.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "text/translate.h"
#include "ui/models/memory_words.h"

#include <QDir>

namespace ui {
namespace {
using session::Event;

EventWords good(const QString& line)
{
    return {line, {}, Tone::Good, QStringLiteral("✓")};
}

EventWords plain(const QString& line)
{
    return {line, {}, Tone::Quiet, QStringLiteral("·")};
}

EventWords warned(const QString& line)
{
    return {line, {}, Tone::Warn, QStringLiteral("!")};
}

EventWords failed(const base::Error& error)
{
    const text::Description words = text::describe(error);
    EventWords result{words.what, {}, Tone::Bad, QStringLiteral("✗")};
    if (error.code == base::ErrorCode::Stopped)
        result = plain(words.what);
    for (const QString& sentence : {words.cause, words.remedy}) {
        if (!sentence.isEmpty())
            result.more << sentence;
    }
    return result;
}

const catalog::Register* registerOf(const session::ServoEntry* servo, const QString& key)
{
    return servo != nullptr && servo->servo.profile ? servo->servo.profile->find(key) : nullptr;
}

EventWords failed(const base::Error& error, const session::ServoEntry* servo)
{
    return failed(withName(error, registerOf(servo, error.registerKey)));
}

/// "minimum angle limit 0 → 300, kept".
QString changeWords(const device::WriteResult& write, const session::ServoEntry* servo)
{
    const catalog::Register* reg = registerOf(servo, write.key);
    const QString name = reg != nullptr ? reg->name.in(text::inChinese()) : write.key;
    const QString old = write.oldRaw ? QString::number(*write.oldRaw) : QStringLiteral("–");
    return text::translate("EventWords", "%1 %2 → %3, %4")
        .arg(name, old, QString::number(write.newRaw),
             text::outcomeWord(device::outcomeName(write.outcome)));
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

EventWords written(const Event& event, const session::Desk& desk)
{
    const session::ServoEntry* servo = desk.servo(event.servo);
    if (event.error && !event.report)
        return failed(*event.error, servo);
    EventWords words = good({});
    QStringList changes;
    for (const device::WriteResult& write : event.report->writes) {
        changes << changeWords(write, servo);
        const Tone tone = toneOf(write.outcome);
        if (words.tone != Tone::Bad && tone != Tone::Good)
            words.tone = tone;
        if (write.error)
            words.more += failed(*write.error, servo).more;
    }
    words.sign = words.tone == Tone::Good   ? QStringLiteral("✓")
                 : words.tone == Tone::Warn ? QStringLiteral("!")
                                            : QStringLiteral("✗");
    words.line = text::translate("EventWords", "ID %1 · %2")
                     .arg(event.report->id)
                     .arg(changes.join(QStringLiteral("; ")));
    if (event.undone)
        words.line = text::translate("EventWords", "Taken back: %1").arg(words.line);
    if (event.redone)
        words.line = text::translate("EventWords", "Redone: %1").arg(words.line);
    switch (event.report->lock) {
    case device::LockState::Closed:
        words.line += text::translate("EventWords", ", lock closed");
        break;
    case device::LockState::Open:
        words.line += text::translate("EventWords", ", THE LOCK IS OPEN");
        words.tone = Tone::Bad;
        break;
    case device::LockState::Unknown:
        words.line += text::translate("EventWords", ", lock not proven closed");
        words.tone = Tone::Bad;
        break;
    case device::LockState::None:
        break;
    }
    return words;
}

EventWords searchEnded(const Event& event, const session::Desk& desk)
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
        return report->found.empty() ? warned(line) : good(line);
    QStringList missing;
    for (const int id : event.missing)
        missing << QString::number(id);
    EventWords words = warned(line + text::translate("EventWords", ". No answer: ID %1")
                                         .arg(missing.join(QStringLiteral(", "))));
    words.more << text::translate("EventWords", "These were expected and asked several times.");
    return words;
}

EventWords exchanged(const Event& event, const session::Desk& desk)
{
    const session::ServoEntry* servo = desk.servo(event.servo);
    const QString model = servo != nullptr && servo->servo.profile
                              ? servo->servo.profile->modelName
                              : text::translate("EventWords", "unknown model");
    EventWords words = warned(text::translate("EventWords", "Another servo answers under ID %1: %2")
                                  .arg(event.id)
                                  .arg(model));
    words.more << text::translate("EventWords", "It takes the place of %1 in the list. Unfinished "
                                                "writes stay noted for that servo.")
                      .arg(event.task);
    return words;
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
EventWords stopChecked(const Event& event, const session::Desk& desk)
{
    const session::StopCheck& stop = event.stop;
    const auto say = [&](const QString& words, const std::vector<session::ServoRef>& servos) {
        return servos.empty() ? QStringList() : QStringList(words.arg(idsOf(servos, desk)));
    };
    QStringList bad =
        say(text::translate("EventWords", "TORQUE IS STILL ON: ID %1"), stop.stillOn) +
        say(text::translate("EventWords", "no answer: ID %1"), stop.silent) +
        say(text::translate("EventWords", "at another rate, not reached: ID %1"), stop.elsewhere) +
        say(text::translate("EventWords", "a goal may still wait for its start: ID %1"),
            stop.stillHeld);
    if (bad.isEmpty())
        return good(text::translate("EventWords", "Stop checked: torque is off, ID %1")
                        .arg(idsOf(stop.off, desk)));
    EventWords words{
        text::translate("EventWords", "Stop checked: %1").arg(bad.join(QStringLiteral("; "))),
        {},
        Tone::Bad,
        QStringLiteral("✗")};
    if (!stop.stillOn.empty() || !stop.silent.empty())
        words.more << text::translate("EventWords",
                                      "Keep clear, and switch the supply off if in doubt.");
    return words;
}

QString supplyOff()
{
    return text::translate("EventWords", "Servos may still be moving; switch off their supply.");
}

EventWords stopSent(const Event& event)
{
    if (!event.owed)
        return warned(
            text::translate("EventWords", "Stop sent: torque off for everybody on the bus"));
    return {text::translate("EventWords", "Not sent yet: the link is lost."),
            {supplyOff(),
             text::translate("EventWords", "The stop is sent first when the link is back.")},
            Tone::Bad,
            QStringLiteral("✗")};
}

EventWords stopNotSent(const Event& event)
{
    if (!event.earlier)
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

EventWords stopUnconfirmed(const Event& event, const session::Desk& desk)
{
    return {text::translate("EventWords", "Stop sent, but not confirmed yet: ID %1")
                .arg(idsOf(event.stop.silent, desk)),
            {text::translate("EventWords", "Keep clear, and switch the supply off if in doubt.")},
            Tone::Bad,
            QStringLiteral("!")};
}

EventWords notLeft(const Event& event, const session::Desk& desk)
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

EventWords disconnected(const Event& event, const session::Desk& desk)
{
    EventWords words = plain(text::translate("EventWords", "Port closed: %1").arg(event.task));
    if (!event.halted.empty())
        words.line +=
            text::translate("EventWords", ". Stopped before: ID %1").arg(idsOf(event.halted, desk));
    if (!event.moving.empty()) {
        words = {words.line + text::translate("EventWords", ". STILL MOVING: ID %1")
                                  .arg(idsOf(event.moving, desk)),
                 {text::translate("EventWords", "Switch off the supply to stop it.")},
                 Tone::Bad,
                 QStringLiteral("✗")};
    }
    if (!event.locked.empty())
        words.line += text::translate("EventWords", ". EPROM lock closed: ID %1")
                          .arg(idsOf(event.locked, desk));
    if (!event.unlocked.empty()) {
        words.line += text::translate("EventWords", ". EPROM LOCK STILL OPEN: ID %1")
                          .arg(idsOf(event.unlocked, desk));
        words.more << text::translate("EventWords", "Connect again to finish or undo the write.");
        words.tone = Tone::Bad;
        words.sign = QStringLiteral("✗");
    }
    return words;
}

QString about(const Event& event, const QString& what)
{
    return event.id < 0 ? what
                        : text::translate("EventWords", "ID %1 · %2").arg(event.id).arg(what);
}

/// A new action takes the place of what was said of the one before.
EventWords moved(const Event& event)
{
    return plain(
        about(event, event.path.isEmpty()
                         ? text::translate("EventWords", "the goal follows the control")
                         : text::translate("EventWords", "goal sent: %1").arg(event.path)));
}

EventWords ended(const Event& event, const session::Desk& desk)
{
    if (event.error && event.error->code == base::ErrorCode::Preempted)
        return {}; // the stop has been said
    if (event.error && event.error->code != base::ErrorCode::Stopped)
        return failed(*event.error, desk.servo(event.servo));
    return plain(
        event.error
            ? text::translate("EventWords", "%1: stopped").arg(about(event, taskWord(event.task)))
            : text::translate("EventWords", "%1: ended").arg(about(event, taskWord(event.task))));
}

EventWords sentence(const Event& event, const session::Desk& desk)
{
    switch (event.kind) {
    case Event::Kind::Connected:
        return good(text::translate("EventWords", "Connected: %1").arg(event.task));
    case Event::Kind::Disconnected:
        return disconnected(event, desk);
    case Event::Kind::Exchanged:
        return exchanged(event, desk);
    case Event::Kind::NotLeft:
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
                                      .arg(about(event, taskWord(event.task))));
    case Event::Kind::Moved:
        return moved(event);
    case Event::Kind::Began:
        return plain(
            text::translate("EventWords", "%1: running").arg(about(event, taskWord(event.task))));
    case Event::Kind::Ended:
        return ended(event, desk);
    case Event::Kind::Stopped:
        return stopSent(event);
    case Event::Kind::StopNotSent:
        return stopNotSent(event);
    case Event::Kind::StopChecked:
        return stopChecked(event, desk);
    case Event::Kind::Failed:
        return event.error ? failed(*event.error, desk.servo(event.servo)) : EventWords{};
    }
    return {};
}
} // namespace

QString taskWord(const QString& task)
{
    static const std::pair<const char*, const char*> words[] = {
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
    for (const auto& [name, word] : words) {
        if (task == QLatin1String(name))
            return text::translate("EventWords", word);
    }
    return task;
}

EventWords describe(const Event& event, const session::Desk& desk)
{
    EventWords words = sentence(event, desk);
    for (const base::Notice& notice : event.notices) {
        const QString about =
            notice.id >= 0 ? text::translate("EventWords", "ID %1: ").arg(notice.id) : QString();
        words.more << about + text::describe(notice);
        if (notice.code != base::NoticeCode::NotRecorded)
            continue;
        words.line += text::translate("EventWords", ", NOT RECORDED");
        words.sign = QStringLiteral("✗");
        words.tone = Tone::Bad;
    }
    return words;
}
} // namespace ui
