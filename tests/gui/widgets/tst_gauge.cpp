// SPDX-License-Identifier: GPL-3.0-or-later
// Gauge and dial: how they show a value and its limits, and that the dial requests goals only when
// allowed, within the limits, by mouse, wheel and keys.
#include "gui/recorded_painting.h"
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "ui/widgets/circle_text.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/position_dial.h"

#include <QPainter>
#include <QSignalSpy>

using ui::DialState;
using ui::Gauge;
using ui::PositionDial;

namespace {
DialState halfTurnDial()
{
    DialState view;
    view.position = 2048;
    view.goal = 2048;
    view.minGoal = 1024;
    view.maxGoal = 3072;
    view.isGoalMovable = true;
    return view;
}

/// A place on the face: degrees clockwise from the top.
QPoint at(const PositionDial& dial, double degrees)
{
    const double angle = degrees / 180 * 3.14159265358979;
    const double radius = 60;
    return dial.rect().center() +
           QPoint(qRound(std::sin(angle) * radius), qRound(-std::cos(angle) * radius));
}
} // namespace

class TestGauge : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void distinguishesNearLimitFromBeyond_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("standing");
        QTest::newRow("middle") << 6.0 << int(Gauge::LimitState::Ok);
        QTest::newRow("near the upper") << 7.9 << int(Gauge::LimitState::Near);
        QTest::newRow("at the upper") << 8.0 << int(Gauge::LimitState::Near);
        QTest::newRow("above") << 8.1 << int(Gauge::LimitState::Exceeded);
        QTest::newRow("below") << 3.9 << int(Gauge::LimitState::Exceeded);
    }
    void distinguishesNearLimitFromBeyond()
    {
        QFETCH(double, value);
        QFETCH(int, standing);
        Gauge gauge;
        gauge.setScale({.min = 2, .max = 10, .low = 4, .high = 8, .decimals = 1});
        gauge.setValue(value, {}, false);
        QCOMPARE(int(gauge.limitState()), standing);
    }

    void bothDirectionsHaveOneLimit()
    {
        Gauge gauge;
        gauge.setScale({.min = -100, .max = 100, .high = 80});
        gauge.setValue(-85, {}, false);
        QCOMPARE(gauge.limitState(), Gauge::LimitState::Exceeded);
        gauge.setValue(85, {}, false);
        QCOMPARE(gauge.limitState(), Gauge::LimitState::Exceeded);
        gauge.setValue(-20, {}, false);
        QCOMPARE(gauge.limitState(), Gauge::LimitState::Ok);
    }

    void aValueThatIsNoNumberIsMarked()
    {
        Gauge gauge;
        gauge.setTitle(QStringLiteral("Current"));
        gauge.setValue(12, QStringLiteral("≤ 3"), false);
        QVERIFY(gauge.accessibleDescription().contains(QLatin1String("12")));
        gauge.setValue(std::nan(""), {}, false);
        QCOMPARE(gauge.valueText(), QStringLiteral("—"));
        gauge.setValue(3, {}, false);
        QCOMPARE(gauge.valueText(), QStringLiteral("3"));
    }

    void theDialRequestsOnlyWhenEnabled()
    {
        PositionDial dial;
        dial.resize(240, 220);
        DialState view = halfTurnDial();
        view.isGoalMovable = false;
        dial.show(view);
        QSignalSpy goalSpy(&dial, &PositionDial::goalRequested);
        QTest::mouseClick(&dial, Qt::LeftButton, {}, at(dial, 30));
        QTest::keyClick(&dial, Qt::Key_Up);
        QCOMPARE(goalSpy.size(), 0);
        view.isGoalMovable = true;
        dial.show(view);
        QTest::mouseClick(&dial, Qt::LeftButton, {}, at(dial, 45));
        QCOMPARE(goalSpy.size(), 1);
        // The middle of the range is at the top, clockwise is more.
        const auto goal = goalSpy.front().front().value<std::int64_t>();
        QVERIFY(std::abs(goal - (2048 + 512)) < 25);
    }

    void theDialStaysWithinTheLimits()
    {
        PositionDial dial;
        dial.resize(240, 220);
        dial.show(halfTurnDial());
        QSignalSpy goalSpy(&dial, &PositionDial::goalRequested);
        QTest::mouseClick(&dial, Qt::LeftButton, {}, at(dial, 130));
        QCOMPARE(goalSpy.back().front().value<std::int64_t>(), 3072);
        QTest::keyClick(&dial, Qt::Key_Home);
        QCOMPARE(goalSpy.back().front().value<std::int64_t>(), 1024);
        QTest::keyClick(&dial, Qt::Key_Up);
        QCOMPARE(goalSpy.back().front().value<std::int64_t>(), 1025); // not read again yet
    }

    /// In multi-turn the knob follows the pointer round and round.
    void theDialGoesOverSeveralTurns()
    {
        PositionDial dial;
        dial.resize(240, 220);
        DialState view = halfTurnDial();
        view.minGoal = -30719;
        view.maxGoal = 30719;
        dial.show(view);
        QSignalSpy goalSpy(&dial, &PositionDial::goalRequested);
        QTest::mousePress(&dial, Qt::LeftButton, {}, at(dial, 0));
        for (int angle = 0; angle <= 720; angle += 30)
            QTest::mouseMove(&dial, at(dial, angle));
        QTest::mouseRelease(&dial, Qt::LeftButton, {}, at(dial, 0));
        QVERIFY(std::abs(goalSpy.back().front().value<std::int64_t>() - (2048 + 8192)) < 40);
    }

    void textStaysInsideTheGauge_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<double>("diameter");
        const QString english = QStringLiteral("turns since connecting: 10 (uncertain)");
        const QString chinese = QStringLiteral("连接以来的圈数：10（不确定）");
        for (const double diameter : {120.0, 186.0, 300.0}) {
            QTest::addRow("English, %.0f", diameter) << english << diameter;
            QTest::addRow("Chinese, %.0f", diameter) << chinese << diameter;
            QTest::addRow("short, %.0f", diameter) << QStringLiteral("2048") << diameter;
        }
    }
    void textStaysInsideTheGauge()
    {
        QFETCH(QString, words);
        QFETCH(double, diameter);
        const QRectF circle(10, 10, diameter, diameter);
        const double top = circle.center().y() + diameter * 0.2;
        const ui::CircleText fitted = ui::fitIntoCircle(words, QApplication::font(), circle, top);
        const QRectF taken =
            QFontMetricsF(fitted.font)
                .boundingRect(fitted.rect, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                              words);
        for (const QPointF& corner :
             {taken.topLeft(), taken.topRight(), taken.bottomLeft(), taken.bottomRight()}) {
            const QPointF away = corner - circle.center();
            QVERIFY(std::hypot(away.x(), away.y()) <= diameter / 2 + 2);
        }
        QCOMPARE(taken.top(), top);
    }

    /// As wide as it is in a window of 1024 px.
    void aNarrowGaugeShowsAllItsText()
    {
        ui::Gauge gauge;
        gauge.setTitle(QStringLiteral("Temperature"));
        gauge.resize(68, 118);
        gui::RecordedPainting painting(gauge.size());
        QPainter painter(&painting);
        gauge.render(&painter);
        painter.end();
        const auto& texts = painting.texts();
        const auto title = std::find_if(texts.begin(), texts.end(), [](const auto& painted) {
            return painted.text == QLatin1String("Temperature");
        });
        QVERIFY(title != texts.end());
        QVERIFY(QRectF(gauge.rect()).contains(title->ink));
    }

    void theWheelNeedsTheFocus()
    {
        QWidget window;
        auto* dial = new PositionDial(&window);
        dial->resize(240, 220);
        dial->show(halfTurnDial());
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        dial->clearFocus();
        QSignalSpy goalSpy(dial, &PositionDial::goalRequested);
        const auto turn = [&] {
            QWheelEvent event(QPointF(50, 50), dial->mapToGlobal(QPointF(50, 50)), {}, {0, 120},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(dial, &event);
        };
        turn();
        QCOMPARE(goalSpy.size(), 0);
        dial->setFocus();
        turn();
        QCOMPARE(goalSpy.size(), 1);
        QCOMPARE(goalSpy.front().front().value<std::int64_t>(), 2058);
    }
};

SERVODESK_TEST(TestGauge)
#include "tst_gauge.moc"
