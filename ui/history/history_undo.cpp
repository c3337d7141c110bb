// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_undo.h"

#include "device/write_meaning.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/editors/write_question.h"

namespace ui {
using text::translate;

namespace {
/// The servo in the list that this one of the history is; null: it is not there.
const session::ServoEntry* connectedServo(const session::Workbench& workbench,
                                          const history::HistoryServo* servo)
{
    if (servo == nullptr || workbench.link().state() != session::LinkState::Open)
        return nullptr;
    for (const session::ServoRef ref : workbench.registry().order()) {
        const session::ServoEntry* entry = workbench.registry().servo(ref);
        const base::ServoIdentity now = entry->servo.identity();
        if (now.id == servo->identity.id && now.isSameKind(servo->identity) &&
            now.isSimulated() == servo->identity.isSimulated())
            return entry;
    }
    return nullptr;
}
} // namespace

QString undoRefusal(const session::Workbench& workbench, const history::HistoryWrite& write,
                    const history::HistoryServo* servo)
{
    const session::ServoEntry* entry = connectedServo(workbench, servo);
    const catalog::Register* reg =
        entry != nullptr && entry->servo.profile ? entry->servo.profile->find(write.key) : nullptr;
    if (reg == nullptr)
        return translate("History", "This servo is not connected.");
    const device::WriteMeaning meaning = device::classify(*reg, write.oldRaw);
    if (meaning.changesAddress())
        return translate(
            "History",
            "To change the ID or baud rate back, use Servo → Set ID or Servo → Set baud rate.");
    if (meaning.procedure != device::WriteProcedure::Register || meaning.isMotion() ||
        reg->access != catalog::Access::ReadWrite || !write.newRaw)
        return translate("History",
                         "This entry is an action, not a value that can be written back.");
    if (entry->displayedRaw(*reg) == write.oldRaw)
        return translate("History", "The register already holds the old value.");
    return {};
}

void askToUndo(QWidget* page, session::Workbench& workbench, const history::HistoryWrite& write,
               const history::HistoryServo* servo)
{
    if (!undoRefusal(workbench, write, servo).isEmpty())
        return;
    const session::ServoEntry& entry = *connectedServo(workbench, servo);
    const catalog::Register& reg = *entry.servo.profile->find(write.key);
    const auto now = entry.displayedRaw(reg);
    const auto risky = writeQuestion(entry, {{write.key, write.oldRaw}}, write.temporary);
    Question question = risky.value_or(Question{});
    question.title = translate("History", "Undo this write?");
    QStringList sentences{translate("History", "ID %1 · %2: %3 will change from %4 to %5.")
                              .arg(entry.servo.id)
                              .arg(entry.servo.profile->modelName, text::localized(reg.name),
                                   now ? QString::number(*now) : QStringLiteral("–"),
                                   QString::number(write.oldRaw))};
    if (now && now != write.newRaw)
        sentences << translate("History", "The value was changed again after this write.");
    sentences << question.text;
    sentences.removeAll(QString());
    question.text = sentences.join(QLatin1Char('\n'));
    question.acceptText = translate("History", "Undo this write");
    question.guard = page;
    ask(page, question,
        [&workbench, ref = entry.ref, key = write.key, raw = write.oldRaw,
         temporary = write.temporary,
         consent = risky ? device::Consent::confirmed() : device::Consent()] {
            workbench.writes().write(ref, {{{key, raw}}, temporary, consent});
        });
}
} // namespace ui
