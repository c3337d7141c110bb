// SPDX-License-Identifier: GPL-3.0-or-later
// The command `write` with every register that must ask, in every family: refused without
// --dangerous, with the reason or the command to use. See tst_consent for every value.
#include "catalog/catalog.h"
#include "support/cli_program.h"
#include "support/consent_rules.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::consentFamilies;
using support::ProgramResult;
using support::words;

class TestCliConsent : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void riskyRegistersAreRefused_data();
    void riskyRegistersAreRefused();
    void removingTheLimitsIsRefused();
};

void TestCliConsent::riskyRegistersAreRefused_data()
{
    QTest::addColumn<int>("family");
    for (std::size_t i = 0; i < consentFamilies().size(); ++i)
        QTest::newRow(consentFamilies()[i].servos) << int(i);
}

void TestCliConsent::riskyRegistersAreRefused()
{
    QFETCH(const int, family);
    const support::FamilyRules& rules = consentFamilies()[std::size_t(family)];
    const QString servos = QString::fromLatin1(rules.servos);
    CliProgram cli;
    cli.setPort(QStringLiteral("sim:") + servos);
    cli.setGlobals({QStringLiteral("--baud"), QString::number(rules.baud)});
    const QJsonObject before = cli.json("dump 1").json();
    QVERIFY(!before.isEmpty());
    const auto loaded = catalog::Catalog::load();
    const QJsonObject info = cli.json("info 1").json();
    const QString name = info[QLatin1String("model")].toString();
    const QStringList firmware = info[QLatin1String("firmware")].toString().split(u'.');
    // LX servos do not report their model.
    const catalog::ModelEntry* model =
        loaded.catalog.model(name == QLatin1String("LX") ? QStringLiteral("LX-16A") : name);
    QVERIFY(model != nullptr);
    const catalog::ProfilePtr profile =
        loaded.catalog.profileFor(*model, firmware.value(0).toInt(), firmware.value(1).toInt());
    int refused = 0;
    for (const catalog::Register& reg : profile->registers) {
        for (const std::int64_t raw : support::specialValues(reg, std::nullopt)) {
            if (!reg.writable() || !support::mustAsk(rules, reg, raw))
                continue;
            const ProgramResult result = cli.run({QStringLiteral("write"), QStringLiteral("1"),
                                                  QStringLiteral("%1=%2").arg(reg.key).arg(raw)});
            QVERIFY2(result.exit == 2, qPrintable(reg.key + result.out + result.err));
            ++refused;
            break; // each is a run of the program
        }
    }
    QVERIFY(refused > 1);
    QCOMPARE(cli.json("dump 1").json()[QLatin1String("registers")],
             before[QLatin1String("registers")]);
}

void TestCliConsent::removingTheLimitsIsRefused()
{
    CliProgram cli;
    cli.setPort(QStringLiteral("sim:scs15@1"));
    const char* const line = "write 1 min_angle_limit=0 max_angle_limit=0";
    const ProgramResult refused = cli.run(line);
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.err.contains(QStringLiteral("not limited")) &&
                 refused.err.contains(QStringLiteral("--dangerous")),
             qPrintable(refused.err));
    QCOMPARE(cli.run(words(line) << QStringLiteral("--dangerous")).exit, 0);
}

SERVODESK_GUILESS_TEST(TestCliConsent)
#include "tst_cli_consent.moc"
