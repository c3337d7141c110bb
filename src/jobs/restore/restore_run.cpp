// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/restore_run.h"

#include "device/motion/motion.h"
#include "device/persistence.h"
#include "device/reader.h"
#include "device/transactions.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover_apply.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using device::NoticeCode;
using device::WriteOutcome;
using device::WriteResult;

bool needsOwnJob(const RestoreWrite& write)
{
    return write.stage == RestoreStage::Id || write.stage == RestoreStage::Baud;
}

bool isLockOpen(const device::Servo& servo)
{
    const auto lock = servo.raw(catalog::Role::Lock);
    return lock && device::isLockOpen(*lock);
}

namespace {
const QString restoreRunOperation = QStringLiteral("restore");

bool isAccepted(const WriteResult& result)
{
    return !result.error &&
           (result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary);
}

/// The present values become the old values in the journal: they are read afresh, because the plan
/// may be an hour old.
base::Result<void> readFresh(const device::Context& context, device::Servo& servo,
                             const std::vector<RestoreWrite>& writes)
{
    std::vector<const catalog::Register*> registers;
    for (const RestoreWrite& write : writes) {
        const catalog::Register* reg = servo.profile->find(write.key);
        servo.image.invalidate(reg->offset, reg->size);
        registers.push_back(reg);
    }
    return device::read(context, servo, registers);
}

} // namespace

/// The old value of a row is the one before the first attempt.
void RestoreRunner::addResults(const device::WriteReport& report)
{
    for (const WriteResult& result : report.writes) {
        const auto known =
            std::find_if(m_outcome.rows.begin(), m_outcome.rows.end(),
                         [&](const auto& row) { return row.write.key == result.key; });
        if (known == m_outcome.rows.end()) {
            m_outcome.rows.push_back({result});
            continue;
        }
        const auto before = known->write.oldRaw;
        known->write = result;
        known->write.oldRaw = before;
    }
    m_outcome.lock = report.lock;
}

bool RestoreRunner::isSuccessful() const
{
    return std::all_of(m_outcome.rows.begin(), m_outcome.rows.end(),
                       [](const RestoreRowResult& row) { return isAccepted(row.write); }) &&
           m_outcome.lock != device::LockState::Open &&
           m_outcome.lock != device::LockState::Unknown;
}

/// If finishing cannot even start, the values are written in the ordinary way, and the intent stays
/// open.
bool RestoreRunner::finishInterrupted(const std::vector<base::Intent>& intents)
{
    const int baud = m_context.bus.baud();
    for (const base::Intent& intent : intents) {
        const auto one = recoverIntent(m_context, intent, RecoveryAction::Finish);
        if (m_context.bus.canSetBaud())
            (void)m_context.bus.setBaud(baud);
        if (one && one->report)
            addResults(*one->report);
        if (one && one->done)
            continue;
        m_unfinished = one ? one->error : one.error();
        if (!one || !one->report)
            continue;
        m_openIntents << intent.uuid;
        if (!one->report->openIntent.isEmpty())
            m_openIntents << one->report->openIntent;
        return false;
    }
    // Reads what they have changed; a failure shows at the next read.
    if (!intents.empty())
        (void)device::readSettings(m_context, m_servo);
    return true;
}

/// A value that the servo has already may still have to be kept; finishing an earlier attempt may
/// have done that.
bool RestoreRunner::isStillToWrite(const RestoreWrite& write) const
{
    const bool kept =
        std::any_of(m_outcome.rows.begin(), m_outcome.rows.end(), [&](const auto& row) {
            return row.write.key == write.key && row.write.outcome == WriteOutcome::Kept;
        });
    return m_servo.raw(write.key) != write.to || (write.isRewrite && !kept);
}

