// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover.h"

#include "device/write_access.h"
#include "jobs/change.h"
#include "jobs/recover_look.h"
#include "jobs/recover_settle.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;

namespace {
/// Of a snapshot's rows each is known by itself; of others the whole is. What finishing had to
/// write was not written back then: it has an intent of its own, with its time, and here only what
/// it was found with is known.
std::vector<base::ItemEnd> itemEnds(const base::Intent& intent, const device::Servo& servo,
                                    const Settled& settled, const QString& word)
{
    const bool undone = word == QLatin1String("undone");
    const QString unknown = device::outcomeName(device::WriteOutcome::Unknown);
    std::vector<base::ItemEnd> ends;
    if (isSnapshotRestore(intent) && settled.report)
        ends = settled.report->itemEnds();
    for (base::ItemEnd& end : ends)
        end.outcome = undone ? word : end.outcome;
    for (const QString& key : settled.left)
        ends.push_back({key, servo.raw(key), unknown});
    if (undone)
        return ends;
    for (const device::WriteItem& item : settled.writtenNow) {
        const auto known = std::find_if(ends.begin(), ends.end(),
                                        [&](const auto& end) { return end.key == item.key; });
        if (known != ends.end())
            ends.erase(known);
        ends.push_back({item.key, item.raw, unknown});
    }
    return ends;
}

bool ofOneServo(const base::Intent& a, const base::Intent& b)
{
    return a.servo.id == b.servo.id && a.servo.port == b.servo.port && a.servo.sameKind(b.servo) &&
           isSnapshotRestore(a) && isSnapshotRestore(b);
}

/// The way back of a restore that did not succeed: it writes what that one had found.
bool leadsBack(const base::Intent& later, const base::Intent& restore)
{
    const auto found = [&](const base::JournalItem& item) {
        return std::any_of(restore.items.begin(), restore.items.end(), [&](const auto& before) {
            return before.key == item.key && before.oldRaw == item.newRaw;
        });
    };
    return ofOneServo(later, restore) && std::all_of(later.items.begin(), later.items.end(), found);
}

struct Wish {
    base::Intent intent;
    RecoverAction action = RecoverAction::Look;
};

/// Oldest first, and undone from the latest on. A restore whose way back had begun was given up
/// then, with every try to finish it: that ends with the values before, whatever is asked of all.
std::vector<Wish> wishesFor(const std::vector<base::Intent>& open, RecoverAction action)
{
    std::vector<Wish> wishes;
    for (const base::Intent& intent : open)
        wishes.push_back({intent, action});
    if (action == RecoverAction::Look)
        return wishes;
    const auto place = [](std::size_t at) { return static_cast<std::ptrdiff_t>(at); };
    for (std::size_t back = open.size(); back-- > 0;) {
        std::size_t first = 0;
        while (first < back && !leadsBack(open[back], open[first]))
            ++first;
        if (first == back)
            continue;
        for (std::size_t i = first; i < back; ++i) {
            if (ofOneServo(open[i], open[back]))
                wishes[i].action = RecoverAction::Undo;
        }
        wishes[back].action = RecoverAction::Finish;
        if (action == RecoverAction::Finish)
            std::reverse(wishes.begin() + place(first), wishes.begin() + place(back + 1));
        back = first;
    }
    if (action == RecoverAction::Undo)
        std::reverse(wishes.begin(), wishes.end());
    return wishes;
}

/// A restore leaves torque off, also one that is ended later.
void noteTorque(const device::Context& context, const Recovered& one)
{
    if (one.torqueIsOff)
        context.note(device::NoticeCode::TorqueStaysOff, one.before.foundId);
}
} // namespace

