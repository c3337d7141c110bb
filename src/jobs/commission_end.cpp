// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a servo on the line: its row, its name in the history.
#include "jobs/commission_line.h"
#include "jobs/commission_settle.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::CommissionPending;
using record::CommissionTrouble;
using record::CommissionVerdict;

namespace {
/// So often a servo whose change is still open is waited for again; then its row says "failed".
constexpr int maxReturns = 2;

bool endsLine(ErrorCode code)
{
    switch (code) {
    case ErrorCode::LinkLost:
    case ErrorCode::Stopped:
    case ErrorCode::Preempted:
    case ErrorCode::Held:
    case ErrorCode::FileUnwritable:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileFormat:
    case ErrorCode::DiskFull:
        return true;
    default:
        return false;
    }
}

CommissionTrouble troubleOf(const base::Error& error)
{
    return {base::errorName(error.code),
            error.registerKey.isEmpty() ? error.detail : error.registerKey};
}
} // namespace

/// Is it the very servo? Then what was begun on it is brought to one side.
base::Result<CommissionLine::Stay> CommissionLine::stayed(CommissionWork& work,
                                                          const CommissionPending& begun)
{
    if (m_context.bus.hasBaud() && m_context.bus.baud() != work.servo.baud) {
        if (const auto set = m_context.bus.setBaud(work.servo.baud); !set)
            return tl::unexpected(set.error());
    }
    if (!leftOpen(m_context, work.servo, begun))
        return Stay::NotProven;
    const auto settled = settleIntents(m_context, begun);
    if (!settled && endsLine(settled.error().code))
        return tl::unexpected(settled.error());
    const bool over = settled.has_value() && !owesChange(m_context, begun);
    return over ? Stay::Settled : Stay::Unsettled;
}

/// Its lock may be open by now: the batch says so.
base::Result<void> CommissionLine::lose()
{
    m_lost = true;
    return keep();
}

/// Ends the line, or waits for a servo that has gone away, or sets its failure down.
base::Result<void> CommissionLine::failed(CommissionWork& work, const base::Error& error)
{
    if (endsLine(error.code))
        return tl::unexpected(error);
    const base::Protocol language = work.servo.protocol;
    std::optional<Place> here;
    for (const int baud : {work.servo.baud, work.newBaud, work.row.oldBaud}) {
        for (const int id : {work.servo.id, work.newId, work.row.servo.id}) {
            if (here || id < 0)
                continue;
            const auto present = m_look.present({language, id, baud});
            if (!present)
                return tl::unexpected(present.error());
            if (*present)
                here = Place{language, id, baud};
        }
    }
    CommissionPending* one = pendingOf(work);
    if (!here)
        return one != nullptr ? lose() : base::Result<void>();
    if (one != nullptr && one->idRead && here->id != work.newId)
        return lose(); // another servo has taken its place
    work.servo.id = here->id;
    work.servo.baud = here->baud;
    if (one != nullptr && owesChange(m_context, *one)) {
        const auto known = stayed(work, *one);
        if (!known)
            return tl::unexpected(known.error());
        // It may have been swapped for another one, so it is identified again.
        if (*known == Stay::NotProven && ++m_returns[work.newId] <= maxReturns)
            return lose();
    }
    if (one != nullptr && here->id != work.newId && one->idSent && !owesChange(m_context, *one)) {
        one->idSent = false; // it is proven to answer as before: no servo has the new ID
        if (const auto kept = keep(); !kept)
            return kept;
    }
    work.row.troubles.push_back(troubleOf(error));
    work.row.verdict = CommissionVerdict::Failed;
    return finish(work);
}

QString CommissionLine::labelOf(const CommissionWork& work) const
{
    record::CommissionRow row = work.row;
    row.newId = work.newId;
    row.newBaud = row.newBaud > 0 ? row.newBaud : work.newBaud;
    return record::commissionLabel(m_spec.labelFormat, row).trimmed();
}

base::Result<void> CommissionLine::keepName(CommissionWork& work, const QString& label)
{
    if (!m_hooks.name || label.isEmpty() || label == work.named)
        return {};
    const bool another = work.row.servo.id != work.newId || work.newId == factoryId;
    const auto named = m_hooks.name(work.servo, label, another);
    if (named)
        work.named = label;
    return named;
}

base::Result<void> CommissionLine::finish(CommissionWork& work)
{
    record::CommissionRow& row = work.row;
    if (work.servo.id == work.newId) {
        row.newId = work.newId;
        row.newBaud = work.servo.baud;
    }
    row.label = row.newId < 0 ? QString() : labelOf(work);
    if (const auto named = keepName(work, row.label); !named)
        row.troubles.push_back({QStringLiteral("label-not-kept"), troubleOf(named.error()).word});
    const bool alarmed = std::any_of(row.troubles.begin(), row.troubles.end(), [](const auto& one) {
        return one.word == QLatin1String("alarm");
    });
    if (row.verdict == CommissionVerdict::Good && !row.troubles.empty())
        row.verdict = alarmed ? CommissionVerdict::Failed : CommissionVerdict::Remark;
    // What the journal still holds open is not over with this row: it stays unfinished.
    const CommissionPending* one = pendingOf(work);
    if (one != nullptr && !owesChange(m_context, *one))
        m_batch.pending.erase(m_batch.pending.begin() + (one - m_batch.pending.data()));
    CommissionView view;
    view.baud = work.servo.baud;
    view.newId = row.newId;
    view.newBaud = row.newBaud;
    view.snapshot = row.snapshot;
    return enter(work, row, view);
}

/// On the disk before anybody is told of it.
base::Result<void> CommissionLine::enter(const CommissionWork& work,
                                         const record::CommissionRow& row, CommissionView view)
{
    m_batch.rows.push_back(row);
    m_batch.onWire = {base::protocolName(work.servo.protocol), work.servo.id, work.servo.baud};
    if (const auto kept = keep(); !kept)
        return kept;
    if (m_hooks.onRow)
        m_hooks.onRow(row);
    view.servo = row.servo;
    view.concerns = row.troubles;
    return awaitGone(placeOf(work.servo), view);
}
} // namespace jobs
