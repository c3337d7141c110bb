// SPDX-License-Identifier: GPL-3.0-or-later
// The same walk through the window on every family, as a technician would do it: connect, search,
// select, read, change a setting permanently, change one temporarily, undo, power-cycle, new ID,
// new baud rate — also on a disturbed line.
#include "gui/main_window_fixture.h"
#include "sim/host/sim_link.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/real_time.h"
#include "support/test_main.h"
#include "ui/app/event_text.h"

#include <QSignalSpy>

using device::WriteOutcome;

namespace {
std::optional<WriteOutcome> outcomeOf(gui::MainWindowFixture& fixture, const QString& key)
{
    const auto& writes = fixture.entry().writes;
    return writes.count(key) > 0 ? writes.at(key).outcome : std::nullopt;
}

bool write(gui::MainWindowFixture& fixture, const QString& key, std::int64_t raw,
           bool temporary = false)
{
    fixture.workbench().writes().write(fixture.selection().current(),
                                       {{{key, raw}}, temporary, device::Consent::confirmed()});
    return fixture.waitUntilIdle();
}

QString keyOf(gui::MainWindowFixture& fixture, catalog::Role role)
{
    const catalog::Register* reg = fixture.entry().servo.profile->byRole(role);
    return reg != nullptr ? reg->key : QString();
}

/// The code of the rate register that stands for another rate than the present one.
std::optional<std::int64_t> anotherRate(gui::MainWindowFixture& fixture)
{
    const catalog::Register* reg = fixture.entry().servo.profile->byRole(catalog::Role::BaudRate);
    if (reg == nullptr || !reg->writable())
        return std::nullopt;
    for (const catalog::NamedValue& value : reg->values) {
        if (value.key == QLatin1String("57600") || value.key == QLatin1String("38400"))
            return value.value;
    }
    return std::nullopt;
}
} // namespace

