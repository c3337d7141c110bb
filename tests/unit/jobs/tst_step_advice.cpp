// SPDX-License-Identifier: GPL-3.0-or-later
// Advice on gains does not go in circles: what one of the runs has measured is not proposed again.
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
    void whatWasMeasuredIsNotProposedAgain()
    {
        const std::vector runs{runWith(32, 32), runWith(40, 32)};
        const auto left = jobs::withoutTried({repeat, lowerP, raiseD}, runs);
        QCOMPARE(left, (std::vector{repeat, raiseD})); // 32, 32 was the first run
    }

    void withOtherGainsItIsNew()
    {
        // P was 32 before, but with another D.
        const std::vector runs{runWith(32, 20), runWith(40, 32)};
        QCOMPARE(jobs::withoutTried({lowerP}, runs), std::vector{lowerP});
        QCOMPARE(jobs::withoutTried({lowerP}, {}), std::vector{lowerP});
    }
};

SERVODESK_TEST(TestStepAdvice)
#include "tst_step_advice.moc"
