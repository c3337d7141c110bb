// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/redo.h"

#include "ui/memory/write_question.h"

namespace ui {
namespace {
std::vector<Question> questionsOf(const session::Desk& desk, const session::UndoStep& step)
{
    std::vector<Question> all;
    const session::ServoEntry* entry = desk.servo(step.servo);
    if (entry == nullptr || !entry->servo.profile)
        return all;
    for (const device::WriteItem& item : step.newItems) {
        const catalog::Register* reg = entry->servo.profile->find(item.key);
        if (reg == nullptr)
            continue;
        if (auto question = writeQuestion(*entry, *reg, item.raw, step.temporary))
            all.push_back(std::move(*question));
    }
    return all;
}

bool sameStep(const session::UndoStep& a, const session::UndoStep& b)
{
    const auto same = [](const device::WriteItem& one, const device::WriteItem& other) {
        return one.key == other.key && one.raw == other.raw;
    };
    return a.servo == b.servo && std::equal(a.newItems.begin(), a.newItems.end(),
                                            b.newItems.begin(), b.newItems.end(), same);
}

void confirmFrom(session::Desk& desk, QWidget* parent, const session::UndoStep& step,
                 std::vector<Question> questions)
{
    const session::UndoStep* next = desk.redoStep();
    if (next == nullptr || !sameStep(*next, step))
        return;
    if (questions.empty()) {
        desk.redo(true);
        return;
    }
    Question first = std::move(questions.front());
    questions.erase(questions.begin());
    first.guard = parent;
    ask(parent, first, [&desk, parent, step, questions = std::move(questions)] {
        confirmFrom(desk, parent, step, questions);
    });
}
} // namespace

void redo(session::Desk& desk, QWidget* parent)
{
    const session::UndoStep* next = desk.redoStep();
    if (next == nullptr)
        return;
    const std::vector<Question> questions = questionsOf(desk, *next);
    if (questions.empty())
        desk.redo(); // dangerous rows it does not know of are refused
    else
        confirmFrom(desk, parent, *next, questions);
}
} // namespace ui
