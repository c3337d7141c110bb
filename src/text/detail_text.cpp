// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/detail_text.h"

#include "text/family_text.h"
#include "text/refusal_text.h"
#include "text/server_text.h"
#include "text/translate.h"

#include <array>

namespace text {
using base::ErrorCode;

namespace {
struct Token {
    const char* token;
    const char* words;
};

constexpr std::array tokens{
    Token{"given twice", QT_TRANSLATE_NOOP("text", "it is given twice")},
    Token{"acceleration", QT_TRANSLATE_NOOP("text", "it has no acceleration setting")},
    Token{"speed", QT_TRANSLATE_NOOP("text", "it has no speed setting")},
    Token{"mode", QT_TRANSLATE_NOOP("text", "its operating mode is not known")},
    Token{"damp", QT_TRANSLATE_NOOP("text", "it has no damping")},
    Token{"torque", QT_TRANSLATE_NOOP("text", "it has no torque switch")},
    Token{"position", QT_TRANSLATE_NOOP("text", "it does not report its position")},
    Token{"after-failure", QT_TRANSLATE_NOOP("text", "an earlier register did not take its value")},
    Token{"register", QT_TRANSLATE_NOOP("text", "its memory table has no such register")},
    Token{"bridge", QT_TRANSLATE_NOOP("text", "nobody could follow it through a TCP bridge")},
    Token{"garbled", QT_TRANSLATE_NOOP("text", "something answered there, but not readably")},
    Token{"illegal-function", QT_TRANSLATE_NOOP("text", "exception 1: it knows no such function")},
    Token{"illegal-address", QT_TRANSLATE_NOOP("text", "exception 2: it has no such register")},
    Token{"illegal-value",
          QT_TRANSLATE_NOOP("text", "exception 3: it does not take this value or length")},
    Token{"no such instruction", QT_TRANSLATE_NOOP("text", "its protocol has no such instruction")},
    Token{"Modbus stations are 1 to 247",
          QT_TRANSLATE_NOOP("text", "Modbus stations are 1 to 247")},
    Token{"IDs 0 to 253, rates above 0",
          QT_TRANSLATE_NOOP("text", "IDs are 0 to 253, rates above 0")},
    Token{"no port named", QT_TRANSLATE_NOOP("text", "no port is named")},
};

/// Writing these is more than a write; the detail names the command that does it.
struct Procedure {
    const char* token;
    const char* remedy;
};

constexpr std::array procedures{
    Procedure{"set-id", QT_TRANSLATE_NOOP("text", "Change the ID with set-id.")},
    Procedure{"set-baud", QT_TRANSLATE_NOOP("text", "Change the baud rate with set-baud.")},
    Procedure{"center", QT_TRANSLATE_NOOP("text", "Set the middle with center.")},
    Procedure{"torque", QT_TRANSLATE_NOOP("text", "Switch torque with torque; it then holds where "
                                                  "the servo is.")},
    Procedure{"unlock", QT_TRANSLATE_NOOP("text", "The lock is opened and closed around each write "
                                                  "by itself; there is nothing to do.")},
};

const char* procedureRemedy(const base::Error& error)
{
    if (error.code != ErrorCode::NotSupported || error.operation != QLatin1String("write"))
        return nullptr;
    for (const Procedure& procedure : procedures) {
        if (error.detail == QLatin1String(procedure.token))
            return procedure.remedy;
    }
    return nullptr;
}

bool isMoveTime(const base::Error& error)
{
    return error.operation == QLatin1String("move") && error.registerKey == QLatin1String("time");
}

/// "write KEY": there is no command for it, but a register.
QString insteadWrite(const base::Error& error)
{
    static const QString prefix = QStringLiteral("write ");
    const bool so = error.code == ErrorCode::NotSupported && error.detail.startsWith(prefix);
    return so ? error.detail.mid(prefix.size()) : QString();
}

QString notSupportedText(const base::Error& error)
{
    if (!insteadWrite(error).isEmpty())
        return translate("text", "it has no command for this");
    if (procedureRemedy(error) != nullptr)
        return translate("text", "this register is not simply written");
    if (isMoveTime(error))
        return translate("text", "this servo has no travel time in its present mode");
    return {};
}

/// "from ID": what replied, when nothing did under the ID that was asked; empty: nothing.
QString repliedInstead(const base::Error& error)
{
    static const QString prefix = QStringLiteral("from ");
    const bool foreign = error.code == ErrorCode::NoReply && error.detail.startsWith(prefix);
    return foreign ? error.detail.mid(prefix.size()) : QString();
}

/// Torque on holds a servo where it is, and it may not be there.
bool standsOutside(const base::Error& error)
{
    return error.code == ErrorCode::OutOfRange && error.operation == QLatin1String("torque");
}

QString badArgumentText(const base::Error& error)
{
    // Words of the command line are complained about in full sentences already.
    if (error.operation == QLatin1String("arguments"))
        return error.detail;
    if (isMoveTime(error))
        return translate("text", "time and speed cannot be given together");
    if (error.operation == QLatin1String("move") && error.detail.startsWith(QLatin1String("unit ")))
        return translate("text", "in this mode the goal needs its unit (%1)")
            .arg(error.detail.mid(5));
    return {};
}

/// "FOUND WRITTEN BEFORE": a value that was to be written back is no longer the one left there.
QStringList changedSince(const base::Error& error)
{
    constexpr qsizetype values = 3;
    const bool so =
        error.code == ErrorCode::Mismatch && error.operation == QLatin1String("write-back");
    const QStringList parts = so ? error.detail.split(QLatin1Char(' ')) : QStringList();
    return parts.size() == values ? parts : QStringList();
}

/// Never written over: the change may be wanted.
QString changedSinceCase(const base::Error& error)
{
    const QStringList values = changedSince(error);
    return values.isEmpty() ? QString()
                            : translate("text", "not written: the servo shows %1, where %2 was "
                                                "left; it would have become %3")
                                  .arg(values[0], values[1], values[2]);
}

const QLatin1StringView brailleMark(", brltty");

/// The port is missing because the braille service has taken the adapter.
bool adaptersClaimedByBrltty(const base::Error& error)
{
    return error.code == ErrorCode::PortMissing && error.detail.endsWith(brailleMark);
}

QString refusedText(const base::Error& error)
{
    if (error.operation == QLatin1String("arrive") && error.detail == QLatin1String("time"))
        return translate("text", "it did not come to rest in time");
    if (error.operation == QLatin1String("arrive"))
        return translate("text", "it came to rest %1 steps from its goal").arg(error.detail);
    return {};
}
} // namespace

QString detailText(const QString& detail)
{
    for (const Token& token : tokens) {
        if (detail == QLatin1String(token.token))
            return translate("text", token.words);
    }
    return detail;
}

QString specialCase(const base::Error& error)
{
    if (const RefusalText* words = serverText(error)) {
        const QString what = translate("text", words->message);
        const QString saying = serverMessage(error);
        return saying.isEmpty()
                   ? what
                   : translate("text", "%1 (%2)", "sentence, technical detail").arg(what, saying);
    }
    if (const RefusalText* words = refusalText(error)) {
        const QString held = heldByStop(error) + heldGoals(error);
        const QString what = translate("text", words->message);
        return held.isEmpty() ? what
                              : translate("text", "%1 (servos %2)", "what, IDs").arg(what, held);
    }
    if (const QString bar = writeRefusedMessage(error); !bar.isEmpty())
        return bar;
    if (const QString other = repliedInstead(error); !other.isEmpty())
        return translate("text", "no answer under this ID, but ID %1 replied").arg(other);
    if (const QString changed = changedSinceCase(error); !changed.isEmpty())
        return changed;
    switch (error.code) {
    case ErrorCode::IdentityMismatch:
        return error.detail.isEmpty()
                   ? QString()
                   : translate("text", "another servo answers under this ID: %1").arg(error.detail);
    case ErrorCode::OutOfRange:
        return standsOutside(error)
                   ? translate("text", "it stands outside its limits (%1)").arg(error.detail)
                   : QString();
    case ErrorCode::NotSupported:
        return notSupportedText(error);
    case ErrorCode::BadArgument:
        return badArgumentText(error);
    case ErrorCode::Refused:
        return refusedText(error);
    case ErrorCode::PortMissing:
        return adaptersClaimedByBrltty(error)
                   ? translate("text", "the braille service (brltty) has taken the adapter (%1)")
                         .arg(error.detail.chopped(brailleMark.size()))
                   : QString();
    case ErrorCode::PortBusy:
        return error.detail.isEmpty()
                   ? QString()
                   : translate("text", "the port is in use by %1").arg(error.detail);
    case ErrorCode::PortPermission:
        return translate("text", "the port may be opened by the group %1 only")
            .arg(owningGroup(error.detail));
    default:
        return {};
    }
}

QString specialCause(const base::Error& error)
{
    if (const RefusalText* words = refusalText(error))
        return translate("text", words->cause);
    if (const QString bar = writeRefusedCause(error); !bar.isEmpty())
        return bar;
    if (standsOutside(error))
        return translate("text", "Holding it where it is would mean a goal beyond its limits.");
    if (!repliedInstead(error).isEmpty())
        return translate("text", "The servo answers under another ID than the one it hears, or a "
                                 "second program uses the bus.");
    if (!changedSince(error).isEmpty())
        return translate("text", "Another program has changed the value since, or the servo was "
                                 "exchanged for one of its kind.");
    if (adaptersClaimedByBrltty(error))
        return translate("text", "It takes adapters with this chip for braille displays, and their "
                                 "port vanishes.");
    if (procedureRemedy(error) != nullptr)
        return translate("text", "Changing it safely takes more than writing one register.");
    return {};
}

QString specialRemedy(const base::Error& error)
{
    if (const RefusalText* words = refusalText(error))
        return translate("text", words->remedy);
    if (const QString bar = writeRefusedRemedy(error); !bar.isEmpty())
        return bar;
    if (standsOutside(error))
        return translate("text", "Turn it by hand into its range, or move it to a goal inside.");
    if (!repliedInstead(error).isEmpty())
        return translate("text", "Close other programs that use the bus, connect this servo alone, "
                                 "and search for it.");
    if (const QStringList values = changedSince(error); !values.isEmpty())
        return translate("text", "Edit the value in the table if you want %1; this step is no "
                                 "longer offered.")
            .arg(values[2]);
    if (adaptersClaimedByBrltty(error))
        return translate("text", "If nobody here reads braille, run \"sudo apt remove brltty\", "
                                 "then plug the adapter in again.");
    if (const QString key = insteadWrite(error); !key.isEmpty())
        return translate("text", "Write the register %1 instead.").arg(key);
    if (const char* remedy = procedureRemedy(error))
        return translate("text", remedy);
    if (error.code == ErrorCode::NotSupported && isMoveTime(error))
        return translate("text", "Give a speed instead of a time.");
    return {};
}

QString owningGroup(const QString& detail)
{
    return detail.isEmpty() ? QStringLiteral("dialout") : detail;
}
} // namespace text
