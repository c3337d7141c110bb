// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/undo_text.h"

#include "text/language.h"
#include "text/translate.h"

namespace ui {
using text::translate;

namespace {
constexpr int maxNameLength = 24;
constexpr std::size_t maxLines = 12;

QString nameOf(const session::ServoEntry* servo, const QString& key)
{
    return text::registerName(servo != nullptr ? servo->servo.profile.get() : nullptr, key);
}

QString elided(const QString& name)
{
    return name.size() > maxNameLength ? name.left(maxNameLength - 1) + QStringLiteral("…") : name;
}
} // namespace

UndoText undoText(const session::ServoRegistry& registry, const session::UndoStep& step, bool undo)
{
    const session::ServoEntry* servo = registry.servo(step.servo);
    const auto& from = undo ? step.newItems : step.oldItems;
    const auto& to = undo ? step.oldItems : step.newItems;
    if (to.empty() || from.size() != to.size())
        return {};
    const QString id = servo != nullptr ? QString::number(servo->servo.id) : QStringLiteral("–");
    UndoText words;
    const QString what = to.size() == 1
                             ? elided(nameOf(servo, to.front().key))
                             : translate("UndoText", "%n setting(s)", nullptr, int(to.size()));
    words.brief = translate("UndoText", "ID %1 · %2").arg(id, what);
    for (std::size_t i = 0; i < to.size() && i < maxLines; ++i)
        words.lines << translate("UndoText", "ID %1 · %2: %3 → %4")
                           .arg(id, nameOf(servo, to[i].key))
                           .arg(from[i].raw)
                           .arg(to[i].raw);
    if (to.size() > maxLines)
        words.lines << QStringLiteral("…");
    return words;
}
} // namespace ui
