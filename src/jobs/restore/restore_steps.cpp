// SPDX-License-Identifier: GPL-3.0-or-later
// From the ticks of a restore plan to the writes and to all that happens around them, in order.
#include "device/motion/motion.h"
#include "device/motion/saved_speed.h"
#include "device/persistence.h"
#include "jobs/restore/restore_plan.h"

#include <algorithm>

namespace jobs {
using catalog::Area;
using catalog::Role;

namespace {
/// Runs of one area, so that each area is unlocked once; factory values are limits of the rest.
/// Those the lock does not keep come after all that it keeps, so that it is opened for those only.
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
    case RestoreStepKind::Neutralize:
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

    /// Once the last register is written, before the lock is closed.
    void addNeutralCommands()
    {
        auto neutralItems = device::extraWritesOfSwitch(m_servo, m_items);
        if (auto speed = device::restoredSpeed(m_servo, m_items, m_positionSpeed))
            neutralItems.push_back(std::move(*speed));
        for (const device::WriteItem& item : neutralItems)
            m_steps.push_back(
                {RestoreStepKind::Neutralize, item.key, m_servo.raw(item.key), item.raw});
        if (!neutralItems.empty())
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
