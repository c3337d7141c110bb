// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore_plan.h"

#include "device/remembered_speed.h"
#include "jobs/restore_rows.h"

#include <algorithm>
#include <array>

namespace jobs {
namespace {
struct ReasonName {
    RestoreReason reason;
    const char* name;
};

constexpr std::array reasonNames{
    ReasonName{RestoreReason::Same, "same"},
    ReasonName{RestoreReason::Identity, "identity"},
    ReasonName{RestoreReason::Live, "live"},
    ReasonName{RestoreReason::OffUnlessAsked, "off-unless-asked"},
    ReasonName{RestoreReason::MovesShaft, "moves-shaft"},
    ReasonName{RestoreReason::ReadOnly, "read-only"},
    ReasonName{RestoreReason::Factory, "factory"},
    ReasonName{RestoreReason::NeedsConsent, "needs-consent"},
    ReasonName{RestoreReason::NoSuchRegister, "no-such-register"},
    ReasonName{RestoreReason::NotInFile, "not-in-file"},
    ReasonName{RestoreReason::NoValue, "no-value"},
    ReasonName{RestoreReason::NotRead, "not-read"},
    ReasonName{RestoreReason::OutsideRange, "outside-range"},
    ReasonName{RestoreReason::OtherMeaning, "other-meaning"},
    ReasonName{RestoreReason::Converted, "converted"},
    ReasonName{RestoreReason::PlainNumber, "plain-number"},
    ReasonName{RestoreReason::NotChosen, "not-chosen"},
    ReasonName{RestoreReason::OtherModelLimit, "other-model-limit"},
    ReasonName{RestoreReason::WouldAlarm, "would-alarm"},
    ReasonName{RestoreReason::OnlyTemporary, "only-temporary"},
};

bool has(const RestoreRow& row, RestoreReason reason)
{
    return row.reasons.testFlag(reason);
}

void takeFile(RestoreRow& row, const record::SnapshotRegister& file)
{
    row.fileRaw = file.raw;
    row.fileValue = file.value;
    row.fileUnit = file.unit;
    row.reasons.setFlag(RestoreReason::NoValue, !file.raw);
}

bool tickable(const RestoreRow& row, const catalog::Profile& profile)
{
    constexpr std::array never{RestoreReason::Same,         RestoreReason::Live,
                               RestoreReason::ReadOnly,     RestoreReason::NotRead,
                               RestoreReason::OutsideRange, RestoreReason::NoSuchRegister};
    return profile.writable && row.wanted.has_value() &&
           std::none_of(never.begin(), never.end(),
                        [&](RestoreReason reason) { return has(row, reason); });
}

bool tickedBy(const RestoreRow& row, const RestoreChoice& choice)
{
    const bool named = choice.only.contains(row.key);
    return row.mayTick && !has(row, RestoreReason::NotChosen) &&
           (!has(row, RestoreReason::Identity) || choice.identity) &&
           (!has(row, RestoreReason::NeedsConsent) || choice.dangerous) &&
           (!has(row, RestoreReason::OtherModelLimit) ||
            choice.otherModelLimits.contains(row.key)) &&
           (!has(row, RestoreReason::OffUnlessAsked) || choice.live || named) &&
           (!has(row, RestoreReason::PlainNumber) || named);
}

/// Who names a row wants to hear what became of it. A template's identity rows are not for every
/// servo it is given to, so they count only where they are chosen.
bool askedFor(const RestoreRow& row, const record::Snapshot& snapshot, const RestoreChoice& choice)
{
    if (!choice.only.isEmpty())
        return choice.only.contains(row.key);
    return snapshot.isTemplate && (choice.identity || !has(row, RestoreReason::Identity));
}

RestoreRow rowOf(const device::Servo& servo, const catalog::Register& reg,
                 const record::Snapshot& snapshot, const Kinship& kinship,
                 const RestoreChoice& choice)
{
    RestoreRow row;
    row.key = reg.key;
    row.address = reg.address;
    row.now = servo.raw(reg);
    row.reasons = natureOf(reg);
    row.stage = stageOf(reg);
    row.reasons.setFlag(RestoreReason::NotRead, !row.now);
    const record::SnapshotRegister* file = snapshot.find(reg.key);
    row.reasons.setFlag(RestoreReason::NotInFile, file == nullptr);
    if (file != nullptr) {
        takeFile(row, *file);
        if (file->raw)
            mapValue(row, servo, reg, *file, kinship);
    }
    row.reasons.setFlag(RestoreReason::Same, row.now && row.now == row.wanted);
    if (row.wanted && !has(row, RestoreReason::Same) && reg.writable()) {
        if (kinship.otherModel && isProtectionLimit(reg))
            row.reasons |=
                RestoreReasons(RestoreReason::OtherModelLimit) | RestoreReason::NeedsConsent;
        predictAlarm(row, servo, reg);
    }
    row.reasons.setFlag(RestoreReason::NotChosen,
                        !choice.only.isEmpty() && !choice.only.contains(reg.key));
    row.mayTick = tickable(row, *servo.profile);
    row.ticked = tickedBy(row, choice);
    row.asked = askedFor(row, snapshot, choice);
    return row;
}

RestoreRow foreignRow(const record::SnapshotRegister& file, const record::Snapshot& snapshot,
                      const RestoreChoice& choice)
{
    RestoreRow row;
    row.key = file.key;
    row.address = file.address;
    takeFile(row, file);
    row.reasons |= RestoreReason::NoSuchRegister;
    row.reasons.setFlag(RestoreReason::ReadOnly, file.access == catalog::Access::ReadOnly);
    row.reasons.setFlag(RestoreReason::NotChosen,
                        !choice.only.isEmpty() && !choice.only.contains(file.key));
    row.asked = askedFor(row, snapshot, choice);
    return row;
}

bool isUnmapped(const RestoreRow& row)
{
    constexpr RestoreReasons uninteresting = RestoreReasons(RestoreReason::Same) |
                                             RestoreReason::Live | RestoreReason::ReadOnly |
                                             RestoreReason::NotInFile | RestoreReason::NotChosen;
    return !row.mayTick && !(row.reasons & uninteresting);
}

int place(const RestoreRow& row)
{
    if (row.mayTick)
        return 0;
    return isUnmapped(row) ? 1 : 2;
}
} // namespace

QString restoreReasonName(RestoreReason reason)
{
    for (const ReasonName& entry : reasonNames) {
        if (entry.reason == reason)
            return QLatin1String(entry.name);
    }
    return {};
}

QStringList restoreReasonNames(RestoreReasons reasons)
{
    QStringList names;
    for (const ReasonName& entry : reasonNames) {
        if (reasons.testFlag(entry.reason))
            names << QLatin1String(entry.name);
    }
    return names;
}

const RestoreRow* RestorePlan::find(const QString& key) const
{
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.key == key; });
    return found == rows.end() ? nullptr : &*found;
}

