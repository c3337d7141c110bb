// SPDX-License-Identifier: GPL-3.0-or-later
// The light of the port counts what a servo failed to answer, and nothing that the program asked to
// find out who is there: changes of ID, a servo that is unplugged on the commissioning line.
#include "gui/main_window_fixture.h"
#include "sim/host/sim_link.h"
#include "ui/connect/link_meter.h"

class TestLinkMeter : public QObject {
    Q_OBJECT

private:
    static bus::Statistics statistics(gui::MainWindowFixture& fixture)
    {
        return fixture.desk().connection()->bus().statistics();
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
            fixture.desk().write(fixture.selection().current(), {{{QStringLiteral("id"), id}}});
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
        fixture.desk().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        fixture.desk().readTable(fixture.selection().current());
        QTRY_VERIFY_WITH_TIMEOUT(
            (meter.addStatistics(statistics(fixture), false, std::chrono::seconds(1)),
             meter.values().errors > 0),
            20000);
    }
};

QTEST_MAIN(TestLinkMeter)
#include "tst_link_meter.moc"
