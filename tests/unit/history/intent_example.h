// SPDX-License-Identifier: GPL-3.0-or-later
// Intents for the tests of the journal.
#pragma once

#include "base/journal.h"

#include <QtTest>

namespace intent_example {
inline base::ServoIdentity exampleServo(int id = 1)
{
    return {id, 9, 3, 3, 10, QStringLiteral("sts-sms"), QStringLiteral("/dev/ttyUSB0"), 1000000};
}

inline base::Intent exampleIntent(int id = 1)
{
    base::Intent intent;
    intent.lockOpened = true;
    intent.servo = exampleServo(id);
    intent.items = {{QStringLiteral("min_angle"), 9, -12, 100},
                    {QStringLiteral("position_offset"), 31, 2047, -2047}};
    return intent;
}

inline void compareIntents(const base::Intent& found, const base::Intent& written)
{
    QCOMPARE(int(found.kind), int(written.kind));
    QCOMPARE(found.temporary, written.temporary);
    QCOMPARE(found.lockOpened, written.lockOpened);
    QCOMPARE(found.servo.id, written.servo.id);
    QVERIFY(found.servo.isSameKind(written.servo));
    QCOMPARE(found.servo.port, written.servo.port);
    QCOMPARE(found.servo.baud, written.servo.baud);
    QCOMPARE(found.servo.protocol, written.servo.protocol);
    QCOMPARE(found.items.size(), written.items.size());
    for (std::size_t i = 0; i < found.items.size(); ++i) {
        QCOMPARE(found.items[i].key, written.items[i].key);
        QCOMPARE(found.items[i].address, written.items[i].address);
        QCOMPARE(found.items[i].oldRaw, written.items[i].oldRaw);
        QCOMPARE(found.items[i].newRaw, written.items[i].newRaw);
    }
}
} // namespace intent_example
