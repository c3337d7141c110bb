// SPDX-License-Identifier: GPL-3.0-or-later
// From the ticks of a restore plan to the writes and to all that happens around them, in order.
#include "device/motion.h"
#include "device/persistence.h"
#include "device/remembered_speed.h"
#include "jobs/restore_plan.h"

#include <algorithm>

namespace jobs {
using catalog::Area;
using catalog::Role;

namespace {
/// Runs of one area, so that each area is unlocked once; factory values are limits of the rest.
/// Those the lock does not keep come after all that it keeps, so that it is opened for those only.
int areaRank(const catalog::Register& reg)
{
    if (reg.area == Area::Factory && device::keepingOf(reg) != device::Keeping::Lock)
        return 2;
    switch (reg.area) {
    case Area::Factory:
        return 0;
    case Area::Eprom:
        return 1;
    case Area::Sram:
    case Area::Feedback:
        break;
    }
    return 2;
}

std::tuple<bool, int, RestoreStage, int> orderOf(const RestoreWrite& write,
                                                 const catalog::Profile& profile)
{
    const catalog::Register& reg = *profile.find(write.key);
    const bool last = write.stage == RestoreStage::Id || write.stage == RestoreStage::Baud;
    return {last, last ? 0 : areaRank(reg), write.stage, reg.writeOffset};
}
} // namespace

QString restoreStepName(RestoreStepKind kind)
{
    switch (kind) {
    case RestoreStepKind::TorqueOff:
        return QStringLiteral("torque-off");
    case RestoreStepKind::Unlock:
        return QStringLiteral("unlock");
    case RestoreStepKind::Write:
        return QStringLiteral("write");
    case RestoreStepKind::Settle:
        return QStringLiteral("settle");
    case RestoreStepKind::Lock:
        return QStringLiteral("lock");
    case RestoreStepKind::SetId:
        return QStringLiteral("set-id");
    case RestoreStepKind::SetBaud:
        return QStringLiteral("set-baud");
    }
    return {};
}

std::vector<RestoreWrite> writesOf(const RestorePlan& plan)
{
    std::vector<RestoreWrite> writes;
    for (const RestoreRow& row : plan.rows) {
        const bool again = row.reasons.testFlag(RestoreReason::OnlyTemporary);
        if (row.ticked && row.wanted && (again || row.now != row.wanted))
            writes.push_back({row.key, row.address, row.now, *row.wanted, row.stage, again});
    }
    std::sort(writes.begin(), writes.end(), [&](const RestoreWrite& a, const RestoreWrite& b) {
        return orderOf(a, *plan.servo.profile) < orderOf(b, *plan.servo.profile);
    });
    return writes;
}

namespace {
/// The writes with everything around them.
class StepList {
public:
    explicit StepList(const RestorePlan& plan)
        : m_servo(plan.servo)
        , m_positionSpeed(plan.positionSpeed)
    {
        torqueOff(m_servo.raw(Role::TorqueSwitch));
    }

    void add(const RestoreWrite& write)
    {
        const catalog::Register& reg = *m_servo.profile->find(write.key);
        const RestoreStepKind kind = kindOf(write);
        const bool own = kind != RestoreStepKind::Write;
        if (own)
            settle();
        const bool needsLock = device::keepingOf(reg) == device::Keeping::Lock;
        if (m_open != nullptr && (own || (needsLock && m_open->area != reg.area)))
            lock(); // what is kept without it goes out meanwhile
        if (m_open == nullptr && needsLock) {
            m_steps.push_back({RestoreStepKind::Unlock, lockKey()});
            m_open = &reg;
        }
        m_steps.push_back({kind, write.key, write.from, write.to});
        if (!own)
            m_items.push_back({write.key, write.to});
    }

    std::vector<RestoreStep> finish()
    {
        settle();
        if (m_open != nullptr)
            lock();
        return std::move(m_steps);
    }

private:
    static RestoreStepKind kindOf(const RestoreWrite& write)
    {
        if (write.stage == RestoreStage::Id)
            return RestoreStepKind::SetId;
        return write.stage == RestoreStage::Baud ? RestoreStepKind::SetBaud
                                                 : RestoreStepKind::Write;
    }

    void torqueOff(std::optional<std::int64_t> from)
    {
        if (const catalog::Register* torque = m_servo.profile->byRole(Role::TorqueSwitch))
            m_steps.push_back({RestoreStepKind::TorqueOff, torque->key, from, 0});
    }

    QString lockKey() const
    {
        const catalog::Register* reg = m_servo.profile->byRole(Role::Lock);
        return reg != nullptr ? reg->key : QString();
    }

    void lock()
    {
        m_steps.push_back({RestoreStepKind::Lock, lockKey()});
        m_open = nullptr;
    }

    /// Once the last register is written, before the lock is closed.
    void settle()
    {
        auto also = device::settledBySwitch(m_servo, m_items);
        if (auto speed = device::speedPutBack(m_servo, m_items, m_positionSpeed))
            also.push_back(std::move(*speed));
        for (const device::WriteItem& item : also)
            m_steps.push_back({RestoreStepKind::Settle, item.key, m_servo.raw(item.key), item.raw});
        if (!also.empty())
            torqueOff({}); // a command may have switched it on
        m_items.clear();
    }

    const device::Servo& m_servo;
    std::optional<std::int64_t> m_positionSpeed;
    const catalog::Register* m_open = nullptr; ///< for whose area the lock is open
    std::vector<device::WriteItem> m_items;
    std::vector<RestoreStep> m_steps;
};
} // namespace

namespace {
/// A lock that was left open is closed even if nothing else is to be done.
std::vector<RestoreStep> lockAlone(const device::Servo& servo)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    const auto flag = lock != nullptr ? servo.raw(*lock) : std::nullopt;
    if (!flag || !device::isOpen(*flag))
        return {};
    return {{RestoreStepKind::Lock, lock->key}};
}
} // namespace

std::vector<RestoreStep> stepsOf(const RestorePlan& plan)
{
    const std::vector<RestoreWrite> writes = writesOf(plan);
    if (writes.empty())
        return lockAlone(plan.servo);
    StepList steps(plan);
    for (const RestoreWrite& write : writes)
        steps.add(write);
    return steps.finish();
}
} // namespace jobs
