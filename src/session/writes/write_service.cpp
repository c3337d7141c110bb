// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/writes/write_service.h"

#include "device/write_meaning.h"
#include "jobs/change/ordered_write.h"
#include "jobs/recover/recover.h"
#include "session/history/servo_history.h"
#include "session/workbench.h"

#include <algorithm>
#include <utility>

namespace session {
namespace {
using device::WriteOutcome;

/// The word for a register whose write never began.
WriteOutcome outcomeOf(const base::Error& error)
{
    using base::ErrorCode;
    switch (error.code) {
    case ErrorCode::LinkLost:
    case ErrorCode::Held:
    case ErrorCode::IdentityMismatch:
    case ErrorCode::DuplicateId:
    case ErrorCode::FamilyConflict:
    case ErrorCode::UnknownModel:
        return WriteOutcome::NotSent;
    default:
        break;
    }
    if (jobs::isChangedSince(error))
        return WriteOutcome::NotSent;
    const bool silent = error.code == ErrorCode::NoReply || error.code == ErrorCode::Garbled ||
                        error.code == ErrorCode::LineBusy;
    return silent ? WriteOutcome::NoReply : WriteOutcome::Refused;
}

const catalog::Register* registerOf(const ServoEntry& entry, const QString& key)
{
    return entry.servo.profile ? entry.servo.profile->find(key) : nullptr;
}

/// The meaning of an item; that of a plain register where the servo does not have it.
device::WriteMeaning meaningOf(const ServoEntry& entry, const QString& key, std::int64_t raw)
{
    const catalog::Register* reg = registerOf(entry, key);
    return reg != nullptr ? device::classify(*reg, raw) : device::WriteMeaning{};
}

/// What this order does to a shaft. Turning torque on is the way out of a stop, so a goal in the
/// same order is refused with it.
Effect effectOf(const ServoEntry& entry, const WriteRequest& request)
{
    Effect effect = Effect::None;
    for (const device::WriteItem& item : request.items) {
        const device::WriteMeaning meaning = meaningOf(entry, item.key, item.raw);
        if (meaning.moves)
            return Effect::Moves;
        if (meaning.enablesTorque)
            effect = Effect::EnablesTorque;
    }
    return effect;
}

/// It would be polled where it no longer replies.
bool changesAddress(const ServoEntry& entry, const WriteRequest& request)
{
    return std::any_of(request.items.begin(), request.items.end(),
                       [&](const device::WriteItem& item) {
                           return meaningOf(entry, item.key, item.raw).changesAddress();
                       });
}

/// "position_p 32 → 40", with the word for it if it did not become so.
QString markText(const device::WriteResult& result)
{
    const QString old = result.oldRaw ? QString::number(*result.oldRaw) : QStringLiteral("?");
    QString text = QStringLiteral("%1 %2 → %3").arg(result.key, old).arg(result.newRaw);
    if (result.outcome != WriteOutcome::Kept)
        text += QStringLiteral(", ") + device::outcomeName(result.outcome);
    return text;
}

bool wasApplied(const device::WriteResult& result)
{
    return result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary;
}
} // namespace

WriteService::WriteService(Workbench& bench)
    : m_bench(bench)
{
    connect(&bench.registry(), &ServoRegistry::servoRemoved, this, &WriteService::forget);
    connect(&bench.registry(), &ServoRegistry::servosCleared, this, [this] {
        m_undo.clear();
        m_redo.clear();
        m_pendingStep.reset();
        Q_EMIT undoChanged();
    });
}

void WriteService::forget(ServoRef ref)
{
    const auto isGone = [ref](const UndoStep& step) { return step.servo == ref; };
    std::erase_if(m_undo, isGone);
    std::erase_if(m_redo, isGone);
    Q_EMIT undoChanged();
}

void WriteService::readTable(ServoRef ref)
{
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known == nullptr || known->isReadingTable)
        return;
    known->isReadingTable = true;
    Q_EMIT m_bench.registry().servoChanged(ref);
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
    m_bench.tasks().enqueue(work);
}

void WriteService::tableRead(const Work& ended)
{
    ServoEntry* known = m_bench.registry().entry(ended.ref);
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
        m_bench.emitEvent({.kind = Event::Kind::Failed, .servo = ended.ref, .error = ended.error});
}

void WriteService::write(ServoRef ref, const WriteRequest& request)
{
    enqueueWrite(ref, request, WriteKind::New);
}

void WriteService::markWritesPending(ServoEntry& known, const WriteRequest& request)
{
    for (const device::WriteItem& item : request.items) {
        RegisterWriteState& row = known.writes[item.key];
        ++row.pending;
        row.requested = item.raw;
    }
    Q_EMIT m_bench.registry().tableChanged(known.ref);
}

