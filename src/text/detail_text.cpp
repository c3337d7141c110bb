// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/detail_text.h"

#include "text/family_text.h"
#include "text/refusal_text.h"
#include "text/server_text.h"
#include "text/text_table.h"

#include <array>

namespace text {
using base::ErrorCode;

namespace {
constexpr std::array details{
    NamedText{"given twice", QT_TRANSLATE_NOOP("text", "specified twice")},
    NamedText{"acceleration", QT_TRANSLATE_NOOP("text", "the servo has no acceleration setting")},
    NamedText{"speed", QT_TRANSLATE_NOOP("text", "the servo has no speed setting")},
    NamedText{"mode", QT_TRANSLATE_NOOP("text", "its operating mode is unknown")},
    NamedText{"damp", QT_TRANSLATE_NOOP("text", "the servo has no damping")},
    NamedText{"torque",
              QT_TRANSLATE_NOOP("text", "torque cannot be turned on or off on this servo")},
    NamedText{"position", QT_TRANSLATE_NOOP("text", "the servo does not report its position")},
    NamedText{
        "after-failure",
        QT_TRANSLATE_NOOP("text", "the servo did not accept the value of an earlier register")},
    NamedText{"register", QT_TRANSLATE_NOOP("text", "its memory table has no such register")},
    NamedText{"bridge", QT_TRANSLATE_NOOP(
                            "text", "ServoDesk cannot switch the baud rate through a TCP bridge")},
    NamedText{"garbled", QT_TRANSLATE_NOOP("text", "its reply cannot be decoded")},
    NamedText{"illegal-function", QT_TRANSLATE_NOOP("text", "exception 1: function not supported")},
    NamedText{"illegal-address", QT_TRANSLATE_NOOP("text", "exception 2: no such register")},
    NamedText{"illegal-value",
              QT_TRANSLATE_NOOP("text", "exception 3: value or length not accepted")},
    NamedText{"no such instruction",
              QT_TRANSLATE_NOOP("text", "its protocol has no such instruction")},
    NamedText{"Modbus stations are 1 to 247",
              QT_TRANSLATE_NOOP("text", "Modbus addresses must be 1 to 247")},
    NamedText{"IDs 0 to 253, rates above 0",
              QT_TRANSLATE_NOOP("text", "IDs must be 0 to 253, and baud rates must be above 0")},
    NamedText{"no port named", QT_TRANSLATE_NOOP("text", "no port specified")},
};

/// Changing these takes more than one write; the detail names the command for it.
constexpr std::array procedures{
    NamedText{"set-id", QT_TRANSLATE_NOOP("text", "Use set-id to change the ID.")},
    NamedText{"set-baud", QT_TRANSLATE_NOOP("text", "Use set-baud to change the baud rate.")},
    NamedText{"center", QT_TRANSLATE_NOOP("text", "Use the center command to set the midpoint.")},
    NamedText{"torque", QT_TRANSLATE_NOOP(
                            "text", "Use the torque command to turn torque on or off. When torque "
                                    "is turned on, the servo holds its present position.")},
    NamedText{"unlock",
              QT_TRANSLATE_NOOP("text",
                                "Each write automatically unlocks the EPROM and locks it again.")},
};

const char* procedureRemedy(const base::Error& error)
{
    if (error.code != ErrorCode::NotSupported || error.operation != QLatin1String("write"))
        return nullptr;
    const NamedText* remedy = entryFor(procedures, error.detail);
    return remedy != nullptr ? remedy->text : nullptr;
}

bool isMoveTime(const base::Error& error)
{
    return error.operation == QLatin1String("move") && error.registerKey == QLatin1String("time");
}

/// The key in "write KEY": there is no command, but a register; empty: another detail.
QString insteadWrite(const base::Error& error)
{
    static const QString prefix = QStringLiteral("write ");
    const bool matches = error.code == ErrorCode::NotSupported && error.detail.startsWith(prefix);
    return matches ? error.detail.mid(prefix.size()) : QString();
}

QString notSupportedText(const base::Error& error)
{
    if (!insteadWrite(error).isEmpty())
        return translate("text", "the servo has no command for this");
    if (procedureRemedy(error) != nullptr)
        return translate("text", "this register cannot be written directly");
    if (isMoveTime(error))
        return translate("text", "this servo does not support a travel time in its present mode");
    return {};
}

/// The ID in "from ID": another ID replied instead of the requested one; empty: none did.
QString repliedInstead(const base::Error& error)
{
    static const QString prefix = QStringLiteral("from ");
    const bool foreign = error.code == ErrorCode::NoReply && error.detail.startsWith(prefix);
    return foreign ? error.detail.mid(prefix.size()) : QString();
}

QString repliedInsteadCase(const base::Error& error)
{
    const QString other = repliedInstead(error);
    return other.isEmpty()
               ? QString()
               : translate("text", "no reply from this ID, but ID %1 replied").arg(other);
}

/// Errors whose texts are in the tables of refusal_text and server_text.
QString refusalCase(const base::Error& error)
{
    const RefusalText* entry = refusalText(error);
    if (entry == nullptr)
        return {};
    const QString message = translate("text", entry->message);
    const QString reply = serverText(error) != nullptr ? serverMessage(error) : QString();
    if (!reply.isEmpty())
        return translate("text", "%1 (%2)", "sentence, technical detail").arg(message, reply);
    const QString held = heldByStop(error) + heldGoals(error);
    return held.isEmpty() ? message
                          : translate("text", "%1 (servos %2)", "what, IDs").arg(message, held);
}

/// Turning torque on would hold the servo at a position outside its limits.
bool standsOutside(const base::Error& error)
{
    return error.code == ErrorCode::OutOfRange && error.operation == QLatin1String("torque");
}

QString badArgumentText(const base::Error& error)
{
    // The command line has put a whole sentence into the detail.
    if (error.operation == QLatin1String("arguments"))
        return error.detail;
    if (isMoveTime(error))
        return translate("text", "time and speed cannot be combined");
    if (error.operation == QLatin1String("move") && error.detail.startsWith(QLatin1String("unit ")))
        return translate("text", "in this mode, the goal needs a unit (%1)")
            .arg(error.detail.mid(5));
    return {};
}

/// "FOUND WRITTEN BEFORE": the value to be written back was changed in the meantime.
QStringList changedSince(const base::Error& error)
{
    constexpr qsizetype values = 3;
    const bool matches =
        error.code == ErrorCode::Mismatch && error.operation == QLatin1String("write-back");
    const QStringList parts = matches ? error.detail.split(QLatin1Char(' ')) : QStringList();
    return parts.size() == values ? parts : QStringList();
}

/// Such a value is never overwritten, because the change may be intended.
QString changedSinceCase(const base::Error& error)
{
    const QStringList values = changedSince(error);
    return values.isEmpty() ? QString()
                            : translate("text", "not written: the servo has %1 instead of the "
                                                "expected %2; the new value would have been %3")
                                  .arg(values[0], values[1], values[2]);
}

const QLatin1StringView brailleMark(", brltty");

/// The braille service has taken over the adapter, so its port is missing.
bool adaptersClaimedByBrltty(const base::Error& error)
{
    return error.code == ErrorCode::PortMissing && error.detail.endsWith(brailleMark);
}

QString refusedText(const base::Error& error)
{
    if (error.operation == QLatin1String("arrive") && error.detail == QLatin1String("time"))
        return translate("text", "the servo did not stop in time");
    if (error.operation == QLatin1String("arrive"))
        return translate("text", "the servo stopped %1 steps from its goal").arg(error.detail);
    return {};
}
} // namespace

QString detailText(const QString& detail)
{
    return textFor(details, detail);
}

QString specialCase(const base::Error& error)
{
    for (const auto special :
         {refusalCase, writeRefusedMessage, repliedInsteadCase, changedSinceCase}) {
        if (const QString message = special(error); !message.isEmpty())
            return message;
    }
    switch (error.code) {
    case ErrorCode::IdentityMismatch:
        return error.detail.isEmpty()
                   ? QString()
                   : translate("text", "a different servo is replying with this ID: %1")
                         .arg(error.detail);
    case ErrorCode::OutOfRange:
        return standsOutside(error)
                   ? translate("text", "the present position is outside the servo's limits (%1)")
                         .arg(error.detail)
                   : QString();
    case ErrorCode::NotSupported:
        return notSupportedText(error);
    case ErrorCode::BadArgument:
        return badArgumentText(error);
    case ErrorCode::Refused:
        return refusedText(error);
    case ErrorCode::PortMissing:
        return adaptersClaimedByBrltty(error)
                   ? translate("text", "the braille service (brltty) has taken over the adapter "
                                       "(%1)")
                         .arg(error.detail.chopped(brailleMark.size()))
                   : QString();
    case ErrorCode::PortBusy:
        return error.detail.isEmpty()
                   ? QString()
                   : translate("text", "the port is in use by %1").arg(error.detail);
    case ErrorCode::PortPermission:
        return translate("text", "only members of the group %1 can open the port")
            .arg(owningGroup(error.detail));
    default:
        return {};
    }
}

QString specialCause(const base::Error& error)
{
    if (const RefusalText* words = refusalText(error))
        return translate("text", words->cause);
    if (const QString own = writeRefusedCause(error); !own.isEmpty())
        return own;
    if (standsOutside(error))
        return translate(
            "text",
            "To hold its present position, the servo would need a goal outside its limits.");
    if (!repliedInstead(error).isEmpty())
        return translate("text", "The servo replies with an ID other than its own, or another "
                                 "program is using the bus.");
    if (!changedSince(error).isEmpty())
        return translate("text", "Another program has changed the value, or the servo was "
                                 "replaced by one of the same model.");
    if (adaptersClaimedByBrltty(error))
        return translate("text", "The service mistakes an adapter with this chip for a braille "
                                 "display, and the adapter's port disappears.");
    if (procedureRemedy(error) != nullptr)
        return translate("text",
                         "Changing this value safely requires more than writing one register.");
    return {};
}

QString specialRemedy(const base::Error& error)
{
    if (const RefusalText* words = refusalText(error))
        return translate("text", words->remedy);
    if (const QString own = writeRefusedRemedy(error); !own.isEmpty())
        return own;
    if (standsOutside(error))
        return translate(
            "text",
            "Turn the shaft back into its range by hand, or send a goal within the limits.");
    if (!repliedInstead(error).isEmpty())
        return translate("text", "Close other programs that use the bus, connect only this "
                                 "servo, and search for it.");
    if (const QStringList values = changedSince(error); !values.isEmpty())
        return translate("text", "If you need the value %1, set it in the memory table; this undo "
                                 "or redo is no longer available.")
            .arg(values[2]);
    if (adaptersClaimedByBrltty(error))
        return translate("text", "If braille is not used on this computer, run \"sudo apt "
                                 "remove brltty\", then plug the adapter in again.");
    if (const QString key = insteadWrite(error); !key.isEmpty())
        return translate("text", "Write to register %1 instead.").arg(key);
    if (const char* remedy = procedureRemedy(error))
        return translate("text", remedy);
    if (error.code == ErrorCode::NotSupported && isMoveTime(error))
        return translate("text", "Use a speed instead of a time.");
    return {};
}

QString owningGroup(const QString& detail)
{
    return detail.isEmpty() ? QStringLiteral("dialout") : detail;
}
} // namespace text
