// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/unlocked_eprom.h"

#include "base/enum_names.h"
#include "device/persistence.h"
#include "device/transactions.h"

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
constexpr base::EnumName<LockState> lockNames[]{
    {LockState::Closed, "closed"},
    {LockState::Open, "open"},
    {LockState::Unknown, "unknown"},
    {LockState::None, "none"},
};
} // namespace

QString lockName(LockState lock)
{
    return base::nameOf(lockNames, lock);
}

base::Result<UnlockedEprom> UnlockedEprom::open(const Context& context, Servo& servo,
                                                const catalog::Register& reg)
{
    if (retentionOf(reg) != Retention::Lock)
        return UnlockedEprom();
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (lock == nullptr) {
        return tl::unexpected(
            base::Error{ErrorCode::NotSupported, QStringLiteral("unlock"), {}, servo.id});
    }
    const std::int64_t needed = unlockValue(reg.area);
    const auto present = readRegister(context, servo, *lock);
    if (!present)
        return tl::unexpected(present.error());
    if (isLockOpen(*present))
        context.note(NoticeCode::LockFoundOpen, servo.id, lock->key);
    // From here on the destructor closes it, even if the reply to the unlock was lost.
    UnlockedEprom unlocked(context, servo, needed);
    if (*present == needed)
        return unlocked;
    servo.image.invalidate(lock->offset, lock->size, context.bus.clock().now());
    auto opened = writeVerified(context, servo, *lock, needed);
    if (!opened) {
        if (opened.error().code == ErrorCode::Mismatch)
            opened.error().code = ErrorCode::Refused;
        opened.error().operation = QStringLiteral("unlock");
        return tl::unexpected(opened.error());
    }
    return unlocked;
}

UnlockedEprom::UnlockedEprom(UnlockedEprom&& other) noexcept
    : m_context(other.m_context)
    , m_servo(std::exchange(other.m_servo, nullptr))
    , m_needed(other.m_needed)
    , m_stayedOpen(other.m_stayedOpen)
{}

UnlockedEprom::~UnlockedEprom()
{
    if (m_servo != nullptr)
        close();
}

LockState UnlockedEprom::close()
{
    Servo* servo = std::exchange(m_servo, nullptr);
    if (servo == nullptr)
        return LockState::None;
    const catalog::Register& lock = *servo->profile->byRole(Role::Lock);
    const auto flag = readRegister(*m_context, *servo, lock);
    m_stayedOpen = flag.has_value() && *flag == m_needed;
    return closeLock(*m_context, *servo);
}

LockState closeLock(const Context& context, Servo& servo)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    if (lock == nullptr)
        return LockState::None;
    // The bus does the retries; a second round covers a servo that did not receive for a moment,
    // and further ones a contact that is loose for longer: nothing else would close the lock.
    constexpr int rounds = 2;
    constexpr base::Duration patience = std::chrono::seconds(2);
    const base::Duration giveUpAt = context.bus.clock().now() + patience;
    bool silent = false;
    LockState state = LockState::Unknown;
    for (int round = 0; round < rounds || (silent && context.bus.clock().now() < giveUpAt);
         ++round) {
        const auto flag = readRegister(context, servo, *lock);
        if (!flag) {
            if (flag.error().code == ErrorCode::LinkLost)
                break;
            silent = flag.error().code == ErrorCode::NoReply;
            if (flag.error().code != ErrorCode::LineBusy)
                continue;
            // The bus sends it as often as any write; a second round would prove no more.
            writeUnverified(context, servo, *lock, lockClosed, flag.error());
            break;
        }
        silent = false;
        if (!isLockOpen(*flag))
            return LockState::Closed;
        const auto closed = writeVerified(context, servo, *lock, lockClosed);
        if (closed)
            return LockState::Closed;
        // It may have closed where only the reading that shows it was lost.
        const bool shown =
            closed.error().code == ErrorCode::Mismatch || closed.error().code == ErrorCode::Refused;
        state = shown ? LockState::Open : LockState::Unknown;
    }
    context.note(NoticeCode::LockLeftOpen, servo.id, lock->key);
    return state;
}
} // namespace device