void WriteService::enqueueWrite(ServoRef ref, const WriteRequest& request, WriteKind kind,
                                const std::vector<device::WriteItem>& expected)
{
    ServoEntry* known = m_bench.registry().entry(ref);
    if (known == nullptr || request.items.empty())
        return;
    markWritesPending(*known, request);
    const auto report = std::make_shared<std::optional<device::WriteReport>>();
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->task.name = QStringLiteral("write");
    work->task.savesTable = true;
    work->task.quiet = true;
    work->task.effect = effectOf(*known, request);
    work->changesRate = changesAddress(*known, request);
    work->completesBeforeClose = true;
    work->task.work = [request, kind, expected, report](TaskContext& task) -> base::Result<void> {
        if (const auto same =
                jobs::requireUnchanged(task.device, task.servo, expected, request.items);
            !same)
            return same;
        device::WriteOptions options;
        options.temporary = request.temporary;
        options.consent = request.consent;
        options.allowPreviousValues = kind != WriteKind::New;
        options.kind = kind == WriteKind::Undo ? base::IntentKind::Undo : base::IntentKind::Write;
        return jobs::writeInOrder(task.device, task.servo, request.items, options,
                                  jobs::SpecialRegisters::Write, *report);
    };
    work->onMerged = [this, request, kind, report](Work& ended) {
        writeEnded(ended, request, kind, *report);
    };
    m_bench.tasks().enqueue(work);
}

void WriteService::writeEnded(const Work& ended, const WriteRequest& request, WriteKind kind,
                              const std::optional<device::WriteReport>& report)
{
    if (ServoEntry* known = m_bench.registry().entry(ended.ref)) {
        for (const device::WriteItem& item : request.items) {
            RegisterWriteState& row = known->writes[item.key];
            row.pending = std::max(row.pending - 1, 0);
            row.at = m_bench.now();
            row.outcome.reset();
            row.error.reset();
            if (ended.error) {
                row.outcome = outcomeOf(*ended.error);
                row.error = ended.error;
            }
        }
        if (report) {
            for (const device::WriteResult& result : report->writes) {
                RegisterWriteState& row = known->writes[result.key];
                // Not begun without a reply is no refusal by the servo.
                const bool begun = result.outcome != WriteOutcome::Refused || !result.error;
                row.outcome = begun ? result.outcome : outcomeOf(*result.error);
                row.error = result.error;
                row.at = m_bench.now();
                if (meaningOf(*known, result.key, result.newRaw).procedure ==
                    device::WriteProcedure::Center)
                    known->turns.reset();
            }
        }
        markWrites(*known, ended, request, report);
        Q_EMIT m_bench.registry().tableChanged(ended.ref);
    }
    recordUndo(ended, request, kind, report);
    m_bench.emitEvent({.kind = Event::Kind::Written,
                       .servo = ended.ref,
                       .error = ended.error,
                       .report = report,
                       .notices = ended.notices,
                       .isUndo = kind == WriteKind::Undo,
                       .isRedo = kind == WriteKind::Redo});
}

void WriteService::markWrites(const ServoEntry& about, const Work& ended,
                              const WriteRequest& request,
                              const std::optional<device::WriteReport>& report)
{
    using recording::MarkKind;
    if (report) {
        for (const device::WriteResult& result : report->writes)
            m_bench.polling().mark(MarkKind::Write, &about, markText(result));
    } else if (ended.error) {
        for (const device::WriteItem& item : request.items) {
            m_bench.polling().mark(MarkKind::Write, &about,
                                   QStringLiteral("%1 → %2, %3")
                                       .arg(item.key)
                                       .arg(item.raw)
                                       .arg(base::errorName(ended.error->code)));
        }
    }
}

/// What really changed can be taken back. What moves or energizes is left out: undoing a setting
/// must not turn a shaft. A way back that failed stays where it was, unless the value is no longer
/// the one that was written: then there is none.
void WriteService::recordUndo(const Work& ended, const WriteRequest& request, WriteKind kind,
                              const std::optional<device::WriteReport>& report)
{
    const ServoRef ref = ended.ref;
    if (kind != WriteKind::New) {
        const bool done =
            report && std::all_of(report->writes.begin(), report->writes.end(), wasApplied);
        const bool toUndo = (kind == WriteKind::Undo) != done;
        const auto step = std::exchange(m_pendingStep, std::nullopt);
        const bool gone = ended.error && jobs::isChangedSince(*ended.error);
        if (step && !gone && m_bench.registry().servo(ref) != nullptr)
            (toUndo ? m_undo : m_redo).push_back(*step);
        Q_EMIT undoChanged();
        return;
    }
    const ServoEntry* known = m_bench.registry().servo(ref);
    const auto isMotion = [known](const device::WriteResult& result) {
        return known != nullptr && meaningOf(*known, result.key, result.newRaw).isMotion();
    };
    UndoStep step{ref, {}, {}, request.temporary};
    for (const device::WriteResult& result :
         report ? report->writes : std::vector<device::WriteResult>{}) {
        if (!wasApplied(result) || !result.oldRaw || *result.oldRaw == result.newRaw ||
            isMotion(result))
            continue;
        step.oldItems.push_back({result.key, *result.oldRaw});
        step.newItems.push_back({result.key, result.newRaw});
    }
    if (step.oldItems.empty() || m_bench.registry().servo(ref) == nullptr)
        return;
    m_undo.push_back(step);
    m_redo.clear();
    Q_EMIT undoChanged();
}

