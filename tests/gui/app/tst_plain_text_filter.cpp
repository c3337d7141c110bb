// SPDX-License-Identifier: GPL-3.0-or-later
// Text that looks like HTML in a name, a label or a note is shown character by character.
#include "support/test_main.h"
#include "ui/app/program.h"

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QToolTip>

namespace {
const QString markup = QStringLiteral("<h1>servo</h1><img src=\"file:///etc/hostname\">");

QLabel* tip()
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->inherits("QTipLabel") && widget->isVisible())
            return qobject_cast<QLabel*>(widget);
    }
    return nullptr;
}
} // namespace

class TestPlainTextFilter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::initProgram(); }

    void aLabelShowsPlainText()
    {
        QLabel label(markup);
        label.show();
        QCOMPARE(label.textFormat(), Qt::PlainText);
        QCOMPARE(label.text(), markup);
        // As wide as its letters: as HTML it would be a heading and a picture.
        QVERIFY(label.sizeHint().width() >= label.fontMetrics().horizontalAdvance(markup));
    }

    void richTextStaysRichText()
    {
        QLabel label(QStringLiteral("<b>Gains</b>"));
        label.setTextFormat(Qt::RichText);
        label.show();
        QCOMPARE(label.textFormat(), Qt::RichText);
    }

    void aTooltipShowsPlainText()
    {
        QWidget widget;
        widget.show();
        QToolTip::showText(widget.mapToGlobal(QPoint(1, 1)), markup, &widget);
        QTRY_VERIFY(tip() != nullptr);
        QCOMPARE(tip()->textFormat(), Qt::PlainText);
        QCOMPARE(tip()->text(), markup);
    }
};

SERVODESK_TEST(TestPlainTextFilter)
#include "tst_plain_text_filter.moc"
