// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/desk_work.h"
#include "session/ordered_write.h"
#include "session/servo_history.h"

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
    case ErrorCode::IdentityDiffers:
    case ErrorCode::SeveralServos:
    case ErrorCode::FamilyUnclear:
    case ErrorCode::UnknownModel:
        return WriteOutcome::NotSent;
    default:
        break;
    }
    if (isChangedSince(error))
        return WriteOutcome::NotSent;
    const bool silent = error.code == ErrorCode::NoAnswer || error.code == ErrorCode::Garbled ||
                        error.code == ErrorCode::LineBusy;
    return silent ? WriteOutcome::NoAnswer : WriteOutcome::Refused;
}

bool moves(const ServoEntry* entry, const QString& key)
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
Effect effectOf(const ServoEntry& entry, const WriteOrder& order)
{
    Effect effect = Effect::None;
    for (const device::WriteItem& item : order.items) {
        const catalog::Register* reg = registerOf(entry, item.key);
        if (reg == nullptr)
            continue;
        if (reg->role == catalog::Role::TorqueSwitch) {
            if (item.raw != 0)
                effect = Effect::Energises;
        } else if (reg->motion) {
            return Effect::Moves;
        }
    }
    return effect;
}

/// Makes the present place the middle.
bool centres(const ServoEntry& entry, const device::WriteResult& result)
{
    constexpr std::int64_t mostSwitch = 2; // damping
    const catalog::Register* reg = registerOf(entry, result.key);
    return reg != nullptr && reg->role == catalog::Role::TorqueSwitch && result.newRaw > mostSwitch;
}