namespace {
/// Nothing can be settled on a servo that has not been found.
std::optional<base::Error> notFound(const OpenIntent& open)
{
    const QString operation = QStringLiteral("recover");
    switch (open.finding) {
    case Finding::NoAnswer:
        return base::Error{ErrorCode::NoAnswer, operation, {}, open.intent.servo.id};
    case Finding::OtherServo:
        return base::Error{ErrorCode::IdentityDiffers, operation, {}, open.intent.servo.id};
    case Finding::Unreadable:
        return open.unreadable;
    default:
        return std::nullopt;
    }
}

base::Error underWay(const base::Intent& intent)
{
    return {ErrorCode::Held, QStringLiteral("recover"), QStringLiteral("other-program"),
            intent.servo.id};
}

Recovered leftAlone(const base::Intent& intent, RecoverAction action)
{
    Recovered recovered;
    recovered.action = action;
    recovered.before.intent = intent;
    recovered.before.finding = Finding::UnderWay;
    if (action != RecoverAction::Look)
        recovered.error = underWay(intent);
    return recovered;
}

/// What a later write has replaced is not this change's any more.
base::Intent withoutReplaced(const OpenIntent& open)
{
    base::Intent rest = open.intent;
    std::erase_if(rest.items,
                  [&](const base::JournalItem& item) { return open.replaced.contains(item.key); });
    return rest;
}

/// Restoring its defaults may have moved the servo. Where the rows are put back, ID and rate follow
/// by the way that is safe for them.
base::Result<void> moveBack(const device::Context& context, const base::Intent& intent,
                            device::Servo& servo)
{
    const auto proved = [](const base::Result<device::WriteReport>& report) {
        if (!report)
            return base::Result<void>(tl::unexpected(report.error()));
        return report->allGood()
                   ? base::Result<void>()
                   : base::fail(ErrorCode::LockOpen, QStringLiteral("recover"), {}, report->id);
    };
    if (servo.id != intent.servo.id) {
        if (const auto moved = proved(changeId(context, servo, intent.servo.id)); !moved)
            return moved;
    }
    if (!context.bus.hasBaud() || intent.servo.baud <= 0 || servo.baud == intent.servo.baud)
        return {};
    return proved(changeBaud(context, servo, intent.servo.baud));
}

/// ID and rate, which are no plain rows.
base::Intent withoutPlace(base::Intent intent, const device::Servo& servo)
{
    std::erase_if(intent.items, [&](const base::JournalItem& item) {
        const catalog::Register* reg = servo.profile->find(item.key);
        return reg != nullptr && reg->identity;
    });
    return intent;
}

base::Result<void> prepareWriting(const device::Context& context, device::Servo& servo,
                                  const BeforeWrite& beforeWrite)
{
    const auto may = device::beginWriting(context, servo, QStringLiteral("recover"));
    return may && beforeWrite ? beforeWrite(context, servo) : may;
}

/// How the journal has the end of a change that has been settled.
QString endWord(const Recovered& recovered)
{
    if (recovered.allLeft)
        return QStringLiteral("abandoned");
    const bool finished =
        recovered.action == RecoverAction::Finish && !onlyBack(recovered.before.intent);
    return finished ? QStringLiteral("done") : QStringLiteral("undone");
}

void endSettled(const device::Context& context, const device::Servo& servo, const Settled& settled,
                Recovered& recovered)
{
    const base::Intent& intent = recovered.before.intent;
    if (recovered.before.lockOpen.value_or(false))
        context.note(device::NoticeCode::LockClosed, servo.id);
    recovered.left = settled.left;
    recovered.allLeft = settled.nothingToSettle && !settled.left.isEmpty();
    const QString word = endWord(recovered);
    context.record(intent.uuid, servo.id, {word, {}, itemEnds(intent, servo, settled, word)});
    recovered.done = true;
}
} // namespace

