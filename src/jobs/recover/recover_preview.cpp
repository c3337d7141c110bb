// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover/recover_preview.h"

#include "device/motion/move_limits.h"
#include "device/persistence.h"
#include "device/transactions.h"
#include "jobs/change/change.h"
#include "jobs/recover/recover_apply.h"
#include "jobs/restore/restore_rows.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;
using catalog::Role;

namespace {
struct BusLocation {
    int id = -1;
    int baud = 0;
};

void addLocation(std::vector<BusLocation>& candidateLocations, int id, int baud)
{
    const bool known = std::any_of(
        candidateLocations.begin(), candidateLocations.end(),
        [&](const BusLocation& location) { return location.id == id && location.baud == baud; });
    if (!known)
        candidateLocations.push_back({id, baud});
}

catalog::ProfilePtr profileOf(const device::Context& context, const base::Intent& intent)
{
    catalog::Identity identity;
    identity.firmwareMajor = intent.servo.firmwareMajor;
    identity.firmwareMinor = intent.servo.firmwareMinor;
    identity.modelMajor = intent.servo.modelMajor;
    identity.modelMinor = intent.servo.modelMinor;
    identity.protocol = intent.servo.protocol;
    return context.catalog.resolve(identity);
}

int baudFromCode(const device::Context& context, const base::Intent& intent)
{
    const auto profile = profileOf(context, intent);
    const catalog::Register* reg = profile->byRole(Role::BaudRate);
    if (reg == nullptr || intent.items.empty())
        return 0;
    for (const catalog::NamedValue& value : reg->values) {
        if (value.value == intent.items.front().newRaw)
            return value.key.toInt();
    }
    return 0;
}

/// The possible addresses of the servo: its old one, the one after the write, and the present rate.
std::vector<BusLocation> candidateLocations(const device::Context& context,
                                            const base::Intent& intent)
{
    std::vector<int> ids{intent.servo.id};
    if (intent.kind == IntentKind::SetId && !intent.items.empty())
        ids.push_back(static_cast<int>(intent.items.front().newRaw));
    std::vector<int> bauds{context.bus.baud()};
    if (context.bus.canSetBaud()) {
        bauds.push_back(intent.servo.baud);
        if (intent.kind == IntentKind::SetBaud)
            bauds.push_back(baudFromCode(context, intent));
    }
    std::vector<BusLocation> result;
    for (const int baud : bauds) {
        for (const int id : ids) {
            if (baud > 0)
                addLocation(result, id, baud);
        }
    }
    return result;
}

/// The address of a servo after its defaults were restored, if that changed ID and rate.
std::vector<BusLocation> factoryLocations(const device::Context& context,
                                          const base::Intent& intent)
{
    std::vector<BusLocation> result;
    if (intent.kind != IntentKind::Restore || hasKnownNewValues(intent))
        return result;
    std::vector<int> bauds{context.bus.baud(), intent.servo.baud};
    const auto profile = profileOf(context, intent);
    if (const catalog::Register* reg = profile->byRole(Role::BaudRate)) {
        for (const catalog::NamedValue& value : reg->values)
            bauds.push_back(value.key.toInt());
    }
    if (!context.bus.canSetBaud())
        bauds = {context.bus.baud()};
    for (const int id : {intent.servo.id, factoryId}) {
        for (const int baud : bauds) {
            if (baud > 0)
                addLocation(result, id, baud);
        }
    }
    return result;
}

/// What was received besides the servos of the right kind.
struct ReplyErrors {
    bool hasOtherServos = false;
    std::optional<base::Error> unreadable{};

