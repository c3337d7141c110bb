// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/restore_plan.h"

#include "base/enum_names.h"
#include "device/motion/saved_speed.h"
#include "jobs/restore/restore_rows.h"

#include <algorithm>
#include <array>

namespace jobs {
using catalog::Role;

namespace {
constexpr base::EnumName<RestoreReason> reasonNames[]{
    {RestoreReason::Same, "same"},
    {RestoreReason::Identity, "identity"},
    {RestoreReason::Live, "live"},
    {RestoreReason::OptIn, "off-unless-asked"},
    {RestoreReason::MovesShaft, "moves-shaft"},
    {RestoreReason::ReadOnly, "read-only"},
    {RestoreReason::Factory, "factory"},
    {RestoreReason::NeedsConsent, "needs-consent"},
    {RestoreReason::NoSuchRegister, "no-such-register"},
    {RestoreReason::NotInFile, "not-in-file"},
    {RestoreReason::NoValue, "no-value"},
    {RestoreReason::NotRead, "not-read"},
    {RestoreReason::OutsideRange, "outside-range"},
    {RestoreReason::OtherMeaning, "other-meaning"},
    {RestoreReason::Converted, "converted"},
    {RestoreReason::PlainNumber, "plain-number"},
    {RestoreReason::NotChosen, "not-chosen"},
    {RestoreReason::OtherModelLimit, "other-model-limit"},
    {RestoreReason::WouldAlarm, "would-alarm"},
    {RestoreReason::OnlyTemporary, "only-temporary"},
};

bool hasReason(const RestoreRow& row, RestoreReason reason)
{
    return row.reasons.testFlag(reason);
}

void copyFileValues(RestoreRow& row, const snapshot::SnapshotRegister& file)
{
    row.fileRaw = file.raw;
    row.fileValue = file.value;
    row.fileUnit = file.unit;
    row.reasons.setFlag(RestoreReason::NoValue, !file.raw);
}

bool canBeSelected(const RestoreRow& row, const catalog::Profile& profile)
{
    constexpr std::array blockingReasons{
        RestoreReason::Same,    RestoreReason::Live,         RestoreReason::ReadOnly,
        RestoreReason::NotRead, RestoreReason::OutsideRange, RestoreReason::NoSuchRegister};
    return profile.writable && row.newRaw.has_value() &&
           std::none_of(blockingReasons.begin(), blockingReasons.end(),
                        [&](RestoreReason reason) { return hasReason(row, reason); });
}

bool selectedBy(const RestoreRow& row, const RestoreChoice& choice)
{
    const bool named = choice.only.contains(row.key);
    return row.isSelectable && !hasReason(row, RestoreReason::NotChosen) &&
           (!hasReason(row, RestoreReason::Identity) || choice.identity) &&
           (!hasReason(row, RestoreReason::NeedsConsent) || choice.consent) &&
           (!hasReason(row, RestoreReason::OtherModelLimit) ||
            choice.otherModelLimits.contains(row.key)) &&
           (!hasReason(row, RestoreReason::OptIn) || choice.live || named) &&
           (!hasReason(row, RestoreReason::PlainNumber) || named);
}

/// A row that was named must show its result. A template's identity rows are not meant for every
/// servo, so they count only where they are chosen.
bool isRequestedRow(const RestoreRow& row, const snapshot::Snapshot& snapshot,
                    const RestoreChoice& choice)
{
    if (!choice.only.isEmpty())
        return choice.only.contains(row.key);
    return snapshot.isTemplate && (choice.identity || !hasReason(row, RestoreReason::Identity));
}

RestoreRow makeRow(const device::Servo& servo, const catalog::Register& reg,
                   const snapshot::Snapshot& snapshot, const Compatibility& compatibility,
                   const RestoreChoice& choice)
{
    RestoreRow row;
    row.key = reg.key;
    row.address = reg.address;
    row.now = servo.raw(reg);
    row.reasons = registerReasons(reg);
    row.stage = stageOf(reg);
    row.reasons.setFlag(RestoreReason::NotRead, !row.now);
    const snapshot::SnapshotRegister* file = snapshot.find(reg.key);
    row.reasons.setFlag(RestoreReason::NotInFile, file == nullptr);
    if (file != nullptr) {
        copyFileValues(row, *file);
        if (file->raw)
            mapValue(row, servo, reg, *file, compatibility);
    }
    row.reasons.setFlag(RestoreReason::Same, row.now && row.now == row.newRaw);
    if (row.newRaw && !hasReason(row, RestoreReason::Same) && reg.writable()) {
        if (compatibility.otherModel && isProtectionLimit(reg))
            row.reasons |=
                RestoreReasons(RestoreReason::OtherModelLimit) | RestoreReason::NeedsConsent;
        predictAlarm(row, servo, reg);
    }
    row.reasons.setFlag(RestoreReason::NotChosen,
                        !choice.only.isEmpty() && !choice.only.contains(reg.key));
    row.isSelectable = canBeSelected(row, *servo.profile);
    row.selected = selectedBy(row, choice);
    row.isRequested = isRequestedRow(row, snapshot, choice);
    return row;
}

RestoreRow unmatchedRow(const snapshot::SnapshotRegister& file, const snapshot::Snapshot& snapshot,
                        const RestoreChoice& choice)
{
    RestoreRow row;
    row.key = file.key;
    row.address = file.address;
    copyFileValues(row, file);
    row.reasons |= RestoreReason::NoSuchRegister;
    row.reasons.setFlag(RestoreReason::ReadOnly, file.access == catalog::Access::ReadOnly);
    row.reasons.setFlag(RestoreReason::NotChosen,
                        !choice.only.isEmpty() && !choice.only.contains(file.key));
    row.isRequested = isRequestedRow(row, snapshot, choice);
    return row;
}

/// Where the file's angle limits are both 0, and that is a mode without limits here.
void requireConsentForLimits(RestorePlan& plan, const RestoreChoice& choice)
{
    device::RegisterValues limits;
    for (const RestoreRow& row : plan.rows) {
        const catalog::Register* reg = plan.servo.profile->find(row.key);
        const bool isWritten = row.newRaw && !hasReason(row, RestoreReason::Same) &&
                               !hasReason(row, RestoreReason::NotChosen);
        if (isWritten && (reg->role == Role::MinAngle || reg->role == Role::MaxAngle))
            limits.push_back({reg, *row.newRaw});
    }
    if (!device::removesAngleLimits(plan.servo, limits))
        return;
    for (const device::RegisterValue& limit : limits) {
        const auto row = std::find_if(plan.rows.begin(), plan.rows.end(),
                                      [&](const auto& one) { return one.key == limit.reg->key; });
        row->reasons |= RestoreReason::NeedsConsent;
        row->selected = selectedBy(*row, choice);
    }
}

bool isUnmapped(const RestoreRow& row)
{
    constexpr RestoreReasons ignoredReasons = RestoreReasons(RestoreReason::Same) |
                                              RestoreReason::Live | RestoreReason::ReadOnly |
                                              RestoreReason::NotInFile | RestoreReason::NotChosen;
    return !row.isSelectable && !(row.reasons & ignoredReasons);
}

int sortRank(const RestoreRow& row)
{
    if (row.isSelectable)
        return 0;
    return isUnmapped(row) ? 1 : 2;
}
} // namespace

QString restoreReasonName(RestoreReason reason)
{
    return base::nameOf(reasonNames, reason);
}

QStringList restoreReasonNames(RestoreReasons reasons)
{
    QStringList names;
    for (const auto& [reason, name] : reasonNames) {
        if (reasons.testFlag(reason))
            names << QLatin1String(name);
    }
    return names;
}

const RestoreRow* RestorePlan::find(const QString& key) const
{
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.key == key; });
    return found == rows.end() ? nullptr : &*found;
}

