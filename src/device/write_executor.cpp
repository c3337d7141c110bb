// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/write_executor.h"

#include "device/persistence.h"
#include "device/transactions.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;
using catalog::TorqueOff;

namespace {
/// Neither a lost reply nor a refusal by the servo: the link is gone, or an emergency stop took the
/// wire, and further writes would undo it.
bool isFatal(const base::Error& error)
{
    return !isReplyLost(error) && error.code != ErrorCode::Refused;
}

bool isMotion(const RegisterValue& item)
{
    return classify(*item.reg, item.raw).isMotion();
}
} // namespace

bool WriteExecutor::needsTorqueOff() const
{
    if (m_change)
        return true;
    return std::any_of(m_items.begin(), m_items.end(), [](const RegisterValue& item) {
        return item.reg->torqueOff == TorqueOff::Needed;
    });
}

/// The first item from here on that needs the open lock to be kept.
std::size_t WriteExecutor::nextLocked(std::size_t from) const
{
    while (from < m_items.size() && retentionOf(*m_items[from].reg) != Retention::Lock)
        ++from;
    return from;
}

/// A section ends where the lock must be opened for another area.
std::size_t WriteExecutor::endOfSection(std::size_t first) const
{
    const std::size_t locked = nextLocked(first);
    std::size_t end = std::min(locked, m_items.size());
    while (end < m_items.size()) {
        const std::size_t next = nextLocked(end);
        if (next < m_items.size() && m_items[next].reg->area != m_items[locked].reg->area)
            return next;
        end = std::min(next + 1, m_items.size());
    }
    return m_items.size();
}

/// Torque off and, for a temporary write, closing a lock that was left open.
base::Result<void> WriteExecutor::prepare()
{
    if (m_options.torqueOff || needsTorqueOff()) {
        if (const auto off = torqueOff(m_context, m_servo); !off)
            return off;
    }
    const catalog::Register* lock = m_servo.profile->byRole(Role::Lock);
    if (!m_options.temporary || !concernsLock() || lock == nullptr)
        return {};
    const auto flag = readRegister(m_context, m_servo, *lock);
    if (!flag)
        return tl::unexpected(flag.error());
    if (!isLockOpen(*flag))
        return {};
    m_context.note(NoticeCode::LockFoundOpen, m_servo.id, lock->key);
    if (closeLock(m_context, m_servo) != LockState::Closed) {
        return tl::unexpected(
            base::Error{ErrorCode::LockOpen, QStringLiteral("write"), {}, m_servo.id, lock->key});
    }
    m_context.note(NoticeCode::LockClosed, m_servo.id, lock->key);
    return {};
}

void WriteExecutor::skipRest(std::size_t first, const base::Error& why)
{
    for (std::size_t i = first; i < m_report.writes.size(); ++i) {
        WriteResult& result = m_report.writes[i];
        result.outcome = outcomeBeforeSending(why);
        result.readBack.reset();
        result.error = why;
    }
}

WriteReport WriteExecutor::run()
{
    if (const auto ready = prepare(); !ready) {
        skipRest(0, ready.error());
        return m_report;
    }
    if (m_options.temporary) {
        if (concernsLock())
            m_report.lock = LockState::Closed;
        writeRange(0, m_items.size());
        return m_report;
    }
    for (std::size_t first = 0; first < m_items.size();) {
        const std::size_t last = endOfSection(first);
        if (!writeSection(first, last))
            return m_report;
        first = last;
    }
    return m_report;
}

/// After every run, also a failed one: a servo that is in another mode now must stand still in it.
void WriteExecutor::finishModeChange()
{
    if (!m_change)
        return;
    bool unclear = false;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const Role role = m_items[i].reg->role;
        const WriteOutcome outcome = m_report.writes[i].outcome;
        unclear |=
            (role == Role::OperatingMode || role == Role::MinAngle || role == Role::MaxAngle) &&
            (outcome == WriteOutcome::Unknown || outcome == WriteOutcome::NoReply);
    }
    const catalog::Mode* now = m_servo.mode();
    if (!unclear && now == m_change->from)
        return;
    const catalog::Mode* to = unclear || now == nullptr ? m_change->to : now;
    const auto switched = m_fatalError ? base::Result<void>(tl::unexpected(*m_fatalError))
                                       : finishModeSwitch(m_context, m_servo, {m_change->from, to});
    m_modeChangeFailed = !switched;
    if (!switched)
        m_report.writes.back().error = switched.error();
}

