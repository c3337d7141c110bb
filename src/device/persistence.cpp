// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/persistence.h"

namespace device {
using catalog::Area;
using catalog::Persistence;

namespace {
constexpr std::int64_t openForEprom = 0;
constexpr std::int64_t openForFactory = 128;
} // namespace

Keeping keepingOf(const catalog::Register& reg)
{
    switch (reg.persistence) {
    case Persistence::Kept:
        return Keeping::Always;
    case Persistence::Lost:
        return Keeping::Never;
    case Persistence::AfterSave:
        return Keeping::Save;
    case Persistence::NotStated:
        return Keeping::NotStated;
    case Persistence::ByArea:
        break;
    }
    return reg.area == Area::Eprom || reg.area == Area::Factory ? Keeping::Lock : Keeping::Never;
}

bool lasting(const catalog::Register& reg)
{
    const Keeping keeping = keepingOf(reg);
    return keeping == Keeping::Lock || keeping == Keeping::Always || keeping == Keeping::Save;
}

bool takesTime(const catalog::Register& reg)
{
    return keepingOf(reg) != Keeping::Never;
}

std::int64_t openFor(Area area)
{
    return area == Area::Factory ? openForFactory : openForEprom;
}

bool isOpen(std::int64_t lock)
{
    return lock == openForEprom || lock == openForFactory;
}
} // namespace device
