// SPDX-License-Identifier: GPL-3.0-or-later
// What writing a value means: in every register map, by the roles of the fact sheets.
#include "catalog/catalog.h"
#include "device/write_meaning.h"
#include "support/test_main.h"

using catalog::Role;
using device::WriteMeaning;
using device::WriteProcedure;

namespace {
catalog::Register registerOf(Role role, bool dangerous = false, bool motion = false)
{
    catalog::Register reg;
    reg.role = role;
    reg.dangerous = dangerous;
    reg.motion = motion;
    return reg;
}
} // namespace

class TestWriteMeaning : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void addressesComeLast()
    {
        const WriteMeaning id = device::classify(registerOf(Role::Id, true), 7);
        const WriteMeaning rate = device::classify(registerOf(Role::BaudRate, true), 0);
        const WriteMeaning plain = device::classify(registerOf(Role::None), 5);
        QVERIFY(id.changesAddress() && rate.changesAddress() && !plain.changesAddress());
        QVERIFY(plain.procedure < rate.procedure && rate.procedure < id.procedure);
        QVERIFY(id.needsConsent && !plain.needsConsent);
    }

    void torqueOnIsNoMovement()
    {
        const catalog::Register torque = registerOf(Role::TorqueSwitch, false, true);
        const WriteMeaning on = device::classify(torque, 1);
        QCOMPARE(on.procedure, WriteProcedure::Torque);
        QVERIFY(on.enablesTorque && !on.moves && on.isMotion());
        const WriteMeaning off = device::classify(torque, 0);
        QVERIFY(!off.enablesTorque && off.isMotion());
    }

    void goalsMove()
    {
        const WriteMeaning goal = device::classify(registerOf(Role::GoalPosition, false, true), 0);
        QCOMPARE(goal.procedure, WriteProcedure::Register);
        QVERIFY(goal.moves && goal.isMotion() && !goal.enablesTorque);
    }

    void centeringIsFoundByItsValue()
    {
        catalog::Register torque = registerOf(Role::TorqueSwitch, false, true);
        torque.encoding = catalog::Encoding::Enum;
        torque.values.push_back({128, QStringLiteral("center"), {}});
        QCOMPARE(device::classify(torque, 128).procedure, WriteProcedure::Center);
        QVERIFY(!device::classify(torque, 128).enablesTorque);
        QVERIFY(device::classify(torque, 128).needsConsent);
        QVERIFY(!device::classify(torque, 1).needsConsent);
        const catalog::Register reset = registerOf(Role::FaultReset);
        QCOMPARE(device::classify(reset, 4).procedure, WriteProcedure::Center);
        QCOMPARE(device::classify(reset, 3).procedure, WriteProcedure::Register);
    }

    /// In no map is the address of a servo written without consent.
    void holdsForEveryModel()
    {
        const auto loaded = catalog::Catalog::load();
        int checked = 0;
        for (const catalog::ModelEntry& model : loaded.catalog.models()) {
            const catalog::ProfilePtr profile = loaded.catalog.profileFor(model, 3, 10);
            for (const catalog::Register& reg : profile->registers) {
                const WriteMeaning meaning = device::classify(reg, 1);
                QVERIFY2(!meaning.changesAddress() || meaning.needsConsent || !reg.writable(),
                         qPrintable(reg.key));
                checked += meaning.changesAddress() ? 1 : 0;
            }
        }
        QVERIFY(checked > 50);
    }
};

SERVODESK_GUILESS_TEST(TestWriteMeaning)
#include "tst_write_meaning.moc"
