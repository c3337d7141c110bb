// SPDX-License-Identifier: GPL-3.0-or-later
// The same walk through the window on every family, as a technician would take it: connect, search,
// select, read, change a setting for good, change one for now, undo, power off and on, new ID,
// new rate — and on a line that misbehaves.
#include "gui/window_bench.h"
#include "sim/sim_link.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "ui/app/event_words.h"

#include <QSignalSpy>

using device::WriteOutcome;

namespace {
std::optional<WriteOutcome> outcomeOf(gui::WindowBench& bench, const QString& key)
{
    const auto& writes = bench.entry().writes;
    return writes.count(key) > 0 ? writes.at(key).outcome : std::nullopt;
}

bool write(gui::WindowBench& bench, const QString& key, std::int64_t raw, bool temporary = false)
{
    bench.desk().write(bench.selection().current(), {{{key, raw}}, temporary, true});
    return bench.settled();
}

QString keyOf(gui::WindowBench& bench, catalog::Role role)
{
    const catalog::Register* reg = bench.entry().servo.profile->byRole(role);
    return reg != nullptr ? reg->key : QString();
}

/// The code of the rate register that stands for another rate than the present one.
std::optional<std::int64_t> anotherRate(gui::WindowBench& bench)
{
    const catalog::Register* reg = bench.entry().servo.profile->byRole(catalog::Role::BaudRate);
    if (reg == nullptr || !reg->writable())
        return std::nullopt;
    for (const catalog::NamedValue& value : reg->values) {
        if (value.key == QLatin1String("57600") || value.key == QLatin1String("38400"))
            return value.value;
    }
    return std::nullopt;
}
} // namespace

