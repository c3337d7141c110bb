// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore.h"

#include "device/motion.h"
#include "device/persistence.h"
#include "device/reader.h"
#include "jobs/change.h"
#include "jobs/recover.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using device::NoticeCode;
using device::WriteOutcome;
using device::WriteResult;

namespace {
const QString operation = QStringLiteral("restore");

bool took(const WriteResult& result)
{
    return !result.error &&
           (result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary);
}

bool isOwnJob(const RestoreWrite& write)
{
    return write.stage == RestoreStage::Id || write.stage == RestoreStage::Baud;
}

/// The values now are what the journal will call the values before: read afresh, since the plan may
/// have been looked at for an hour.
base::Result<void> readNow(const device::Context& context, device::Servo& servo,
                           const std::vector<RestoreWrite>& writes)
{
    std::vector<const catalog::Register*> registers;
    for (const RestoreWrite& write : writes) {
        const catalog::Register* reg = servo.profile->find(write.key);
        servo.image.forget(reg->offset, reg->size);
        registers.push_back(reg);
    }
    return device::read(context, servo, registers);
}

base::Result<void> checkPlan(const device::Servo& servo, const RestorePlan& plan,
                             const RestoreOptions& options)
{
    const bool same = plan.id == servo.id && plan.servo.profile && servo.profile &&
                      plan.servo.profile->mapKey == servo.profile->mapKey &&
                      plan.servo.profile->identity == servo.profile->identity;
    if (!same)
        return base::fail(ErrorCode::BadArgument, operation, QStringLiteral("other servo"),
                          servo.id);
    if (!plan.needsConsent() || options.dangerous)
        return {};
    base::Error error{ErrorCode::NeedsConsent, operation, {}, servo.id};
    for (const RestoreRow& row : plan.rows) {
        if (row.ticked && row.reasons.testFlag(RestoreReason::NeedsConsent)) {
            error.registerKey = row.key;
            break;
        }
    }
    return tl::unexpected(error);
}

/// A restore of these very values that was broken off: its intent is open. Restoring again asks for
/// its end, which recovery knows best: it also writes again what may stand in RAM only.
std::vector<QString> brokenOff(const device::Context& context, const device::Servo& servo,
                               const RestorePlan& plan)
{
    std::vector<QString> uuids;
    const auto open = context.journal.open();
    if (!open)
        return uuids;
    const base::ServoIdentity who = servo.identity();
    for (const base::Intent& intent : *open) {
        const bool ours = intent.kind == base::IntentKind::Restore && intent.servo.id == who.id &&
                          intent.servo.port == who.port && intent.servo.sameKind(who);
        const auto wanted = [&](const base::JournalItem& item) {
            const RestoreRow* row = plan.find(item.key);
            return row != nullptr && row->wanted == item.newRaw &&
                   (row->ticked || row->reasons.testFlag(RestoreReason::Same));
        };
        if (ours && !intent.items.empty() &&
            std::all_of(intent.items.begin(), intent.items.end(), wanted))
            uuids.push_back(intent.uuid);
    }
    return uuids;
}

bool lockStandsOpen(const device::Servo& servo)
{
    const auto lock = servo.raw(catalog::Role::Lock);
    return lock && device::isOpen(*lock);
}

class Restorer {
public:
    Restorer(const device::Context& context, device::Servo& servo, const RestoreOptions& options,
             RestoreOutcome& outcome)
        : m_context(context)
        , m_servo(servo)
        , m_options(options)
        , m_outcome(outcome)
    {}

    /// What was broken off earlier, to its end.
    void finishEarlier(const std::vector<QString>& uuids);
    /// The registers, in one transaction. Errors: nothing was written.
    base::Result<void> writeRegisters(const std::vector<RestoreWrite>& writes);
    /// Registers, then ID and rate. False: everything was so already. Errors: nothing was written.
    base::Result<bool> writeAll(const std::vector<RestoreWrite>& writes);
    /// ID and rate, each as a job of its own.
    void writeIdentity(const std::vector<RestoreWrite>& writes);
    void rollBack();
    bool good() const;

private:
    void take(const device::WriteReport& report);
    void refuse(const RestoreWrite& write, const base::Error& why);
    base::Result<device::WriteReport> change(const RestoreWrite& write);
    std::vector<device::WriteItem> itemsBefore() const;

