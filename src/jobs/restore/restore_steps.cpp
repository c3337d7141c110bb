// SPDX-License-Identifier: GPL-3.0-or-later
// The writes for the ticked rows of a restore plan, and all steps around them, in order.
#include "base/enum_names.h"
#include "device/motion/motion.h"
#include "device/motion/saved_speed.h"
#include "device/persistence.h"
#include "jobs/restore/restore_plan.h"

#include <algorithm>

namespace jobs {
using catalog::Area;
using catalog::Role;

namespace {
/// Sorted by area, so that each area is unlocked once; factory values are limits of the rest.
/// Values that need no lock come last, so that it is open for the others only.
int areaRank(const catalog::Register& reg)
{
    if (reg.area == Area::Factory && device::retentionOf(reg) != device::Retention::Lock)
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

std::tuple<bool, int, RestoreStage, int> sortKeyOf(const RestoreWrite& write,
                                                   const catalog::Profile& profile)
{
    const catalog::Register& reg = *profile.find(write.key);
    const bool last = write.stage == RestoreStage::Id || write.stage == RestoreStage::Baud;
    return {last, last ? 0 : areaRank(reg), write.stage, reg.writeOffset};
}

constexpr base::EnumName<RestoreStepKind> restoreStepNames[]{
    {RestoreStepKind::TorqueOff, "torque-off"},
    {RestoreStepKind::Unlock, "unlock"},
    {RestoreStepKind::Write, "write"},
    {RestoreStepKind::Neutralize, "settle"},
    {RestoreStepKind::Lock, "lock"},
    {RestoreStepKind::SetId, "set-id"},
    {RestoreStepKind::SetBaud, "set-baud"},
};
} // namespace

QString restoreStepName(RestoreStepKind kind)
{
    return base::nameOf(restoreStepNames, kind);
}

std::vector<RestoreWrite> plannedWrites(const RestorePlan& plan)
{
    std::vector<RestoreWrite> writes;
    for (const RestoreRow& row : plan.rows) {
        const bool isRewrite = row.reasons.testFlag(RestoreReason::OnlyTemporary);
        if (row.selected && row.newRaw && (isRewrite || row.now != row.newRaw))
            writes.push_back({row.key, row.address, row.now, *row.newRaw, row.stage, isRewrite});
    }
    std::sort(writes.begin(), writes.end(), [&](const RestoreWrite& a, const RestoreWrite& b) {
        return sortKeyOf(a, *plan.servo.profile) < sortKeyOf(b, *plan.servo.profile);
    });
    return writes;
}

namespace {
/// The writes with everything around them.
class RestoreStepBuilder {
public:
    explicit RestoreStepBuilder(const RestorePlan& plan)
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
            addNeutralCommands();
        const bool needsLock = device::retentionOf(reg) == device::Retention::Lock;
        if (m_open != nullptr && (own || (needsLock && m_open->area != reg.area)))
            lock(); // values that need no lock are written meanwhile
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
        addNeutralCommands();
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

    /// After the last register is written, before the lock is closed.
    void addNeutralCommands()
    {
        auto neutralItems = device::extraWritesOfSwitch(m_servo, m_items);
        if (auto speed = device::restoredSpeed(m_servo, m_items, m_positionSpeed))
            neutralItems.push_back(std::move(*speed));
        for (const device::WriteItem& item : neutralItems)
            m_steps.push_back(
                {RestoreStepKind::Neutralize, item.key, m_servo.raw(item.key), item.raw});
        if (!neutralItems.empty())
            torqueOff({}); // a command may have turned it on
        m_items.clear();
    }

    const device::Servo& m_servo;
    std::optional<std::int64_t> m_positionSpeed;
    const catalog::Register* m_open = nullptr; ///< the lock is open for its area
    std::vector<device::WriteItem> m_items;
    std::vector<RestoreStep> m_steps;
};
} // namespace

namespace {
/// An open lock is closed even if there is nothing else to do.
std::vector<RestoreStep> lockOnlySteps(const device::Servo& servo)
{
    const catalog::Register* lock = servo.profile->byRole(Role::Lock);
    const auto flag = lock != nullptr ? servo.raw(*lock) : std::nullopt;
    if (!flag || !device::isLockOpen(*flag))
        return {};
    return {{RestoreStepKind::Lock, lock->key}};
}
} // namespace

std::vector<RestoreStep> plannedSteps(const RestorePlan& plan)
{
    const std::vector<RestoreWrite> writes = plannedWrites(plan);
    if (writes.empty())
        return lockOnlySteps(plan.servo);
    RestoreStepBuilder steps(plan);
    for (const RestoreWrite& write : writes)
        steps.add(write);
    return steps.finish();
}
} // namespace jobs
