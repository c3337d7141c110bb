// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/register_help.h"

#include "device/persistence.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"
#include "ui/memory/memory_text.h"

namespace ui {
using catalog::Register;
using catalog::Role;
using device::Retention;
using text::translate;

namespace {
QString listed(const QList<const Register*>& registers)
{
    QStringList parts;
    for (const Register* reg : registers)
        parts << QStringLiteral("%1 (%2)").arg(text::localized(reg->name)).arg(reg->address);
    parts.removeDuplicates();
    return text::joinItems(parts);
}

bool isLimit(const Register& reg)
{
    return reg.role == Role::MinAngle || reg.role == Role::MaxAngle;
}

/// True if the meaning of `reg` follows from the value of `controlling`.
bool dependsOn(const Register& reg, const Register& controlling)
{
    if (reg.scaleBy == controlling.key)
        return true;
    return std::any_of(reg.variants.begin(), reg.variants.end(), [&](const catalog::Variant& v) {
        return v.whenKey == controlling.key || (v.andBothLimitsZero && isLimit(controlling));
    });
}

QString unitFact(const MemoryRow& row)
{
    const QString& unit = row.meaning.unit;
    if (unit.isEmpty())
        return {};
    const QString step = physicalText(1, *row.reg, row.meaning);
    return translate("RegisterHelp", "Resolution: %1").arg(step);
}

QString rangeFact(const MemoryRow& row)
{
    if (!row.isWritable)
        return {};
    const QString raw = rangeText(*row.reg, row.meaning, false);
    const QString physical = rangeText(*row.reg, row.meaning, true);
    return translate("RegisterHelp", "Range: %1")
        .arg(raw == physical ? raw : QStringLiteral("%1 (%2)").arg(raw, physical));
}

QString torqueText(const Register& reg)
{
    switch (reg.torqueOff) {
    case catalog::TorqueOff::Needed:
        return translate("RegisterHelp",
                         "Torque must be off for this write. ServoDesk turns it off first.");
    case catalog::TorqueOff::WhenBothZero:
        return translate("RegisterHelp", "Setting both angle limits to 0 switches the operating "
                                         "mode. ServoDesk turns torque off first.");
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
                 .arg(reg.key, text::areaLabel(reg.area),
                      text::accessLabel(row.isWritable ? catalog::Access::ReadWrite
                                                       : catalog::Access::ReadOnly));
    lines << unitFact(row) << rangeFact(row);
    lines << (reg.defaultRaw ? translate("RegisterHelp", "Default: %1")
                                   .arg(rawWord(*reg.defaultRaw, reg, row.meaning))
                             : translate("RegisterHelp", "Default: unknown"));
    lines.removeAll(QString());
    return lines;
}

QStringList registerRelations(const MemoryRow& row, const catalog::Profile& profile)
{
    QList<const Register*> controllingRegisters;
    QList<const Register*> dependentRegisters;
    for (const Register& other : profile.registers) {
        if (&other == row.reg)
            continue;
        if (dependsOn(*row.reg, other))
            controllingRegisters << &other;
        if (dependsOn(other, *row.reg))
            dependentRegisters << &other;
    }
    QStringList lines;
    if (!controllingRegisters.isEmpty())
        lines << translate("RegisterHelp", "The meaning of this value depends on: %1.")
                     .arg(listed(controllingRegisters));
    if (!controllingRegisters.isEmpty() && row.meaning.assumed)
        lines << translate("RegisterHelp", "The register that determines the meaning has not been "
                                           "read, so the default unit is shown.");
    if (!dependentRegisters.isEmpty())
        lines << translate("RegisterHelp", "Registers that depend on this one: %1.")
                     .arg(listed(dependentRegisters));
    if (!row.hasSensor)
        lines << translate("RegisterHelp", "This servo has no sensor for this value, so the "
                                           "number is meaningless.");
    lines << torqueText(*row.reg);
    if (row.isWritable && row.reg->motion)
        lines << translate("RegisterHelp",
                           "Writing this register may move the shaft or turn torque on.");
    lines.removeAll(QString());
    return lines;
}

QString persistenceText(const Register& reg)
{
    switch (device::retentionOf(reg)) {
    case Retention::Lock:
        return translate("RegisterHelp",
                         "Kept after power-off: ServoDesk unlocks the EPROM, writes the value, "
                         "reads it back and locks the EPROM again.");
    case Retention::Always:
        return translate("RegisterHelp", "Kept after power-off: this family stores every write "
                                         "immediately. ServoDesk reads the value back.");
    case Retention::Save:
        return translate("RegisterHelp", "Kept after power-off: ServoDesk writes the value, reads "
                                         "it back and sends the save command.");
    case Retention::Never:
        return translate("RegisterHelp", "Takes effect immediately and is lost at power-off.");
    case Retention::NotStated:
        return translate("RegisterHelp", "Takes effect immediately. Whether the value is kept "
                                         "after power-off is not documented.");
    }
    return {};
}

bool canWriteTemporarily(const Register& reg)
{
    const Retention keeping = device::retentionOf(reg);
    return keeping == Retention::Lock || keeping == Retention::Save;
}
} // namespace ui