    void take(const base::Error& error)
    {
        switch (error.code) {
        case ErrorCode::NoReply:
            break;
        case ErrorCode::Garbled:
        case ErrorCode::UnexpectedReply:
        case ErrorCode::LineBusy:
            unreadable = error;
            break;
        default:
            hasOtherServos = true;
        }
    }
};

/// The servos of the right kind at these addresses.
base::Result<std::vector<device::Servo>> findCandidates(const device::Context& context,
                                                        const base::Intent& intent,
                                                        const std::vector<BusLocation>& locations,
                                                        ReplyErrors& replyErrors)
{
    std::vector<device::Servo> found;
    for (const BusLocation& location : locations) {
        if (context.bus.canSetBaud() && context.bus.baud() != location.baud &&
            !context.bus.setBaud(location.baud))
            continue; // not supported by this adapter
        auto servo = device::identify(context, location.id, intent.servo.protocol);
        if (!servo) {
            if (servo.error().code == ErrorCode::LinkLost)
                return tl::unexpected(servo.error());
            replyErrors.take(servo.error());
            continue;
        }
        base::ServoIdentity identity = servo->identity();
        identity.map = intent.servo.map.isEmpty() ? QString() : identity.map;
        if (identity.isSameKind(intent.servo))
            found.push_back(*servo);
        else
            replyErrors.hasOtherServos = true;
    }
    return found;
}

/// Servos at the factory address whose lock identifies them: it was opened, and a servo that was
/// switched off since then would have closed it.
base::Result<std::vector<device::Servo>> findAfterFactoryReset(const device::Context& context,
                                                               const base::Intent& intent)
{
    ReplyErrors otherReplyErrors;
    auto found =
        findCandidates(context, intent, factoryLocations(context, intent), otherReplyErrors);
    if (!found)
        return found;
    std::vector<device::Servo> open;
    for (device::Servo& servo : *found) {
        if (context.bus.canSetBaud() && !context.bus.setBaud(servo.baud))
            continue;
        const catalog::Register* lock = servo.profile->byRole(Role::Lock);
        const auto flag = lock != nullptr ? device::readRegister(context, servo, *lock)
                                          : base::Result<std::int64_t>(device::lockClosed);
        if (flag && device::isLockOpen(*flag))
            open.push_back(std::move(servo));
    }
    return open;
}

/// The other registers prove nothing about an interrupted write: those that a servo never shows,
/// and the commands that a mode switch sets to zero.
bool isComparable(const base::Intent& intent, const device::Servo& servo,
                  const base::JournalItem& item)
{
    const catalog::Register* reg = servo.profile->find(item.key);
    if (reg == nullptr || identifiesServo(*reg))
        return reg != nullptr;
    return servo.raw(*reg) && !isZeroedByModeSwitch(intent, servo, *reg);
}

/// Neither the old value nor the new one, but no sign of another servo: a later write of this
/// program, or a register that is lost at power-off and may have been loaded by a restart. A
/// snapshot's row is restored for any value that a restart has loaded.
enum class UnmatchedCause : std::uint8_t { Replaced, LaterAttempt, ToBeRestored, OtherServo };

/// The later entries for a servo like this one.
base::Result<std::vector<base::JournalEntry>> entriesAfter(const device::Context& context,
                                                           const base::Intent& intent)
{
    auto entries = context.journal.entriesFor(intent.servo, maxJournalEntries);
    if (!entries)
        return entries;
    const auto own = std::find_if(entries->begin(), entries->end(), [&](const auto& entry) {
        return entry.intent.uuid == intent.uuid;
    });
    if (own != entries->end())
        entries->erase(entries->begin(), own + 1);
    return entries;
}

/// A later failed attempt may have left a third value, which its last reading shows. A value that
/// was written since then on purpose does not belong to this change.
bool isLeftByLaterAttempt(const std::vector<base::JournalEntry>& later, const base::Intent& intent,
                          const QString& key, std::int64_t raw)
{
    std::optional<base::ItemResult> last;
    for (const base::JournalEntry& entry : later) {
        if (!entry.end || entry.intent.servo.port != intent.servo.port)
            continue;
        for (const base::ItemResult& item : entry.end->items) {
            if (item.key == key && item.readBack)
                last = item;
        }
    }
    const QString left = device::outcomeName(device::WriteOutcome::Mismatch);
    return last && last->readBack == raw && last->outcome == left;
}

/// Whether later writes lead from a value of this intent to the present one.
bool isOverwrittenLater(const std::vector<base::JournalEntry>& later, const base::Intent& intent,
                        const base::JournalItem& item, std::int64_t raw)
{
    std::optional<std::int64_t> now;
    for (const base::JournalEntry& entry : later) {
        if (!entry.end || entry.intent.servo.port != intent.servo.port)
            continue;
        for (const base::JournalItem& next : entry.intent.items) {
            if (next.key != item.key)
                continue;
            const bool follows = now ? next.oldRaw == *now
                                     : next.oldRaw == item.oldRaw || next.oldRaw == item.newRaw;
            if (!follows)
                return false; // of another servo
            now = next.oldRaw;
            for (const base::ItemResult& end : entry.end->items) {
                if (end.key == item.key && end.readBack)
                    now = end.readBack;
            }
        }
    }
    return now == raw;
}

UnmatchedCause unmatchedCause(const base::Intent& intent, const device::Servo& servo,
                              const std::vector<base::JournalEntry>& later,
                              const base::JournalItem& item)
{
    const auto raw = servo.raw(item.key);
    if (raw && isLeftByLaterAttempt(later, intent, item.key, *raw))
        return UnmatchedCause::LaterAttempt;
    if (raw && isOverwrittenLater(later, intent, item, *raw))
        return UnmatchedCause::Replaced;
    if (identifiesServo(*servo.profile->find(item.key)))
        return UnmatchedCause::OtherServo;
    return isSnapshotRestore(intent) ? UnmatchedCause::ToBeRestored : UnmatchedCause::Replaced;
}

Finding compareValues(const base::Intent& intent, const device::Servo& servo,
                      const std::vector<base::JournalEntry>& later, QStringList& replaced)
{
    int oldCount = 0;
    int newCount = 0;
    for (const base::JournalItem& item : intent.items) {
        if (!isComparable(intent, servo, item))
            continue;
        const auto raw = servo.raw(item.key);
        if (!hasKnownNewValues(intent)) {
            ++(raw == item.oldRaw ? oldCount : newCount);
            continue;
        }
        const bool isNew = raw == item.newRaw;
        if (isNew || raw == item.oldRaw) {
            ++(isNew ? newCount : oldCount);
            continue;
        }
        switch (unmatchedCause(intent, servo, later, item)) {
        case UnmatchedCause::OtherServo:
            return Finding::OtherServo;
        case UnmatchedCause::LaterAttempt:
            ++oldCount;
            ++newCount;
            break;
        case UnmatchedCause::Replaced:
            replaced << item.key;
            break;
        case UnmatchedCause::ToBeRestored:
            break;
        }
    }
    if (oldCount + newCount == 0 && !replaced.isEmpty())
        return Finding::Replaced;
    if (oldCount == 0)
        return Finding::AllNew;
    return newCount == 0 ? Finding::AllOld : Finding::Mixed;
}
} // namespace

