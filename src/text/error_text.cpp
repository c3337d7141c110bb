// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_text.h"

#include "text/detail_text.h"
#include "text/front_end.h"
#include "text/translate.h"

#include <QStringList>

#include <array>

namespace text {
using base::ErrorCode;

namespace {
struct ErrorEntry {
    ErrorCode code;
    const char* what;
    const char* cause;
    const char* remedy;
};

constexpr std::array portEntries{
    ErrorEntry{
        ErrorCode::PortMissing, QT_TRANSLATE_NOOP("text", "there is no such port"),
        QT_TRANSLATE_NOOP("text", "The adapter is not plugged in, its cable carries power only, "
                                  "or the name is misspelt."),
        QT_TRANSLATE_NOOP("text", "Plug the adapter in, use a data cable, and look at the list "
                                  "of ports.")},
    ErrorEntry{ErrorCode::PortBusy, QT_TRANSLATE_NOOP("text", "the port is in use"),
               QT_TRANSLATE_NOOP("text",
                                 "Another program has opened it; two programs on one bus would "
                                 "steal each other's answers."),
               QT_TRANSLATE_NOOP("text", "Close the other program, or use another port.")},
    ErrorEntry{ErrorCode::PortPermission, QT_TRANSLATE_NOOP("text", "the port may not be opened"),
               QT_TRANSLATE_NOOP("text",
                                 "Your account does not belong to the group that owns serial "
                                 "ports."),
               QT_TRANSLATE_NOOP("text", "Run \"sudo usermod -aG %1 $USER\", then log in again.")},
    ErrorEntry{
        ErrorCode::PortFailed, QT_TRANSLATE_NOOP("text", "the port could not be opened"),
        QT_TRANSLATE_NOOP("text", "The system refused it, or the other end did not accept the "
                                  "connection."),
        QT_TRANSLATE_NOOP("text", "Unplug the adapter and plug it in again; for tcp:// check host "
                                  "and port.")},
    ErrorEntry{ErrorCode::RateUnsupported,
               QT_TRANSLATE_NOOP("text", "this adapter cannot run at that baud rate"),
               QT_TRANSLATE_NOOP("text", "Its chip or driver knows only some of the rates."),
               QT_TRANSLATE_NOOP("text", "Choose another baud rate, or use another adapter.")},
    ErrorEntry{
        ErrorCode::LinkLost, QT_TRANSLATE_NOOP("text", "the connection broke off"),
        QT_TRANSLATE_NOOP("text", "The adapter was unplugged, its supply failed, or the far end "
                                  "closed the connection."),
        QT_TRANSLATE_NOOP("text", "Plug it in again. If a change was going on, look at the open "
                                  "changes (%recover) before anything else.")},
};

constexpr std::array wireEntries{
    ErrorEntry{
        ErrorCode::NoReply, QT_TRANSLATE_NOOP("text", "no answer"),
        QT_TRANSLATE_NOOP("text", "No supply at the servo, a loose lead, another ID, another baud "
                                  "rate, or another protocol."),
        QT_TRANSLATE_NOOP("text", "Measure the voltage at the servo, check the lead, and search "
                                  "all baud rates.")},
    ErrorEntry{
        ErrorCode::Garbled,
        QT_TRANSLATE_NOOP("text", "something answered, but nothing readable came"),
        QT_TRANSLATE_NOOP("text", "Two servos with one ID, a wrong baud rate, noise, long leads "
                                  "or no common ground."),
        QT_TRANSLATE_NOOP("text", "Connect this servo alone, check the ground lead, and search "
                                  "all baud rates.")},
    ErrorEntry{
        ErrorCode::UnexpectedReply,
        QT_TRANSLATE_NOOP("text", "the answer does not belong to the question"),
        QT_TRANSLATE_NOOP("text", "A second program or master on the bus, or two servos with one "
                                  "ID."),
        QT_TRANSLATE_NOOP("text", "Close other programs that use the bus, and connect this servo "
                                  "alone.")},
    ErrorEntry{
        ErrorCode::LineBusy,
        QT_TRANSLATE_NOOP("text", "the line never falls silent: something sends continuously"),
        QT_TRANSLATE_NOOP("text", "A device that sends on its own, a second master on the bus, "
                                  "an adapter or bridge set to another purpose, or noise on an "
                                  "open line."),
        QT_TRANSLATE_NOOP("text", "Disconnect everything but one servo, check the leads, and "
                                  "choose the right port.")},
    ErrorEntry{
        ErrorCode::Uncertain,
        QT_TRANSLATE_NOOP("text", "the acknowledgement was lost, so it is not known whether the "
                                  "servo did it"),
        QT_TRANSLATE_NOOP("text", "A disturbed wire or a supply that dips. This request must not "
                                  "be repeated blindly."),
        QT_TRANSLATE_NOOP("text", "Read the servo's state first, then decide whether to do it "
                                  "again.")},
    ErrorEntry{ErrorCode::Stopped, QT_TRANSLATE_NOOP("text", "stopped"),
               QT_TRANSLATE_NOOP("text", "You asked for it."),
               QT_TRANSLATE_NOOP("text",
                                 "Start again when you are ready; what was not done yet has not "
                                 "been touched.")},
    ErrorEntry{ErrorCode::Preempted, QT_TRANSLATE_NOOP("text", "interrupted by the emergency stop"),
               QT_TRANSLATE_NOOP("text", "Torque was taken off the whole bus."),
               QT_TRANSLATE_NOOP("text", "Make sure that nothing can move, then start again.")},
    ErrorEntry{ErrorCode::Held, QT_TRANSLATE_NOOP("text", "another task owns this servo now"),
               QT_TRANSLATE_NOOP("text", "A change is going on that must not be disturbed."),
               QT_TRANSLATE_NOOP("text", "Wait until it has ended, or stop it.")},
};

constexpr std::array requestEntries{
    ErrorEntry{
        ErrorCode::BadArgument, QT_TRANSLATE_NOOP("text", "this cannot be understood"),
        QT_TRANSLATE_NOOP("text", "A value is malformed, missing, or contradicts another one."),
        QT_TRANSLATE_NOOP("text", "Correct the value and try again.")},
    ErrorEntry{ErrorCode::UnknownRegister,
               QT_TRANSLATE_NOOP("text", "this servo has no register of that name"),
               QT_TRANSLATE_NOOP("text", "The name is misspelt, or belongs to another family."),
               QT_TRANSLATE_NOOP("text", "Look the name up in the servo's memory table.")},
    ErrorEntry{ErrorCode::ReadOnly, QT_TRANSLATE_NOOP("text", "this register can only be read"),
               QT_TRANSLATE_NOOP("text", "It is set by the factory or by the servo itself."),
               QT_TRANSLATE_NOOP("text", "Choose a register that the memory table shows as "
                                         "read/write.")},
    ErrorEntry{
        ErrorCode::OutOfRange, QT_TRANSLATE_NOOP("text", "the value is outside what is allowed"),
        QT_TRANSLATE_NOOP("text", "The register's range, or the servo's own angle limits, do not "
                                  "permit it."),
        QT_TRANSLATE_NOOP("text", "Give a value inside the range, or change the limits first.")},
    ErrorEntry{
        ErrorCode::NeedsConsent,
        QT_TRANSLATE_NOOP("text", "this register can make the servo unreachable or dangerous"),
        QT_TRANSLATE_NOOP("text", "It decides how the servo is addressed, protected or turns."),
        QT_TRANSLATE_NOOP("text", "Save a snapshot, then repeat the write with your explicit "
                                  "consent.")},
    ErrorEntry{
        ErrorCode::NotSupported, QT_TRANSLATE_NOOP("text", "this servo cannot do that"),
        QT_TRANSLATE_NOOP("text", "Its family, firmware or present mode has no such thing."),
        QT_TRANSLATE_NOOP("text", "Look at the servo's model and mode, and use what it offers.")},
};

constexpr std::array servoEntries{
    ErrorEntry{
        ErrorCode::IdInUse, QT_TRANSLATE_NOOP("text", "another servo already has that ID"),
        QT_TRANSLATE_NOOP("text", "Two servos with one ID answer at the same time and garble each "
                                  "other."),
        QT_TRANSLATE_NOOP("text", "Choose a free ID, or give the other servo a new one first.")},
    ErrorEntry{
        ErrorCode::Refused, QT_TRANSLATE_NOOP("text", "the servo did not do it"),
        QT_TRANSLATE_NOOP("text", "Its firmware does not accept this, a protection has tripped, "
                                  "or something is in the way."),
        QT_TRANSLATE_NOOP("text", "Look at the servo's status and mode, clear what blocks it, and "
                                  "try again.")},
    ErrorEntry{
        ErrorCode::Mismatch,
        QT_TRANSLATE_NOOP("text", "the servo shows another value than the one written"),
        QT_TRANSLATE_NOOP("text", "The firmware limits the value, or a second program wrote too."),
        QT_TRANSLATE_NOOP("text", "Read the register again, and choose a value the servo "
                                  "accepts.")},
    ErrorEntry{
        ErrorCode::LockOpen, QT_TRANSLATE_NOOP("text", "the EPROM lock could not be proven closed"),
        QT_TRANSLATE_NOOP("text", "The connection failed in the middle of a change."),
        QT_TRANSLATE_NOOP("text", "Restore the connection and finish or undo the change "
                                  "(%recover); switching the servo off closes the lock too.")},
    ErrorEntry{
        ErrorCode::UnknownModel, QT_TRANSLATE_NOOP("text", "no memory table fits this servo"),
        QT_TRANSLATE_NOOP("text", "Its firmware version belongs to no known family, so writing "
                                  "could do damage."),
        QT_TRANSLATE_NOOP("text", "Read its feedback only, or add a model file for it.")},
    ErrorEntry{
        ErrorCode::FamilyConflict, QT_TRANSLATE_NOOP("text", "its family is unclear"),
        QT_TRANSLATE_NOOP("text", "A variant that the model list does not know, or a damaged "
                                  "identity. These facts choose the memory table; with the wrong "
                                  "table a write changes another register, so nothing is written."),
        QT_TRANSLATE_NOOP("text", "Connect this servo alone and read it again. If the values stay "
                                  "the same, check the label on the servo, then add a model file "
                                  "that lists this model number with its real family.")},
    ErrorEntry{ErrorCode::DuplicateId, QT_TRANSLATE_NOOP("text", "two servos answer under this ID"),
               QT_TRANSLATE_NOOP("text", "Two servos with the same ID are connected. A write would "
                                         "change both, and only one of the old values would be "
                                         "recorded."),
               QT_TRANSLATE_NOOP("text",
                                 "Connect one servo at a time and change its ID. If only this "
                                 "servo is connected, check leads and ground, then try again: "
                                 "every attempt looks afresh. Switching torque off still "
                                 "reaches both.")},
    ErrorEntry{ErrorCode::IdentityMismatch,
               QT_TRANSLATE_NOOP("text", "another servo answers under this ID"),
               QT_TRANSLATE_NOOP("text", "The servo was exchanged since, or its ID was changed."),
               QT_TRANSLATE_NOOP("text", "Connect the servo that is meant, then try again.")},
    ErrorEntry{ErrorCode::TurnsUnknown,
               QT_TRANSLATE_NOOP("text", "it is not known how many turns this servo has made"),
               QT_TRANSLATE_NOOP("text",
                                 "A multi-turn servo forgets its turns at power-off, and this "
                                 "one reports a single turn only."),
               QT_TRANSLATE_NOOP("text", "Move it to a known position with a goal of your own, or "
                                         "reference the axis first.")},
    ErrorEntry{ErrorCode::AmbiguousProtocol,
               QT_TRANSLATE_NOOP("text", "this ID answers in more than one protocol"),
               QT_TRANSLATE_NOOP("text", "Servos of different makes share the line and the ID."),
               QT_TRANSLATE_NOOP("text", "Say which is meant with --protocol, or give one of them "
                                         "another ID.")},
};

constexpr std::array fileEntries{
    ErrorEntry{ErrorCode::FileMissing, QT_TRANSLATE_NOOP("text", "there is no such file"),
               QT_TRANSLATE_NOOP("text", "The name is misspelt, or the file was moved."),
               QT_TRANSLATE_NOOP("text", "Check the path.")},
    ErrorEntry{ErrorCode::FileUnreadable, QT_TRANSLATE_NOOP("text", "the file cannot be read"),
               QT_TRANSLATE_NOOP("text", "You may not read it, or the disk reports an error."),
               QT_TRANSLATE_NOOP("text", "Check its permissions, or use a copy.")},
    ErrorEntry{ErrorCode::FileFormat,
               QT_TRANSLATE_NOOP("text", "the file is not what it should be"),
               QT_TRANSLATE_NOOP("text", "It is damaged, cut short, or of another kind."),
               QT_TRANSLATE_NOOP("text", "Use an undamaged copy, or make the file anew.")},
    ErrorEntry{ErrorCode::FileUnwritable, QT_TRANSLATE_NOOP("text", "the file cannot be written"),
               QT_TRANSLATE_NOOP("text",
                                 "The folder is missing or read-only, or belongs to somebody "
                                 "else."),
               QT_TRANSLATE_NOOP("text", "Choose a place you may write to.")},
    ErrorEntry{ErrorCode::DiskFull, QT_TRANSLATE_NOOP("text", "the disk is full"),
               QT_TRANSLATE_NOOP("text", "There is no room left, or your quota is used up."),
               QT_TRANSLATE_NOOP("text", "Make room, then try again.")},
};

template <typename Entries>
const ErrorEntry* findIn(const Entries& entries, ErrorCode code)
{
    for (const ErrorEntry& entry : entries) {
        if (entry.code == code)
            return &entry;
    }
    return nullptr;
}

const ErrorEntry* entryFor(ErrorCode code)
{
    const ErrorEntry* found = nullptr;
    for (const ErrorEntry* candidate :
         {findIn(portEntries, code), findIn(wireEntries, code), findIn(requestEntries, code),
          findIn(servoEntries, code), findIn(fileEntries, code)})
        found = candidate != nullptr ? candidate : found;
    return found;
}

QString capitalized(QString sentence)
{
    if (!sentence.isEmpty())
        sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString messageFor(const base::Error& error, const ErrorEntry& entry)
{
    const QString own = specialCase(error);
    QString sentence = own.isEmpty() ? translate("text", entry.what) : own;
    if (own.isEmpty() && !error.detail.isEmpty() && error.detail != error.registerKey)
        sentence = translate("text", "%1 (%2)", "sentence, technical detail")
                       .arg(sentence, detailText(error.detail));
    const QString who = subject(error);
    if (!who.isEmpty())
        sentence = translate("text", "%1: %2", "subject: sentence").arg(who, sentence);
    if (error.attempts > 1)
        sentence += translate("text", ", tried %1 times").arg(error.attempts);
    // A question ("did you mean …?") ends itself.
    return sentence.endsWith(u'?') || sentence.endsWith(u'？')
               ? capitalized(sentence)
               : translate("text", "%1.", "full stop").arg(capitalized(sentence));
}

/// A CH340 adapter that vanishes the moment it is plugged in has been taken by brltty.
QString missingPortRemedy(const base::Error& error, const QString& remedy)
{
    if (!error.detail.contains(QLatin1String("ttyUSB")))
        return remedy;
    return remedy + QLatin1Char(' ') +
           translate("text", "If an adapter with a CH340 chip (1a86:7523) appears and vanishes at "
                             "once, the braille service has taken it: \"sudo apt remove brltty\".");
}
} // namespace

QString subject(const base::Error& error)
{
    QStringList parts;
    if (error.id >= 0)
        parts << translate("text", "servo %1").arg(error.id);
    if (!error.registerKey.isEmpty())
        parts << error.registerKey;
    return parts.join(QStringLiteral(", "));
}

Description describe(const base::Error& error)
{
    const ErrorEntry* entry = entryFor(error.code);
    Description words;
    words.message = messageFor(error, *entry);
    if (error.operation == QLatin1String("torque-off-sent"))
        words.message =
            translate("text", "%1 Torque off was sent all the same; nothing proves that "
                              "it took effect.")
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
