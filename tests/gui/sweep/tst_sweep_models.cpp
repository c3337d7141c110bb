// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a sweep test: every judged figure with its grade and reason, what was not measured
// said so, the latest legs and no more, in both languages, and no more changes told than there are.
#include "gui/workbench_fixture.h"
#include "jobs/sweep/sweep_statistics.h"
#include "support/test_main.h"
#include "support/text.h"
#include "text/language.h"
#include "ui/sweep/sweep_legs_model.h"
#include "ui/sweep/sweep_verdict_model.h"
#include "ui/widgets/test_text.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using results::Grade;
using results::SweepLeg;
using results::SweepMetric;
using results::VerdictLine;
using support::utf8;
using ui::LegColumn;
using ui::SweepLegsModel;
using ui::SweepVerdictModel;
using ui::Tone;
using ui::VerdictColumn;

namespace {
SweepLeg leg(int number)
{
    SweepLeg one;
    one.number = number;
    one.cycle = (number + 1) / 2;
    one.start = 300;
    one.target = 3800;
    one.reached = 3797;
    one.timeToTarget = std::chrono::milliseconds(1420);
    one.settling = std::chrono::milliseconds(86);
    one.overshoot = 0.4;
    one.steadyError = -3;
    one.meanSpeed = 2480;
    one.followingError = 31;
    one.loadPeak = 12.5;
    one.voltageMin = 6.9;
    return one;
}

std::vector<SweepLeg> legs(int from, int count)
{
    std::vector<SweepLeg> many;
    for (int i = 0; i < count; ++i)
        many.push_back(leg(from + i));
    return many;
}

results::SweepServo tested()
{
    results::SweepServo servo;
    results::SweepLimits& all = servo.limits;
    all.name = utf8("test");
    all.lines = {{utf8("steady_error"), utf8("step"), 2, 8, false},
                 {utf8("hysteresis"), utf8("step"), 4, 8, false},
                 {utf8("voltage_min"), utf8("V"), 7, 6.5, true},
                 {utf8("current_peak"), utf8("mA"), {}, 1500, false},
                 {utf8("overshoot"), utf8("%"), 2, 5, false}};
    return servo;
}

struct VerdictData {
    explicit VerdictData(const std::vector<SweepLeg>& all)
        : metrics(jobs::sweepMetrics(all, {}, 25.0))
        , lines(results::evaluate(tested(), metrics, results::SweepShape::Sweep))
    {}
    std::vector<SweepMetric> metrics;
    std::vector<VerdictLine> lines;
};

QString cell(const QAbstractItemModel& model, int row, VerdictColumn column)
{
    return model.index(row, int(column)).data().toString();
}

QString cell(const QAbstractItemModel& model, int row, LegColumn column)
{
    return model.index(row, int(column)).data().toString();
}

int rowOf(const SweepVerdictModel& model, const QString& metric)
{
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.index(row, 0).data(SweepVerdictModel::MetricRole).toString() == metric)
            return row;
    }
    return -1;
}
} // namespace

class TestSweepModels : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        text::installTranslator(utf8("en"));
    }
    void cleanup() { text::installTranslator(utf8("en")); }

    void everyMetricHasItsGradeAndReason();
    void unmeasuredMetricsKeepTheirRow();
    void allMetricsOnlyOnRequest();
    void anUnmeasuredLimitIsKept();
    void onlyChangesAreSignaled();
    void metricsFollowTheLanguage();
    void legsShowTheirMeasurements();
    void remarksNameTheProblem();
    void onlyTheLatestLegsStay();
    void manyLegsAreTrimmedAtOnce();
    void emptyColumnsAreKnown();
    void legsFollowTheLanguage();
};

void TestSweepModels::everyMetricHasItsGradeAndReason()
{
    SweepVerdictModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    const VerdictData shown(legs(1, 4));
    model.show(shown.metrics, shown.lines);
    QCOMPARE(model.rowCount(), 5);

    const int error = rowOf(model, utf8("steady_error"));
    QCOMPARE(cell(model, error, VerdictColumn::Metric), utf8("Steady-state error"));
    QCOMPARE(cell(model, error, VerdictColumn::Value), utf8("3 step"));
    QCOMPARE(cell(model, error, VerdictColumn::Warn), utf8("> 2"));
    QCOMPARE(cell(model, error, VerdictColumn::Fail), utf8("> 8"));
    QCOMPARE(cell(model, error, VerdictColumn::Grade), utf8("⚠ Warn"));
    const QModelIndex grade = model.index(error, int(VerdictColumn::Grade));
    QCOMPARE(grade.data(ui::toneRole).toInt(), int(Tone::Warn));
    QCOMPARE(grade.data(SweepVerdictModel::ReasonRole).toString(), utf8("above 2 step"));
    const QString tip = grade.data(Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains(utf8("Mean: -3 step")), qPrintable(tip));
    QVERIFY2(tip.contains(utf8("Count: 4")), qPrintable(tip));
    QVERIFY2(tip.contains(utf8("above 2 step")), qPrintable(tip));

    const int voltage = rowOf(model, utf8("voltage_min"));
    QCOMPARE(cell(model, voltage, VerdictColumn::Warn), utf8("< 7"));
    QCOMPARE(cell(model, voltage, VerdictColumn::Grade), utf8("⚠ Warn"));
    QCOMPARE(model.index(voltage, 0).data(SweepVerdictModel::ReasonRole).toString(),
             utf8("below 7 V"));

    const int overshoot = rowOf(model, utf8("overshoot"));
    QCOMPARE(cell(model, overshoot, VerdictColumn::Grade), utf8("✔ OK"));
    QCOMPARE(model.index(overshoot, 0).data(SweepVerdictModel::GradeRole).toInt(),
             int(Grade::Pass));
}