/// False when the rest was not sent.
bool WriteExecutor::writeSection(std::size_t first, std::size_t last)
{
    const std::size_t locked = nextLocked(first);
    if (locked >= last)
        return writeRange(first, last);
    auto unlocked = UnlockedEprom::open(m_context, m_servo, *m_items[locked].reg);
    if (!unlocked) {
        if (isFatal(unlocked.error()))
            m_fatalError = unlocked.error();
        skipRest(first, unlocked.error());
        finishModeChange();
        setLockState(closeLock(m_context, m_servo));
        return false;
    }
    m_open = true;
    const bool whole = writeRange(first, last);
    m_open = false;
    const LockState lock = unlocked->close();
    setLockState(lock);
    if (lock == LockState::Closed && !unlocked->stayedOpen())
        markUncertain(first, last);
    if (lock == LockState::Closed || !whole)
        return whole;
    skipRest(last, {ErrorCode::LockOpen, QStringLiteral("write"), {}, m_servo.id});
    finishModeChange();
    return false;
}

/// The worst state of all sections counts.
void WriteExecutor::setLockState(LockState lock)
{
    const bool proven = m_report.lock == LockState::None || m_report.lock == LockState::Closed;
    if (proven)
        m_report.lock = lock;
}

/// The lock had closed by itself before the end: the servo restarted, or another one is here. Then
/// it is not known what the EPROM took, and a value that was read may be another servo's.
void WriteExecutor::markUncertain(std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        WriteResult& result = m_report.writes[i];
        if (!result.readBack || retentionOf(*m_items[i].reg) != Retention::Lock)
            continue;
        result.outcome = WriteOutcome::Unknown;
        result.error = base::Error{ErrorCode::Uncertain, QStringLiteral("keep"),
                                   QStringLiteral("restarted"), m_servo.id, result.key};
    }
}

/// False when the rest was not sent.
bool WriteExecutor::writeRange(std::size_t first, std::size_t last)
{
    const bool whole = writeGroups(first, last);
    if (!whole || last == m_items.size())
        finishModeChange();
    return whole;
}

/// False when the user or a fatal error ended it; the rest is not sent then.
bool WriteExecutor::writeGroups(std::size_t first, std::size_t last)
{
    while (first < last) {
        // Neighbors share a frame: both angle limits change at once, never one alone.
        std::size_t end = first + 1;
        while (end < last && sharesFrame(*m_items[end - 1].reg, *m_items[end].reg))
            ++end;
        if (m_context.stop.isRequested()) {
            m_context.note(NoticeCode::StoppedByUser, m_servo.id, m_items[first].reg->key);
            skipRest(first, {ErrorCode::Stopped, QStringLiteral("write"), {}, m_servo.id});
            return false;
        }
        writeGroup(first, end);
        if (m_options.onProgress)
            m_options.onProgress(end, m_items.size());
        if (m_fatalError) {
            skipRest(end, *m_fatalError);
            return false;
        }
        if (const WriteResult* bad = m_options.stopOnFailure ? failed(first, end) : nullptr) {
            skipRest(end, {ErrorCode::Stopped, QStringLiteral("write"),
                           QStringLiteral("after-failure"), m_servo.id, bad->key});
            return false;
        }
        first = end;
    }
    return true;
}

/// The first of these that did not take its value; null: all did.
const WriteResult* WriteExecutor::failed(std::size_t first, std::size_t last) const
{
    for (std::size_t i = first; i < last; ++i) {
        const WriteOutcome outcome = m_report.writes[i].outcome;
        if (outcome != WriteOutcome::Kept && outcome != WriteOutcome::Temporary)
            return &m_report.writes[i];
    }
    return nullptr;
}

/// Reads all of them back in one read where that is possible; with many items reading takes most of
/// the time. False when it is not possible or no reply came; each is then read by itself.
bool WriteExecutor::readTogether(std::size_t first, std::size_t last)
{
    const catalog::Register& front = *m_items[first].reg;
    const catalog::Register& back = *m_items[last - 1].reg;
    if (last - first < 2 || front.block || front.writeOffset != front.offset ||
        back.writeOffset != back.offset)
        return false;
    const int count = back.offset + back.size - front.offset;
    return count <= m_servo.profile->maxRead &&
           readBlock(m_context, m_servo, front.offset, count).has_value();
}

base::Result<void> WriteExecutor::sendGroup(std::size_t first, std::size_t last)
{
    const RegisterValues group(m_items.begin() + static_cast<std::ptrdiff_t>(first),
                               m_items.begin() + static_cast<std::ptrdiff_t>(last));
    const bool motion = std::any_of(group.begin(), group.end(), isMotion);
    const auto patch = freshPatch(m_context, m_servo, group);
    if (!patch)
        return tl::unexpected(patch.error());
    return writeBlock(m_context, m_servo, *patch,
                      motion ? protocol::Repeat::Never : protocol::Repeat::Safe);
}

