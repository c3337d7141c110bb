// SPDX-License-Identifier: GPL-3.0-or-later
// The light of the port counts missing replies of servos, but not silence that the program expects:
// a change of ID, or a servo that is unplugged during commissioning.
#include "gui/main_window_fixture.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "ui/connect/link_meter.h"

class TestLinkMeter : public QObject {
    Q_OBJECT

private:
    static bus::Statistics statistics(gui::MainWindowFixture& fixture)
    {
        return fixture.workbench().link().connection()->bus().statistics();
    }

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void anIdChangeIsNoError()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        ui::LinkMeter meter;
        meter.addStatistics(statistics(fixture), true, {});
        for (const int id : {7, 9, 1}) { // and back: the last one is an ID that has answered before
            fixture.workbench().writes().write(
                fixture.selection().current(),
                {{{QStringLiteral("id"), id}}, false, device::Consent::confirmed()});
            QVERIFY(fixture.waitUntilIdle());
            QCOMPARE(fixture.entry().servo.id, id);
        }
        meter.addStatistics(statistics(fixture), false, std::chrono::seconds(1));
        QByteArray told;
        for (const auto& [id, counters] : statistics(fixture).byId)
            told += QStringLiteral("ID %1: %2 lost, %3 damaged, %4 foreign; ")
                        .arg(id)
                        .arg(counters.timeouts)
                        .arg(counters.badChecksums)
                        .arg(counters.foreign)
                        .toUtf8();
        QVERIFY2(meter.values().errors == 0, told.constData());
    }

    void aLostReplyIsAnError()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        ui::LinkMeter meter;
        meter.addStatistics(statistics(fixture), true, {});
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        fixture.workbench().writes().readTable(fixture.selection().current());
        QTRY_VERIFY((meter.addStatistics(statistics(fixture), false, std::chrono::seconds(1)),
                     meter.values().errors > 0));
    }
};

SERVODESK_TEST(TestLinkMeter)
#include "tst_link_meter.moc"