bool RestorePlan::tick(const QString& key, bool on)
{
    for (RestoreRow& row : rows) {
        if (row.key != key || !row.mayTick)
            continue;
        row.ticked = on;
        return true;
    }
    return false;
}

bool RestorePlan::needsConsent() const
{
    return std::any_of(rows.begin(), rows.end(), [](const RestoreRow& row) {
        return row.ticked && has(row, RestoreReason::NeedsConsent);
    });
}

std::vector<const RestoreRow*> RestorePlan::unmapped() const
{
    std::vector<const RestoreRow*> left;
    for (const RestoreRow& row : rows) {
        if (isUnmapped(row))
            left.push_back(&row);
    }
    return left;
}

std::vector<const RestoreRow*> leftOut(const RestorePlan& plan)
{
    constexpr RestoreReasons notMissing =
        RestoreReasons(RestoreReason::Same) | RestoreReason::NotInFile | RestoreReason::NotChosen;
    constexpr RestoreReasons expected = RestoreReasons(RestoreReason::Identity) |
                                        RestoreReason::Live | RestoreReason::ReadOnly |
                                        RestoreReason::Factory;
    std::vector<const RestoreRow*> left;
    for (const RestoreRow& row : plan.rows) {
        const bool misses = !row.ticked && !(row.reasons & notMissing);
        if (misses && (row.asked || !(row.reasons & expected)))
            left.push_back(&row);
    }
    return left;
}

std::vector<const RestoreRow*> alarmsToCome(const RestorePlan& plan)
{
    std::vector<const RestoreRow*> rows;
    for (const RestoreRow& row : plan.rows) {
        if (!row.alarm.isEmpty() && row.mayTick)
            rows.push_back(&row);
    }
    return rows;
}

int RestorePlan::count(RestoreReason reason) const
{
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return has(row, reason); }));
}

RestorePlan planRestore(const device::Servo& servo, const record::Snapshot& snapshot,
                        const RestoreChoice& choice)
{
    const catalog::Profile& profile = *servo.profile;
    const Kinship kinship = kinshipOf(servo, snapshot);
    RestorePlan plan;
    plan.id = servo.id;
    plan.servo = servo;
    plan.otherMap = !kinship.sameMap;
    plan.otherModel = kinship.otherModel;
    plan.sourceModel = snapshot.servo.model;
    plan.otherFirmware = snapshot.servo.firmware != profile.identity.firmware();
    plan.isTemplate = snapshot.isTemplate;
    for (const catalog::Register& reg : profile.registers) {
        if (!snapshot.isTemplate || snapshot.find(reg.key) != nullptr)
            plan.rows.push_back(rowOf(servo, reg, snapshot, kinship, choice));
    }
    for (const record::SnapshotRegister& file : snapshot.registers) {
        if (profile.find(file.key) == nullptr)
            plan.rows.push_back(foreignRow(file, snapshot, choice));
    }
    std::stable_sort(plan.rows.begin(), plan.rows.end(),
                     [](const RestoreRow& a, const RestoreRow& b) {
                         return std::pair(place(a), a.address) < std::pair(place(b), b.address);
                     });
    return plan;
}

RestorePlan planRestore(const device::Context& context, const device::Servo& servo,
                        const record::Snapshot& snapshot, const RestoreChoice& choice)
{
    RestorePlan plan = planRestore(servo, snapshot, choice);
    plan.positionSpeed = device::rememberedSpeed(context.journal, servo).value_or(std::nullopt);
    tickTemporary(context, plan, choice.dangerous);
    return plan;
}

void tickTemporary(const device::Context& context, RestorePlan& plan, bool dangerous)
{
    if (const auto temporary = device::temporaryValues(context.journal, plan.servo))
        tickTemporary(plan, *temporary, dangerous);
}

void tickTemporary(RestorePlan& plan, const device::TemporaryValues& temporary, bool dangerous)
{
    for (RestoreRow& row : plan.rows) {
        if (!has(row, RestoreReason::Same) || has(row, RestoreReason::Identity) ||
            !device::mayBeTemporary(temporary, row.key, row.now))
            continue;
        row.reasons.setFlag(RestoreReason::Same, false);
        row.reasons |= RestoreReason::OnlyTemporary;
        row.mayTick = tickable(row, *plan.servo.profile);
        row.ticked = row.mayTick && !has(row, RestoreReason::NotChosen) &&
                     (!has(row, RestoreReason::NeedsConsent) || dangerous);
    }
}
} // namespace jobs