bool RestorePlan::setSelected(const QString& key, bool on)
{
    for (RestoreRow& row : rows) {
        if (row.key != key || !row.isSelectable)
            continue;
        row.selected = on;
        return true;
    }
    return false;
}

bool RestorePlan::needsConsent() const
{
    return std::any_of(rows.begin(), rows.end(), [](const RestoreRow& row) {
        return row.selected && hasReason(row, RestoreReason::NeedsConsent);
    });
}

std::vector<const RestoreRow*> RestorePlan::unmappedRows() const
{
    std::vector<const RestoreRow*> left;
    for (const RestoreRow& row : rows) {
        if (isUnmapped(row))
            left.push_back(&row);
    }
    return left;
}

std::vector<const RestoreRow*> omittedRows(const RestorePlan& plan)
{
    constexpr RestoreReasons presentReasons =
        RestoreReasons(RestoreReason::Same) | RestoreReason::NotInFile | RestoreReason::NotChosen;
    constexpr RestoreReasons expected = RestoreReasons(RestoreReason::Identity) |
                                        RestoreReason::Live | RestoreReason::ReadOnly |
                                        RestoreReason::Factory;
    std::vector<const RestoreRow*> left;
    for (const RestoreRow& row : plan.rows) {
        const bool isOmitted = !row.selected && !(row.reasons & presentReasons);
        if (isOmitted && (row.isRequested || !(row.reasons & expected)))
            left.push_back(&row);
    }
    return left;
}

