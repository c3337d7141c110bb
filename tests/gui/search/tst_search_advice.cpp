// SPDX-License-Identifier: GPL-3.0-or-later
// The checklist shows the likely causes first, rules out what the search has answered, and is
// complete in both languages.
#include "session/session.h"
#include "support/test_main.h"
#include "ui/search/search_advice.h"

#include <QtTest>

using ui::AdviceItem;
using ui::AdviceRow;
using ui::SearchFacts;

namespace {
SearchFacts noServoFoundFacts()
{
    SearchFacts facts;
    facts.port.name = QStringLiteral("/dev/ttyUSB0");
    facts.report.rates = {1000000};
    facts.candidates.assign(base::allProtocols.begin(), base::allProtocols.end());
    return facts;
}

jobs::FoundServo servo(int id, bool twins = false)
{
    jobs::FoundServo found;
    found.servo.id = id;
    found.duplicateSuspected = twins;
    return found;
}

AdviceRow rowOf(const std::vector<AdviceRow>& rows, int number)
{
    for (const AdviceRow& row : rows) {
        if (row.number == number)
            return row;
    }
    return {};
}

AdviceItem item(const SearchFacts& facts, int number, const char* key)
{
    for (const AdviceItem& one : rowOf(ui::searchAdvice(facts), number).items) {
        if (one.key == QLatin1String(key))
            return one;
    }
    return {};
}

std::vector<int> order(const SearchFacts& facts)
{
    std::vector<int> numbers;
    for (const AdviceRow& row : ui::searchAdvice(facts))
        numbers.push_back(row.number);
    return numbers;
}

bool containsChinese(const QString& text)
{
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    return text.contains(han);
}

void allTextsSet(const AdviceItem& item)
{
    for (const catalog::Text& text : {item.cause, item.check, item.finding}) {
        if (text.en.isEmpty() && text.zh.isEmpty())
            continue;
        QVERIFY2(!text.en.isEmpty() && !containsChinese(text.en), qPrintable(item.key));
        QVERIFY2(containsChinese(text.zh), qPrintable(item.key + text.zh));
        QVERIFY2(!text.en.contains(u'%') && !text.zh.contains(u'%'), qPrintable(text.en));
    }
    QVERIFY(!item.cause.en.isEmpty() && !item.check.en.isEmpty());
}
} // namespace

class TestSearchAdvice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyRowInBothLanguages_data();
    void everyRowInBothLanguages();
    void matchingAdviceComesFirst();
    void anOpenPortRulesOutTheDriver();
    void otherProgramsAreReported();
    void searchedIdsAreRuledOut();
    void searchedRatesAreRuledOut();
    void triedProtocolsAreRuledOut();
    void aStoppedSearchRulesNothingOut();
    void lateRepliesSuggestTheTimeout();
    void duplicateIdsAreReported();
    void refusedRatesAreReported();
    void aSimulatedBusHasNoCables();
    void afterAnOwnChange();
    void aBridgeSetsTheRate();
};

void TestSearchAdvice::everyRowInBothLanguages_data()
{
    QTest::addColumn<bool>("much"); ///< everything searched, everything suspicious
    QTest::newRow("nothing known") << false;
    QTest::newRow("all known") << true;
}

void TestSearchAdvice::everyRowInBothLanguages()
{
    QFETCH(const bool, much);
    SearchFacts facts = noServoFoundFacts();
    if (much) {
        facts.port.name = QStringLiteral("sim:trouble");
        facts.report.rates = session::standardBaudRates();
        facts.report.unsupportedRates = {76800};
        facts.report.hasGarbledReplies = true;
        facts.report.found.push_back(servo(1, true));
        facts.history.idOrBaudChanged = true;
    }
    const auto rows = ui::searchAdvice(facts);
    QCOMPARE(rows.size(), std::size_t(5));
    for (int number = 1; number <= 5; ++number) {
        const AdviceRow row = rowOf(rows, number);
        QVERIFY(!row.symptom.en.isEmpty() && containsChinese(row.symptom.zh));
        QVERIFY(row.items.size() >= 3);
        for (const AdviceItem& one : row.items)
            allTextsSet(one);
    }
}

