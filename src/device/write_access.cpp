// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/write_access.h"

#include "device/duplicate_id_check.h"
#include "device/reader.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
/// The values of the lock are known for every family; another value there means that the register
/// is something else.
bool isLockValue(const catalog::Register& lock, std::int64_t raw)
{
    return lock.values.empty() ||
           std::any_of(lock.values.begin(), lock.values.end(),
                       [raw](const catalog::NamedValue& value) { return value.value == raw; });
}

std::optional<base::Error> lockConflict(const Servo& servo, std::optional<std::int64_t> raw,
                                        const QString& operation)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (lock == nullptr || !raw || isLockValue(*lock, *raw))
        return std::nullopt;
    const catalog::Profile& profile = *servo.profile;
    catalog::FamilyFacts facts;
    facts.firmware = profile.identity.firmware();
    facts.firmwareSeries = profile.series;
    facts.byteOrderFlag = profile.identity.byteOrderFlag;
    facts.modelId = profile.identity.modelId();
    if (profile.modelKnown) {
        facts.modelName = profile.modelName;
        facts.modelFlag = profile.identity.byteOrderFlag;
    }
    facts.lockAddress = lock->address;
    facts.lock = *raw;
    return base::Error{ErrorCode::FamilyConflict, operation, facts.detail(), servo.id};
}

QString detailOf(const DuplicateIdResult& finding)
{
    switch (finding.sign) {
    case DuplicateIdSign::SecondReply:
        return QStringLiteral("two-replies");
    case DuplicateIdSign::DifferentValues:
        return QStringLiteral("different-values");
    case DuplicateIdSign::BrokenReplies:
        return QStringLiteral("broken %1/%2").arg(finding.broken).arg(finding.reads);
    case DuplicateIdSign::None:
        break;
    }
    return {};
}
} // namespace

base::Result<void> requireWritable(const Servo& servo, const QString& operation)
{
    if (!servo.profile)
        return base::fail(ErrorCode::UnknownModel, operation, {}, servo.id);
    if (servo.profile->conflict) {
        return base::fail(ErrorCode::FamilyConflict, operation, servo.profile->conflict->detail(),
                          servo.id);
    }
    if (!servo.profile->writable) {
        return base::fail(ErrorCode::UnknownModel, operation,
                          QStringLiteral("firmware ") + servo.profile->identity.firmware(),
                          servo.id);
    }
    return {};
}

std::optional<base::Error> writeObstacle(const Servo& servo)
{
    if (const auto writable = requireWritable(servo, {}); !writable)
        return writable.error();
    return lockConflict(servo, servo.raw(Role::Lock), {});
}

base::Result<void> requireUniqueId(const Context& outer, const Servo& servo,
                                   const QString& operation)
{
    if (outer.bus.verifiedIds().contains(servo.protocol, servo.id, outer.bus.baud()))
        return {};
    const Owned owned = own(outer, {servo.id});
    const auto found = checkDuplicateId(owned.context, servo);
    if (!found)
        return tl::unexpected(found.error());
    if (found->sign == DuplicateIdSign::None)
        return {};
    return base::fail(ErrorCode::DuplicateId, operation, detailOf(*found), servo.id);
}

base::Result<void> requireSameServo(const Context& context, const Servo& servo,
                                    const QString& operation)
{
    if (servo.protocol == base::Protocol::Lx)
        return {};
    const auto now = identify(context, servo.id, servo.protocol);
    if (!now)
        return tl::unexpected(now.error());
    if (now->profile->identity == servo.profile->identity)
        return {};
    context.bus.verifiedIds().remove(servo.protocol, servo.id, context.bus.baud());
    const QString model = now->profile->modelName;
    return base::fail(ErrorCode::IdentityMismatch, operation, model, servo.id);
}

base::Result<void> beginWriting(const Context& context, const Servo& servo,
                                const QString& operation)
{
    if (context.emergencyStop)
        return {};
    if (const auto writable = requireWritable(servo, operation); !writable)
        return writable;
    const auto& verified = context.bus.verifiedIds();
    return verified.contains(servo.protocol, servo.id, context.bus.baud())
               ? requireSameServo(context, servo, operation)
               : requireVerified(context, servo, operation);
}

base::Result<void> beginWriting(const Owned& owned, const Servo& servo, const QString& operation)
{
    const bool step = owned.hold.token() == 0;
    return step ? requireVerified(owned.context, servo, operation)
                : beginWriting(owned.context, servo, operation);
}

base::Result<void> requireVerified(const Context& outer, const Servo& servo,
                                   const QString& operation)
{
    if (outer.emergencyStop)
        return {};
    if (const auto writable = requireWritable(servo, operation); !writable)
        return writable;
    bus::VerifiedIds& verified = outer.bus.verifiedIds();
    const int baud = outer.bus.baud();
    if (verified.contains(servo.protocol, servo.id, baud))
        return {};
    const Owned owned = own(outer, {servo.id});
    const auto found = checkDuplicateId(owned.context, servo);
    if (!found)
        return tl::unexpected(found.error());
    if (found->sign != DuplicateIdSign::None)
        return base::fail(ErrorCode::DuplicateId, operation, detailOf(*found), servo.id);
    if (const auto same = requireSameServo(owned.context, servo, operation); !same)
        return same;
    if (auto conflict = lockConflict(servo, found->lock, operation))
        return tl::unexpected(std::move(*conflict));
    verified.add(servo.protocol, servo.id, baud);
    return {};
}

void transferVerification(bus::Bus& bus, const Servo& servo, int oldId, int oldBaud)
{
    bus.verifiedIds().remove(servo.protocol, oldId, oldBaud);
    bus.verifiedIds().add(servo.protocol, servo.id, bus.baud());
}
} // namespace device