std::vector<const RestoreRow*> predictedAlarms(const RestorePlan& plan)
{
    std::vector<const RestoreRow*> rows;
    for (const RestoreRow& row : plan.rows) {
        if (!row.alarm.isEmpty() && row.isSelectable)
            rows.push_back(&row);
    }
    return rows;
}

int RestorePlan::count(RestoreReason reason) const
{
    return static_cast<int>(std::count_if(rows.begin(), rows.end(),
                                          [&](const auto& row) { return hasReason(row, reason); }));
}

RestorePlan planRestore(const device::Servo& servo, const snapshot::Snapshot& snapshot,
                        const RestoreChoice& choice)
{
    const catalog::Profile& profile = *servo.profile;
    const Compatibility compatibility = compatibilityOf(servo, snapshot);
    RestorePlan plan;
    plan.id = servo.id;
    plan.servo = servo;
    plan.otherMap = !compatibility.sameMap;
    plan.otherModel = compatibility.otherModel;
    plan.sourceModel = snapshot.servo.model;
    plan.otherFirmware = snapshot.servo.firmware != profile.identity.firmware();
    plan.isTemplate = snapshot.isTemplate;
    for (const catalog::Register& reg : profile.registers) {
        if (!snapshot.isTemplate || snapshot.find(reg.key) != nullptr)
            plan.rows.push_back(makeRow(servo, reg, snapshot, compatibility, choice));
    }
    requireConsentForLimits(plan, choice);
    for (const snapshot::SnapshotRegister& file : snapshot.registers) {
        if (profile.find(file.key) == nullptr)
            plan.rows.push_back(unmatchedRow(file, snapshot, choice));
    }
    // The order of the list; restore_steps.cpp decides the order of the writes.
    std::stable_sort(
        plan.rows.begin(), plan.rows.end(), [](const RestoreRow& a, const RestoreRow& b) {
            return std::pair(sortRank(a), a.address) < std::pair(sortRank(b), b.address);
        });
    return plan;
}

RestorePlan planRestore(const device::Context& context, const device::Servo& servo,
                        const snapshot::Snapshot& snapshot, const RestoreChoice& choice)
{
    RestorePlan plan = planRestore(servo, snapshot, choice);
    plan.positionSpeed = device::savedSpeed(context.journal, servo).value_or(std::nullopt);
    selectTemporary(context, plan, choice.consent);
    return plan;
}

void selectTemporary(const device::Context& context, RestorePlan& plan, device::Consent consent)
{
    if (const auto temporary = device::temporaryValues(context.journal, plan.servo))
        selectTemporary(plan, *temporary, consent);
}

void selectTemporary(RestorePlan& plan, const device::TemporaryValues& temporary,
                     device::Consent consent)
{
    for (RestoreRow& row : plan.rows) {
        if (!hasReason(row, RestoreReason::Same) || hasReason(row, RestoreReason::Identity) ||
            !device::mayBeTemporary(temporary, row.key, row.now))
            continue;
        row.reasons.setFlag(RestoreReason::Same, false);
        row.reasons |= RestoreReason::OnlyTemporary;
        row.isSelectable = canBeSelected(row, *plan.servo.profile);
        row.selected = row.isSelectable && !hasReason(row, RestoreReason::NotChosen) &&
                       (!hasReason(row, RestoreReason::NeedsConsent) || consent);
    }
}
} // namespace jobs