class TestWalk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void everyFamily_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addColumn<QString>("setting"); ///< kept
        QTest::addColumn<int>("value");
        QTest::addColumn<bool>("canBeTemporary");
        QTest::newRow("STS") << "sim:sts3215@1,sts3215@2"
                             << "position_p" << 41 << true;
        QTest::newRow("SMS") << "sim:sm40blhv@1,sm40blhv@2"
                             << "position_p" << 41 << true;
        QTest::newRow("SCS") << "sim:scs15@1,scs15@2"
                             << "position_p" << 16 << true;
        QTest::newRow("HLS") << "sim:hls3606m@1,hls3606m@2"
                             << "position_p" << 41 << true;
        QTest::newRow("Modbus") << "sim:smsmb@1"
                                << "position_p" << 41 << true;
        QTest::newRow("LX") << "sim:lx16a@1,lx16a@2"
                            << "temp_limit" << 70 << false;
    }
    void everyFamily()
    {
        QFETCH(QString, port);
        QFETCH(QString, setting);
        QFETCH(int, value);
        QFETCH(bool, canBeTemporary);
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, port));
        const session::ServoRef ref = bench.selection().current();
        QStringList told; // for whoever has to find out what went wrong
        connect(&bench.desk(), &session::Desk::happened, &bench.desk(),
                [&](const session::Event& event) {
                    const ui::EventWords words = ui::describe(event, bench.desk());
                    told << words.line + QLatin1Char(' ') + words.more.join(QLatin1Char(' '));
                });
        const auto before = bench.entry().servo.raw(setting);
        QVERIFY2(before, qPrintable(setting));
        QVERIFY(*before != value);

        QVERIFY(write(bench, setting, value));
        QCOMPARE(outcomeOf(bench, setting), std::optional(WriteOutcome::Kept));
        QVERIFY(!bench.entry().lockOpen().value_or(false));
        QVERIFY(QFile::exists(bench.entry().snapshotPath));
        bench.desk().powerCycle();
        bench.desk().readTable(ref);
        QVERIFY(bench.settled());
        QCOMPARE(bench.entry().servo.raw(setting), std::optional<std::int64_t>(value));

        if (canBeTemporary) {
            QVERIFY(write(bench, setting, value - 1, true));
            QCOMPARE(outcomeOf(bench, setting), std::optional(WriteOutcome::Temporary));
            QCOMPARE(bench.entry().servo.raw(setting), std::optional<std::int64_t>(value - 1));
            bench.action(ui::Command::PowerCycle)->trigger();
            QVERIFY(bench.settled());
            QCOMPARE(bench.entry().servo.raw(setting), std::optional<std::int64_t>(value));
            bench.action(ui::Command::Undo)->trigger(); // of the temporary write
            QVERIFY(bench.settled());
        }
        bench.action(ui::Command::Undo)->trigger();
        QVERIFY(bench.settled());
        QVERIFY2(bench.entry().servo.raw(setting) == before,
                 qPrintable(told.join(QLatin1Char('\n'))));

        QVERIFY(write(bench, keyOf(bench, catalog::Role::Id), 9));
        QCOMPARE(bench.entry().servo.id, 9);
        QCOMPARE(bench.selection().current(), ref);
        if (const auto rate = anotherRate(bench)) {
            const int baudBefore = bench.entry().servo.baud;
            QVERIFY(write(bench, keyOf(bench, catalog::Role::BaudRate), *rate));
            QVERIFY(bench.entry().servo.baud != baudBefore);
            QCOMPARE(bench.selection().current(), ref);
        }
        bench.desk().readTable(ref);
        QVERIFY(bench.settled());
        QVERIFY(!bench.entry().readError);
        QVERIFY(bench.session.journal().open()->empty());
    }

    void themesAndLanguagesSwitchWhileItRuns()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        const QImage light = bench.window->grab().toImage();
        bench.themes.apply(session::Theme::Dark);
        const QImage dark = bench.window->grab().toImage();
        QVERIFY(light.pixelColor(5, 300).lightness() > dark.pixelColor(5, 300).lightness() + 100);
        QCOMPARE(bench.action(ui::Command::Search)->text().remove(u'&'), QStringLiteral("Search"));
        bench.speak(QStringLiteral("zh_CN"));
        QVERIFY(bench.action(ui::Command::Search)->text().contains(QStringLiteral("搜索")));
        QCOMPARE(bench.settings.language(), QStringLiteral("zh_CN"));
        QCOMPARE(bench.settings.theme(), session::Theme::Dark);
        QVERIFY(bench.entry().tableRead); // nothing was forgotten
    }

    void theCableIsPulledDuringAWrite()
    {
        support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
        auto cable = std::make_unique<support::CutCable>(simulator.port(), false);
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, cable->port()));
        cable->cutAtWrite(2); // the first one opens the lock
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), 40}}, false, false});
        QTRY_COMPARE(bench.desk().state(), session::LinkState::Lost);
        QTRY_VERIFY(!bench.entry().writing());
        // Nobody knows whether the servo took it.
        QCOMPARE(outcomeOf(bench, QStringLiteral("position_p")),
                 std::optional(WriteOutcome::Unknown));
        QVERIFY(bench.window->isVisible());
        const auto open = bench.session.journal().open();
        QVERIFY(open);
        QCOMPARE(open->size(), std::size_t(1));

        // At another port it is named all the same.
        cable.reset();
        QSignalSpy named(&bench.desk(), &session::Desk::openIntents);
        QVERIFY(bench.connectTo(simulator.port()));
        QTRY_COMPARE(named.count(), 1);
        const auto elsewhere = named.front().at(1).value<std::vector<base::Intent>>();
        QCOMPARE(elsewhere.size(), std::size_t(1));
        QCOMPARE(elsewhere.front().uuid, open->front().uuid);
    }

    void closingDuringAWriteFinishesIt()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), 40}}, false, false});
        bench.window->close();
        QVERIFY(bench.window->isVisible()); // not before the lock is closed
        QTRY_VERIFY(!bench.window->isVisible());
        QCOMPARE(outcomeOf(bench, QStringLiteral("position_p")), std::optional(WriteOutcome::Kept));
        QVERIFY(bench.session.journal().open()->empty());
    }

    void dropsAndNoiseLoseNothing()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        bench.desk().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.config().faults.drop = 0.1;
            bus.config().faults.corrupt = 0.1;
        });
        int kept = 0;
        for (int value = 40; value < 50; ++value) {
            QVERIFY(write(bench, QStringLiteral("position_p"), value));
            const auto outcome = outcomeOf(bench, QStringLiteral("position_p"));
            QVERIFY(outcome.has_value());
            if (outcome == WriteOutcome::Kept) {
                ++kept;
                QCOMPARE(bench.raw("position_p"), std::optional<std::int64_t>(value));
            }
        }
        QVERIFY(kept > 0);
    }
};

QTEST_MAIN(TestWalk)
#include "tst_walk.moc"