base::Result<void> RestoreRunner::writeRegisters(const std::vector<RestoreWrite>& writes)
{
    std::vector<device::WriteItem> items;
    for (const RestoreWrite& write : writes) {
        if (!needsOwnJob(write) && isStillToWrite(write))
            items.push_back({write.key, write.to});
    }
    if (items.empty())
        return device::setTorque(m_context, m_servo, device::Torque::Off);
    device::WriteOptions options;
    options.consent = m_options.consent;
    options.kind = base::IntentKind::Restore;
    options.torqueOff = true;
    options.keepOrder = true;
    options.stopOnFailure = true;
    if (m_progress)
        options.onProgress = [this](std::size_t done, std::size_t total) {
            m_progress({double(done) / double(total)});
        };
    const auto report = device::write(m_context, m_servo, items, options);
    if (!report)
        return tl::unexpected(report.error());
    if (!report->openIntent.isEmpty())
        m_openIntents << report->openIntent;
    addResults(*report);
    return {};
}

base::Result<device::WriteReport> RestoreRunner::changeIdentity(const RestoreWrite& write)
{
    if (write.stage == RestoreStage::Id)
        return changeId(m_context, m_servo, static_cast<int>(write.to));
    for (const catalog::NamedValue& value : m_servo.profile->find(write.key)->values) {
        if (value.value == write.to)
            return changeBaud(m_context, m_servo, value.key.toInt());
    }
    return base::fail(ErrorCode::OutOfRange, restoreRunOperation, QString::number(write.to),
                      m_servo.id);
}

void RestoreRunner::addRefused(const RestoreWrite& write, const base::Error& why)
{
    m_outcome.rows.push_back({{write.key,
                               write.address,
                               write.from,
                               write.to,
                               {},
                               device::outcomeBeforeSending(why),
                               why}});
}

base::Error RestoreRunner::skippedAfterFailure(const QString& key) const
{
    return {ErrorCode::Stopped, restoreRunOperation, QStringLiteral("after-failure"), m_servo.id,
            key};
}

/// All rows without a result yet.
void RestoreRunner::addAllRefused(const std::vector<RestoreWrite>& writes, const base::Error& why)
{
    for (const RestoreWrite& write : writes) {
        const bool isReported =
            std::any_of(m_outcome.rows.begin(), m_outcome.rows.end(),
                        [&](const auto& row) { return row.write.key == write.key; });
        if (!isReported)
            addRefused(write, why);
    }
}

void RestoreRunner::writeIdentity(const std::vector<RestoreWrite>& writes)
{
    for (const RestoreWrite& write : writes) {
        if (!needsOwnJob(write))
            continue;
        if (!isSuccessful()) {
            addRefused(write, skippedAfterFailure(write.key));
            continue;
        }
        const auto report = changeIdentity(write);
        if (report)
            addResults(*report);
        else
            addRefused(write, report.error());
    }
}

/// The lock was left open, or a restore was interrupted before its last step.
void RestoreRunner::closeOpenLock()
{
    if (!isLockOpen(m_servo))
        return;
    m_outcome.lock = device::closeLock(m_context, m_servo);
    if (m_outcome.lock == device::LockState::Closed)
        m_context.note(NoticeCode::LockClosed, m_servo.id);
}

base::Result<void> RestoreRunner::writeAll(const std::vector<RestoreWrite>& writes)
{
    if (const auto fresh = readFresh(m_context, m_servo, writes); !fresh)
        return fresh;
    const bool isAnythingToWrite =
        std::any_of(writes.begin(), writes.end(),
                    [&](const RestoreWrite& write) { return isStillToWrite(write); });
    if (!isAnythingToWrite) {
        closeOpenLock();
        return {};
    }
    if (const auto written = writeRegisters(writes); !written)
        return written;
    writeIdentity(writes);
    return {};
}

base::Result<void> RestoreRunner::run(const std::vector<base::Intent>& earlier,
                                      const std::vector<RestoreWrite>& writes)
{
    forgetTorque();
    if (finishInterrupted(earlier)) {
        const auto written = writeAll(writes);
        if (!written && m_outcome.rows.empty())
            return written;
        if (!written)
            addAllRefused(writes, written.error());
    } else {
        addAllRefused(writes, skippedAfterFailure({}));
    }
    const bool hasNoRows = m_outcome.rows.empty();
    if (hasNoRows && m_unfinished)
        return tl::unexpected(*m_unfinished);
    if (!isSuccessful())
        m_outcome.verdict = RestoreVerdict::Failed;
    else
        m_outcome.verdict = hasNoRows ? RestoreVerdict::AlreadySet : RestoreVerdict::Done;
    if (hasNoRows)
        return {};
    if (!isSuccessful() && m_options.onFailure == OnFailure::RollBack)
        rollBack();
    noteTorque();
    return {};
}

