// SPDX-License-Identifier: GPL-3.0-or-later
// Esc stops from anywhere: the first one in an editor, menu or dialog only cancels that, the next
// always stops, Shift+Esc and the red button always do.
#include "gui/window_bench.h"
#include "ui/dialogs/ask.h"

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

namespace {
/// Counts the stops that were sent.
struct Stops {
    explicit Stops(session::Desk& desk)
    {
        QObject::connect(&desk, &session::Desk::happened, &guard,
                         [this](const session::Event& event) {
                             if (event.kind == session::Event::Kind::Stopped)
                                 ++count;
                         });
    }
    QObject guard;
    int count = 0;
};
} // namespace

class TestStopKey : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void escTakesTorqueOff()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("torque_switch"), 1}}, false, true});
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("torque_switch"), std::optional<std::int64_t>(1));
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QTRY_VERIFY([&] {
            bench.desk().readTable(bench.selection().current());
            return bench.settled() && bench.raw("torque_switch") == 0;
        }());
    }

    void theButtonStops()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        Stops stops(bench.desk());
        QTest::mouseClick(bench.find<QPushButton>("stopButton"), Qt::LeftButton);
        QCOMPARE(stops.count, 1);
    }

    void theFirstEscInACellEditorCancelsIt()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        Stops stops(bench.desk());
        auto* table = bench.find<QTableView>("memoryTable");
        QVERIFY(table != nullptr);
        table->setFocus();
        QModelIndex cell;
        for (int row = 0; row < table->model()->rowCount() && !cell.isValid(); ++row) {
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                const QModelIndex index = table->model()->index(row, column);
                if (index.flags().testFlag(Qt::ItemIsEditable)) {
                    cell = index;
                    break;
                }
            }
        }
        QVERIFY(cell.isValid());
        table->setCurrentIndex(cell);
        table->edit(cell);
        QWidget* editor = table->viewport()->findChild<QWidget*>();
        QVERIFY(editor != nullptr);
        QPointer<QWidget> open = editor;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QCOMPARE(stops.count, 0);
        QTRY_VERIFY(open.isNull() || !open->isVisible());
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                               : bench.window.get(),
                        Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QVERIFY(bench.entry().writes.empty());
    }

    void theFirstEscInAMenuClosesIt()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        Stops stops(bench.desk());
        QMenu* menu = bench.window->menuBar()->actions().front()->menu();
        menu->popup(bench.window->mapToGlobal(QPoint(10, 40)));
        QTRY_VERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Escape);
        QVERIFY(!menu->isVisible());
        QCOMPARE(stops.count, 0);
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    void theFirstEscInADialogClosesIt()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        Stops stops(bench.desk());
        ui::ask(bench.window.get(), {.title = QStringLiteral("?"), .yes = QStringLiteral("yes")},
                [] {});
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape);
        QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
        QCOMPARE(stops.count, 0);
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    void shiftEscStopsWhateverIsOpen()
    {
        gui::WindowBench bench;
        QVERIFY(bench.ready(1));
        Stops stops(bench.desk());
        ui::ask(bench.window.get(), {.title = QStringLiteral("?"), .yes = QStringLiteral("yes")},
                [] {});
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape, Qt::ShiftModifier);
        QCOMPARE(stops.count, 1);
        QVERIFY(QApplication::activeModalWidget() != nullptr);
    }
};

QTEST_MAIN(TestStopKey)
#include "tst_stop_key.moc"
