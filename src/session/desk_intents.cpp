// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/journal_takeover.h"
#include "session/desk_work.h"
#include "session/safety_snapshot.h"

#include <algorithm>

namespace session {
namespace {
/// What a look has brought.
struct Look {
    std::vector<jobs::Recovered> found{};
    std::vector<base::Intent> elsewhere{};
};

/// Where the journal has no open intent to look at no servo is asked.
base::Result<Look> lookOrSettle(const device::Context& context, jobs::RecoverAction action,
                                const jobs::RecoverOptions& options)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    Look look;
    base::ServoIdentity here;
    here.port = context.bus.portName();
    auto elsewhere = jobs::begunElsewhere(*open, here.port);
    const bool any = std::any_of(open->begin(), open->end(), [&](const base::Intent& intent) {
        return intent.servo.port == here.port;
    });
    const bool everywhere = options.anyPort && !here.isSimulated();
    if (any || (everywhere && !elsewhere.empty())) {
        auto recovered = jobs::recover(context, action, options);
        if (!recovered)
            return tl::unexpected(recovered.error());
        look.found = std::move(*recovered);
    }
    if (!everywhere)
        look.elsewhere = std::move(elsewhere);
    return look;
}

/// A table that was saved before an intent was settled.
struct SavedTable {
    base::Protocol protocol;
    int id;
    QString path;
};

jobs::BeforeWrite saveInto(std::vector<SavedTable>& saved)
{
    return [&saved](const device::Context& context, device::Servo& servo) -> base::Result<void> {
        const auto path = saveSafetySnapshot(context, servo);
        if (!path)
            return tl::unexpected(path.error());
        saved.push_back({servo.protocol, servo.id, *path});
        return {};
    };
}

/// The rate a report says was written.
std::optional<int> rateAfter(const catalog::Profile& profile, const device::WriteReport& report)
{
    const catalog::Register* reg = profile.byRole(catalog::Role::BaudRate);
    for (const device::WriteResult& result : report.writes) {
        if (reg == nullptr || result.key != reg->key ||
            result.outcome != device::WriteOutcome::Kept)
            continue;
        for (const catalog::NamedValue& value : reg->values) {
            if (value.value == result.newRaw)
                return value.key.toInt();
        }
    }
    return std::nullopt;
}
} // namespace

void Desk::lookForIntents(bool anyPort)
{
    recoverIntents(jobs::RecoverAction::Look, {}, anyPort);
}

void Desk::settleIntent(const QString& uuid, jobs::RecoverAction action)
{
    recoverIntents(action, uuid, true); // this one was chosen, wherever it was begun
}

void Desk::recoverIntents(jobs::RecoverAction action, const QString& uuid, bool anyPort)
{
    const auto look = std::make_shared<Look>();
    const auto saved = std::make_shared<std::vector<SavedTable>>();
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("recover");
    work->task.quiet = action == jobs::RecoverAction::Look;
    work->task.work = [action, uuid, anyPort, look, saved](TaskContext& task) {
        return lookOrSettle(task.device, action, {anyPort, uuid, saveInto(*saved)})
            .map([&look](Look&& made) { *look = std::move(made); });
    };
    work->merged = [this, look, saved, action](Work& ended) {
        for (const SavedTable& table : *saved) {
            const ServoRef ref = find(table.protocol, table.id);
            if (ServoEntry* known = entry(ref))
                known->snapshotPath = table.path;
            tell({.kind = Event::Kind::TableSaved, .servo = ref, .path = table.path});
        }
        if (ended.error)
            tell({.kind = Event::Kind::Failed, .error = ended.error});
        for (const base::Error& journal : record::takeUnreadableJournals())
            tell({.kind = Event::Kind::Failed, .error = journal});
        if (ended.error && action == jobs::RecoverAction::Look) {
            m_intentsLooked = false; // nobody knows whether there are none
            return;
        }
        for (const jobs::Recovered& one : look->found)
            followRecovered(one);
        Q_EMIT openIntents(look->found, look->elsewhere);
    };
    enqueue(work);
}

/// Settling an ID or a rate leads the servo away from where the list has it.
void Desk::followRecovered(const jobs::Recovered& one)
{
    const ServoRef ref = find(one.before.intent.servo.protocol, one.before.foundId);
    ServoEntry* known = entry(ref);
    if (!one.done || known == nullptr || known->servo.baud != one.before.foundBaud)
        return;
    device::Servo moved = known->servo;
    if (one.report && one.report->id >= 0)
        moved.id = one.report->id;
    if (one.report && moved.profile)
        moved.baud = rateAfter(*moved.profile, *one.report).value_or(moved.baud);
    merge(*known, moved, now());
    readTable(ref);
    loadHistory(ref);
}

void Desk::forgetIntent(const QString& uuid)
{
    m_openThread->start([this, uuid] {
        const auto ended = m_session.journal().end(uuid, {QStringLiteral("abandoned"), {}});
        m_inbox.post([this, ended] {
            if (!ended)
                tell({.kind = Event::Kind::Failed, .error = ended.error()});
            else
                lookForIntents();
        });
    });
}
} // namespace session
