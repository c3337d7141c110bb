// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window: they ask what a write of these values asks, and the message reports
// what was done.
#include "gui/main_window_fixture.h"
#include "support/test_main.h"

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

    void aDangerousRowIsConfirmedAgain()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        const auto before = fixture.raw("unload_condition");
        QVERIFY(before);
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{condition, *before ^ 1}}, false, device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("unload_condition"), std::optional<std::int64_t>(*before ^ 1));
        const auto message = [&] { return fixture.find<QLabel>("messageText")->toolTip(); };
        for (const bool isUndo : {true, false}) {
            const std::int64_t from = isUndo ? *before ^ 1 : *before;
            for (const bool yes : {false, true}) {
                fixture.action(isUndo ? ui::Command::Undo : ui::Command::Redo)->trigger();
                QTRY_VERIFY(fixture.find<QDialog>("question") != nullptr);
                QVERIFY(fixture.waitUntilIdle());
                QCOMPARE(fixture.raw("unload_condition"), from); // nothing before the answer
                auto* answer = fixture.find<QPushButton>(yes ? "questionYes" : "questionNo");
                QVERIFY(answer != nullptr);
                QTest::mouseClick(answer, Qt::LeftButton);
                QTRY_VERIFY(fixture.find<QDialog>("question") == nullptr);
                QVERIFY(fixture.waitUntilIdle());
                QCOMPARE(fixture.raw("unload_condition"), yes ? from ^ 1 : from);
            }
            const QString done = isUndo ? QStringLiteral("Undone") : QStringLiteral("Redone");
            QTRY_VERIFY2(message().startsWith(done), qPrintable(message()));
        }
    }

    /// With one question, which names each of them.
    void severalDangerousRowsAreConfirmedTogether()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        const QString offset = QStringLiteral("position_offset");
        const auto before = fixture.raw("unload_condition");
        QVERIFY(before && fixture.raw("position_offset") != 100);
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{condition, *before ^ 1}, {offset, 100}}, false, device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("position_offset"), std::optional<std::int64_t>(100));
        fixture.action(ui::Command::Undo)->trigger();
        QTRY_VERIFY(fixture.find<QDialog>("question") != nullptr);
        QString words;
        for (const QLabel* label : fixture.find<QDialog>("question")->findChildren<QLabel*>())
            words += label->text() + QLatin1Char('\n');
        for (const char* part :
             {"Write 2 settings", "Unload", "offset", "100", "motor can burn out",
              "different angle", "Torque is turned off first"})
            QVERIFY2(words.contains(QLatin1String(part)), qPrintable(words));
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(fixture.find<QDialog>("question") == nullptr);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("unload_condition"), before);
        QVERIFY(fixture.raw("position_offset") != 100);
    }

    /// The button names what it changes back and in which servo, and selects that servo.
    void undoDescribesTheChange()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        const session::ServoRef first = fixture.selection().current();
        fixture.workbench().writes().write(first, {{{QStringLiteral("position_p"), 40}}});
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.choose(2));
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_d"), 20}}});
        QVERIFY(fixture.waitUntilIdle());
        QAction* undo = fixture.action(ui::Command::Undo);
        auto* button = fixture.find<QToolButton>("undoButton");
        QVERIFY2(button->text().contains(QLatin1String("ID 2")), qPrintable(button->text()));
        undo->trigger();
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY2(button->text().contains(QLatin1String("ID 1")), qPrintable(button->text()));
        QVERIFY2(undo->toolTip().contains(QStringLiteral("40 → 32")), qPrintable(undo->toolTip()));
        undo->trigger(); // while servo 2 is selected
        QCOMPARE(fixture.selection().current(), first);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("position_p"), std::optional<std::int64_t>(32));
        QVERIFY(!button->text().contains(QLatin1String("ID")));
        QVERIFY(fixture.action(ui::Command::Redo)->text().contains(QLatin1String("ID 1")));
    }

    void harmlessRowsAreRedoneAtOnce()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 40}}});
        QVERIFY(fixture.waitUntilIdle());
        fixture.action(ui::Command::Undo)->trigger();
        QVERIFY(fixture.waitUntilIdle());
        fixture.action(ui::Command::Redo)->trigger();
        QVERIFY(fixture.find<QDialog>("question") == nullptr);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("position_p"), std::optional<std::int64_t>(40));
    }
};

SERVODESK_TEST(TestRedo)
#include "tst_redo.moc"