class TestFamilyWalkthrough : public QObject {
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
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, port));
        const session::ServoRef ref = fixture.selection().current();
        QStringList log; // for finding out what went wrong
        connect(&fixture.workbench(), &session::Workbench::eventOccurred, &fixture.workbench(),
                [&](const session::Event& event) {
                    const ui::EventText words = ui::describe(event, fixture.workbench().registry());
                    log << words.message + QLatin1Char(' ') + words.details.join(QLatin1Char(' '));
                });
        const auto before = fixture.entry().servo.raw(setting);
        QVERIFY2(before, qPrintable(setting));
        QVERIFY(*before != value);

        QVERIFY(write(fixture, setting, value));
        QCOMPARE(outcomeOf(fixture, setting), std::optional(WriteOutcome::Kept));
        QVERIFY(!fixture.entry().isLockOpen().value_or(false));
        QVERIFY(QFile::exists(fixture.entry().snapshotPath));
        fixture.workbench().link().powerCycle();
        fixture.workbench().writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.entry().servo.raw(setting), std::optional<std::int64_t>(value));

        if (canBeTemporary) {
            QVERIFY(write(fixture, setting, value - 1, true));
            QCOMPARE(outcomeOf(fixture, setting), std::optional(WriteOutcome::Temporary));
            QCOMPARE(fixture.entry().servo.raw(setting), std::optional<std::int64_t>(value - 1));
            fixture.action(ui::Command::PowerCycle)->trigger();
            QVERIFY(fixture.waitUntilIdle());
            QCOMPARE(fixture.entry().servo.raw(setting), std::optional<std::int64_t>(value));
            fixture.action(ui::Command::Undo)->trigger(); // of the temporary write
            QVERIFY(fixture.waitUntilIdle());
        }
        fixture.action(ui::Command::Undo)->trigger();
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY2(fixture.entry().servo.raw(setting) == before,
                 qPrintable(log.join(QLatin1Char('\n'))));

        QVERIFY(write(fixture, keyOf(fixture, catalog::Role::Id), 9));
        QCOMPARE(fixture.entry().servo.id, 9);
        QCOMPARE(fixture.selection().current(), ref);
        if (const auto rate = anotherRate(fixture)) {
            const int baudBefore = fixture.entry().servo.baud;
            QVERIFY(write(fixture, keyOf(fixture, catalog::Role::BaudRate), *rate));
            QVERIFY(fixture.entry().servo.baud != baudBefore);
            QCOMPARE(fixture.selection().current(), ref);
        }
        fixture.workbench().writes().readTable(ref);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!fixture.entry().readError);
        QVERIFY(fixture.session.journal().open()->empty());
    }

    void themesAndLanguagesSwitchWhileItRuns()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        const QImage light = fixture.window->grab().toImage();
        fixture.themes.apply(session::Theme::Dark);
        const QImage dark = fixture.window->grab().toImage();
        QVERIFY(light.pixelColor(5, 300).lightness() > dark.pixelColor(5, 300).lightness() + 100);
        QCOMPARE(fixture.action(ui::Command::Search)->text().remove(u'&'),
                 QStringLiteral("Search"));
        fixture.setLanguage(QStringLiteral("zh_CN"));
        QVERIFY(fixture.action(ui::Command::Search)->text().contains(QStringLiteral("搜索")));
        QCOMPARE(fixture.settings.language(), QStringLiteral("zh_CN"));
        QCOMPARE(fixture.settings.theme(), session::Theme::Dark);
        QVERIFY(fixture.entry().hasFullTable); // nothing was forgotten
    }

    void theCableIsUnpluggedDuringAWrite()
    {
        const support::RealTime realTime; // no simulated port
        support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
        auto cable = std::make_unique<support::CutCable>(simulator.port(), false);
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, cable->port()));
        cable->cutAtWrite(2); // the first one opens the lock
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 40}}, false, {}});
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Lost);
        QTRY_VERIFY(!fixture.entry().writing());
        // It is unknown whether the servo took it.
        QCOMPARE(outcomeOf(fixture, QStringLiteral("position_p")),
                 std::optional(WriteOutcome::Unknown));
        QVERIFY(fixture.window->isVisible());
        const auto open = fixture.session.journal().open();
        QVERIFY(open);
        QCOMPARE(open->size(), std::size_t(1));

        // At another port it is named all the same.
        cable.reset();
        QSignalSpy named(&fixture.workbench().recovery(),
                         &session::RecoveryService::openIntentsFound);
        QVERIFY(fixture.connectTo(simulator.port()));
        QTRY_COMPARE(named.count(), 1);
        const auto otherPortIntents = named.front().at(1).value<std::vector<base::Intent>>();
        QCOMPARE(otherPortIntents.size(), std::size_t(1));
        QCOMPARE(otherPortIntents.front().uuid, open->front().uuid);
    }

    void closingDuringAWriteFinishesIt()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 40}}, false, {}});
        fixture.window->close();
        QVERIFY(fixture.window->isVisible()); // not before the lock is closed
        QTRY_VERIFY(!fixture.window->isVisible());
        QCOMPARE(outcomeOf(fixture, QStringLiteral("position_p")),
                 std::optional(WriteOutcome::Kept));
        QVERIFY(fixture.session.journal().open()->empty());
    }

    void dropsAndNoiseLoseNothing()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.config().faults.drop = 0.1;
            bus.config().faults.corrupt = 0.1;
        });
        int kept = 0;
        for (int value = 40; value < 50; ++value) {
            QVERIFY(write(fixture, QStringLiteral("position_p"), value));
            const auto outcome = outcomeOf(fixture, QStringLiteral("position_p"));
            QVERIFY(outcome.has_value());
            if (outcome == WriteOutcome::Kept) {
                ++kept;
                QCOMPARE(fixture.raw("position_p"), std::optional<std::int64_t>(value));
            }
        }
        QVERIFY(kept > 0);
    }
};

SERVODESK_TEST(TestFamilyWalkthrough)
#include "tst_family_walkthrough.moc"
