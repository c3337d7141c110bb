// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/write_question.h"

#include "device/consent.h"
#include "device/write_meaning.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/editors/register_text.h"

#include <utility>

namespace ui {
using catalog::Role;
using text::translate;

namespace {
/// The mode the servo is in, and the one it would be in after the write; null while not known.
struct ModeTransition {
    const catalog::Mode* from = nullptr;
    const catalog::Mode* to = nullptr;
};

/// The value of a role's register after all pending writes.
std::optional<std::int64_t> pendingValue(const session::ServoEntry& entry, Role role)
{
    const catalog::Register* reg = entry.servo.profile->byRole(role);
    if (reg == nullptr)
        return std::nullopt;
    const auto write = entry.writes.find(reg->key);
    if (write != entry.writes.end() && write->second.pending > 0)
        return write->second.requested;
    return entry.servo.raw(*reg);
}

QString nameOf(const catalog::Register& reg)
{
    return QStringLiteral("%1 (%2)").arg(text::localized(reg.name)).arg(reg.address);
}

QString nameOf(const session::ServoEntry& entry, Role role)
{
    const catalog::Register* reg = entry.servo.profile->byRole(role);
    return reg != nullptr ? nameOf(*reg) : QString();
}

QString persistenceSentence(bool temporary)
{
    return temporary ? translate("WriteQuestion", "The value is lost at power-off.") : QString();
}

QString modeRisk(const session::ServoEntry& entry, const catalog::Mode& to)
{
    if (to.command != Role::GoalPosition)
        return translate("WriteQuestion",
                         "In this mode, the shaft turns continuously as soon as the servo receives "
                         "a command. Clear the area around the mechanism first.");
    if (to.limitsZero && entry.servo.profile->byRole(Role::MinAngle) != nullptr)
        return translate("WriteQuestion", "In this mode, the shaft is not restricted by angle "
                                          "limits. Clear the area around the mechanism first.");
    return {};
}

Question modeQuestion(const session::ServoEntry& entry, const catalog::Register& reg,
                      std::int64_t raw, const ModeTransition& step, bool temporary)
{
    const bool chinese = text::isUiChinese();
    const QString target = step.to->name.in(chinese);
    Question question;
    question.title = translate("WriteQuestion", "Change the mode to “%1”?").arg(target);
    const QString change =
        step.from != nullptr
            ? translate("WriteQuestion", "Writing %1 to %2 switches the servo from “%3” to “%4”.")
                  .arg(QString::number(raw), nameOf(reg), step.from->name.in(chinese), target)
            : translate("WriteQuestion", "Writing %1 to %2 switches the servo to “%3”.")
                  .arg(QString::number(raw), nameOf(reg), target);
    const QString command = nameOf(entry, step.to->command);
    const QString zeroed =
        step.to->command == Role::GoalPosition || command.isEmpty()
            ? QString()
            : translate("WriteQuestion", "The command register (%1) of the new mode is set to 0.")
                  .arg(command);
    question.text = text::joinSentences(
        {change,
         translate("WriteQuestion",
                   "ServoDesk turns torque off, writes the value and reads it back."),
         zeroed, translate("WriteQuestion", "Torque stays off until you turn it on."),
         persistenceSentence(temporary)});
    question.risk = modeRisk(entry, *step.to);
    question.acceptText = translate("WriteQuestion", "Change mode");
    return question;
}

QString limitsRisk()
{
    return translate("WriteQuestion",
                     "With both angle limits at 0, the shaft can turn without limit.");
}

QString roleRisk(const catalog::Register& reg, std::int64_t raw)
{
    if (device::classify(reg, raw).procedure == device::WriteProcedure::Center)
        return translate("WriteQuestion",
                         "The present position becomes the midpoint. Afterwards, every position "
                         "corresponds to a different angle than before, in other programs too.");
    switch (reg.role) {
    case Role::Id:
        return translate("WriteQuestion", "After this, the servo replies as ID %1. Programs that "
                                          "use the old ID will no longer find it.")
            .arg(raw);
    case Role::BaudRate:
        return translate("WriteQuestion",
                         "The servo switches to another baud rate. ServoDesk switches "
                         "automatically; other programs and servos keep the old baud rate.");
    case Role::ResponseLevel:
    case Role::ReturnDelay:
        return translate("WriteQuestion", "Programs that expect the previous reply behavior may "
                                          "report the servo as lost.");
    case Role::UnloadCondition:
        return translate(
            "WriteQuestion",
            "With protection turned off, the motor can burn out and the gears can break.");
    case Role::Phase:
        return translate("WriteQuestion",
                         "This changes the direction, feedback and drive of the motor. A wrong "
                         "value can make the motor run out of control.");
    case Role::PositionOffset:
    case Role::AngleResolution:
        return translate("WriteQuestion",
                         "Afterwards, every position corresponds to a different angle than before. "
                         "Clear the area around the mechanism before turning torque on.");
    case Role::MinAngle:
    case Role::MaxAngle:
        return limitsRisk();
    default:
        return translate("WriteQuestion", "A wrong value can make the servo unreachable or "
                                          "dangerous. Note the old value before you continue.");
    }
}

/// What one of the writes asks.
struct Asked {
    Question question; ///< where it is the only one
    QString line;      ///< the change, among others
    QString torque;    ///< what becomes of torque; empty: nothing
};

Asked askedOfDangerous(const session::ServoEntry& entry, const catalog::Register& reg,
                       std::int64_t raw, bool temporary)
{
    const catalog::ValueFormat meaning = entry.servo.meaning(reg);
    const auto present = entry.displayedRaw(reg);
    Question question;
    question.title = translate("WriteQuestion", "Write %1?").arg(nameOf(reg));
    const QString change =
        present ? translate("WriteQuestion", "Old value: %1. New value: %2.")
                      .arg(rawWord(*present, reg, meaning), rawWord(raw, reg, meaning))
                : translate("WriteQuestion", "New value: %1. The present value could not be read.")
                      .arg(rawWord(raw, reg, meaning));
    const QString torque =
        reg.torqueOff == catalog::TorqueOff::Needed
            ? translate("WriteQuestion", "Torque is turned off first and stays off.")
            : QString();
    question.text = change + QStringLiteral("\n\n") + text::localized(reg.help) +
                    (torque.isEmpty() && !temporary
                         ? QString()
                         : QStringLiteral("\n\n") +
                               text::joinSentences({torque, persistenceSentence(temporary)}));
    question.risk = text::joinSentences(
        {device::classify(reg, raw).moves
             ? translate(
                   "WriteQuestion",
                   "The shaft turns as soon as the value is written. Keep clear of the mechanism.")
             : QString(),
         roleRisk(reg, raw)});
    question.acceptText = translate("WriteQuestion", "Write");
    return {question, translate("WriteQuestion", "%1: %2").arg(nameOf(reg), change), torque};
}

ModeTransition modeTransition(const session::ServoEntry& entry,
                              const std::vector<device::WriteItem>& items)
{
    const catalog::Profile& profile = *entry.servo.profile;
    const auto after = [&](Role role) {
        const catalog::Register* reg = profile.byRole(role);
        for (const device::WriteItem& item : items) {
            if (reg != nullptr && item.key == reg->key)
                return std::optional(item.raw);
        }
        return pendingValue(entry, role);
    };
    return {device::modeFor(profile, pendingValue(entry, Role::OperatingMode),
                            pendingValue(entry, Role::MinAngle),
                            pendingValue(entry, Role::MaxAngle)),
            device::modeFor(profile, after(Role::OperatingMode), after(Role::MinAngle),
                            after(Role::MaxAngle))};
}

bool isAngleLimit(const catalog::Register& reg)
{
    return reg.role == Role::MinAngle || reg.role == Role::MaxAngle;
}

/// Of the mode, or else the last of the limits; null: none of them decides the mode.
const device::WriteItem* modeItem(const catalog::Profile& profile,
                                  const std::vector<device::WriteItem>& items)
{
    const device::WriteItem* found = nullptr;
    for (const device::WriteItem& item : items) {
        const catalog::Register* reg = profile.find(item.key);
        if (reg != nullptr && reg->role == Role::OperatingMode)
            return &item;
        if (reg != nullptr && isAngleLimit(*reg))
            found = &item;
    }
    return found;
}

/// Together with the limits that are on their way.
bool removesLimits(const session::ServoEntry& entry, const std::vector<device::WriteItem>& items)
{
    device::RegisterValues values;
    for (const device::WriteItem& item : items) {
        if (const catalog::Register* reg = entry.servo.profile->find(item.key))
            values.push_back({reg, item.raw});
    }
    for (const Role role : {Role::MinAngle, Role::MaxAngle}) {
        if (const auto pending = pendingValue(entry, role)) // where an item has it, that counts
            values.push_back({entry.servo.profile->byRole(role), *pending});
    }
    return device::removesAngleLimits(entry.servo, values);
}

std::vector<Asked> askedOf(const session::ServoEntry& entry,
                           const std::vector<device::WriteItem>& items, bool temporary)
{
    const catalog::Profile& profile = *entry.servo.profile;
    const ModeTransition step = modeTransition(entry, items);
    const bool changesMode = step.to != nullptr && step.to != step.from;
    const device::WriteItem* const mode = changesMode ? modeItem(profile, items) : nullptr;
    const bool losesLimits = removesLimits(entry, items);
    bool limitsAreAsked = mode != nullptr || !losesLimits;
    std::vector<Asked> all;
    for (const device::WriteItem& item : items) {
        const catalog::Register* reg = profile.find(item.key);
        if (reg == nullptr)
            continue;
        if (&item == mode) {
            Question question = modeQuestion(entry, *reg, item.raw, step, temporary);
            if (losesLimits && !step.to->limitsZero)
                question.risk = text::joinSentences({question.risk, limitsRisk()});
            all.push_back({question, question.text, {}});
        } else if (device::classify(*reg, item.raw).needsConsent ||
                   (isAngleLimit(*reg) && !std::exchange(limitsAreAsked, true))) {
            all.push_back(askedOfDangerous(entry, *reg, item.raw, temporary));
        }
    }
    return all;
}

/// One for all: each change is a line, without what the register is for.
Question combined(const std::vector<Asked>& all, bool temporary)
{
    Question question;
    QStringList lines;
    QStringList risks;
    QString torque;
    for (const Asked& one : all) {
        lines << one.line;
        if (!risks.contains(one.question.risk))
            risks << one.question.risk;
        if (torque.isEmpty())
            torque = one.torque;
    }
    const auto count = static_cast<int>(all.size());
    question.title =
        translate("WriteQuestion", "Write %n setting(s) that need confirmation?", nullptr, count);
    question.text = lines.join(QLatin1Char('\n'));
    const QString rest = text::joinSentences({torque, persistenceSentence(temporary)});
    if (!rest.isEmpty())
        question.text += QStringLiteral("\n\n") + rest;
    question.risk = text::joinSentences(risks);
    question.acceptText = translate("WriteQuestion", "Write");
    return question;
}
} // namespace

std::optional<Question> writeQuestion(const session::ServoEntry& entry,
                                      const std::vector<device::WriteItem>& items, bool temporary)
{
    std::vector<Asked> all = askedOf(entry, items, temporary);
    if (all.empty())
        return std::nullopt;
    return all.size() == 1 ? std::move(all.front().question) : combined(all, temporary);
}
} // namespace ui
