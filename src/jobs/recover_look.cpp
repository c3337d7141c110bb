// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/recover_look.h"

#include "device/move_limits.h"
#include "device/persistence.h"
#include "device/talk.h"
#include "jobs/recover_settle.h"
#include "jobs/restore_rows.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using base::IntentKind;
using catalog::Role;

namespace {
struct Place {
    int id = -1;
    int baud = 0;
};

void addPlace(std::vector<Place>& places, int id, int baud)
{
    const bool known = std::any_of(places.begin(), places.end(), [&](const Place& place) {
        return place.id == id && place.baud == baud;
    });
    if (!known)
        places.push_back({id, baud});
}

catalog::ProfilePtr profileOf(const device::Context& context, const base::Intent& intent)
{
    catalog::Identity who;
    who.firmwareMajor = intent.servo.firmwareMajor;
    who.firmwareMinor = intent.servo.firmwareMinor;
    who.modelMajor = intent.servo.modelMajor;
    who.modelMinor = intent.servo.modelMinor;
    who.protocol = intent.servo.protocol;
    return context.catalog.resolve(who);
}

int baudOfCode(const device::Context& context, const base::Intent& intent)
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

/// Where the servo may be: where it was, where the write would have put it, and at today's rate.
std::vector<Place> places(const device::Context& context, const base::Intent& intent)
{
    std::vector<int> ids{intent.servo.id};
    if (intent.kind == IntentKind::SetId && !intent.items.empty())
        ids.push_back(static_cast<int>(intent.items.front().newRaw));
    std::vector<int> bauds{context.bus.baud()};
    if (context.bus.hasBaud()) {
        bauds.push_back(intent.servo.baud);
        if (intent.kind == IntentKind::SetBaud)
            bauds.push_back(baudOfCode(context, intent));
    }
    std::vector<Place> result;
    for (const int baud : bauds) {
        for (const int id : ids) {
            if (baud > 0)
                addPlace(result, id, baud);
        }
    }
    return result;
}

/// Where a servo answers after its own defaults were restored, as far as that changed ID and rate.
std::vector<Place> factoryPlaces(const device::Context& context, const base::Intent& intent)
{
    constexpr int factoryId = 1;
    std::vector<Place> result;
    if (intent.kind != IntentKind::Restore || newValuesKnown(intent))
        return result;
    std::vector<int> bauds{context.bus.baud(), intent.servo.baud};
    const auto profile = profileOf(context, intent);
    if (const catalog::Register* reg = profile->byRole(Role::BaudRate)) {
        for (const catalog::NamedValue& value : reg->values)
            bauds.push_back(value.key.toInt());
    }
    if (!context.bus.hasBaud())
        bauds = {context.bus.baud()};
    for (const int id : {intent.servo.id, factoryId}) {
        for (const int baud : bauds) {
            if (baud > 0)
                addPlace(result, id, baud);
        }
    }
    return result;
}

/// What was heard besides the servos of the right kind.
struct Heard {
    bool others = false;
    std::optional<base::Error> unreadable{};

