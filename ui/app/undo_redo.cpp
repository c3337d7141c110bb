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

void confirmFrom(session::WriteService& writes, QWidget* parent, const Direction& direction,
                 const UndoStep& step, std::vector<Question> questions)
{
    const UndoStep* next = (writes.*direction.next)();
    if (next == nullptr || !sameStep(*next, step))
        return;
    if (questions.empty()) {
        (writes.*direction.write)(device::Consent::confirmed());
        return;
    }
    Question first = std::move(questions.front());
    questions.erase(questions.begin());
    first.guard = parent;
    ask(parent, first, [&writes, parent, direction, step, questions = std::move(questions)] {
        confirmFrom(writes, parent, direction, step, questions);
    });
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
    const std::vector<Question> questions =
        entry != nullptr && entry->servo.profile
            ? writeQuestions(*entry, next->*direction.items, next->temporary)
            : std::vector<Question>{};
    if (questions.empty())
        (writes.*direction.write)({}); // refused where it needs consent after all
    else
        confirmFrom(writes, parent, direction, *next, questions);
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