    const device::Context& m_context;
    device::Servo& m_servo;
    const RestoreOptions& m_options;
    RestoreOutcome& m_outcome;
    QString m_openIntent;
};

void Restorer::take(const device::WriteReport& report)
{
    for (const WriteResult& result : report.writes)
        m_outcome.rows.push_back({result});
    m_outcome.lock = report.lock;
}

bool Restorer::good() const
{
    return std::all_of(m_outcome.rows.begin(), m_outcome.rows.end(),
                       [](const RestoreRowResult& row) { return took(row.write); }) &&
           m_outcome.lock != device::LockState::Open &&
           m_outcome.lock != device::LockState::Unknown;
}

/// If it fails, the ordinary way is left, and the intent stays open.
void Restorer::finishEarlier(const std::vector<QString>& uuids)
{
    for (const QString& uuid : uuids) {
        const auto done = recover(m_context, RecoverAction::Finish, {false, uuid, {}});
        if (!done)
            return;
        for (const Recovered& one : *done) {
            if (one.done && one.report)
                take(*one.report);
        }
    }
}

base::Result<void> Restorer::writeRegisters(const std::vector<RestoreWrite>& writes)
{
    std::vector<device::WriteItem> items;
    for (const RestoreWrite& write : writes) {
        if (!isOwnJob(write) && m_servo.raw(write.key) != write.to)
            items.push_back({write.key, write.to});
    }
    if (items.empty())
        return device::setTorque(m_context, m_servo, device::Torque::Off);
    device::WriteOptions options;
    options.dangerous = m_options.dangerous;
    options.kind = base::IntentKind::Restore;
    options.torqueOff = true;
    options.inOrder = true;
    options.stopAtFailure = true;
    const auto report = device::write(m_context, m_servo, items, options);
    if (!report)
        return tl::unexpected(report.error());
    m_openIntent = report->openIntent;
    take(*report);
    return {};
}

base::Result<device::WriteReport> Restorer::change(const RestoreWrite& write)
{
    if (write.stage == RestoreStage::Id)
        return changeId(m_context, m_servo, static_cast<int>(write.to));
    for (const catalog::NamedValue& value : m_servo.profile->find(write.key)->values) {
        if (value.value == write.to)
            return changeBaud(m_context, m_servo, value.key.toInt());
    }
    return base::fail(ErrorCode::OutOfRange, operation, QString::number(write.to), m_servo.id);
}

void Restorer::refuse(const RestoreWrite& write, const base::Error& why)
{
    m_outcome.rows.push_back(
        {{write.key, write.address, write.from, write.to, {}, WriteOutcome::Refused, why}});
}

void Restorer::writeIdentity(const std::vector<RestoreWrite>& writes)
{
    for (const RestoreWrite& write : writes) {
        if (!isOwnJob(write))
            continue;
        if (!good()) {
            refuse(write, {ErrorCode::Stopped, operation, QStringLiteral("after-failure"),
                           m_servo.id, write.key});
            continue;
        }
        const auto report = change(write);
        if (report)
            take(*report);
        else
            refuse(write, report.error());
    }
}

base::Result<bool> Restorer::writeAll(const std::vector<RestoreWrite>& writes)
{
    if (const auto fresh = readNow(m_context, m_servo, writes); !fresh)
        return tl::unexpected(fresh.error());
    const bool differs = std::any_of(writes.begin(), writes.end(), [&](const RestoreWrite& write) {
        return m_servo.raw(write.key) != write.to;
    });
    if (!differs) {
        // Somebody left it open, or a restore was broken off before its last step.
        if (lockStandsOpen(m_servo))
            m_outcome.lock = device::closeLock(m_context, m_servo);
        return false;
    }
    if (const auto written = writeRegisters(writes); !written)
        return tl::unexpected(written.error());
    writeIdentity(writes);
    return true;
}

/// What may not be as before any more. A register that refused has proved that it is.
std::vector<device::WriteItem> Restorer::itemsBefore() const
{
    std::vector<device::WriteItem> items;
    for (const RestoreRowResult& row : m_outcome.rows) {
        const WriteResult& result = row.write;
        const bool untouched = result.outcome == WriteOutcome::Refused;
        const catalog::Register* reg = m_servo.profile->find(result.key);
        if (!untouched && result.oldRaw && reg != nullptr && !reg->identity)
            items.push_back({result.key, *result.oldRaw});
    }
    return items;
}

void Restorer::rollBack()
{
    const auto items = itemsBefore();
    device::WriteReport report;
    report.lock = m_outcome.lock;
    if (!items.empty()) {
        device::WriteOptions options;
        options.dangerous = true; // they had these values a moment ago
        options.asBefore = true;
        options.kind = base::IntentKind::Restore;
        options.torqueOff = true;
        const auto written = device::write(m_context, m_servo, items, options);
        if (!written)
            return;
        report = *written;
    }
    m_outcome.lock = report.lock;
    for (RestoreRowResult& row : m_outcome.rows) {
        const auto back =
            std::find_if(report.writes.begin(), report.writes.end(),
                         [&](const WriteResult& result) { return result.key == row.write.key; });
        row.rolledBack = back != report.writes.end() && took(*back);
        if (back != report.writes.end())
            row.write.readBack = back->readBack;
    }
    if (!report.allGood())
        return;
    m_outcome.verdict = RestoreVerdict::RolledBack;
    if (!m_openIntent.isEmpty())
        (void)m_context.journal.end(m_openIntent,
                                    {QStringLiteral("undone"), {}, report.itemEnds()});
}
} // namespace