    void take(const base::Error& error)
    {
        switch (error.code) {
        case ErrorCode::NoAnswer:
            break;
        case ErrorCode::Garbled:
        case ErrorCode::WrongAnswer:
        case ErrorCode::LineBusy:
            unreadable = error;
            break;
        default:
            others = true;
        }
    }
};

/// The servos of the right kind among the places.
base::Result<std::vector<device::Servo>> candidates(const device::Context& context,
                                                    const base::Intent& intent,
                                                    const std::vector<Place>& among, Heard& heard)
{
    std::vector<device::Servo> found;
    for (const Place& place : among) {
        if (context.bus.hasBaud() && context.bus.baud() != place.baud &&
            !context.bus.setBaud(place.baud))
            continue; // this adapter cannot
        auto servo = device::identify(context, place.id, intent.servo.protocol);
        if (!servo) {
            if (servo.error().code == ErrorCode::LinkLost)
                return tl::unexpected(servo.error());
            heard.take(servo.error());
            continue;
        }
        base::ServoIdentity who = servo->identity();
        who.map = intent.servo.map.isEmpty() ? QString() : who.map;
        if (who.sameKind(intent.servo))
            found.push_back(*servo);
        else
            heard.others = true;
    }
    return found;
}

/// Those at their factory place that the lock tells to be the one: it was opened, and a servo that
/// was switched off since would have closed it.
base::Result<std::vector<device::Servo>> movedByDefaults(const device::Context& context,
                                                         const base::Intent& intent)
{
    Heard elsewhere;
    auto found = candidates(context, intent, factoryPlaces(context, intent), elsewhere);
    if (!found)
        return found;
    std::vector<device::Servo> open;
    for (device::Servo& servo : *found) {
        if (context.bus.hasBaud() && !context.bus.setBaud(servo.baud))
            continue;
        const catalog::Register* lock = servo.profile->byRole(Role::Lock);
        const auto flag = lock != nullptr ? device::readRegister(context, servo, *lock)
                                          : base::Result<std::int64_t>(device::lockClosed);
        if (flag && device::isOpen(*flag))
            open.push_back(std::move(servo));
    }
    return open;
}

/// The others say nothing about an interrupted write: what a servo never shows, and the commands
/// that a switch of the mode sets to zero.
bool isComparable(const base::Intent& intent, const device::Servo& servo,
                  const base::JournalItem& item)
{
    const catalog::Register* reg = servo.profile->find(item.key);
    if (reg == nullptr || provesServo(*reg))
        return reg != nullptr;
    return servo.raw(*reg) && !isZeroedBySwitch(intent, servo, *reg);
}

/// Neither the old value nor the new one, and yet no sign of another servo: a later write of this
/// program, or a register that is lost at power-off and may have been loaded by a restart. A
/// snapshot's row is restored whatever a restart has loaded.
enum class Neither : std::uint8_t { Replaced, LaterTry, ToBeRestored, OtherServo };

/// What was begun later for a servo like this.
base::Result<std::vector<base::JournalEntry>> laterThan(const device::Context& context,
                                                        const base::Intent& intent)
{
    auto entries = context.journal.entriesOf(intent.servo, entriesLookedAt);
    if (!entries)
        return entries;
    const auto own = std::find_if(entries->begin(), entries->end(), [&](const auto& entry) {
        return entry.intent.uuid == intent.uuid;
    });
    if (own != entries->end())
        entries->erase(entries->begin(), own + 1);
    return entries;
}

/// A later try that did not succeed may have left a third value, as its last reading tells. One
/// that somebody has written since on purpose is none of ours.
bool leftByLaterTry(const std::vector<base::JournalEntry>& later, const base::Intent& intent,
                    const QString& key, std::int64_t raw)
{
    std::optional<base::ItemEnd> last;
    for (const base::JournalEntry& entry : later) {
        if (!entry.end || entry.intent.servo.port != intent.servo.port)
            continue;
        for (const base::ItemEnd& item : entry.end->items) {
            if (item.key == key && item.readBack)
                last = item;
        }
    }
    const QString left = device::outcomeName(device::WriteOutcome::Mismatch);
    return last && last->readBack == raw && last->outcome == left;
}

/// Writes that came later lead from a value of this intent to the one that stands there now.
bool replacedLater(const std::vector<base::JournalEntry>& later, const base::Intent& intent,
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
            for (const base::ItemEnd& end : entry.end->items) {
                if (end.key == item.key && end.readBack)
                    now = end.readBack;
            }
        }
    }
    return now == raw;
}

Neither neitherOf(const base::Intent& intent, const device::Servo& servo,
                  const std::vector<base::JournalEntry>& later, const base::JournalItem& item)
{
    const auto raw = servo.raw(item.key);
    if (raw && leftByLaterTry(later, intent, item.key, *raw))
        return Neither::LaterTry;
    if (raw && replacedLater(later, intent, item, *raw))
        return Neither::Replaced;
    if (provesServo(*servo.profile->find(item.key)))
        return Neither::OtherServo;
    return isSnapshotRestore(intent) ? Neither::ToBeRestored : Neither::Replaced;
}

