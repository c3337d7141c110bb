// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/commission/commission_steps.h"

#include "device/alarms.h"
#include "device/motion/motion.h"
#include "device/persistence.h"
#include "device/reader.h"
#include "jobs/change/change.h"
#include "jobs/restore/restore.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;
using catalog::Role;
using results::CommissionIssue;

void addAlarms(const device::Servo& servo, std::vector<CommissionIssue>& issues)
{
    const catalog::Register* status = servo.profile->byRole(Role::Status);
    for (int bit = 0; bit < 8; ++bit) {
        if ((servo.status >> bit & 1) == 0)
            continue;
        QString name = QStringLiteral("bit%1").arg(bit);
        if (status != nullptr) {
            const auto known =
                std::find_if(status->values.begin(), status->values.end(),
                             [bit](const catalog::NamedValue& one) { return one.value == bit; });
            name = known == status->values.end() ? name : known->key;
        }
        issues.push_back({QStringLiteral("alarm"), name});
    }
    for (const device::Notice& alarm : device::derivedAlarms(servo))
        issues.push_back(
            {QStringLiteral("alarm"), alarm.code == device::NoticeCode::DerivedTemperature
                                          ? QStringLiteral("temperature")
                                          : QStringLiteral("voltage")});
}

bool supportsBaud(const device::Servo& servo, int baud)
{
    const catalog::Register* reg = servo.profile->byRole(Role::BaudRate);
    return reg != nullptr &&
           std::any_of(reg->values.begin(), reg->values.end(),
                       [baud](const auto& value) { return value.key == QString::number(baud); });
}

void addUnsupportedIssues(const CommissionSpec& spec, CommissionWork& work,
                          std::vector<CommissionIssue>& issues)
{
    const device::Servo& servo = work.servo;
    if (work.newBaud != servo.baud && !supportsBaud(servo, work.newBaud)) {
        issues.push_back({QStringLiteral("no-such-rate"), QString::number(work.newBaud)});
        work.newBaud = servo.baud;
    }
    const catalog::Register* reg = servo.profile->byRole(Role::Id);
    if (reg == nullptr || work.newId < reg->min.value_or(0) ||
        work.newId > reg->max.value_or(protocol::maxId))
        issues.push_back({QStringLiteral("no-such-id"), QString::number(work.newId)});
    const bool canCenter = servo.profile->centering != catalog::Centering::None &&
                           servo.profile->byRole(Role::PositionOffset) != nullptr;
    work.center = spec.center && canCenter;
    if (spec.center && !canCenter)
        issues.push_back({QStringLiteral("no-centring"), servo.profile->series});
}

void addTemplate(const device::Context& context, const CommissionSpec& spec, CommissionWork& work,
                 std::vector<CommissionIssue>& issues)
{
    if (!spec.settings)
        return;
    RestoreChoice choice;
    choice.consent = spec.consent;
    work.plan = planRestore(context, work.servo, *spec.settings, choice);
    if (work.plan->otherModel)
        issues.push_back({QStringLiteral("other-model"), spec.settings->servo.model});
    QStringList remainingRows;
    for (const RestoreRow* row : work.plan->unmappedRows())
        remainingRows.append(row->key);
    for (const RestoreRow& row : work.plan->rows) {
        const bool differs = row.newRaw && (row.now != row.newRaw ||
                                            row.reasons.testFlag(RestoreReason::OnlyTemporary));
        if (differs && row.reasons.testFlag(RestoreReason::NeedsConsent) && !row.selected)
            remainingRows.append(row.key);
    }
    remainingRows.removeDuplicates();
    if (!remainingRows.isEmpty() && spec.settings->isTemplate)
        issues.push_back({QStringLiteral("rows-left"), remainingRows.join(QLatin1Char(' '))});
}

