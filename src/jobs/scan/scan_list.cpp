// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_list.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace jobs {
namespace {
// A receiver accepts a rate that is up to this far off, so 250000 is also received at 256000.
constexpr double baudTolerance = 0.04;

/// The rate in its own baud register, 0 if that is not known.
int storedRate(const device::Servo& servo)
{
    const catalog::Register* reg =
        servo.profile ? servo.profile->byRole(catalog::Role::BaudRate) : nullptr;
    const auto code = servo.raw(catalog::Role::BaudRate);
    if (reg == nullptr || !code)
        return 0;
    for (const catalog::NamedValue& value : reg->values) {
        if (value.value == *code)
            return value.key.toInt();
    }
    return 0;
}

bool sameServo(const device::Servo& a, const device::Servo& b)
{
    return a.id == b.id && a.protocol == b.protocol;
}

bool isNeighborRate(const device::Servo& weak, const device::Servo& strong)
{
    return sameServo(weak, strong) && areNeighborRates(weak.baud, strong.baud) &&
           storedRate(strong) == strong.baud && storedRate(weak) != weak.baud;
}
} // namespace

bool areNeighborRates(int a, int b)
{
    return a != b && std::abs(a - b) <= baudTolerance * std::max(a, b);
}

void dropNeighborRates(std::vector<FoundServo>& found)
{
    const auto isFoundElsewhere = [&](const FoundServo& weak) {
        return std::any_of(found.begin(), found.end(), [&](const FoundServo& strong) {
            return isNeighborRate(weak.servo, strong.servo);
        });
    };
    std::vector<FoundServo> kept;
    std::copy_if(found.begin(), found.end(), std::back_inserter(kept),
                 [&](const FoundServo& one) { return !isFoundElsewhere(one); });
    found = std::move(kept);
}

void sortFound(std::vector<FoundServo>& found, const std::vector<int>& rates)
{
    const auto sortKeyOf = [&](const FoundServo& one) {
        const auto rate = std::find(rates.begin(), rates.end(), one.servo.baud);
        return std::tuple(rate - rates.begin(), one.servo.id, one.servo.protocol);
    };
    std::sort(found.begin(), found.end(), [&](const FoundServo& a, const FoundServo& b) {
        return sortKeyOf(a) < sortKeyOf(b);
    });
}

bool familiesMixed(const std::vector<FoundServo>& found)
{
    const auto has = [&](base::ByteOrder order) {
        return std::any_of(found.begin(), found.end(), [order](const FoundServo& one) {
            return one.servo.protocol == base::Protocol::Feetech && one.servo.profile &&
                   !one.servo.profile->series.isEmpty() && one.servo.profile->byteOrder == order;
        });
    };
    return has(base::ByteOrder::Little) && has(base::ByteOrder::Big);
}
} // namespace jobs