Finding compare(const base::Intent& intent, const device::Servo& servo,
                const std::vector<base::JournalEntry>& later, QStringList& replaced)
{
    int asOld = 0;
    int asNew = 0;
    for (const base::JournalItem& item : intent.items) {
        if (!isComparable(intent, servo, item))
            continue;
        const auto raw = servo.raw(item.key);
        if (!newValuesKnown(intent)) {
            ++(raw == item.oldRaw ? asOld : asNew);
            continue;
        }
        const bool isNew = raw == item.newRaw;
        if (isNew || raw == item.oldRaw) {
            ++(isNew ? asNew : asOld);
            continue;
        }
        switch (neitherOf(intent, servo, later, item)) {
        case Neither::OtherServo:
            return Finding::OtherServo;
        case Neither::LaterTry:
            ++asOld;
            ++asNew;
            break;
        case Neither::Replaced:
            replaced << item.key;
            break;
        case Neither::ToBeRestored:
            break;
        }
    }
    if (asOld + asNew == 0 && !replaced.isEmpty())
        return Finding::Replaced;
    if (asOld == 0)
        return Finding::AllNew;
    return asNew == 0 ? Finding::AllOld : Finding::Mixed;
}
} // namespace

bool newValuesKnown(const base::Intent& intent)
{
    // Of the two that restore, a snapshot's values are known; the servo's own (0x06) are not.
    const bool anywhere =
        std::any_of(intent.items.begin(), intent.items.end(),
                    [](const base::JournalItem& item) { return item.oldRaw != item.newRaw; });
    return intent.kind != IntentKind::Calibrate && (intent.kind != IntentKind::Restore || anywhere);
}

bool onlyBack(const base::Intent& intent)
{
    return intent.kind == IntentKind::Identify || intent.kind == IntentKind::Trial;
}

bool provesServo(const catalog::Register& reg)
{
    return device::lasting(reg) || reg.role == Role::OperatingMode;
}

bool isZeroedBySwitch(const base::Intent& intent, const device::Servo& servo,
                      const catalog::Register& reg)
{
    return reg.motion && !provesServo(reg) && changesMode(intent, servo);
}

bool isRecoverable(const base::Intent& intent, const device::Servo& servo,
                   const catalog::Register& reg)
{
    if (!reg.writable())
        return false;
    if (provesServo(reg) || !natureOf(reg).testFlag(RestoreReason::Live))
        return true;
    // The mark of a restart: a running time turns nothing by itself while goals are positions.
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

base::Result<OpenIntent> look(const device::Context& context, const base::Intent& intent,
                              device::Servo& servo)
{
    OpenIntent result;
    result.intent = intent;
    const int baudBefore = context.bus.baud();
    Heard heard;
    auto found = candidates(context, intent, places(context, intent), heard);
    if (found && found->empty())
        found = movedByDefaults(context, intent);
    if (!found)
        return tl::unexpected(found.error());
    // Two servos of the kind: nothing tells which of them the intent means.
    if (found->size() != 1) {
        result.unreadable = heard.unreadable;
        result.finding = !found->empty() || heard.others ? Finding::OtherServo
                         : heard.unreadable              ? Finding::Unreadable
                                                         : Finding::NoAnswer;
        if (context.bus.hasBaud())
            (void)context.bus.setBaud(baudBefore);
        return result;
    }
    servo = found->front();
    if (context.bus.hasBaud()) {
        if (const auto set = context.bus.setBaud(servo.baud); !set)
            return tl::unexpected(set.error());
    }
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    result.foundId = servo.id;
    result.foundBaud = servo.baud;
    const auto later = laterThan(context, intent);
    if (!later)
        return tl::unexpected(later.error());
    result.finding = compare(intent, servo, *later, result.replaced);
    if (const auto flag = servo.raw(Role::Lock))
        result.lockOpen = device::isOpen(*flag);
    return result;
}
} // namespace jobs