/// Whoever was polled meanwhile would be asked where it is no more.
bool changesPlace(const ServoEntry& entry, const WriteOrder& order)
{
    return std::any_of(order.items.begin(), order.items.end(), [&](const device::WriteItem& item) {
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

bool took(const device::WriteResult& result)
{
    return result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary;
}
} // namespace

void Desk::write(ServoRef ref, const WriteOrder& order)
{
    enqueueWrite(ref, order, WriteKind::New);
}

void Desk::awaitWrites(ServoEntry& known, const WriteOrder& order)
{
    for (const device::WriteItem& item : order.items) {
        RowWrite& row = known.writes[item.key];
        ++row.pending;
        row.wanted = item.raw;
    }
    Q_EMIT tableChanged(known.ref);
}

void Desk::enqueueWrite(ServoRef ref, const WriteOrder& order, WriteKind kind,
                        const std::vector<device::WriteItem>& expected)
{
    ServoEntry* known = entry(ref);
    if (known == nullptr || order.items.empty())
        return;
    awaitWrites(*known, order);
    const auto report = std::make_shared<std::optional<device::WriteReport>>();
    const auto work = std::make_shared<Work>();
    work->ref = ref;
    work->task.name = QStringLiteral("write");
    work->task.savesTable = true;
    work->task.quiet = true;
    work->task.effect = effectOf(*known, order);
    work->movesRate = changesPlace(*known, order);
    work->finishes = true;
    work->task.work = [order, kind, expected, report](TaskContext& task) -> base::Result<void> {
        if (const auto same = requireUnchanged(task.device, task.servo, expected, order.items);
            !same)
            return same;
        device::WriteOptions options;
        options.temporary = order.temporary;
        options.dangerous = order.dangerous;
        options.asBefore = kind != WriteKind::New;
        options.kind = kind == WriteKind::Undo ? base::IntentKind::Undo : base::IntentKind::Write;
        return writeInOrder(task.device, task.servo, order.items, options, *report);
    };
    work->merged = [this, order, kind, report](Work& ended) {
        writeEnded(ended, order, kind, *report);
    };
    enqueue(work);
}

void Desk::writeEnded(const Work& ended, const WriteOrder& order, WriteKind kind,
                      const std::optional<device::WriteReport>& report)
{
    if (ServoEntry* known = entry(ended.ref)) {
        for (const device::WriteItem& item : order.items) {
            RowWrite& row = known->writes[item.key];
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
                RowWrite& row = known->writes[result.key];
                // Not begun because nobody answered is no refusal of the servo's.
                const bool begun = result.outcome != WriteOutcome::Refused || !result.error;
                row.outcome = begun ? result.outcome : outcomeOf(*result.error);
                row.error = result.error;
                row.at = now();
                if (centres(*known, result))
                    known->turns.reset();
            }
        }
        markWrites(*known, ended, order, report);
        Q_EMIT tableChanged(ended.ref);
    }
    remember(ended, order, kind, report);
    tell({.kind = Event::Kind::Written,
          .servo = ended.ref,
          .error = ended.error,
          .report = report,
          .notices = ended.notices,
          .undone = kind == WriteKind::Undo,
          .redone = kind == WriteKind::Redo});
}

void Desk::markWrites(const ServoEntry& about, const Work& ended, const WriteOrder& order,
                      const std::optional<device::WriteReport>& report)
{
    using record::MarkKind;
    if (report) {
        for (const device::WriteResult& result : report->writes)
            mark(MarkKind::Write, &about, markText(result));
    } else if (ended.error) {
        for (const device::WriteItem& item : order.items) {
            mark(MarkKind::Write, &about,
                 QStringLiteral("%1 → %2, %3")
                     .arg(item.key)
                     .arg(item.raw)
                     .arg(base::errorName(ended.error->code)));
        }
    }
}

/// What really changed can be taken back. What moves or energises is left out: undoing a setting
/// must not turn a shaft. A way back that failed stays where it was, unless the value is no longer
/// the one that was written: then there is none.
void Desk::remember(const Work& ended, const WriteOrder& order, WriteKind kind,
                    const std::optional<device::WriteReport>& report)
{
    const ServoRef ref = ended.ref;
    if (kind != WriteKind::New) {
        const bool done = report && std::all_of(report->writes.begin(), report->writes.end(), took);
        const bool toUndo = (kind == WriteKind::Undo) != done;
        const auto step = std::exchange(m_returning, std::nullopt);
        const bool gone = ended.error && isChangedSince(*ended.error);
        if (step && !gone && servo(ref) != nullptr)
            (toUndo ? m_undo : m_redo).push_back(*step);
        Q_EMIT undoChanged();
        return;
    }
    UndoStep step{ref, {}, {}, order.temporary};
    for (const device::WriteResult& result :
         report ? report->writes : std::vector<device::WriteResult>{}) {
        if (!took(result) || !result.oldRaw || *result.oldRaw == result.newRaw ||
            moves(servo(ref), result.key))
            continue;
        step.before.push_back({result.key, *result.oldRaw});
        step.after.push_back({result.key, result.newRaw});
    }
    if (step.before.empty() || servo(ref) == nullptr)
        return;
    m_undo.push_back(step);
    m_redo.clear();
    Q_EMIT undoChanged();
}

const UndoStep* Desk::nextUndo() const
{
    return m_undo.empty() || m_returning ? nullptr : &m_undo.back();
}

const UndoStep* Desk::nextRedo() const
{
    return m_redo.empty() || m_returning ? nullptr : &m_redo.back();
}

void Desk::undo()
{
    if (nextUndo() == nullptr)
        return;
    m_returning = m_undo.back();
    m_undo.pop_back();
    // Consent was given for the way there, so it holds for the way back.
    enqueueWrite(m_returning->servo, {m_returning->before, m_returning->temporary, true},
                 WriteKind::Undo, m_returning->after);
    Q_EMIT undoChanged();
}

void Desk::redo(bool dangerous)
{
    if (nextRedo() == nullptr)
        return;
    m_returning = m_redo.back();
    m_redo.pop_back();
    enqueueWrite(m_returning->servo, {m_returning->after, m_returning->temporary, dangerous},
                 WriteKind::Redo, m_returning->before);
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
    const base::ServoIdentity who = known->servo.identity();
    m_openThread->start([this, ref, who] {
        constexpr int most = 1000;
        auto own = servoHistory(m_session.journal(), who, most);
        if (!own)
            return;
        m_inbox.post([this, ref, own = std::move(*own)]() mutable {
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