void WriteExecutor::writeGroup(std::size_t first, std::size_t last)
{
    constexpr int tries = 2;
    const auto showsOld = [this](std::size_t i) {
        const WriteResult& result = m_report.writes[i];
        return result.readBack && result.readBack == result.oldRaw &&
               result.oldRaw != result.newRaw;
    };
    // A motion command is not sent twice, unless the protocol has no acknowledgements: its goals
    // are positions, never steps.
    const bool once = isMotion(m_items[first]) && m_servo.acknowledgesWrites();
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto sent = sendGroup(first, last);
        if (needsWriteTime(*m_items[first].reg))
            m_context.bus.clock().sleepFor(epromWriteTime);
        if (!sent && isFatal(sent.error()))
            return abortAt(first, last, sent.error());
        const bool together = readTogether(first, last);
        for (std::size_t i = first; i < last && !m_fatalError; ++i)
            evaluate(i, sent, together);
        if (m_fatalError)
            return;
        // Reading proved that nothing happened, so sending again repeats nothing. A servo that
        // acknowledged and kept the old value has refused: a second write would change nothing.
        const bool untouched = sent ? !m_servo.repliesToWrites() : isReplyLost(sent.error());
        const bool unclear = m_report.writes[first].outcome == WriteOutcome::Unknown;
        if (!untouched || unclear || !showsOld(first) || once)
            break;
        if (attempt + 1 < tries)
            noteResent(m_context, m_servo, !sent, m_items[first].reg->key);
    }
    for (std::size_t i = first; i < last; ++i)
        makePersistent(i);
}

/// The frame may have been sent, so a later reading must show the result. Nothing more is sent,
/// except to close the lock.
void WriteExecutor::abortAt(std::size_t first, std::size_t last, const base::Error& why)
{
    m_fatalError = why;
    for (std::size_t i = first; i < last; ++i) {
        m_report.writes[i].outcome = WriteOutcome::Unknown;
        m_report.writes[i].error = why;
    }
}

/// `alreadyRead`: the servo's image has just been filled.
void WriteExecutor::evaluate(std::size_t index, const base::Result<void>& sent, bool alreadyRead)
{
    const RegisterValue& item = m_items[index];
    WriteResult& result = m_report.writes[index];
    const auto back = alreadyRead ? base::Result<std::int64_t>(*m_servo.raw(*item.reg))
                                  : readRegister(m_context, m_servo, *item.reg);
    if (!back) {
        if (isFatal(back.error()))
            return abortAt(index, index + 1, back.error());
        result.outcome = WriteOutcome::NoReply;
        result.error = back.error();
        return;
    }
    result.readBack = *back;
    result.error.reset();
    const bool refused = !sent && sent.error().code == ErrorCode::Refused;
    if (item.reg->role == Role::FaultReset && !sent && !refused) {
        result.outcome = WriteOutcome::Unknown;
        result.error = sent.error();
        return;
    }
    // A fault reset clears itself, so only its acknowledgement proves it.
    const bool shown = item.reg->role == Role::FaultReset ? sent.has_value() : *back == item.raw;
    if (shown && !refused) {
        result.outcome = WriteOutcome::Temporary;
        if (!sent)
            m_context.note(NoticeCode::ReplyLostButWritten, m_servo.id, item.reg->key);
        return;
    }
    const bool unchanged = refused || result.oldRaw == *back;
    result.outcome = unchanged ? WriteOutcome::Refused : WriteOutcome::Mismatch;
    result.error = base::Error{
        unchanged ? ErrorCode::Refused : ErrorCode::Mismatch, QStringLiteral("write"),
        refused ? sent.error().detail : QString::number(*back), m_servo.id, item.reg->key};
}

/// Whether a value that was written and read back also survives power-off.
void WriteExecutor::makePersistent(std::size_t index)
{
    const catalog::Register& reg = *m_items[index].reg;
    WriteResult& result = m_report.writes[index];
    if (result.outcome != WriteOutcome::Temporary)
        return;
    switch (retentionOf(reg)) {
    case Retention::Lock:
        result.outcome = m_open ? WriteOutcome::Kept : WriteOutcome::Temporary;
        break;
    case Retention::Always:
        result.outcome = WriteOutcome::Kept;
        break;
    case Retention::Save:
        if (m_options.temporary)
            break;
        if (const auto saved = save(m_context, m_servo, reg); !saved) {
            result.outcome = WriteOutcome::Unknown;
            result.error = saved.error();
            break;
        }
        result.outcome = WriteOutcome::Kept;
        m_context.note(NoticeCode::SaveUnverified, m_servo.id, reg.key);
        break;
    case Retention::NotStated:
        m_context.note(NoticeCode::PersistenceUndocumented, m_servo.id, reg.key);
        break;
    case Retention::Never:
        break;
    }
}

/// False while a result is unknown: the intent then stays open in the journal.
bool WriteExecutor::finished() const
{
    const bool certain =
        std::none_of(m_report.writes.begin(), m_report.writes.end(), [](const WriteResult& result) {
            return result.outcome == WriteOutcome::Unknown ||
                   result.outcome == WriteOutcome::NoReply;
        });
    return certain && !m_modeChangeFailed && m_report.lock != LockState::Open &&
           m_report.lock != LockState::Unknown;
}
} // namespace device
