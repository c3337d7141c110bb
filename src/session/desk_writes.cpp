// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/desk_work.h"
#include "session/history/servo_journal.h"
#include "session/ordered_write.h"

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
    if (isChangedSince(error))
        return WriteOutcome::NotSent;
    const bool silent = error.code == ErrorCode::NoReply || error.code == ErrorCode::Garbled ||
                        error.code == ErrorCode::LineBusy;
    return silent ? WriteOutcome::NoReply : WriteOutcome::Refused;
}

bool isMotionRegister(const ServoEntry* entry, const QString& key)
{
    const catalog::Register* reg =
        entry != nullptr && entry->servo.profile ? entry->servo.profile->find(key) : nullptr;
    return reg != nullptr && reg->motion;
}

const catalog::Register* registerOf(const ServoEntry& entry, const QString& key)
{
    return entry.servo.profile ? entry.servo.profile->find(key) : nullptr;
}

/// What this order does to a shaft. Switching torque on is the way out of a stop, so a goal in the
/// same order does not come with it.
Effect effectOf(const ServoEntry& entry, const WriteRequest& request)
{
    Effect effect = Effect::None;
    for (const device::WriteItem& item : request.items) {
        const catalog::Register* reg = registerOf(entry, item.key);
        if (reg == nullptr)
            continue;
        if (reg->role == catalog::Role::TorqueSwitch) {
            if (item.raw != 0)
                effect = Effect::EnablesTorque;
        } else if (reg->motion) {
            return Effect::Moves;
        }
    }
    return effect;
}

/// Makes the present place the middle.
bool setsCenter(const ServoEntry& entry, const device::WriteResult& result)
{
    constexpr std::int64_t maxTorqueSwitch = 2; // damping
    const catalog::Register* reg = registerOf(entry, result.key);
    return reg != nullptr && reg->role == catalog::Role::TorqueSwitch &&
           result.newRaw > maxTorqueSwitch;
}

