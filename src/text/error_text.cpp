// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_text.h"

#include "text/detail_text.h"
#include "text/front_end.h"
#include "text/language.h"
#include "text/text_table.h"

#include <QStringList>

#include <array>

namespace text {
using base::ErrorCode;

namespace {
struct ErrorEntry {
    ErrorCode key;
    const char* text;
    const char* cause;
    const char* remedy;
};

constexpr std::array errorEntries{
    ErrorEntry{
        ErrorCode::PortMissing, QT_TRANSLATE_NOOP("text", "port not found"),
        QT_TRANSLATE_NOOP("text", "The adapter is not plugged in, its cable has no data lines, "
                                  "or the name is misspelled."),
        QT_TRANSLATE_NOOP("text", "Plug the adapter in, use a data cable, and check the list of "
                                  "ports.")},
    ErrorEntry{ErrorCode::PortBusy, QT_TRANSLATE_NOOP("text", "the port is in use"),
               QT_TRANSLATE_NOOP("text", "Another program has opened the port. Two programs on one "
                                         "bus would receive each other's replies."),
               QT_TRANSLATE_NOOP("text", "Close the other program, or use another port.")},
    ErrorEntry{
        ErrorCode::PortPermission, QT_TRANSLATE_NOOP("text", "no permission to open the port"),
        QT_TRANSLATE_NOOP("text", "Your account does not belong to the group that owns serial "
                                  "ports."),
        QT_TRANSLATE_NOOP("text", "Run \"sudo usermod -aG %1 $USER\", then log in again.")},
    ErrorEntry{
        ErrorCode::PortFailed, QT_TRANSLATE_NOOP("text", "the port could not be opened"),
        QT_TRANSLATE_NOOP(
            "text", "The system refused access, or the other side did not accept the connection."),
        QT_TRANSLATE_NOOP(
            "text",
            "Unplug the adapter and plug it in again; for tcp://, check the host and port.")},
    ErrorEntry{
        ErrorCode::RateUnsupported,
        QT_TRANSLATE_NOOP("text", "this adapter does not support that baud rate"),
        QT_TRANSLATE_NOOP("text", "The adapter's chip or driver supports only some baud rates."),
        QT_TRANSLATE_NOOP("text", "Use another baud rate or another adapter.")},
    ErrorEntry{
        ErrorCode::LinkLost, QT_TRANSLATE_NOOP("text", "the connection was lost"),
        QT_TRANSLATE_NOOP("text", "The adapter was unplugged or lost power, or the other side "
                                  "closed the connection."),
        QT_TRANSLATE_NOOP("text", "Plug the adapter in again. If a change was in progress, check "
                                  "the interrupted writes (%recover) before you continue.")},
    ErrorEntry{ErrorCode::NoReply, QT_TRANSLATE_NOOP("text", "no reply"),
               QT_TRANSLATE_NOOP("text", "The servo has no power, a wire is loose, or the ID, baud "
                                         "rate or protocol does not match."),
               QT_TRANSLATE_NOOP("text", "Measure the voltage at the servo, check the wires, and "
                                         "search at all baud rates.")},
    ErrorEntry{ErrorCode::Garbled, QT_TRANSLATE_NOOP("text", "the reply could not be decoded"),
               QT_TRANSLATE_NOOP("text", "Possible causes: two servos with the same ID, a wrong "
                                         "baud rate, noise, long wires or no common ground."),
               QT_TRANSLATE_NOOP("text",
                                 "Connect only this servo, check the ground wire, and search "
                                 "at all baud rates.")},
    ErrorEntry{
        ErrorCode::UnexpectedReply,
        QT_TRANSLATE_NOOP("text", "the reply does not match the request"),
        QT_TRANSLATE_NOOP(
            "text",
            "Another program or controller is using the bus, or two servos have the same ID."),
        QT_TRANSLATE_NOOP("text", "Close other programs that use the bus, and connect only this "
                                  "servo.")},
    ErrorEntry{
        ErrorCode::LineBusy,
        QT_TRANSLATE_NOOP("text", "the bus is never idle: a device is sending continuously"),
        QT_TRANSLATE_NOOP(
            "text",
            "Possible causes: a device that sends data on its own, a second controller on the bus, "
            "an adapter or bridge used for something else, or noise on an open line."),
        QT_TRANSLATE_NOOP("text", "Connect only one servo, check the wires, and select the "
                                  "right port.")},
    ErrorEntry{
        ErrorCode::Uncertain,
        QT_TRANSLATE_NOOP("text", "no acknowledgment received, so it is unknown whether the "
                                  "servo executed the request"),
        QT_TRANSLATE_NOOP("text", "Possible causes: noise on the line or a voltage drop. Do not "
                                  "repeat this request without checking the servo."),
        QT_TRANSLATE_NOOP(
            "text", "Read the servo's state first, then decide whether to repeat the request.")},
    ErrorEntry{ErrorCode::Stopped, QT_TRANSLATE_NOOP("text", "stopped"),
               QT_TRANSLATE_NOOP("text", "You stopped the operation."),
               QT_TRANSLATE_NOOP("text",
                                 "Start again when you are ready; the remaining steps were not "
                                 "executed.")},
    ErrorEntry{ErrorCode::Preempted, QT_TRANSLATE_NOOP("text", "interrupted by the emergency stop"),
               QT_TRANSLATE_NOOP("text", "Torque was turned off on the whole bus."),
               QT_TRANSLATE_NOOP("text", "Make sure that nothing can move unexpectedly, then "
                                         "start again.")},
    ErrorEntry{ErrorCode::Held, QT_TRANSLATE_NOOP("text", "another task is using this servo"),
               QT_TRANSLATE_NOOP("text", "A change in progress must not be interrupted."),
               QT_TRANSLATE_NOOP("text", "Wait until the task ends, or stop it.")},
    ErrorEntry{ErrorCode::BadArgument, QT_TRANSLATE_NOOP("text", "invalid input"),
               QT_TRANSLATE_NOOP(
                   "text", "A value is malformed or missing, or it contradicts another value."),
               QT_TRANSLATE_NOOP("text", "Correct the value and try again.")},
    ErrorEntry{ErrorCode::UnknownRegister,
               QT_TRANSLATE_NOOP("text", "this servo has no register with that name"),
               QT_TRANSLATE_NOOP("text", "The name is misspelled or belongs to another family."),
               QT_TRANSLATE_NOOP("text", "Look up the name in the servo's memory table.")},
    ErrorEntry{
        ErrorCode::ReadOnly, QT_TRANSLATE_NOOP("text", "this register is read-only"),
        QT_TRANSLATE_NOOP("text", "This register is set by the factory or by the servo itself."),
        QT_TRANSLATE_NOOP("text", "Select a register that the memory table shows as "
                                  "read/write.")},
    ErrorEntry{
        ErrorCode::OutOfRange, QT_TRANSLATE_NOOP("text", "the value is outside the allowed range"),
        QT_TRANSLATE_NOOP(
            "text", "The register's range or the servo's angle limits do not allow this value."),
        QT_TRANSLATE_NOOP("text", "Use a value within the range, or change the limits first.")},
    ErrorEntry{ErrorCode::NeedsConsent,
               QT_TRANSLATE_NOOP(
                   "text", "writing to this register can make the servo unreachable or dangerous"),
               QT_TRANSLATE_NOOP("text", "This register affects the servo's communication, "
                                         "protection or direction of rotation."),
               QT_TRANSLATE_NOOP(
                   "text", "Save a snapshot, then repeat the write and confirm it explicitly.")},
    ErrorEntry{
        ErrorCode::NotSupported,
        QT_TRANSLATE_NOOP("text", "this servo does not support this operation"),
        QT_TRANSLATE_NOOP(
            "text", "The servo's family, firmware or present mode does not support this function."),
        QT_TRANSLATE_NOOP(
            "text", "Check the servo's model and mode, and use only functions that it supports.")},
    ErrorEntry{
        ErrorCode::IdInUse, QT_TRANSLATE_NOOP("text", "another servo already has this ID"),
        QT_TRANSLATE_NOOP("text", "Two servos with the same ID reply at the same time, and "
                                  "their replies collide."),
        QT_TRANSLATE_NOOP("text", "Choose a free ID, or change the ID of the other servo first.")},
    ErrorEntry{
        ErrorCode::Refused, QT_TRANSLATE_NOOP("text", "the servo did not execute the request"),
        QT_TRANSLATE_NOOP("text", "The firmware did not accept the request, the servo's protection "
                                  "has tripped, or the movement is blocked."),
        QT_TRANSLATE_NOOP("text", "Check the servo's status and mode, remove the cause, and try "
                                  "again.")},
    ErrorEntry{
        ErrorCode::Mismatch,
        QT_TRANSLATE_NOOP("text", "the value read back differs from the value written"),
        QT_TRANSLATE_NOOP(
            "text", "The firmware limits the value, or another program also wrote to the servo."),
        QT_TRANSLATE_NOOP("text", "Read the register again, and use a value that the servo "
                                  "accepts.")},
    ErrorEntry{ErrorCode::LockOpen,
               QT_TRANSLATE_NOOP("text", "the EPROM lock could not be confirmed"),
               QT_TRANSLATE_NOOP("text", "The connection failed during a change."),
               QT_TRANSLATE_NOOP("text",
                                 "Restore the connection and finish or undo the change (%recover); "
                                 "turning the servo off and on also locks the EPROM.")},
    ErrorEntry{ErrorCode::UnknownModel,
               QT_TRANSLATE_NOOP("text", "no memory table matches this servo"),
               QT_TRANSLATE_NOOP("text", "The firmware version does not belong to any known "
                                         "family, so writing could cause damage."),
               QT_TRANSLATE_NOOP(
                   "text", "Read only the servo's feedback, or add a model file for the servo.")},
    ErrorEntry{
        ErrorCode::FamilyConflict, QT_TRANSLATE_NOOP("text", "the servo family is unclear"),
        QT_TRANSLATE_NOOP(
            "text", "The servo is a variant that is not in the model list, or its identity data is "
                    "damaged. This data determines the memory table; with the wrong table, a write "
                    "would change a different register, so nothing is written."),
        QT_TRANSLATE_NOOP("text", "Connect only this servo and read it again. If the values stay "
                                  "the same, check the label on the servo. Then add a model file "
                                  "with this model number and the servo's actual family.")},
    ErrorEntry{
        ErrorCode::DuplicateId, QT_TRANSLATE_NOOP("text", "two servos reply with this ID"),
        QT_TRANSLATE_NOOP("text", "Two servos with the same ID are connected. A write "
                                  "would change both, but only one of the old values "
                                  "would be recorded."),
        QT_TRANSLATE_NOOP(
            "text",
            "Connect one servo at a time and change its ID. If only this servo is connected, check "
            "the wires and the ground, then try again; the check for duplicate IDs is repeated "
            "each time. A torque-off command still reaches both servos.")},
    ErrorEntry{ErrorCode::IdentityMismatch,
               QT_TRANSLATE_NOOP("text", "a different servo is replying with this ID"),
               QT_TRANSLATE_NOOP("text", "The servo was replaced, or its ID was changed."),
               QT_TRANSLATE_NOOP("text", "Connect the original servo, then try again.")},
    ErrorEntry{
        ErrorCode::TurnsUnknown,
        QT_TRANSLATE_NOOP("text", "the turn count of this servo is unknown"),
        QT_TRANSLATE_NOOP("text", "A multi-turn servo loses its turn count at power-off, and "
                                  "this one reports only the position within one turn."),
        QT_TRANSLATE_NOOP(
            "text",
            "Send a goal that moves the servo to a known position, or home the axis first.")},
    ErrorEntry{
        ErrorCode::AmbiguousProtocol,
        QT_TRANSLATE_NOOP("text", "this ID replies in more than one protocol"),
        QT_TRANSLATE_NOOP(
            "text", "Servos from different manufacturers share this bus and have the same ID."),
        QT_TRANSLATE_NOOP(
            "text", "Select a protocol with --protocol, or change the ID of one of the servos.")},
    ErrorEntry{ErrorCode::FileMissing, QT_TRANSLATE_NOOP("text", "file not found"),
               QT_TRANSLATE_NOOP("text", "The name is misspelled, or the file was moved."),
               QT_TRANSLATE_NOOP("text", "Check the path.")},
    ErrorEntry{
        ErrorCode::FileUnreadable, QT_TRANSLATE_NOOP("text", "the file cannot be read"),
        QT_TRANSLATE_NOOP(
            "text", "You do not have permission to read the file, or the disk reports an error."),
        QT_TRANSLATE_NOOP("text", "Check the file permissions, or use a copy.")},
    ErrorEntry{ErrorCode::FileFormat, QT_TRANSLATE_NOOP("text", "the file content is not valid"),
               QT_TRANSLATE_NOOP(
                   "text", "The file is damaged, truncated, or not the expected type of file."),
               QT_TRANSLATE_NOOP("text", "Use an undamaged copy, or create the file again.")},
    ErrorEntry{ErrorCode::FileUnwritable, QT_TRANSLATE_NOOP("text", "the file cannot be written"),
               QT_TRANSLATE_NOOP("text",
                                 "The folder is missing or read-only, or belongs to another user."),
               QT_TRANSLATE_NOOP("text", "Choose a folder you can write to.")},
    ErrorEntry{ErrorCode::DiskFull, QT_TRANSLATE_NOOP("text", "the disk is full"),
               QT_TRANSLATE_NOOP("text", "There is no space left, or your quota is used up."),
               QT_TRANSLATE_NOOP("text", "Free up some space, then try again.")},
};

QString messageFor(const base::Error& error, const ErrorEntry& entry)
{
    const QString own = specialCase(error);
    QString sentence = own.isEmpty() ? translate("text", entry.text) : own;
    if (own.isEmpty() && !error.detail.isEmpty() && error.detail != error.registerKey)
        sentence = translate("text", "%1 (%2)", "sentence, technical detail")
                       .arg(sentence, detailText(error.detail));
    const QString about = subject(error);
    if (!about.isEmpty())
        sentence = translate("text", "%1: %2", "subject: sentence").arg(about, sentence);
    if (error.attempts > 1)
        sentence += translate("text", ", %1 attempts").arg(error.attempts);
    // A question ("did you mean …?") gets no full stop.
    return sentence.endsWith(u'?') || sentence.endsWith(u'？')
               ? capitalized(sentence)
               : translate("text", "%1.", "full stop").arg(capitalized(sentence));
}

/// If a CH340 adapter disappears as soon as it is plugged in, brltty has taken it over.
QString missingPortRemedy(const base::Error& error, const QString& remedy)
{
    if (!error.detail.contains(QLatin1String("ttyUSB")))
        return remedy;
    return joinSentences(
        {remedy,
         translate(
             "text",
             "If an adapter with a CH340 chip (1a86:7523) disappears right after it is plugged "
             "in, the braille service has taken it over: run \"sudo apt remove brltty\".")});
}
} // namespace

QString subject(const base::Error& error)
{
    QStringList parts;
    if (error.id >= 0)
        parts << translate("text", "servo %1").arg(error.id);
    if (!error.registerKey.isEmpty())
        parts << error.registerKey;
    return joinItems(parts);
}

Description describe(const base::Error& error)
{
    const ErrorEntry* entry = entryFor(errorEntries, error.code);
    Description words;
    words.message = messageFor(error, *entry);
    if (error.operation == QLatin1String("torque-off-sent"))
        words.message =
            translate("text",
                      "%1 A torque-off command was sent anyway, but its effect is not confirmed.")
                .arg(words.message);
    words.cause = translate("text", entry->cause);
    words.remedy = translate("text", entry->remedy);
    if (error.code == ErrorCode::PortPermission)
        words.remedy = words.remedy.arg(owningGroup(error.detail));
    if (error.code == ErrorCode::PortMissing)
        words.remedy = missingPortRemedy(error, words.remedy);
    if (const QString own = specialCause(error); !own.isEmpty())
        words.cause = own;
    if (const QString own = specialRemedy(error); !own.isEmpty())
        words.remedy = own;
    words.remedy = withRecoveryName(words.remedy);
    return words;
}
} // namespace text