bool hasKnownNewValues(const base::Intent& intent)
{
    // Of the two kinds of restore, a snapshot's values are known; the servo's own (0x06) are not.
    return intent.kind != IntentKind::Calibrate &&
           (intent.kind != IntentKind::Restore || isSnapshotRestore(intent));
}

bool isRevertOnly(const base::Intent& intent)
{
    return intent.kind == IntentKind::Identify || intent.kind == IntentKind::Trial;
}

bool identifiesServo(const catalog::Register& reg)
{
    return device::isPersistent(reg) || reg.role == Role::OperatingMode;
}

bool isZeroedByModeSwitch(const base::Intent& intent, const device::Servo& servo,
                          const catalog::Register& reg)
{
    return reg.motion && !identifiesServo(reg) && changesMode(intent, servo);
}

bool isRecoverable(const base::Intent& intent, const device::Servo& servo,
                   const catalog::Register& reg)
{
    if (!reg.writable())
        return false;
    if (identifiesServo(reg) || !registerReasons(reg).testFlag(RestoreReason::Live))
        return true;
    // The mark of a restart: while goals are positions, a running time moves nothing by itself.
    return intent.kind == IntentKind::Trial && reg.role == Role::GoalTime && !reg.block &&
           device::goalKind(servo) == device::GoalKind::Position;
}

bool changesMode(const base::Intent& intent, const device::Servo& servo)
{
    for (const base::JournalItem& item : intent.items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        if (reg != nullptr && (reg->role == Role::OperatingMode || reg->role == Role::MinAngle ||
                               reg->role == Role::MaxAngle))
            return true;
    }
    return false;
}

base::Result<OpenIntent> previewIntent(const device::Context& context, const base::Intent& intent,
                                       device::Servo& servo)
{
    OpenIntent result;
    result.intent = intent;
    const int baudBefore = context.bus.baud();
    ReplyErrors replyErrors;
    auto found = findCandidates(context, intent, candidateLocations(context, intent), replyErrors);
    if (found && found->empty())
        found = findAfterFactoryReset(context, intent);
    if (!found)
        return tl::unexpected(found.error());
    // Two servos of this kind: it is not known which of them the intent means.
    if (found->size() != 1) {
        result.unreadable = replyErrors.unreadable;
        result.finding = !found->empty() || replyErrors.hasOtherServos ? Finding::OtherServo
                         : replyErrors.unreadable                      ? Finding::Unreadable
                                                                       : Finding::NoReply;
        if (context.bus.canSetBaud())
            (void)context.bus.setBaud(baudBefore);
        return result;
    }
    servo = found->front();
    if (context.bus.canSetBaud()) {
        if (const auto set = context.bus.setBaud(servo.baud); !set)
            return tl::unexpected(set.error());
    }
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    result.foundId = servo.id;
    result.foundBaud = servo.baud;
    const auto later = entriesAfter(context, intent);
    if (!later)
        return tl::unexpected(later.error());
    result.finding = compareValues(intent, servo, *later, result.replaced);
    if (const auto flag = servo.raw(Role::Lock))
        result.lockOpen = device::isLockOpen(*flag);
    return result;
}
} // namespace jobs
