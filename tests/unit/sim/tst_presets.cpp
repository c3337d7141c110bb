// SPDX-License-Identifier: GPL-3.0-or-later
// The ready-made buses keep what their names promise, seen over the wire; the list syntax says what
// it does not understand.
#include <QRegularExpression>
#include <QTest>

#include "wire_bench.h"
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

class tst_Presets : public QObject {
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

    void troubleHasTwins()
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

    void oneRateForAllMayBeAskedFor()
    {
        const auto bus = preset("demo", 57'600);
        Duration now = 1ms;
        bus->hostReads(now);
        QCOMPARE(found(*bus, now, 57'600).size(), std::size_t{6});
    }

    void everyPresetCanBeMade()
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

    void servosComeWithTheirFactoryRate()
    {
        const auto bus = wire::bus("sts3215@1,sm40blhv@2,scs0009@3");
        QCOMPARE(bus->servo(1)->baud(), 1'000'000);
        QCOMPARE(bus->servo(2)->baud(), 115'200);
        QCOMPARE(bus->servo(3)->baud(), 1'000'000);
    }

    void refusesWhatItCannotMake_data()
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
        row("LX at another rate", "lx16a@1:1000000", "1000000");
        row("Modbus at a Feetech rate", "smsmb@1:1000000", "1000000");
        row("comma at the end", "sts3215@1,", "MODEL@ID");
    }
    void refusesWhatItCannotMake()
    {
        QFETCH(QString, list);
        QFETCH(QString, culprit);
        const auto made = sim::makeServos(list, wire::models(), std::nullopt);
        QVERIFY(!made);
        QCOMPARE(made.error().code, base::ErrorCode::BadArgument);
        QVERIFY2(made.error().detail.contains(culprit), qPrintable(made.error().detail));
    }
};

QTEST_GUILESS_MAIN(tst_Presets)
#include "tst_presets.moc"