void TestSearchAdvice::matchingAdviceComesFirst()
{
    SearchFacts facts = noServoFoundFacts();
    QCOMPARE(order(facts), std::vector<int>({1, 2, 3, 4, 5}));
    QVERIFY(rowOf(ui::searchAdvice(facts), 1).matches);
    QVERIFY(!rowOf(ui::searchAdvice(facts), 3).matches);
    facts.report.hasGarbledReplies = true;
    QCOMPARE(order(facts), std::vector<int>({4, 1, 2, 3, 5}));
    facts.report.hasGarbledReplies = false;
    facts.history.lostServos = 1;
    QCOMPARE(order(facts), std::vector<int>({5, 1, 2, 3, 4}));
    facts.history = {};
    facts.report.found.push_back(servo(3));
    QCOMPARE(order(facts), std::vector<int>({3, 1, 2, 4, 5}));
}

void TestSearchAdvice::anOpenPortRulesOutTheDriver()
{
    const SearchFacts facts = noServoFoundFacts();
    QVERIFY(item(facts, 1, "driver").ruledOut);
    QVERIFY(!item(facts, 1, "driver").finding.en.isEmpty());
    QVERIFY(!item(facts, 1, "port").ruledOut); // it may be another adapter
    QVERIFY(!item(facts, 1, "supply").ruledOut);
}

/// One that opened the port before, without locking it, is not kept out and does not keep out.
void TestSearchAdvice::otherProgramsAreReported()
{
    SearchFacts facts = noServoFoundFacts();
    for (const int row : {1, 2, 3, 4}) {
        QVERIFY(!item(facts, row, "holder").cause.en.isEmpty());
        QVERIFY(!item(facts, row, "holder").ruledOut); // those of other users cannot be seen
        QVERIFY(item(facts, row, "holder").finding.en.isEmpty());
    }
    QVERIFY(!item(facts, 1, "driver").finding.en.contains(QLatin1String("program")));
    facts.otherPrograms = QStringLiteral("python3 (123)");
    QVERIFY(item(facts, 1, "holder").finding.en.contains(QLatin1String("python3 (123)")));
    QVERIFY(item(facts, 1, "holder").finding.zh.contains(QLatin1String("python3 (123)")));
    QVERIFY(!item(facts, 1, "holder").ruledOut);
    facts.port.name = QStringLiteral("sim:demo");
    facts.otherPrograms.clear();
    QVERIFY(item(facts, 1, "holder").ruledOut);
}

void TestSearchAdvice::searchedIdsAreRuledOut()
{
    SearchFacts facts = noServoFoundFacts();
    QVERIFY(item(facts, 1, "ids").ruledOut);
    facts.spec.firstId = 100;
    facts.spec.lastId = 110;
    const AdviceItem some = item(facts, 1, "ids");
    QVERIFY(!some.ruledOut);
    QVERIFY2(some.finding.en.contains(QStringLiteral("100–110")), qPrintable(some.finding.en));
    QVERIFY(some.finding.zh.contains(QStringLiteral("100–110")));
    QVERIFY(ui::canSearchWider(facts));
}

void TestSearchAdvice::searchedRatesAreRuledOut()
{
    SearchFacts facts = noServoFoundFacts();
    const AdviceItem one = item(facts, 1, "rate");
    QVERIFY(!one.ruledOut);
    QVERIFY(one.finding.en.contains(QStringLiteral("1000000")));
    QVERIFY(ui::canSearchWider(facts));
    facts.report.rates = session::standardBaudRates();
    for (const int row : {1, 2, 3})
        QVERIFY(item(facts, row, "rate").ruledOut);
    QVERIFY(item(facts, 1, "rate").finding.en.contains(QStringLiteral("14")));
    QVERIFY(!ui::canSearchWider(facts));
    facts.report.rates.pop_back(); // one of them is not enough
    QVERIFY(!item(facts, 1, "rate").ruledOut);
}

