// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a servo's whole table.
#include "session/desk_work.h"

namespace session {
void Desk::readTable(ServoRef ref)
{
    ServoEntry* known = entry(ref);
    if (known == nullptr || known->isReadingTable)
        return;
    known->isReadingTable = true;
    Q_EMIT servoChanged(ref);
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->readOnly = true;
    work->task.name = QStringLiteral("read");
    work->task.quiet = true;
    work->task.work = [](TaskContext& task) -> base::Result<void> {
        // Another servo may have been put in its place: what it says of itself comes first.
        auto now = device::identify(task.device, task.servo.id, task.servo.protocol);
        if (!now)
            return tl::unexpected(now.error());
        const bool other =
            !task.servo.profile || !(task.servo.profile->identity == now->profile->identity);
        if (other)
            task.servo = std::move(*now);
        return device::readAll(task.device, task.servo);
    };
    work->onMerged = [this](Work& ended) { tableRead(ended); };
    enqueue(work);
}

void Desk::tableRead(const Work& ended)
{
    ServoEntry* known = entry(ended.ref);
    if (known == nullptr)
        return;
    known->isReadingTable = false;
    known->readError = ended.error;
    known->unreadable.clear();
    if (!ended.error)
        known->hasFullTable = true;
    if (known->servo.profile && ended.error) {
        for (const catalog::Register& reg : known->servo.profile->registers) {
            const auto at = known->servo.image.readAt(reg.offset);
            if (!at || *at < ended.startedAt)
                known->unreadable.insert(reg.key);
        }
    }
    if (ended.error)
        emitEvent({.kind = Event::Kind::Failed, .servo = ended.ref, .error = ended.error});
}
} // namespace session
