// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/undo_redo.h"

#include "ui/editors/write_question.h"

namespace ui {
namespace {
using session::UndoStep;

/// Undo writes the old values of a step, redo its new ones.
struct Direction {
    const UndoStep* (session::WriteService::*next)() const;
    void (session::WriteService::*write)(device::Consent);
    std::vector<device::WriteItem> UndoStep::*items;
};
constexpr Direction undoing{&session::WriteService::undoStep, &session::WriteService::undo,
                            &UndoStep::oldItems};
constexpr Direction redoing{&session::WriteService::redoStep, &session::WriteService::redo,
                            &UndoStep::newItems};

bool sameStep(const UndoStep& a, const UndoStep& b)
{
    const auto same = [](const device::WriteItem& one, const device::WriteItem& other) {
        return one.key == other.key && one.raw == other.raw;
    };
    return a.servo == b.servo && std::equal(a.newItems.begin(), a.newItems.end(),
                                            b.newItems.begin(), b.newItems.end(), same);
}

void writeStep(session::WriteService& writes, const session::ServoRegistry& registry,
               Selection& selection, QWidget* parent, const Direction& direction)
{
    const UndoStep* next = (writes.*direction.next)();
    if (next == nullptr)
        return;
    if (next->servo != selection.current())
        selection.select(next->servo);
    const session::ServoEntry* entry = registry.servo(next->servo);
    auto question = entry != nullptr && entry->servo.profile
                        ? writeQuestion(*entry, next->*direction.items, next->temporary)
                        : std::nullopt;
    if (!question)
        return (writes.*direction.write)({}); // refused where it needs consent after all
    question->guard = parent;
    ask(parent, *question, [&writes, direction, step = *next] {
        const UndoStep* now = (writes.*direction.next)();
        if (now != nullptr && sameStep(*now, step))
            (writes.*direction.write)(device::Consent::confirmed());
    });
}
} // namespace

void undo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent)
{
    writeStep(writes, registry, selection, parent, undoing);
}

void redo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent)
{
    writeStep(writes, registry, selection, parent, redoing);
}
} // namespace ui
