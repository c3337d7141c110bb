// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/register_input.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "text/language.h"

namespace cli {
namespace {
QString expectation(const catalog::Register& reg, const catalog::ValueFormat& meaning)
{
    QStringList kinds;
    if (meaning.min && meaning.max)
        kinds << translate("cli", "a raw value from %1 to %2").arg(*meaning.min).arg(*meaning.max);
    else
        kinds << translate("cli", "a raw value");
    if (!meaning.unit.isEmpty())
        kinds << translate("cli", "a value with its unit (%1)").arg(meaning.unit);
    QStringList names;
    for (const catalog::NamedValue& value : reg.values)
        names << value.key;
    if (!names.isEmpty())
        kinds << translate("cli", "one of %1").arg(text::joinItems(names));
    return kinds.join(translate("cli", ", or ", "between alternatives"));
}
} // namespace

base::Result<std::int64_t> parseRegisterValue(const device::Servo& servo,
                                              const catalog::Register& reg, const QString& text)
{
    const catalog::ValueFormat meaning = servo.meaning(reg);
    const auto raw = catalog::parseValue(text, reg, meaning);
    if (raw)
        return raw;
    base::Error error = raw.error();
    error.id = servo.id;
    error.registerKey = reg.key;
    error.detail =
        translate("cli", "\"%1\" is not valid; expected: %2").arg(text, expectation(reg, meaning));
    return tl::unexpected(error);
}

base::Result<std::vector<device::WriteItem>> parseWriteItems(const device::Servo& servo,
                                                             const QStringList& words)
{
    std::vector<device::WriteItem> items;
    for (const QString& word : words) {
        const auto assignment = parseAssignment(word);
        if (!assignment)
            return tl::unexpected(assignment.error());
        const auto reg = findRegister(*servo.profile, assignment->first, servo.id);
        if (!reg)
            return tl::unexpected(reg.error());
        const auto raw = parseRegisterValue(servo, **reg, assignment->second);
        if (!raw)
            return tl::unexpected(raw.error());
        items.push_back({(*reg)->key, *raw});
    }
    return items;
}
} // namespace cli