base::Result<RestoreOutcome> restore(const device::Context& outer, device::Servo& servo,
                                     const RestorePlan& plan, const RestoreOptions& options,
                                     const ProgressFn& progress)
{
    if (const auto fit = checkPlan(servo, plan, options); !fit)
        return tl::unexpected(fit.error());
    RestoreOutcome outcome;
    outcome.oldId = outcome.newId = servo.id;
    outcome.oldBaud = outcome.newBaud = servo.baud;
    const std::vector<RestoreWrite> writes = writesOf(plan);
    const auto earlier = brokenOff(outer, servo, plan);
    if (writes.empty() && earlier.empty() && !lockStandsOpen(servo)) {
        outer.note(NoticeCode::AlreadySo, servo.id);
        return outcome;
    }
    if (options.beforeWrite) {
        if (const auto saved = options.beforeWrite(outer, servo); !saved)
            return tl::unexpected(saved.error());
    }
    // A servo that gets another ID or rate, or is looked for, needs the line to itself.
    const bool own = !earlier.empty() || std::any_of(writes.begin(), writes.end(), isOwnJob);
    const device::Owned owned =
        device::own(outer, own ? std::vector<int>() : std::vector<int>{servo.id});
    const device::Context& context = owned.context;
    if (progress)
        progress({});
    const std::size_t before = context.notices.size();
    Restorer restorer(context, servo, options, outcome);
    restorer.finishEarlier(earlier);
    const auto written = restorer.writeAll(writes);
    if (!written)
        return tl::unexpected(written.error());
    if (!*written && earlier.empty())
        return outcome;
    outcome.verdict = restorer.good() ? RestoreVerdict::Done : RestoreVerdict::Failed;
    if (outcome.verdict == RestoreVerdict::Failed && options.onFailure == OnFailure::RollBack)
        restorer.rollBack();
    for (std::size_t i = before; i < context.notices.size(); ++i)
        outcome.torqueSwitchedOff |= context.notices[i].code == NoticeCode::TorqueSwitchedOff;
    context.note(NoticeCode::TorqueStaysOff, servo.id);
    outcome.newId = servo.id;
    outcome.newBaud = servo.baud;
    if (progress)
        progress({1.0});
    return outcome;
}

bool restoresSnapshot(const base::Intent& intent)
{
    return std::any_of(intent.items.begin(), intent.items.end(),
                       [](const base::JournalItem& item) { return item.oldRaw != item.newRaw; });
}
} // namespace jobs