void TestSearchAdvice::triedProtocolsAreRuledOut()
{
    SearchFacts facts = noServoFoundFacts();
    QVERIFY(item(facts, 1, "protocol").ruledOut);
    facts.candidates = {base::Protocol::Feetech}; // LX and Modbus cannot be met at this rate
    QVERIFY(!item(facts, 1, "protocol").ruledOut);
    facts.spec.protocols = {base::Protocol::Feetech, base::Protocol::Lx};
    QVERIFY(!item(facts, 3, "protocol").ruledOut);
    QVERIFY(item(facts, 3, "protocol").finding.en.contains(QStringLiteral("Feetech, LX")));
    facts.spec.protocols.clear();
    facts.port.protocol = base::Protocol::Modbus; // as connected
    QVERIFY(!item(facts, 1, "protocol").ruledOut);
    QVERIFY(item(facts, 1, "protocol").finding.en.contains(QStringLiteral("Modbus")));
}

void TestSearchAdvice::aStoppedSearchRulesNothingOut()
{
    SearchFacts facts = noServoFoundFacts();
    facts.report.rates = session::standardBaudRates();
    facts.report.stopped = true;
    for (const char* key : {"ids", "rate", "protocol"})
        QVERIFY2(!item(facts, 1, key).ruledOut, key);
    QVERIFY(!item(facts, 5, "old").ruledOut);
}

void TestSearchAdvice::lateRepliesSuggestTheTimeout()
{
    SearchFacts facts = noServoFoundFacts();
    QVERIFY(item(facts, 3, "late").ruledOut);
    facts.report.lateReplies = 3;
    QVERIFY(!item(facts, 3, "late").ruledOut);
    QVERIFY(item(facts, 3, "late").finding.en.contains(u'3'));
}

void TestSearchAdvice::duplicateIdsAreReported()
{
    SearchFacts facts = noServoFoundFacts();
    for (const int id : {4, 7})
        facts.report.found.push_back(servo(id, true));
    QVERIFY(rowOf(ui::searchAdvice(facts), 4).matches);
    for (const int row : {3, 4, 5})
        QVERIFY(item(facts, row, "same_id").finding.en.contains(QStringLiteral("4, 7")));
}

void TestSearchAdvice::refusedRatesAreReported()
{
    SearchFacts facts = noServoFoundFacts();
    QVERIFY(item(facts, 4, "rate_off").finding.en.isEmpty());
    facts.report.unsupportedRates = {76800, 14400};
    QVERIFY(item(facts, 4, "rate_off").finding.en.contains(QStringLiteral("76800, 14400")));
}

void TestSearchAdvice::aSimulatedBusHasNoCables()
{
    SearchFacts facts = noServoFoundFacts();
    facts.port.name = QStringLiteral("sim:demo");
    for (const char* key : {"port", "adapter_supply", "supply", "lead", "damaged"})
        QVERIFY2(item(facts, 1, key).ruledOut, key);
}

void TestSearchAdvice::afterAnOwnChange()
{
    SearchFacts facts = noServoFoundFacts();
    QVERIFY(!item(facts, 5, "locked").ruledOut);
    facts.history.idOrBaudChanged = true;
    QVERIFY(rowOf(ui::searchAdvice(facts), 5).matches);
    QVERIFY(item(facts, 5, "locked").ruledOut);
    QVERIFY(!item(facts, 5, "old").ruledOut);
    facts.report.rates = session::standardBaudRates();
    QVERIFY(item(facts, 5, "old").ruledOut);
}

void TestSearchAdvice::aBridgeSetsTheRate()
{
    SearchFacts facts = noServoFoundFacts();
    facts.canSetBaud = false;
    facts.report.rates = session::standardBaudRates();
    QVERIFY(!item(facts, 1, "rate").ruledOut);
    QVERIFY(item(facts, 1, "rate").finding.en.isEmpty());
    QVERIFY(!ui::canSearchWider(facts)); // nothing wider can be asked from here
}

SERVODESK_GUILESS_TEST(TestSearchAdvice)
#include "tst_search_advice.moc"
