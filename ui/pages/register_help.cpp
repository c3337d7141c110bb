// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/register_help.h"

#include "device/persistence.h"
#include "text/language.h"
#include "text/notice_words.h"
#include "text/translate.h"
#include "ui/models/memory_words.h"

namespace ui {
using catalog::Register;
using catalog::Role;
using device::Keeping;
using text::translate;

namespace {
QString listed(const QList<const Register*>& registers)
{
    QStringList words;
    for (const Register* reg : registers)
        words << QStringLiteral("%1 (%2)").arg(reg->name.in(text::inChinese())).arg(reg->address);
    words.removeDuplicates();
    return words.join(translate("RegisterHelp", ", ", "between items of a list"));
}

bool isLimit(const Register& reg)
{
    return reg.role == Role::MinAngle || reg.role == Role::MaxAngle;
}

/// True when what `reg` means follows from `decider`.
bool dependsOn(const Register& reg, const Register& decider)
{
    if (reg.scaleBy == decider.key)
        return true;
    return std::any_of(reg.variants.begin(), reg.variants.end(), [&](const catalog::Variant& v) {
        return v.whenKey == decider.key || (v.andBothLimitsZero && isLimit(decider));
    });
}

QString unitFact(const MemoryRow& row)
{
    const QString& unit = row.meaning.unit;
    if (unit.isEmpty())
        return {};
    const QString step = physicalWord(1, *row.reg, row.meaning);
    return translate("RegisterHelp", "One step: %1").arg(step);
}

QString rangeFact(const MemoryRow& row)
{
    if (!row.writable)
        return {};
    const QString raw = rangeWord(*row.reg, row.meaning, false);
    const QString physical = rangeWord(*row.reg, row.meaning, true);
    return translate("RegisterHelp", "Range: %1")
        .arg(raw == physical ? raw : QStringLiteral("%1 (%2)").arg(raw, physical));
}

QString torqueSentence(const Register& reg)
{
    switch (reg.torqueOff) {
    case catalog::TorqueOff::Needed:
        return translate("RegisterHelp",
                         "Torque has to be off while this is written: ServoDesk switches it off.");
    case catalog::TorqueOff::WhenBothZero:
        return translate("RegisterHelp", "Both limits at 0 switch the mode: ServoDesk takes torque "
                                         "off for that.");
    case catalog::TorqueOff::NotNeeded:
        break;
    }
    return {};
}
} // namespace

QStringList registerFacts(const MemoryRow& row)
{
    const Register& reg = *row.reg;
    QStringList lines;
    lines << QStringLiteral("%1 · %2 · %3")
                 .arg(reg.key, text::areaWord(reg.area),
                      text::accessWord(row.writable ? catalog::Access::ReadWrite
                                                    : catalog::Access::ReadOnly));
    lines << unitFact(row) << rangeFact(row);
    lines << (reg.defaultRaw ? translate("RegisterHelp", "Default: %1")
                                   .arg(rawWord(*reg.defaultRaw, reg, row.meaning))
                             : translate("RegisterHelp", "Default: not known"));
    lines.removeAll(QString());
    return lines;
}

QStringList registerRelations(const MemoryRow& row, const catalog::Profile& profile)
{
    QList<const Register*> deciders;
    QList<const Register*> followers;
    for (const Register& other : profile.registers) {
        if (&other == row.reg)
            continue;
        if (dependsOn(*row.reg, other))
            deciders << &other;
        if (dependsOn(other, *row.reg))
            followers << &other;
    }
    QStringList lines;
    if (!deciders.isEmpty())
        lines << translate("RegisterHelp", "Its meaning depends on: %1.").arg(listed(deciders));
    if (!deciders.isEmpty() && row.meaning.assumed)
        lines << translate("RegisterHelp",
                           "That has not been read, so the unit shown is the usual one.");
    if (!followers.isEmpty())
        lines << translate("RegisterHelp", "Depends on it: %1.").arg(listed(followers));
    if (!row.measured)
        lines << translate("RegisterHelp", "This servo has no sensor for it: the number means "
                                           "nothing.");
    lines << torqueSentence(*row.reg);
    if (row.writable && row.reg->motion)
        lines << translate("RegisterHelp", "Writing it may move the shaft or switch torque on.");
    lines.removeAll(QString());
    return lines;
}

QString keepingSentence(const Register& reg)
{
    switch (device::keepingOf(reg)) {
    case Keeping::Lock:
        return translate("RegisterHelp", "Kept after power-off: ServoDesk opens the lock, writes, "
                                         "reads back and locks again.");
    case Keeping::Always:
        return translate("RegisterHelp", "Kept after power-off: this family stores every write at "
                                         "once. ServoDesk reads it back.");
    case Keeping::Save:
        return translate("RegisterHelp", "Kept after power-off: ServoDesk writes, reads back and "
                                         "sends the save command.");
    case Keeping::Never:
        return translate("RegisterHelp", "Acts at once and is lost at power-off.");
    case Keeping::NotStated:
        return translate("RegisterHelp",
                         "Acts at once. Nobody says whether it survives power-off.");
    }
    return {};
}

bool mayWriteTemporarily(const Register& reg)
{
    const Keeping keeping = device::keepingOf(reg);
    return keeping == Keeping::Lock || keeping == Keeping::Save;
}
} // namespace ui