/// The error of the first write that failed, or of a lock that stayed open.
base::Result<void> toResult(const device::WriteReport& report)
{
    if (report.isSuccessful())
        return {};
    for (const device::WriteResult& write : report.writes) {
        if (write.error)
            return tl::unexpected(*write.error);
    }
    return base::fail(ErrorCode::LockOpen, QStringLiteral("commission"), {}, report.id);
}

base::Result<void> readHealth(const device::Context& context, device::Servo& servo)
{
    std::vector<Role> wanted;
    for (const Role role :
         {Role::PresentVoltage, Role::PresentTemperature, Role::Status, Role::MaxTemperature,
          Role::MinVoltage, Role::MaxVoltage, Role::TorqueSwitch, Role::Lock, Role::BaudRate}) {
        if (servo.profile->byRole(role) != nullptr)
            wanted.push_back(role);
    }
    return device::readRoles(context, servo, wanted);
}

/// The value of the rate register, if there is one.
std::optional<int> storedBaud(const device::Servo& servo)
{
    const catalog::Register* reg = servo.profile->byRole(Role::BaudRate);
    const auto raw = reg != nullptr ? servo.raw(*reg) : std::nullopt;
    if (!raw)
        return std::nullopt;
    for (const catalog::NamedValue& value : reg->values) {
        if (value.value == *raw)
            return value.key.toInt();
    }
    return std::nullopt;
}
} // namespace

base::Result<std::vector<CommissionIssue>>
checkServo(const device::Context& context, const CommissionSpec& spec, CommissionWork& work)
{
    if (const auto read = device::readAll(context, work.servo); !read)
        return tl::unexpected(read.error());
    std::vector<CommissionIssue> issues;
    addAlarms(work.servo, issues);
    if (!work.servo.profile->writable)
        issues.push_back({QStringLiteral("not-writable"), work.servo.profile->modelName});
    addUnsupportedIssues(spec, work, issues);
    addTemplate(context, spec, work, issues);
    return issues;
}

bool needsDecision(const CommissionIssue& issue)
{
    return issue.word != QLatin1String("rows-left");
}

bool hasWork(const CommissionWork& work)
{
    return work.center || work.servo.id != work.newId || work.servo.baud != work.newBaud ||
           (work.plan && !plannedWrites(*work.plan).empty());
}

base::Result<void> saveTable(const device::Context& context, const CommissionCallbacks& callbacks,
                             CommissionWork& work)
{
    if (work.saved || !callbacks.save)
        return {};
    const auto saved = callbacks.save(context, work.servo);
    if (!saved)
        return tl::unexpected(saved.error());
    work.row.snapshot = *saved;
    work.saved = true;
    return {};
}

base::Result<void> applyTemplate(const device::Context& context, const CommissionSpec& spec,
                                 CommissionWork& work)
{
    if (!work.plan)
        return {};
    RestoreOptions options;
    options.consent = spec.consent;
    const auto outcome = restore(context, work.servo, *work.plan, options);
    if (!outcome)
        return tl::unexpected(outcome.error());
    work.row.templateName = spec.templateName;
    for (const RestoreRowResult& row : outcome->rows) {
        const bool good = row.write.outcome == device::WriteOutcome::Kept ||
                          row.write.outcome == device::WriteOutcome::Temporary;
        if (good)
            ++work.row.written;
        else
            work.row.issues.push_back(
                {QStringLiteral("row-") + device::outcomeName(row.write.outcome), row.write.key});
    }
    if (outcome->verdict == RestoreVerdict::AlreadySet || outcome->verdict == RestoreVerdict::Done)
        return {};
    for (const RestoreRowResult& row : outcome->rows) {
        if (row.write.error)
            return tl::unexpected(*row.write.error);
    }
    const bool isVerified =
        outcome->lock == device::LockState::Closed || outcome->lock == device::LockState::None;
    return base::fail(isVerified ? ErrorCode::Refused : ErrorCode::LockOpen,
                      QStringLiteral("template"), {}, work.servo.id);
}

