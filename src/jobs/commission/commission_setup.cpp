// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_setup.h"

#include "device/write_access.h"
#include "jobs/commission/commission_recovery.h"
#include "jobs/restore/take_snapshot.h"

namespace jobs {
using base::ErrorCode;
using results::PendingCommission;

namespace {
const QString commissionSetupOperation = QStringLiteral("commission");
}

base::Result<void> CommissionSetup::run(CommissionWork& work, CommissionView& view)
{
    const auto step = [&](CommissionStep now, auto&& action) -> base::Result<void> {
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, commissionSetupOperation, {}, work.servo.id);
        view.step = now;
        view.baud = work.servo.baud;
        m_display.show(view);
        return action();
    };
    return begin(work, view)
        .and_then([&] {
            return step(CommissionStep::Template,
                        [&] { return applyTemplate(m_context, m_spec, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Id, [&] {
                // The name follows the ID at once: later writes then belong to this servo in the
                // history. It is tried again at the end.
                return assignId(work).map([&] { (void)saveName(work, labelOf(work)); });
            });
        })
        .and_then([&] {
            return step(CommissionStep::Rate, [&] { return changeServoRate(m_context, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Center, [&] { return centerServo(m_context, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Health, [&] { return checkHealth(m_context, work); });
        });
}

base::Result<void> CommissionSetup::begin(CommissionWork& work, CommissionView& view)
{
    if (view.isResumed) {
        if (const auto resumed = resume(work); !resumed)
            return resumed;
    }
    const PendingCommission* known = m_progress.pendingOf(work);
    const QString first = known != nullptr && view.isResumed ? known->snapshot : QString();
    if (hasWork(work)) {
        if (const auto saved = saveBefore(work, view); !saved)
            return saved;
    }
    if (!first.isEmpty())
        work.row.snapshot = first; // as it was at first, not when it was left unfinished
    view.snapshot = work.row.snapshot;
    return hasWork(work) ? m_progress.addPending(work, view.isResumed) : base::Result<void>();
}

base::Result<void> CommissionSetup::resume(CommissionWork& work)
{
    if (work.servo.id == work.newId)
        (void)saveName(work, labelOf(work)); // before anything more is written to it
    if (const PendingCommission* one = m_progress.pendingOf(work)) {
        if (const auto recovered = recoverOpenIntents(m_context, *one); !recovered)
            return recovered;
    }
    return checkServo(m_context, m_spec, work).map([](const auto&) {});
}

base::Result<void> CommissionSetup::saveBefore(CommissionWork& work, CommissionView& view)
{
    if (const auto may = device::beginWriting(m_context, work.servo, commissionSetupOperation);
        !may)
        return may;
    view.step = CommissionStep::Snapshot;
    m_display.show(view);
    if (!view.isResumed && work.servo.id == factoryId && m_callbacks.onNewServo)
        (void)m_callbacks.onNewServo(work.servo); // a history that fails refuses the write itself
    return saveTable(m_context, m_callbacks, work);
}

base::Result<void> CommissionSetup::assignId(CommissionWork& work)
{
    if (work.servo.id == work.newId)
        return {};
    PendingCommission* one = m_progress.pendingOf(work);
    if (!one->isIdSent) {
        one->isIdSent = true;
        if (const auto saved = m_progress.save(); !saved)
            return saved;
    }
    const auto given = changeServoId(m_context, work);
    if (work.isIdConfirmed) {
        one->isIdConfirmed = true;
        if (const auto saved = m_progress.save(); !saved)
            return saved;
    }
    return given;
}

QString CommissionSetup::labelOf(const CommissionWork& work) const
{
    results::CommissionRow row = work.row;
    row.newId = work.newId;
    row.newBaud = row.newBaud > 0 ? row.newBaud : work.newBaud;
    return results::commissionLabel(m_spec.labelFormat, row).trimmed();
}

base::Result<void> CommissionSetup::saveName(CommissionWork& work, const QString& label) const
{
    if (!m_callbacks.name || label.isEmpty() || label == work.savedLabel)
        return {};
    const bool another = work.row.servo.id != work.newId || work.newId == factoryId;
    const auto named = m_callbacks.name(work.servo, label, another);
    if (named)
        work.savedLabel = label;
    return named;
}
} // namespace jobs
