// SPDX-License-Identifier: GPL-3.0-or-later
// Advice on gains does not go in circles: what an earlier run has measured is known, but only where
// that run proves something about the last one.
#include "jobs/step/step_advice.h"
#include "support/test_main.h"

#include <QtTest>

using results::StepAdvice;
using results::StepRemedy;
using results::StepRun;
using results::StepSymptom;

namespace {
StepRun runWith(std::int64_t p, std::int64_t d)
{
    StepRun run;
    run.gains = {{QStringLiteral("position_p"), p}, {QStringLiteral("position_d"), d}};
    run.parameters.servo.id = 1;
    run.axis.from = 1800;
    run.axis.to = 2100;
    return run;
}

const StepAdvice lowerP{StepSymptom::Oscillation, StepRemedy::LowerP, QStringLiteral("position_p"),
                        40, 32};
const StepAdvice raiseD{StepSymptom::Overshoot, StepRemedy::RaiseD, QStringLiteral("position_d"),
                        32, 36};
const StepAdvice repeat{StepSymptom::NotSeen, StepRemedy::RepeatRun};
} // namespace

class TestStepAdvice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEarlierRunHasMeasuredIt()
    {
        const std::vector runs{runWith(32, 32), runWith(40, 32)};
        QVERIFY(jobs::wasMeasured(lowerP, runs)); // 32, 32 was the first run
        QVERIFY(!jobs::wasMeasured(raiseD, runs));
        QVERIFY(!jobs::wasMeasured(repeat, runs));
        QVERIFY(!jobs::wasMeasured(lowerP, {}));
    }

    void aRunThatProvesNothingDoesNotCount()
    {
        const StepRun last = runWith(40, 32);
        QVERIFY(!jobs::wasMeasured(lowerP, {runWith(32, 20), last})); // another D
        StepRun interrupted = runWith(32, 32);
        interrupted.end = results::SweepEnd::Stopped;
        QVERIFY(!jobs::wasMeasured(lowerP, {interrupted, last}));
        StepRun other = runWith(32, 32);
        other.parameters.servo.id = 2;
        QVERIFY(!jobs::wasMeasured(lowerP, {other, last}));
        StepRun larger = runWith(32, 32);
        larger.axis.to = 2500;
        QVERIFY(!jobs::wasMeasured(lowerP, {larger, last}));
    }
};

SERVODESK_TEST(TestStepAdvice)
#include "tst_step_advice.moc"
