// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/persistence.h"

namespace device {
using catalog::Area;
using catalog::Persistence;

namespace {
constexpr std::int64_t lockOpenForEprom = 0;
constexpr std::int64_t lockOpenForFactory = 128;
} // namespace

Retention retentionOf(const catalog::Register& reg)
{
    switch (reg.persistence) {
    case Persistence::Kept:
        return Retention::Always;
    case Persistence::Lost:
        return Retention::Never;
    case Persistence::AfterSave:
        return Retention::Save;
    case Persistence::NotStated:
        return Retention::NotStated;
    case Persistence::ByArea:
        break;
    }
    return reg.area == Area::Eprom || reg.area == Area::Factory ? Retention::Lock
                                                                : Retention::Never;
}

bool isPersistent(const catalog::Register& reg)
{
    const Retention retention = retentionOf(reg);
    return retention == Retention::Lock || retention == Retention::Always ||
           retention == Retention::Save;
}

bool needsWriteTime(const catalog::Register& reg)
{
    return retentionOf(reg) != Retention::Never;
}

std::int64_t unlockValue(Area area)
{
    return area == Area::Factory ? lockOpenForFactory : lockOpenForEprom;
}

bool isLockOpen(std::int64_t lock)
{
    return lock == lockOpenForEprom || lock == lockOpenForFactory;
}
} // namespace device
