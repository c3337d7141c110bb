// SPDX-License-Identifier: GPL-3.0-or-later
// Seven rows of an STS3215 to restore, and what may come between: another hand at the servo, a
// servo that falls silent, a cable that is pulled. For the tests of restoring; one thread.
#pragma once

#include "integration/restore_support.h"

namespace support {
/// Seven rows that differ, far enough apart for frames of their own.
inline void changeSevenRegisters(SimFixture& fixture)
{
    pokePersistent(fixture, QStringLiteral("max_temperature"), 60);
    pokePersistent(fixture, QStringLiteral("max_torque"), 900);
    pokePersistent(fixture, QStringLiteral("position_p"), 50);
    pokePersistent(fixture, QStringLiteral("position_i"), 5);
    pokePersistent(fixture, QStringLiteral("cw_dead_zone"), 3);
    pokePersistent(fixture, QStringLiteral("protection_torque"), 33);
    pokePersistent(fixture, QStringLiteral("speed_p"), 77);
}

inline bool isWrite(const base::Bytes& frame)
{
    return frame.size() > 5 && frame[4] == Write;
}

/// As if somebody else wrote this register right after we did, every time.
inline void overwriteAfterWrite(SimFixture& fixture, std::uint8_t address, const QString& key,
                                std::int64_t raw, int times)
{
    fixture.tap().onWrite = [&fixture, address, key, raw, times,
                             pending = false](const base::Bytes& frame) mutable {
        if (pending && times-- > 0)
            fixture.poke(1, key, raw);
        pending = isWrite(frame) && frame[5] == address;
    };
}

inline bool isLockAbandoned(SimFixture& fixture)
{
    const auto& notices = fixture.notices();
    return std::any_of(notices.begin(), notices.end(), [](const device::Notice& notice) {
        return notice.code == device::NoticeCode::LockLeftOpen;
    });
}

/// From its `from`th WRITE on it obeys without a word, until all hope for the lock is given up.
inline void muteFromWrite(SimFixture& fixture, int from,
                          std::function<void(const base::Bytes&)> then = {})
{
    fixture.tap().onWrite = [&fixture, from, then = std::move(then),
                             count = 0](const base::Bytes& frame) mutable {
        count += isWrite(frame) ? 1 : 0;
        const bool givenUp = isLockAbandoned(fixture);
        fixture.wireConfig().faults.muteIds =
            count >= from && !givenUp ? std::vector<int>{1} : std::vector<int>{};
        if (givenUp && then)
            then(frame);
    };
}

/// Ends the link when the `count`th WRITE frame goes out.
inline void cutAtWrite(SimFixture& fixture, int count)
{
    fixture.tap().onWrite = [&fixture, count](const base::Bytes& frame) mutable {
        if (isWrite(frame) && --count == 0)
            fixture.cutLink();
    };
}
} // namespace support
