// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as better or worse between two step responses: more than their scatter, and more than
// a step, or a reading, can tell.
#include "results/step_run.h"
#include "support/test_main.h"

#include <QTest>

using results::StepChange;

class TestStepChange : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void changes_data();
    void changes();
};

namespace {
constexpr double way = 200;        ///< steps
constexpr double sampleRate = 250; ///< a reading every 4 ms

results::StepRun runWith(std::optional<double> results::StepFigures::*member,
                         const std::vector<double>& values)
{
    results::StepRun run;
    run.axis.from = 1000;
    run.axis.to = 1000 + way;
    run.sampleRate = sampleRate;
    for (const double value : values) {
        results::StepResponse response;
        response.figures.*member = value;
        run.responses.push_back(response);
    }
    run.mean = results::meanOf(run.responses);
    return run;
}
} // namespace

void TestStepChange::changes_data()
{
    QTest::addColumn<QString>("figure");
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("after");
    QTest::addColumn<double>("scatter"); ///< of each, up and down
    QTest::addColumn<int>("change");
    const auto row = [](const char* name, const char* figure, double before, double after,
                        double scatter, StepChange change) {
        QTest::newRow(name) << QString::fromLatin1(figure) << before << after << scatter
                            << int(change);
    };
    row("a 25th of a step", "steady_error", 0.04, 0, 0, StepChange::Same);
    row("less than a step worse", "steady_error", 0, 0.9, 0, StepChange::Same);
    row("a step", "steady_error", 1, 0, 0, StepChange::Better);
    row("steps within the scatter", "steady_error", 6, 3, 2, StepChange::Same);
    row("steps beyond the scatter", "steady_error", 3, 8, 1, StepChange::Worse);
    row("overshoot of less than a step", "overshoot", 0.4, 0, 0, StepChange::Same);
    row("overshoot of more", "overshoot", 0, 0.6, 0, StepChange::Worse);
    row("a time shorter than a reading", "rise_time", 100, 97, 0, StepChange::Same);
    row("a time of two readings", "rise_time", 100, 92, 0, StepChange::Better);
    row("no way is better", "peak_speed", 100, 900, 0, StepChange::Neither);
}

void TestStepChange::changes()
{
    QFETCH(QString, figure);
    QFETCH(double, before);
    QFETCH(double, after);
    QFETCH(double, scatter);
    QFETCH(int, change);
    const auto found = std::find_if(
        results::stepFigures.begin(), results::stepFigures.end(),
        [&](const results::StepFigure& one) { return figure == QLatin1StringView(one.key); });
    const auto around = [&](double middle) {
        return runWith(found->member, {middle - scatter, middle, middle + scatter});
    };
    const auto rows = results::compareSteps(around(before), around(after));
    QCOMPARE(rows.size(), std::size_t(1));
    QCOMPARE(int(rows[0].change), change);
}

SERVODESK_GUILESS_TEST(TestStepChange)
#include "tst_step_change.moc"
