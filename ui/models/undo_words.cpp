// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/undo_words.h"

#include "text/language.h"
#include "text/translate.h"

namespace ui {
using text::translate;

namespace {
constexpr int longestName = 24;
constexpr std::size_t mostLines = 12;

QString nameOf(const session::ServoEntry* servo, const QString& key)
{
    const catalog::Register* reg =
        servo != nullptr && servo->servo.profile ? servo->servo.profile->find(key) : nullptr;
    return reg != nullptr ? reg->name.in(text::inChinese()) : key;
}

QString shortened(const QString& name)
{
    return name.size() > longestName ? name.left(longestName - 1) + QStringLiteral("…") : name;
}
} // namespace

UndoWords undoWords(const session::Desk& desk, const session::UndoStep& step, bool back)
{
    const session::ServoEntry* servo = desk.servo(step.servo);
    const auto& from = back ? step.after : step.before;
    const auto& to = back ? step.before : step.after;
    if (to.empty() || from.size() != to.size())
        return {};
    const QString id = servo != nullptr ? QString::number(servo->servo.id) : QStringLiteral("–");
    UndoWords words;
    const QString what = to.size() == 1 ? shortened(nameOf(servo, to.front().key))
                                        : translate("UndoWords", "%1 settings").arg(to.size());
    words.brief = translate("UndoWords", "ID %1 · %2").arg(id, what);
    for (std::size_t i = 0; i < to.size() && i < mostLines; ++i)
        words.lines << translate("UndoWords", "ID %1 · %2: %3 → %4")
                           .arg(id, nameOf(servo, to[i].key))
                           .arg(from[i].raw)
                           .arg(to[i].raw);
    if (to.size() > mostLines)
        words.lines << QStringLiteral("…");
    return words;
}
} // namespace ui
