// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/commission_line.h"
#include "jobs/commission_settle.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::CommissionPending;
using record::CommissionTrouble;
using record::CommissionVerdict;

namespace {
const QString operation = QStringLiteral("commission");

/// What is kept in them tells two of a kind apart, as far as anything does.
bool sameSettings(const device::Servo& one, const device::Servo& other)
{
    return std::none_of(one.profile->registers.begin(), one.profile->registers.end(),
                        [&](const catalog::Register& reg) {
                            const auto before = one.raw(reg);
                            const auto now = other.raw(reg);
                            return reg.area == catalog::Area::Eprom && before && now &&
                                   *before != *now;
                        });
}
} // namespace

CommissionPending* CommissionLine::pendingFor(int newId, const QString& protocol)
{
    for (CommissionPending& one : m_batch.pending) {
        if (one.newId == newId && one.servo.protocol == protocol)
            return &one;
    }
    return nullptr;
}

CommissionPending* CommissionLine::pendingOf(const CommissionWork& work)
{
    return pendingFor(work.newId, work.row.servo.protocol);
}

/// Is it one that was left in the middle? Then it goes on with what it was to get. At its old place
/// it may as well be another one of the kind, if the new ID may have been written already or a
/// write to it has not ended, unless its lock still stands open. Once the new ID was read back it
/// certainly is another one.
bool CommissionLine::recognise(CommissionWork& work, CommissionView& view)
{
    const record::SnapshotServo who = servoRecord(work.servo);
    for (const CommissionPending& one : m_batch.pending) {
        const bool sameKind = one.servo.protocol == who.protocol &&
                              one.servo.modelId == who.modelId &&
                              one.servo.firmware == who.firmware;
        const bool atNew = one.idSent && who.id == one.newId;
        const bool atOld = who.id == one.servo.id && !one.idRead;
        const bool rate = work.servo.baud == one.oldBaud || work.servo.baud == one.newBaud;
        if (!sameKind || !rate || !(atNew || atOld))
            continue;
        work.proven = leftOpen(m_context, work.servo, one);
        const bool begun = one.idSent || owesChange(m_context, one);
        if (!atNew && begun && !work.proven) {
            view.doubtfulId = one.newId;
            continue;
        }
        work.newId = one.newId;
        work.row.servo = one.servo;
        work.row.oldBaud = one.oldBaud;
        view.doubtfulId = -1;
        return true;
    }
    return false;
}

/// Beside the question whether it is the one that was begun: what is known of that one.
void CommissionLine::addUnfinished(const CommissionWork& work, CommissionView& view)
{
    const int newId = view.doubtfulId >= 0 ? view.doubtfulId : work.newId;
    const CommissionPending* one = pendingFor(newId, work.row.servo.protocol);
    if (one == nullptr)
        return;
    for (const CommissionTrouble& trouble : record::unfinishedTroubles(*one))
        view.concerns.push_back(trouble);
}

base::Result<void> CommissionLine::deal(device::Servo servo)
{
    m_lost = false;
    CommissionView view;
    view.step = CommissionStep::Checking;
    CommissionWork work;
    work.servo = std::move(servo);
    work.row.at = QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
    work.row.servo = servoRecord(work.servo);
    work.row.oldBaud = work.servo.baud;
    work.newId = nextId().value_or(-1);
    work.newBaud = m_spec.baud > 0 ? m_spec.baud : work.servo.baud;
    view.halfDone = recognise(work, view);
    if (work.newId < 0)
        work.newId = view.doubtfulId; // there is no ID for another one
    view.servo = servoRecord(work.servo);
    view.baud = work.servo.baud;
    const int id = work.servo.id;
    if (!view.halfDone && id != factoryId && m_batch.idTaken(id)) {
        view.newId = id;
        view.newBaud = view.baud;
        view.concerns = {{QStringLiteral("already-done")}};
        return awaitGone(placeOf(work.servo), view);
    }
    auto concerns = checkServo(m_context, m_spec, work);
    if (!concerns)
        return failed(work, concerns.error());
    if (!view.halfDone && id != factoryId)
        concerns->push_back({QStringLiteral("other-id"), QString::number(id)});
    if (work.newId < 0)
        return setAside(work, {{QStringLiteral("no-id-left")}});
    const auto agreed = decide(work, view, *concerns);
    if (!agreed || !*agreed)
        return agreed ? base::Result<void>() : tl::unexpected(agreed.error());
    work.row.troubles = *concerns;
    view.newId = work.newId;
    view.halfDone = view.halfDone || work.newId == view.doubtfulId;
    if (const auto done = setUp(work, view); !done)
        return failed(work, done.error());
    return finish(work);
}

