// SPDX-License-Identifier: GPL-3.0-or-later
// The light of the port counts what a servo failed to answer, and nothing that the program asked to
// find out who is there: changes of ID, a servo that is unplugged on the commissioning line.
#include "gui/window_bench.h"
#include "sim/sim_link.h"
#include "ui/models/link_meter.h"

class TestLinkMeter : public QObject {
    Q_OBJECT

private:
    static bus::Statistics statistics(gui::WindowBench& bench)
    {
        return bench.desk().connection()->bus().statistics();
    }

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aChangeOfIdIsNoError()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        ui::LinkMeter meter;
        meter.look(statistics(bench), true, {});
        for (const int id : {7, 9, 1}) { // and back: the last one is an ID that has answered before
            bench.desk().write(bench.selection().current(), {{{QStringLiteral("id"), id}}});
            QVERIFY(bench.settled());
            QCOMPARE(bench.entry().servo.id, id);
        }
        meter.look(statistics(bench), false, std::chrono::seconds(1));
        QByteArray told;
        for (const auto& [id, counters] : statistics(bench).byId)
            told += QStringLiteral("ID %1: %2 lost, %3 damaged, %4 foreign; ")
                        .arg(id)
                        .arg(counters.timeOuts)
                        .arg(counters.badChecks)
                        .arg(counters.foreign)
                        .toUtf8();
        QVERIFY2(meter.figures().errors == 0, told.constData());
    }

    void aLostAnswerIsOne()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        ui::LinkMeter meter;
        meter.look(statistics(bench), true, {});
        bench.desk().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.muteIds = {1}; });
        bench.desk().readTable(bench.selection().current());
        QTRY_VERIFY_WITH_TIMEOUT((meter.look(statistics(bench), false, std::chrono::seconds(1)),
                                  meter.figures().errors > 0),
                                 20000);
    }
};

QTEST_MAIN(TestLinkMeter)
#include "tst_link_meter.moc"