/// Whoever was polled meanwhile would be asked where it is no more.
bool changesAddress(const ServoEntry& entry, const WriteRequest& request)
{
    return std::any_of(
        request.items.begin(), request.items.end(), [&](const device::WriteItem& item) {
            const catalog::Register* reg = registerOf(entry, item.key);
            return reg != nullptr &&
                   (reg->role == catalog::Role::BaudRate || reg->role == catalog::Role::Id);
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

void Desk::write(ServoRef ref, const WriteRequest& request)
{
    enqueueWrite(ref, request, WriteKind::New);
}

void Desk::markWritesPending(ServoEntry& known, const WriteRequest& request)
{
    for (const device::WriteItem& item : request.items) {
        RegisterWriteState& row = known.writes[item.key];
        ++row.pending;
        row.requested = item.raw;
    }
    Q_EMIT tableChanged(known.ref);
}

void Desk::enqueueWrite(ServoRef ref, const WriteRequest& request, WriteKind kind,
                        const std::vector<device::WriteItem>& expected)
{
    ServoEntry* known = entry(ref);
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
        if (const auto same = requireUnchanged(task.device, task.servo, expected, request.items);
            !same)
            return same;
        device::WriteOptions options;
        options.temporary = request.temporary;
        options.dangerous = request.dangerous;
        options.allowPreviousValues = kind != WriteKind::New;
        options.kind = kind == WriteKind::Undo ? base::IntentKind::Undo : base::IntentKind::Write;
        return writeInOrder(task.device, task.servo, request.items, options, *report);
    };
    work->onMerged = [this, request, kind, report](Work& ended) {
        writeEnded(ended, request, kind, *report);
    };
    enqueue(work);
}

void Desk::writeEnded(const Work& ended, const WriteRequest& request, WriteKind kind,
                      const std::optional<device::WriteReport>& report)
{
    if (ServoEntry* known = entry(ended.ref)) {
        for (const device::WriteItem& item : request.items) {
            RegisterWriteState& row = known->writes[item.key];
            row.pending = std::max(row.pending - 1, 0);
            row.at = now();
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
                // Not begun because nobody answered is no refusal of the servo's.
                const bool begun = result.outcome != WriteOutcome::Refused || !result.error;
                row.outcome = begun ? result.outcome : outcomeOf(*result.error);
                row.error = result.error;
                row.at = now();
                if (setsCenter(*known, result))
                    known->turns.reset();
            }
        }
        markWrites(*known, ended, request, report);
        Q_EMIT tableChanged(ended.ref);
    }
    recordUndo(ended, request, kind, report);
    emitEvent({.kind = Event::Kind::Written,
               .servo = ended.ref,
               .error = ended.error,
               .report = report,
               .notices = ended.notices,
               .isUndo = kind == WriteKind::Undo,
               .isRedo = kind == WriteKind::Redo});
}

void Desk::markWrites(const ServoEntry& about, const Work& ended, const WriteRequest& request,
                      const std::optional<device::WriteReport>& report)
{
    using record::MarkKind;
    if (report) {
        for (const device::WriteResult& result : report->writes)
            mark(MarkKind::Write, &about, markText(result));
    } else if (ended.error) {
        for (const device::WriteItem& item : request.items) {
            mark(MarkKind::Write, &about,
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
void Desk::recordUndo(const Work& ended, const WriteRequest& request, WriteKind kind,
                      const std::optional<device::WriteReport>& report)
{
    const ServoRef ref = ended.ref;
    if (kind != WriteKind::New) {
        const bool done =
            report && std::all_of(report->writes.begin(), report->writes.end(), wasApplied);
        const bool toUndo = (kind == WriteKind::Undo) != done;
        const auto step = std::exchange(m_pendingStep, std::nullopt);
        const bool gone = ended.error && isChangedSince(*ended.error);
        if (step && !gone && servo(ref) != nullptr)
            (toUndo ? m_undo : m_redo).push_back(*step);
        Q_EMIT undoChanged();
        return;
    }
    UndoStep step{ref, {}, {}, request.temporary};
    for (const device::WriteResult& result :
         report ? report->writes : std::vector<device::WriteResult>{}) {
        if (!wasApplied(result) || !result.oldRaw || *result.oldRaw == result.newRaw ||
            isMotionRegister(servo(ref), result.key))
            continue;
        step.oldItems.push_back({result.key, *result.oldRaw});
        step.newItems.push_back({result.key, result.newRaw});
    }
    if (step.oldItems.empty() || servo(ref) == nullptr)
        return;
    m_undo.push_back(step);
    m_redo.clear();
    Q_EMIT undoChanged();
}

const UndoStep* Desk::undoStep() const
{
    return m_undo.empty() || m_pendingStep ? nullptr : &m_undo.back();
}

const UndoStep* Desk::redoStep() const
{
    return m_redo.empty() || m_pendingStep ? nullptr : &m_redo.back();
}

void Desk::undo()
{
    if (undoStep() == nullptr)
        return;
    m_pendingStep = m_undo.back();
    m_undo.pop_back();
    // Consent was given for the way there, so it holds for the way back.
    enqueueWrite(m_pendingStep->servo, {m_pendingStep->oldItems, m_pendingStep->temporary, true},
                 WriteKind::Undo, m_pendingStep->newItems);
    Q_EMIT undoChanged();
}

void Desk::redo(bool dangerous)
{
    if (redoStep() == nullptr)
        return;
    m_pendingStep = m_redo.back();
    m_redo.pop_back();
    enqueueWrite(m_pendingStep->servo,
                 {m_pendingStep->newItems, m_pendingStep->temporary, dangerous}, WriteKind::Redo,
                 m_pendingStep->oldItems);
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

void Desk::loadHistory(ServoRef ref)
{
    const ServoEntry* known = servo(ref);
    if (known == nullptr || !known->servo.profile)
        return;
    const base::ServoIdentity identity = known->servo.identity();
    m_openThread->start([this, ref, identity] {
        constexpr int maxEntries = 1000;
        auto own = servoHistory(m_session.journal(), identity, maxEntries);
        if (!own)
            return;
        m_mainQueue.post([this, ref, own = std::move(*own)]() mutable {
            ServoEntry* entry = this->entry(ref);
            const bool unlocked =
                std::any_of(own.begin(), own.end(), [](const base::JournalEntry& one) {
                    return !one.end && one.intent.lockOpened;
                });
            if (entry == nullptr ||
                (sameEntries(entry->history, own) && entry->lockOpenedByUs == unlocked))
                return;
            entry->lockOpenedByUs = unlocked;
            entry->history = std::move(own);
            Q_EMIT servoChanged(ref);
        });
    });
}
} // namespace session