/// As confirm(). Without a click where nothing speaks against it; but whatever answers after a
/// silence may be another servo, and that is for the user to say.
base::Result<bool> CommissionLine::decide(CommissionWork& work, CommissionView& view,
                                          std::vector<CommissionTrouble>& concerns)
{
    view.newId = work.newId;
    view.newBaud = work.newBaud;
    view.concerns = concerns;
    const bool unclear = view.doubtfulId >= 0 || (view.halfDone && !work.proven);
    if (unclear)
        addUnfinished(work, view);
    show(view);
    if (!m_spec.automatic || unclear)
        return confirm(work, view, concerns);
    if (std::none_of(concerns.begin(), concerns.end(), needsDecision))
        return true;
    const auto aside = setAside(work, concerns);
    return aside ? base::Result<bool>(false) : tl::unexpected(aside.error());
}

/// False: it is not to be set up now, and whatever is to be done about that has been done.
base::Result<bool> CommissionLine::confirm(CommissionWork& work, CommissionView view,
                                           std::vector<CommissionTrouble>& concerns)
{
    view.step = CommissionStep::Confirm;
    show(view);
    int silences = 0;
    for (;;) {
        CommissionAnswer answer = m_hooks.answer ? m_hooks.answer() : CommissionAnswer::None;
        if (answer == CommissionAnswer::Continue && view.doubtfulId == work.newId)
            answer = CommissionAnswer::None; // there is no ID for another one
        if (answer == CommissionAnswer::SetAside) {
            const auto aside = setAside(work, concerns);
            return aside ? base::Result<bool>(false) : tl::unexpected(aside.error());
        }
        if (answer == CommissionAnswer::SameServo && view.doubtfulId >= 0)
            work.newId = view.doubtfulId;
        if (answer != CommissionAnswer::None)
            return stillAlone(work);
        const auto here = m_look.present(placeOf(work.servo));
        if (!here)
            return tl::unexpected(here.error());
        silences = *here ? 0 : silences + 1;
        if (silences >= silencesUntilGone)
            return false;
        if (const auto paused = pause(answerPause); !paused)
            return tl::unexpected(paused.error());
    }
}

/// Between the check and the click another servo may have been plugged in, or swapped for it.
base::Result<bool> CommissionLine::stillAlone(CommissionWork& work)
{
    CommissionView checking = *m_view;
    checking.step = CommissionStep::Checking;
    show(checking);
    device::Servo now;
    const auto ready = alone(placeOf(work.servo), now);
    if (!ready || !*ready || now.id != work.servo.id || now.baud != work.servo.baud ||
        !now.identity().sameKind(work.servo.identity()))
        return ready ? base::Result<bool>(false) : ready;
    if (const auto read = device::readAll(m_context, now); !read)
        return read.error().code == ErrorCode::NoAnswer
                   ? base::Result<bool>(false)
                   : base::Result<bool>(tl::unexpected(read.error()));
    return sameSettings(work.servo, now);
}

base::Result<void> CommissionLine::setAside(const CommissionWork& work,
                                            const std::vector<CommissionTrouble>& why)
{
    record::CommissionRow row = work.row;
    row.servo = servoRecord(work.servo);
    row.verdict = CommissionVerdict::Aside;
    row.troubles = why;
    if (why.empty())
        row.troubles = {{QStringLiteral("by-hand")}};
    row.volts = work.servo.physical(catalog::Role::PresentVoltage);
    row.celsius = work.servo.physical(catalog::Role::PresentTemperature);
    CommissionView view;
    view.baud = row.oldBaud;
    return enter(work, row, view);
}

