// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/undo_redo.h"

#include "ui/editors/write_question.h"

namespace ui {
namespace {
std::vector<Question> questionsOf(const session::ServoRegistry& registry,
                                  const session::UndoStep& step)
{
    const session::ServoEntry* entry = registry.servo(step.servo);
    if (entry == nullptr || !entry->servo.profile)
        return {};
    return writeQuestions(*entry, step.newItems, step.temporary);
}

bool sameStep(const session::UndoStep& a, const session::UndoStep& b)
{
    const auto same = [](const device::WriteItem& one, const device::WriteItem& other) {
        return one.key == other.key && one.raw == other.raw;
    };
    return a.servo == b.servo && std::equal(a.newItems.begin(), a.newItems.end(),
                                            b.newItems.begin(), b.newItems.end(), same);
}

void confirmFrom(session::WriteService& writes, QWidget* parent, const session::UndoStep& step,
                 std::vector<Question> questions)
{
    const session::UndoStep* next = writes.redoStep();
    if (next == nullptr || !sameStep(*next, step))
        return;
    if (questions.empty()) {
        writes.redo(device::Consent::confirmed());
        return;
    }
    Question first = std::move(questions.front());
    questions.erase(questions.begin());
    first.guard = parent;
    ask(parent, first, [&writes, parent, step, questions = std::move(questions)] {
        confirmFrom(writes, parent, step, questions);
    });
}

void selectServoOf(const session::UndoStep& step, Selection& selection)
{
    if (step.servo != selection.current())
        selection.select(step.servo);
}
} // namespace

void undo(session::WriteService& writes, Selection& selection)
{
    const session::UndoStep* next = writes.undoStep();
    if (next == nullptr)
        return;
    selectServoOf(*next, selection);
    writes.undo();
}

void redo(session::WriteService& writes, const session::ServoRegistry& registry,
          Selection& selection, QWidget* parent)
{
    const session::UndoStep* next = writes.redoStep();
    if (next == nullptr)
        return;
    selectServoOf(*next, selection);
    const std::vector<Question> questions = questionsOf(registry, *next);
    if (questions.empty())
        writes.redo(); // refuses dangerous registers that it has not read
    else
        confirmFrom(writes, parent, *next, questions);
}
} // namespace ui
