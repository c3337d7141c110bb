// SPDX-License-Identifier: GPL-3.0-or-later
// The ready-made buses keep what their names promise, seen over the wire; the list syntax says what
// it does not understand.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"
#include <map>

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;

namespace {
/// Status byte of every ID that answers a ping, by rate.
std::map<int, std::uint8_t> found(sim::VirtualBus& bus, Duration& now, int baud)
{
    std::map<int, std::uint8_t> servos;
    for (int id = 0; id <= 253; ++id) {
        const auto reply =
            wire::ask(bus, wire::ping(static_cast<std::uint8_t>(id)), now, baud, 5ms);
        if (wire::isStatusOf(reply, static_cast<std::uint8_t>(id)))
            servos[id] = reply[4];
    }
    return servos;
}

std::unique_ptr<sim::VirtualBus> preset(const char* name, std::optional<int> baud = {})
{
    return std::move(*sim::makePreset(QString::fromLatin1(name), wire::models(), {}, baud));
}
} // namespace

class TestPresets : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void demoHasSixServosAtOneRateOneOfThemAlarmed()
    {
        const auto bus = preset("demo");
        Duration now = 1ms;
        bus->hostReads(now);
        const auto servos = found(*bus, now, 1'000'000);
        QCOMPARE(servos.size(), std::size_t{6});
        QStringList models;
        for (const auto* servo : bus->servos())
            models += servo->profile().modelName;
        models.removeDuplicates();
        QVERIFY(models.size() >= 4);
        const auto alarmed = [](const auto& all) {
            return std::count_if(all.begin(), all.end(), [](auto& s) { return s.second != 0; });
        };
        QCOMPARE(alarmed(servos), 1);
        now += 10min;
        QCOMPARE(alarmed(found(*bus, now, 1'000'000)), 1);
        bus->powerCycle();
        now += 5s;
        QCOMPARE(alarmed(found(*bus, now, 1'000'000)), 1);
    }

    void troubleHasMixedRates()
    {
        const auto bus = preset("trouble");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(found(*bus, now, 1'000'000).size() >= 2);
        QVERIFY(!found(*bus, now, 500'000).empty());
        QVERIFY(!found(*bus, now, 115'200).empty());
        QVERIFY(found(*bus, now, 57'600).empty());
    }

    void troubleHasDuplicateIds()
    {
        const auto bus = preset("trouble");
        std::map<int, int> ids;
        for (const auto* servo : bus->servos())
            ++ids[servo->id()];
        QCOMPARE(std::count_if(ids.begin(), ids.end(), [](auto& id) { return id.second == 2; }), 1);
        const int twin = std::max_element(ids.begin(), ids.end(), [](auto& a, auto& b) {
                             return a.second < b.second;
                         })->first;
        Duration now = 1ms;
        bus->hostReads(now);
        const auto id = static_cast<std::uint8_t>(twin);
        const Bytes reply = wire::ask(*bus, wire::read(id, 56, 15), now);
        QVERIFY(!reply.empty());
        QVERIFY(!wire::isStatusOf(reply, id));
    }

    void troubleHasAnOpenLock()
    {
        const auto bus = preset("trouble");
        int open = 0;
        for (const auto* servo : bus->servos())
            open += servo->raw(QStringLiteral("lock")) == 0 ? 1 : 0;
        QCOMPARE(open, 1);
    }

    void troubleHasAnOverloadThatStays()
    {
        constexpr int overload = 32;
        const auto bus = preset("trouble");
        Duration now = 1ms;
        bus->hostReads(now);
        const auto tripped = [&] {
            int count = 0;
            for (const auto& [id, status] : found(*bus, now, 1'000'000))
                count += (status & overload) != 0 ? 1 : 0;
            return count;
        };
        QCOMPARE(tripped(), 1);
        now += 1min;
        QCOMPARE(tripped(), 1);
    }

    void modbusIsOneServoAtStationOne()
    {
        const auto bus = preset("modbus");
        QCOMPARE(bus->servos().size(), std::size_t{1});
        QCOMPARE(bus->servos()[0]->baud(), 115'200);
        Duration now = 1ms;
        bus->hostReads(now);
        const Bytes pingRequest{0x00, 0x11, 0xC1, 0xBC};
        const Bytes stationOne{0x01, 0x11, 0x03, 0x01, 0x00, 0x00, 0xAC, 0x4D};
        QCOMPARE(wire::ask(*bus, pingRequest, now, 115'200), stationOne);
    }

    // What a table of the preset would show: IDs, an offset that was saved, a motor too warm.
    void lxPresetIsInteresting()
    {
        const auto bus = preset("lx");
        bus->hostReads(1ms);
        bus->powerCycle();
        bus->hostReads(10s);
        QStringList models;
        std::vector<int> ids;
        int offsets = 0;
        int warm = 0;
        for (const sim::VirtualServo* servo : bus->servos()) {
            QCOMPARE(servo->baud(), 115'200);
            ids.push_back(servo->id());
            models += servo->profile().modelName;
            offsets += servo->raw(QStringLiteral("angle_offset")) != 0 ? 1 : 0;
            warm +=
                servo->raw(QStringLiteral("temperature")) > servo->raw(QStringLiteral("temp_limit"))
                    ? 1
                    : 0;
        }
        models.removeDuplicates();
        QVERIFY(models.size() >= 3);
        QCOMPARE(ids, (std::vector<int>{1, 2, 3, 4, 5}));
        QCOMPARE(offsets, 1);
        QCOMPARE(warm, 1);
    }

    void oneRateForAll()
    {
        const auto bus = preset("demo", 57'600);
        Duration now = 1ms;
        bus->hostReads(now);
        QCOMPARE(found(*bus, now, 57'600).size(), std::size_t{6});
    }

    void everyPresetCanBeCreated()
    {
        QVERIFY(sim::presetNames().contains(QStringLiteral("demo")));
        QVERIFY(sim::presetNames().contains(QStringLiteral("trouble")));
        for (const QString& name : sim::presetNames())
            QVERIFY(sim::makePreset(name, wire::models()));
        const auto unknown = sim::makePreset(QStringLiteral("party"), wire::models());
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().code, base::ErrorCode::BadArgument);
        QVERIFY(unknown.error().detail.contains(QStringLiteral("party")));
        QVERIFY(unknown.error().detail.contains(QStringLiteral("trouble")));
    }

    void listsSetModelIdAndRate()
    {
        const auto bus = wire::bus("STS3215@1, sts3250@2:57600,scs15@253,sm40blhv@0", 500'000);
        const auto servos = bus->servos();
        QCOMPARE(servos.size(), std::size_t{4});
        const std::vector<std::pair<int, int>> expected{
            {1, 500'000}, {2, 57'600}, {253, 500'000}, {0, 500'000}};
        for (std::size_t i = 0; i < servos.size(); ++i) {
            QCOMPARE(servos[i]->id(), expected[i].first);
            QCOMPARE(servos[i]->baud(), expected[i].second);
        }
        QCOMPARE(servos[2]->profile().modelName, QStringLiteral("SCS15"));
    }

    void namesMatchInAnySpelling_data()
    {
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("model");
        const auto row = [](const char* written, const char* model) {
            QTest::newRow(written) << QString::fromLatin1(written) << QString::fromLatin1(model);
        };
        row("lx16a", "LX-16A");
        row("LX-16A", "LX-16A");
        row("lx 224 hv", "LX-224HV");
        row("hts35h", "HTS-35H");
        row("hls3606m", "HLS3606");
        row("HLS3915", "HLS3915");
        row("hd1910", "HD-1910");
        row("scs15-2", "SCS15-2");
        row("sm80360m", "SM80-360M");
        row("smsmb", "SMSMB");
    }
    void namesMatchInAnySpelling()
    {
        QFETCH(QString, written);
        QFETCH(QString, model);
        const auto bus = wire::bus(qPrintable(written + QStringLiteral("@7")));
        QCOMPARE(bus->servos()[0]->profile().modelName, model);
        QCOMPARE(bus->servos()[0]->id(), 7);
    }

    void everyModelWithAMapCanBeSimulated_data()
    {
        QTest::addColumn<QString>("model");
        for (const auto& model : wire::models().models()) {
            if (model.supported)
                QTest::addRow("%s %d.%d", qPrintable(model.name), model.major, model.minor)
                    << model.name;
        }
    }
    void everyModelWithAMapCanBeSimulated()
    {
        QFETCH(QString, model);
        const auto bus = wire::bus(qPrintable(model + QStringLiteral("@1")));
        sim::VirtualServo& servo = *bus->servos()[0];
        QCOMPARE(servo.baud(), servo.profile().defaultBaud.value_or(0));
        bus->hostReads(1ms);
        bus->hostReads(1s);
        QVERIFY2(servo.profile().find(QStringLiteral("servo_status")) == nullptr ||
                     servo.raw(QStringLiteral("servo_status")) == 0,
                 "alarmed at its own supply");
        QCOMPARE(servo.raw(servo.profile().byRole(catalog::Role::Id)->key), 1);
        const auto position = servo.profile().byRole(catalog::Role::PresentPosition)->key;
        const std::int64_t before = servo.raw(position);
        const auto goal = servo.profile().byRole(catalog::Role::GoalPosition)->key;
        servo.poke(servo.profile().byRole(catalog::Role::TorqueSwitch)->key, 1);
        servo.poke(goal, before * 3 / 4);
        bus->hostReads(4s);
        QVERIFY(std::abs(servo.raw(position) - before * 3 / 4) <= 15);
    }

    void servosHaveTheirFactoryRate()
    {
        const auto bus = wire::bus("sts3215@1,sm40blhv@2,scs0009@3,hls3606@4,smsmb@5,lx16a@6,"
                                   "sm60-360m@7,scs15-2@8");
        const std::vector<int> rates{1'000'000, 115'200, 1'000'000, 1'000'000,
                                     115'200,   115'200, 115'200,   1'000'000};
        for (std::size_t i = 0; i < rates.size(); ++i)
            QCOMPARE(bus->servos()[i]->baud(), rates[i]);
    }

    /// As on a bench; the same seed gives the same servos.
    void servosDifferAtRest()
    {
        const auto resting = [](bool identical) {
            sim::WireConfig wire;
            wire.identicalServos = identical;
            const auto bus = sim::makeServos(QStringLiteral("sts3215@1,sts3215@1"), wire::models(),
                                             std::nullopt, wire)
                                 .value();
            std::vector<std::array<double, 3>> states;
            for (auto* servo : bus->servos())
                states.push_back({servo->shaftDegrees(), servo->environment().supplyVolts,
                                  servo->environment().ambientCelsius});
            return states;
        };
        const auto states = resting(false);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(states[0][i] != states[1][i]);
        QVERIFY(resting(false) == states);
        QCOMPARE(resting(true)[0], resting(true)[1]);
    }

    void refusesUnknownServos_data()
    {
        QTest::addColumn<QString>("list");
        QTest::addColumn<QString>("culprit");
        const auto row = [](const char* name, const char* list, const char* culprit) {
            QTest::newRow(name) << QString::fromLatin1(list) << QString::fromLatin1(culprit);
        };
        row("nothing", "", "MODEL@ID");
        row("no ID", "sts3215", "sts3215");
        row("no model", "@1", "@1");
        row("unknown model", "sts3215@1,xyz9@2", "xyz9@2");
        row("ID too high", "sts3215@254", "sts3215@254");
        row("negative ID", "sts3215@-1", "sts3215@-1");
        row("ID no number", "sts3215@one", "sts3215@one");
        row("two IDs", "sts3215@1@2", "sts3215@1@2");
        row("rate no number", "sts3215@1:fast", "sts3215@1:fast");
        row("rate the model lacks", "sts3215@1:9600", "9600");
        row("too many parts", "sts3215@1:9600:3", "sts3215@1:9600:3");
        row("series without a map", "sws3225@1", "sws3225@1");
        row("Modbus station 0", "smsmb@0", "smsmb@0");
        row("Modbus station 248", "smsmb@248", "smsmb@248");
        row("Modbus at a Feetech rate", "smsmb@1:1000000", "1000000");
        row("comma at the end", "sts3215@1,", "MODEL@ID");
    }
    void refusesUnknownServos()
    {
        QFETCH(QString, list);
        QFETCH(QString, culprit);
        const auto made = sim::makeServos(list, wire::models(), std::nullopt);
        QVERIFY(!made);
        QCOMPARE(made.error().code, base::ErrorCode::BadArgument);
        QVERIFY2(made.error().detail.contains(culprit), qPrintable(made.error().detail));
    }
};

SERVODESK_GUILESS_TEST(TestPresets)
#include "tst_presets.moc"