/// From now on only new readings count.
void RestoreRunner::forgetTorque()
{
    if (const auto* torque = m_servo.profile->byRole(catalog::Role::TorqueSwitch))
        m_servo.image.invalidate(torque->offset, torque->size);
}

/// Notes torque off, only if the servo has shown it.
void RestoreRunner::noteTorque()
{
    const catalog::Register* torque = m_servo.profile->byRole(catalog::Role::TorqueSwitch);
    if (torque == nullptr)
        return;
    auto torqueRaw = m_servo.raw(*torque);
    if (!torqueRaw) {
        if (const auto now = device::readRegister(m_context, m_servo, *torque))
            torqueRaw = *now;
    }
    if (torqueRaw == 0)
        m_context.note(NoticeCode::TorqueStaysOff, m_servo.id);
}

/// The rows that may not have their old value any more. A register that refused still has it.
std::vector<device::WriteItem> RestoreRunner::previousItems() const
{
    std::vector<device::WriteItem> items;
    for (const RestoreRowResult& row : m_outcome.rows) {
        const WriteResult& result = row.write;
        const bool untouched = device::isUntouched(result.outcome);
        const catalog::Register* reg = m_servo.profile->find(result.key);
        if (!untouched && result.oldRaw && reg != nullptr && !reg->identity)
            items.push_back({result.key, *result.oldRaw});
    }
    return items;
}

/// The journal's outcome for the rows of an undone intent: none was kept.
std::vector<base::ItemResult> RestoreRunner::revertedItemEnds() const
{
    std::vector<base::ItemResult> ends;
    for (const RestoreRowResult& row : m_outcome.rows) {
        ends.push_back(
            {row.write.key, row.write.readBack,
             row.rolledBack ? QStringLiteral("undone") : device::outcomeName(row.write.outcome)});
    }
    return ends;
}

void RestoreRunner::rollBack()
{
    // The user's stop is one of the reasons for rolling back, so it must not end the rollback.
    const base::StopToken neverStop;
    const device::Context context{m_context.bus,  m_context.catalog, m_context.journal,
                                  neverStop,      m_context.notices, m_context.priority,
                                  m_context.hold, m_context.epoch};
    const auto items = previousItems();
    device::WriteReport report;
    report.lock = m_outcome.lock;
    if (!items.empty()) {
        device::WriteOptions options;
        options.consent = device::Consent::ofEarlierChange();
        options.allowPreviousValues = true;
        options.kind = base::IntentKind::Restore;
        options.torqueOff = true;
        const auto written = device::write(context, m_servo, items, options);
        if (!written) {
            for (const device::WriteItem& item : items)
                m_outcome.notReverted << item.key;
            m_outcome.isChangeOpen = !m_openIntents.isEmpty();
            return;
        }
        report = *written;
        m_outcome.isChangeOpen = !m_openIntents.isEmpty() || !report.openIntent.isEmpty();
    }
    addRollBack(report);
    if (!report.isSuccessful())
        return;
    m_outcome.isChangeOpen = false;
    m_outcome.verdict = RestoreVerdict::RolledBack;
    for (const QString& uuid : std::as_const(m_openIntents))
        m_context.record(uuid, m_servo.id, {QStringLiteral("undone"), {}, revertedItemEnds()});
}

void RestoreRunner::addRollBack(const device::WriteReport& report)
{
    m_outcome.lock = report.lock;
    for (RestoreRowResult& row : m_outcome.rows) {
        const auto back =
            std::find_if(report.writes.begin(), report.writes.end(),
                         [&](const WriteResult& result) { return result.key == row.write.key; });
        row.rolledBack = back != report.writes.end() && isAccepted(*back);
        if (back != report.writes.end())
            row.write.readBack = back->readBack;
        if (back != report.writes.end() && !row.rolledBack)
            m_outcome.notReverted << row.write.key;
    }
}
} // namespace jobs