base::Result<Recovered> recoverOne(const device::Context& context, const base::Intent& intent,
                                   RecoverAction action, const BeforeWrite& beforeWrite)
{
    if (intent.underWayElsewhere)
        return leftAlone(intent, action);
    Recovered recovered;
    recovered.action = action;
    device::Servo servo;
    const auto before = look(context, intent, servo);
    if (!before)
        return tl::unexpected(before.error());
    recovered.before = *before;
    if (action == RecoverAction::Look)
        return recovered;
    if (const auto bar = notFound(*before)) {
        recovered.error = bar;
        return recovered;
    }
    if (const auto ready = prepareWriting(context, servo, beforeWrite); !ready) {
        recovered.error = ready.error();
        return recovered;
    }
    base::Intent rest = withoutReplaced(*before);
    const bool moved = intent.kind == IntentKind::Restore && !newValuesKnown(intent) &&
                       (servo.id != intent.servo.id || servo.baud != intent.servo.baud);
    if (moved)
        rest = withoutPlace(std::move(rest), servo);
    Settled settled = settle(context, rest, servo, action);
    settled.left = before->replaced + settled.left;
    if (settled.result && moved && action == RecoverAction::Undo)
        settled.result = moveBack(context, intent, servo);
    recovered.report = settled.report;
    recovered.torqueIsOff = settled.torqueIsOff;
    if (!settled.result) {
        recovered.error = settled.result.error();
        return recovered;
    }
    endSettled(context, servo, settled, recovered);
    return recovered;
}

bool isSettledBy(const Recovered& recovered, const device::Servo& servo,
                 const catalog::Register& reg)
{
    return !recovered.left.contains(reg.key) && isRecoverable(recovered.before.intent, servo, reg);
}

namespace {
bool isTaken(const base::Intent& intent, const QString& port, IntentPorts ports)
{
    if (intent.servo.port == port)
        return true;
    base::ServoIdentity here;
    here.port = port;
    if (ports == IntentPorts::This || intent.servo.isSimulated() != here.isSimulated())
        return false;
    return ports == IntentPorts::Any || !isPortPresent(intent);
}
} // namespace

std::vector<base::Intent> begunElsewhere(const std::vector<base::Intent>& open, const QString& port,
                                         IntentPorts ports)
{
    std::vector<base::Intent> elsewhere;
    std::copy_if(open.begin(), open.end(), std::back_inserter(elsewhere), [&](const auto& intent) {
        return !intent.servo.isSimulated() && !isTaken(intent, port, ports);
    });
    return elsewhere;
}

bool isPortPresent(const base::Intent& intent)
{
    const QString& port = intent.servo.port;
    return QDir::isAbsolutePath(port) && QFileInfo::exists(port);
}

base::Result<void> forget(base::Journal& journal, const base::Intent& intent)
{
    if (intent.underWayElsewhere)
        return tl::unexpected(underWay(intent));
    return journal.end(intent.uuid, {QStringLiteral("abandoned"), {}});
}

base::Result<std::vector<Recovered>> recover(const device::Context& outer, RecoverAction action,
                                             const RecoverOptions& options)
{
    const auto open = outer.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    const QString port = context.bus.portName();
    std::vector<base::Intent> asked;
    std::copy_if(open->begin(), open->end(), std::back_inserter(asked), [&](const auto& intent) {
        return isTaken(intent, port, options.ports) &&
               (options.uuid.isEmpty() || intent.uuid == options.uuid);
    });
    std::vector<Recovered> all;
    const int baudBefore = context.bus.baud();
    for (const Wish& wish : wishesFor(asked, action)) {
        if (context.stop.requested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("recover"));
        auto one = recoverOne(context, wish.intent, wish.action, options.beforeWrite);
        if (context.bus.hasBaud()) // also after an error: whoever comes next counts on it
            (void)context.bus.setBaud(baudBefore);
        if (!one)
            return tl::unexpected(one.error());
        if (one->error && one->error->code == ErrorCode::LinkLost)
            return tl::unexpected(*one->error);
        noteTorque(context, *one);
        all.push_back(std::move(*one));
    }
    return all;
}
} // namespace jobs