/// From here on the servo is in the batch's file, so that it is known wherever it is left.
base::Result<void> CommissionLine::begin(CommissionWork& work, CommissionView& view)
{
    if (view.halfDone) {
        if (work.servo.id == work.newId)
            (void)keepName(work, labelOf(work)); // before anything more is written to it
        if (const CommissionPending* one = pendingOf(work)) {
            if (const auto settled = settleIntents(m_context, *one); !settled)
                return settled;
        }
        const auto concerns = checkServo(m_context, m_spec, work);
        if (!concerns)
            return tl::unexpected(concerns.error());
    }
    const CommissionPending* known = pendingOf(work);
    const QString first = known != nullptr && view.halfDone ? known->snapshot : QString();
    if (hasWork(work)) {
        const auto may = device::beginWriting(m_context, work.servo, operation);
        if (!may)
            return may;
        view.step = CommissionStep::Snapshot;
        show(view);
        if (!view.halfDone && work.servo.id == factoryId && m_hooks.meet)
            (void)m_hooks.meet(
                work.servo); // a history that cannot be used refuses the write itself
        if (const auto saved = saveTable(m_context, m_hooks, work); !saved)
            return saved;
    }
    if (!first.isEmpty())
        work.row.snapshot = first; // as it was when it came, not when it was left in the middle
    view.snapshot = work.row.snapshot;
    return hasWork(work) ? enlist(work, view) : base::Result<void>();
}

/// Into the batch's file.
base::Result<void> CommissionLine::enlist(const CommissionWork& work, const CommissionView& view)
{
    CommissionPending* known = pendingOf(work);
    const bool atNew = work.servo.id == work.newId;
    CommissionPending now{QDateTime::currentDateTimeUtc(),
                          work.row.servo,
                          work.row.oldBaud,
                          work.newId,
                          work.newBaud,
                          atNew,
                          work.row.snapshot};
    if (known != nullptr && view.halfDone) {
        now.at = known->at;
        now.idSent = now.idSent || known->idSent;
        now.idRead = known->idRead || (atNew && !owesChange(m_context, *known));
    }
    if (known != nullptr)
        *known = now; // of another one that never got the ID: it begins anew when it comes back
    else
        m_batch.pending.push_back(now);
    return keep();
}

base::Result<void> CommissionLine::takeId(CommissionWork& work)
{
    if (work.servo.id == work.newId)
        return {};
    CommissionPending* one = pendingOf(work);
    if (!one->idSent) {
        one->idSent = true;
        if (const auto kept = keep(); !kept)
            return kept;
    }
    const auto given = giveId(m_context, work);
    if (work.idRead) {
        one->idRead = true;
        if (const auto kept = keep(); !kept)
            return kept;
    }
    return given;
}

/// As early as it has its ID, so that what is written from now on is its own in the history.
base::Result<void> CommissionLine::placed(CommissionWork& work)
{
    return takeId(work).map([&] { (void)keepName(work, labelOf(work)); }); // tried again at the end
}

base::Result<void> CommissionLine::setUp(CommissionWork& work, CommissionView& view)
{
    const auto step = [&](CommissionStep now, auto&& work_) -> base::Result<void> {
        if (m_context.stop.requested())
            return base::fail(ErrorCode::Stopped, operation, {}, work.servo.id);
        view.step = now;
        view.baud = work.servo.baud;
        show(view);
        return work_();
    };
    return begin(work, view)
        .and_then([&] {
            return step(CommissionStep::Template,
                        [&] { return applyTemplate(m_context, m_spec, work); });
        })
        .and_then([&] { return step(CommissionStep::Id, [&] { return placed(work); }); })
        .and_then(
            [&] { return step(CommissionStep::Rate, [&] { return giveRate(m_context, work); }); })
        .and_then([&] {
            return step(CommissionStep::Center, [&] { return centerServo(m_context, work); });
        })
        .and_then([&] {
            return step(CommissionStep::Health, [&] { return checkHealth(m_context, work); });
        });
}
} // namespace jobs
