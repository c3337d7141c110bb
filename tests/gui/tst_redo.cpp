// SPDX-License-Identifier: GPL-3.0-or-later
// Redo in the window: what was asked about the first time is asked about again, and the message
// says what was done.
#include "gui/window_bench.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace {
const QString condition = QStringLiteral("unload_condition");
}

class TestRedo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aDangerousRowIsAskedAboutAgain()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        const auto before = bench.raw("unload_condition");
        QVERIFY(before);
        bench.desk().write(bench.selection().current(), {{{condition, *before ^ 1}}, false, true});
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("unload_condition"), std::optional<std::int64_t>(*before ^ 1));
        bench.action(ui::Command::Undo)->trigger();
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("unload_condition"), before);
        const auto message = [&] { return bench.find<QLabel>("messageText")->toolTip(); };
        QTRY_VERIFY2(message().startsWith(QStringLiteral("Taken back")), qPrintable(message()));

        for (const bool yes : {false, true}) {
            bench.action(ui::Command::Redo)->trigger();
            QTRY_VERIFY(bench.find<QDialog>("question") != nullptr);
            QVERIFY(bench.settled());
            QCOMPARE(bench.raw("unload_condition"), before); // nothing before the answer
            auto* answer = bench.find<QPushButton>(yes ? "questionYes" : "questionNo");
            QVERIFY(answer != nullptr);
            QTest::mouseClick(answer, Qt::LeftButton);
            QTRY_VERIFY(bench.find<QDialog>("question") == nullptr);
            QVERIFY(bench.settled());
            QCOMPARE(bench.raw("unload_condition"),
                     std::optional<std::int64_t>(yes ? *before ^ 1 : *before));
        }
        QTRY_VERIFY2(message().startsWith(QStringLiteral("Redone")), qPrintable(message()));
    }

    /// The button says what it changes back and in which servo, and shows that one.
    void undoNamesWhatItTakesBack()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        const session::ServoRef first = bench.selection().current();
        bench.desk().write(first, {{{QStringLiteral("position_p"), 40}}});
        QVERIFY(bench.settled());
        QVERIFY(bench.choose(2));
        bench.desk().write(bench.selection().current(), {{{QStringLiteral("position_d"), 20}}});
        QVERIFY(bench.settled());
        QAction* undo = bench.action(ui::Command::Undo);
        auto* button = bench.find<QToolButton>("undoButton");
        QVERIFY2(button->text().contains(QLatin1String("ID 2")), qPrintable(button->text()));
        undo->trigger();
        QVERIFY(bench.settled());
        QVERIFY2(button->text().contains(QLatin1String("ID 1")), qPrintable(button->text()));
        QVERIFY2(undo->toolTip().contains(QStringLiteral("40 → 32")), qPrintable(undo->toolTip()));
        undo->trigger(); // while servo 2 is selected
        QCOMPARE(bench.selection().current(), first);
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("position_p"), std::optional<std::int64_t>(32));
        QVERIFY(!button->text().contains(QLatin1String("ID")));
        QVERIFY(bench.action(ui::Command::Redo)->text().contains(QLatin1String("ID 1")));
    }

    void whatIsHarmlessIsRedoneAtOnce()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.desk().write(bench.selection().current(), {{{QStringLiteral("position_p"), 40}}});
        QVERIFY(bench.settled());
        bench.action(ui::Command::Undo)->trigger();
        QVERIFY(bench.settled());
        bench.action(ui::Command::Redo)->trigger();
        QVERIFY(bench.find<QDialog>("question") == nullptr);
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("position_p"), std::optional<std::int64_t>(40));
    }
};

QTEST_MAIN(TestRedo)
#include "tst_redo.moc"