const UndoStep* WriteService::undoStep() const
{
    return m_undo.empty() || m_pendingStep ? nullptr : &m_undo.back();
}

const UndoStep* WriteService::redoStep() const
{
    return m_redo.empty() || m_pendingStep ? nullptr : &m_redo.back();
}

void WriteService::undo(device::Consent consent)
{
    if (undoStep() == nullptr)
        return;
    m_pendingStep = m_undo.back();
    m_undo.pop_back();
    enqueueWrite(m_pendingStep->servo, {m_pendingStep->oldItems, m_pendingStep->temporary, consent},
                 WriteKind::Undo, m_pendingStep->newItems);
    Q_EMIT undoChanged();
}

void WriteService::redo(device::Consent consent)
{
    if (redoStep() == nullptr)
        return;
    m_pendingStep = m_redo.back();
    m_redo.pop_back();
    enqueueWrite(m_pendingStep->servo, {m_pendingStep->newItems, m_pendingStep->temporary, consent},
                 WriteKind::Redo, m_pendingStep->oldItems);
    Q_EMIT undoChanged();
}

/// What the interrupted write had changed in this session could be undone by itself, and would
/// leave a mixture behind. Once it is finished Undo takes back all of it; once it is undone
/// nothing.
void WriteService::mergeRecoveredUndo(const jobs::RecoveryResult& one, ServoRef ref)
{
    const base::Intent& intent = one.before.intent;
    const bool snapshot = jobs::isSnapshotRestore(intent);
    const ServoEntry* known = m_bench.registry().servo(ref);
    if (!one.done || known == nullptr || !known->servo.profile ||
        !(snapshot || intent.kind == base::IntentKind::Write))
        return;
    UndoStep whole{ref, {}, {}, intent.temporary};
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = known->servo.profile->find(item.key);
        const bool settled = reg != nullptr && jobs::isRecoveredBy(one, known->servo, *reg);
        if (!settled || item.oldRaw == item.newRaw)
            continue;
        whole.oldItems.push_back({item.key, item.oldRaw});
        whole.newItems.push_back({item.key, item.newRaw});
    }
    const auto isIn = [](const std::vector<device::WriteItem>& all, const device::WriteItem& item) {
        return std::any_of(all.begin(), all.end(), [&](const device::WriteItem& each) {
            return each.key == item.key && each.raw == item.raw;
        });
    };
    std::erase_if(m_undo, [&](const UndoStep& step) {
        const auto covered = [&](const auto& items, const auto& by) {
            return std::all_of(items.begin(), items.end(),
                               [&](const device::WriteItem& item) { return isIn(by, item); });
        };
        return step.servo == ref && covered(step.oldItems, whole.oldItems) &&
               covered(step.newItems, whole.newItems);
    });
    if (one.action == jobs::RecoveryAction::Finish && !whole.oldItems.empty()) {
        m_undo.push_back(whole);
        m_redo.clear();
    }
    Q_EMIT undoChanged();
}

namespace {
/// An entry changes in one way only: it gets an end.
bool sameEntries(const std::vector<base::JournalEntry>& a, const std::vector<base::JournalEntry>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& two) {
        return one.intent.uuid == two.intent.uuid && one.end.has_value() == two.end.has_value() &&
               (!one.end || one.end->outcome == two.end->outcome);
    });
}
} // namespace

void WriteService::loadHistory(ServoRef ref)
{
    const ServoEntry* known = m_bench.registry().servo(ref);
    if (known == nullptr || !known->servo.profile)
        return;
    const base::ServoIdentity identity = known->servo.identity();
    m_bench.backgroundThread().start([this, ref, identity] {
        constexpr int maxEntries = 1000;
        auto own = servoHistory(m_bench.session().journal(), identity, maxEntries);
        if (!own)
            return;
        m_bench.mainQueue().post([this, ref, own = std::move(*own)]() mutable {
            ServoEntry* entry = m_bench.registry().entry(ref);
            const bool unlocked =
                std::any_of(own.begin(), own.end(), [](const base::JournalEntry& one) {
                    return !one.end && one.intent.lockOpened;
                });
            if (entry == nullptr ||
                (sameEntries(entry->history, own) && entry->lockOpenedByUs == unlocked))
                return;
            entry->lockOpenedByUs = unlocked;
            entry->history = std::move(own);
            Q_EMIT m_bench.registry().servoChanged(ref);
        });
    });
}
} // namespace session
