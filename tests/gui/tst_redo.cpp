// SPDX-License-Identifier: GPL-3.0-or-later
// Redo in the window: what was asked about the first time is asked about again, and the message
// says what was done.
#include "gui/window_bench.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>

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