void TestSweepModels::unmeasuredMetricsKeepTheirRow()
{
    SweepVerdictModel model;
    const VerdictData shown(legs(1, 4));
    model.show(shown.metrics, shown.lines);
    const int current = rowOf(model, utf8("current_peak"));
    QVERIFY(current > rowOf(model, utf8("steady_error"))); // which warns
    QVERIFY(current > rowOf(model, utf8("voltage_min")));
    QCOMPARE(cell(model, current, VerdictColumn::Value), utf8("–"));
    QCOMPARE(cell(model, current, VerdictColumn::Warn), utf8("–"));
    QCOMPARE(cell(model, current, VerdictColumn::Fail), utf8("> 1500"));
    QCOMPARE(cell(model, current, VerdictColumn::Grade), utf8("– not measured"));
    QCOMPARE(model.index(current, int(VerdictColumn::Grade)).data(ui::toneRole).toInt(),
             int(Tone::Quiet));
}

void TestSweepModels::allMetricsOnlyOnRequest()
{
    SweepVerdictModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    const VerdictData shown(legs(1, 4));
    model.show(shown.metrics, shown.lines);
    QCOMPARE(rowOf(model, utf8("mean_speed")), -1);
    model.setShowAll(true);
    QCOMPARE(model.rowCount(), int(results::sweepMetricKinds().size()));
    const int speed = rowOf(model, utf8("mean_speed"));
    QCOMPARE(cell(model, speed, VerdictColumn::Value), utf8("2480 step/s"));
    QCOMPARE(cell(model, speed, VerdictColumn::Grade), utf8("no limit"));
    QVERIFY(!model.index(speed, 0).data(SweepVerdictModel::GradeRole).isValid());
    model.setShowAll(false);
    QCOMPARE(model.rowCount(), 5);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
}

void TestSweepModels::anUnmeasuredLimitIsKept()
{
    SweepVerdictModel model;
    VerdictLine line;
    line.limit = {utf8("of_tomorrow"), utf8("N"), {}, 3, false};
    line.value = 4;
    line.grade = Grade::Fail;
    model.show({}, {line});
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(cell(model, 0, VerdictColumn::Metric), utf8("of_tomorrow"));
    QCOMPARE(cell(model, 0, VerdictColumn::Value), utf8("4 N"));
    QCOMPARE(cell(model, 0, VerdictColumn::Grade), utf8("✘ Fail"));
}

void TestSweepModels::onlyChangesAreSignaled()
{
    SweepVerdictModel model;
    const VerdictData first(legs(1, 4));
    model.show(first.metrics, first.lines);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    model.show(first.metrics, first.lines);
    QCOMPARE(changed.size(), 0);
    auto more = legs(1, 4);
    more.front().voltageMin = 6.6;
    const VerdictData second(more);
    model.show(second.metrics, second.lines);
    QCOMPARE(changed.size(), 1);
    const auto row = changed.front().front().toModelIndex().row();
    QCOMPARE(row, rowOf(model, utf8("voltage_min")));
    QCOMPARE(cell(model, row, VerdictColumn::Value), utf8("6.6 V"));
    QCOMPARE(reset.size(), 0);
    // What fails goes to the top, above what only warns.
    more.front().voltageMin = 6.2;
    const VerdictData third(more);
    model.show(third.metrics, third.lines);
    QCOMPARE(rowOf(model, utf8("voltage_min")), 0);
    QCOMPARE(cell(model, 0, VerdictColumn::Grade), utf8("✘ Fail"));
    QCOMPARE(rowOf(model, utf8("steady_error")), 1);
    QCOMPARE(reset.size(), 1);
}

void TestSweepModels::metricsFollowTheLanguage()
{
    SweepVerdictModel model;
    const VerdictData shown(legs(1, 4));
    model.show(shown.metrics, shown.lines);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy headers(&model, &QAbstractItemModel::headerDataChanged);
    text::installTranslator(utf8("zh_CN"));
    model.retranslate();
    QCOMPARE(changed.size(), 1);
    QCOMPARE(headers.size(), 1);
    const int error = rowOf(model, utf8("steady_error"));
    QCOMPARE(cell(model, error, VerdictColumn::Metric), utf8("静差"));
    QCOMPARE(cell(model, error, VerdictColumn::Value), utf8("3 步"));
    QCOMPARE(model.headerData(int(VerdictColumn::Fail), Qt::Horizontal).toString(),
             utf8("不合格限值"));
}

