// SPDX-License-Identifier: GPL-3.0-or-later
// A segmented control shows one choice, changes it by mouse and arrow keys, may show none, and
// stays one row while there is room.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "ui/widgets/segmented_control.h"

#include <QAccessible>
#include <QApplication>
#include <QSignalSpy>
#include <QtTest>

using ui::SegmentedControl;

class TestSegmentedControl : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        m_control = std::make_unique<SegmentedControl>(nullptr);
        for (const char* name : {"first", "second", "third"})
            m_control->addSegment(QString::fromLatin1(name))->setText(QString::fromLatin1(name));
        m_control->select(0);
        m_control->resize(m_control->sizeHint());
        m_control->show();
        QVERIFY(QTest::qWaitForWindowActive(m_control.get()));
    }

    void aClickSelects()
    {
        QSignalSpy chosen(m_control.get(), &SegmentedControl::chosen);
        QTest::mouseClick(m_control->segment(2), Qt::LeftButton);
        QCOMPARE(m_control->selected(), 2);
        QVERIFY(!m_control->segment(0)->isChecked());
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toInt(), 2);
    }

    void arrowKeysSelect()
    {
        m_control->segment(0)->setFocus();
        QSignalSpy chosen(m_control.get(), &SegmentedControl::chosen);
        QTest::keyClick(m_control->segment(0), Qt::Key_Right);
        QCOMPARE(m_control->selected(), 1);
        QVERIFY(m_control->segment(1)->hasFocus());
        QCOMPARE(chosen.count(), 1);
    }

    void arrowKeysMayOnlyMoveTheFocus()
    {
        m_control->setArrowsSelect(false);
        m_control->segment(0)->setFocus();
        QSignalSpy chosen(m_control.get(), &SegmentedControl::chosen);
        for (int i = 0; i < 3; ++i) // past the last one, too
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QVERIFY(m_control->segment(2)->hasFocus());
        QCOMPARE(chosen.count(), 0);
        QCOMPARE(m_control->selected(), 0);
        QTest::keyClick(m_control->segment(2), Qt::Key_Space);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(m_control->selected(), 2);
    }

    void screenReadersSeeRadioButtons()
    {
        const QAccessibleInterface* segment =
            QAccessible::queryAccessibleInterface(m_control->segment(1));
        QVERIFY(segment != nullptr);
        QCOMPARE(segment->role(), QAccessible::RadioButton);
        QVERIFY(!segment->state().checked);
    }

    void tabGoesToTheSelectedOne()
    {
        m_control->select(1);
        for (int i = 0; i < 3; ++i)
            QCOMPARE((m_control->segment(i)->focusPolicy() & Qt::TabFocus) != 0, i == 1);
        m_control->select(-1);
        QVERIFY((m_control->segment(0)->focusPolicy() & Qt::TabFocus) != 0);
    }

    void theProgramMayShowNone()
    {
        QSignalSpy chosen(m_control.get(), &SegmentedControl::chosen);
        m_control->select(-1);
        QCOMPARE(m_control->selected(), -1);
        m_control->select(1);
        QCOMPARE(m_control->selected(), 1);
        QCOMPARE(chosen.count(), 0);
    }

    void segmentsTouchInOneRow()
    {
        const auto box = [this](int index) { return m_control->segment(index)->geometry(); };
        QCOMPARE(box(1).left(), box(0).right() + 1);
        QCOMPARE(box(2).left(), box(1).right() + 1);
        QCOMPARE(box(2).top(), box(0).top());
        // The last one goes below; the rows have one frame, which fills the width.
        const int width = box(1).right() + 21;
        m_control->resize(width, 100);
        QTRY_COMPARE(box(2).top(), box(0).bottom() + 1);
        QCOMPARE(box(1).left(), box(0).right() + 1);
        QCOMPARE(box(1).right() + 1, width);
        QCOMPARE(box(2).left(), 0);
        QCOMPARE(box(2).right() + 1, width);
        QCOMPARE(m_control->heightForWidth(width), 2 * box(0).height());
    }

    void clearRemovesAll()
    {
        m_control->clear();
        QCOMPARE(m_control->segment(0), nullptr);
        QCOMPARE(m_control->selected(), -1);
        m_control->addSegment(QStringLiteral("new"));
        QVERIFY(m_control->segment(0) != nullptr);
    }

private:
    std::unique_ptr<SegmentedControl> m_control;
};

SERVODESK_TEST(TestSegmentedControl)
#include "tst_segmented_control.moc"