base::Result<void> changeServoId(const device::Context& context, CommissionWork& work)
{
    if (work.servo.id == work.newId)
        return {};
    const auto changed = changeId(context, work.servo, work.newId);
    if (!changed)
        return tl::unexpected(changed.error());
    work.isIdConfirmed =
        !changed->writes.empty() && changed->writes.front().outcome == device::WriteOutcome::Kept;
    return toResult(*changed);
}

base::Result<void> changeServoRate(const device::Context& context, CommissionWork& work)
{
    if (work.servo.baud == work.newBaud)
        return {};
    const auto changed = changeBaud(context, work.servo, work.newBaud);
    if (!changed)
        return tl::unexpected(changed.error());
    if (const auto good = toResult(*changed); !good)
        return good;
    if (work.servo.baud != work.newBaud)
        work.row.issues.push_back(
            {QStringLiteral("rate-after-restart"), QString::number(work.newBaud)});
    return {};
}

base::Result<void> centerServo(const device::Context& context, CommissionWork& work)
{
    if (!work.center)
        return {};
    const auto centered = jobs::center(context, work.servo);
    if (!centered)
        return tl::unexpected(centered.error());
    if (centered->lock == device::LockState::Open || centered->lock == device::LockState::Unknown)
        return base::fail(ErrorCode::LockOpen, QStringLiteral("center"), {}, work.servo.id);
    work.row.centered = true;
    return {};
}

namespace {
/// Checks that the connected servo has every row of the template: another servo may have taken its
/// place between two steps.
base::Result<void> verifyTemplate(const device::Context& context, CommissionWork& work)
{
    if (!work.plan)
        return {};
    if (const auto read = device::readAll(context, work.servo); !read)
        return tl::unexpected(read.error());
    for (const RestoreRow& row : work.plan->rows) {
        const catalog::Register* reg = work.servo.profile->find(row.key);
        const bool isReported = std::any_of(work.row.issues.begin(), work.row.issues.end(),
                                            [&](const auto& one) { return one.detail == row.key; });
        if (!row.selected || !row.newRaw || reg == nullptr || isReported ||
            reg->area != catalog::Area::Eprom || reg->role == Role::PositionOffset)
            continue;
        const auto now = work.servo.raw(*reg);
        if (now && *now != *row.newRaw)
            return tl::unexpected(base::Error{ErrorCode::Mismatch, QStringLiteral("commission"),
                                              QStringLiteral("swapped"), work.servo.id, row.key});
    }
    return {};
}
} // namespace

base::Result<void> checkHealth(const device::Context& context, CommissionWork& work)
{
    std::vector<CommissionIssue>& issues = work.row.issues;
    const auto identified = device::identify(context, work.servo.id, work.servo.protocol);
    if (!identified)
        return tl::unexpected(identified.error());
    if (!identified->identity().isSameKind(work.servo.identity()))
        return base::fail(ErrorCode::IdentityMismatch, QStringLiteral("commission"),
                          identified->profile->modelName, work.servo.id);
    device::Servo& servo = work.servo;
    if (const auto verified = verifyTemplate(context, work); !verified)
        return verified;
    if (const auto read = readHealth(context, servo); !read)
        return read;
    addAlarms(servo, issues);
    if (const auto storedRate = storedBaud(servo); storedRate && *storedRate != work.newBaud)
        issues.push_back({QStringLiteral("rate-differs"), QString::number(*storedRate)});
    if (servo.raw(Role::TorqueSwitch).value_or(0) != 0) {
        if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
            return off;
        issues.push_back({QStringLiteral("torque-was-on")});
    }
    if (const auto lock = servo.raw(Role::Lock); lock && device::isLockOpen(*lock))
        return base::fail(ErrorCode::LockOpen, QStringLiteral("commission"), {}, servo.id);
    work.row.volts = servo.physical(Role::PresentVoltage);
    work.row.celsius = servo.physical(Role::PresentTemperature);
    return {};
}
} // namespace jobs