void TestSweepModels::legsShowTheirMeasurements()
{
    SweepLegsModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.append(leg(7));
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(cell(model, 0, LegColumn::Leg), utf8("7"));
    QCOMPARE(cell(model, 0, LegColumn::Cycle), utf8("4"));
    QCOMPARE(cell(model, 0, LegColumn::Reached), utf8("3797"));
    QCOMPARE(cell(model, 0, LegColumn::Time), utf8("1420"));
    QCOMPARE(cell(model, 0, LegColumn::SteadyError), utf8("-3"));
    QCOMPARE(cell(model, 0, LegColumn::Voltage), utf8("6.9"));
    QCOMPARE(cell(model, 0, LegColumn::Current), utf8("–"));
    QCOMPARE(cell(model, 0, LegColumn::Remarks), QString());
    const QString tip = model.index(0, 0).data(Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains(utf8("Settling, ms: 86")), qPrintable(tip));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.total(), std::size_t(0));
}

void TestSweepModels::remarksNameTheProblem()
{
    SweepLegsModel model;
    SweepLeg bad = leg(1);
    bad.missed = true;
    bad.timeToTarget.reset();
    bad.flagWrong = true;
    bad.alarms = 0x20;
    bad.lost = 2;
    model.append(bad);
    const QModelIndex remarks = model.index(0, int(LegColumn::Remarks));
    const QString words = remarks.data().toString();
    for (const char* part : {"goal missed", "moving flag error", "overload", "2 readings lost"})
        QVERIFY2(words.contains(utf8(part)), qPrintable(words));
    QCOMPARE(remarks.data(ui::toneRole).toInt(), int(Tone::Bad));
    QCOMPARE(cell(model, 0, LegColumn::Time), utf8("–"));
}

void TestSweepModels::onlyTheLatestLegsStay()
{
    SweepLegsModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    model.append(legs(1, 990));
    QCOMPARE(inserted.size(), 1);
    QVERIFY(model.notice().isEmpty());
    model.append(legs(991, 30));
    QCOMPARE(inserted.size(), 2);
    QCOMPARE(model.rowCount(), int(SweepLegsModel::maxLegs));
    QCOMPARE(model.leg(0).number, 21);
    QCOMPARE(model.leg(model.rowCount() - 1).number, 1020);
    QCOMPARE(model.total(), std::size_t(1020));
    QVERIFY2(model.notice().contains(QLocale().toString(1020)), qPrintable(model.notice()));
    QVERIFY(model.notice().contains(utf8("CSV")));
}

void TestSweepModels::manyLegsAreTrimmedAtOnce()
{
    SweepLegsModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.append(legs(1, 5));
    model.append(legs(6, 3000));
    QCOMPARE(model.rowCount(), int(SweepLegsModel::maxLegs));
    QCOMPARE(model.leg(0).number, 2006);
    QCOMPARE(model.total(), std::size_t(3005));
}

void TestSweepModels::emptyColumnsAreKnown()
{
    SweepLegsModel model;
    QSignalSpy changed(&model, &SweepLegsModel::emptyColumnsChanged);
    QVERIFY(!model.isColumnEmpty(LegColumn::Current)); // nothing is known yet
    model.append(legs(1, 3));
    QCOMPARE(changed.size(), 1);
    QVERIFY(model.isColumnEmpty(LegColumn::Current));
    QVERIFY(model.isColumnEmpty(LegColumn::Temperature));
    QVERIFY(!model.isColumnEmpty(LegColumn::Load));
    QVERIFY(!model.isColumnEmpty(LegColumn::Leg));
    QVERIFY(!model.isColumnEmpty(LegColumn::Remarks));
    model.append(legs(4, 3));
    QCOMPARE(changed.size(), 1);
    SweepLeg warm = leg(7);
    warm.temperatureMax = 41;
    model.append(warm);
    QCOMPARE(changed.size(), 2);
    QVERIFY(!model.isColumnEmpty(LegColumn::Temperature));
}

void TestSweepModels::legsFollowTheLanguage()
{
    SweepLegsModel model;
    SweepLeg bad = leg(1);
    bad.missed = true;
    model.append(bad);
    text::installTranslator(utf8("zh_CN"));
    model.retranslate();
    QVERIFY(cell(model, 0, LegColumn::Remarks).contains(utf8("未到位")));
    QCOMPARE(model.headerData(int(LegColumn::Voltage), Qt::Horizontal).toString(),
             utf8("最低电压（V）"));
}

SERVODESK_TEST(TestSweepModels)
#include "tst_sweep_models.moc"
