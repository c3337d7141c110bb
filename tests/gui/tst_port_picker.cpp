// SPDX-License-Identifier: GPL-3.0-or-later
// The list of ports follows what is plugged in; the choice is the user's and stays.
#include "gui/desk_bench.h"
#include "ui/dialogs/port_dialog.h"
#include "ui/widgets/port_picker.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QSignalSpy>

using ui::PortPicker;

namespace {
const QString usb0 = QStringLiteral("/dev/ttyUSB0");
const QString usb1 = QStringLiteral("/dev/ttyUSB1");

struct Bench {
    gui::Plugs plugs;
    session::PortWatch ports{nullptr, plugs.lister()};
    PortPicker picker{ports};
    QAbstractItemModelTester tester{picker.model(),
                                    QAbstractItemModelTester::FailureReportingMode::QtTest};

    int rowOf(const QString& port) const { return picker.findData(port); }
    /// As the user does.
    void choose(const QString& port)
    {
        picker.setCurrentIndex(rowOf(port));
        Q_EMIT picker.activated(rowOf(port));
    }
};
} // namespace

class TestPortPicker : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void adaptersAreDescribed();
    void simulatedBusesAreOffered();
    void pluggingNeverLosesTheChoice();
    void aChosenAdapterThatIsGoneStays();
    void theSameAdapterElsewhereIsFollowed();
    void oneWithoutSerialNumberIsNotFollowed();
    void anOpenListStaysOpen();
    void suggestionsGiveWay();
    void typedNamesAreEntries_data();
    void typedNamesAreEntries();
    void theLastEntryAsksForAName();
    void theWheelChoosesNothing();
};

void TestPortPicker::adaptersAreDescribed()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("5A2F31")));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    const QString text = bench.picker.itemText(bench.rowOf(usb0));
    QCOMPARE(text, QStringLiteral("ttyUSB0 — USB Serial · QinHeng · 5A2F31"));
    const QString tip = bench.picker.itemData(bench.rowOf(usb0), Qt::ToolTipRole).toString();
    for (const char* part : {"/dev/ttyUSB0", "QinHeng", "5A2F31", "1a86:7523"})
        QVERIFY2(tip.contains(QLatin1String(part)), qPrintable(tip));
}

void TestPortPicker::simulatedBusesAreOffered()
{
    Bench bench;
    for (const QString& name : session::simulatedPorts())
        QVERIFY2(bench.rowOf(name) >= 0, qPrintable(name));
    QCOMPARE(bench.picker.port(), QString());
    QCOMPARE(bench.picker.currentIndex(), -1);
}

void TestPortPicker::pluggingNeverLosesTheChoice()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(bench.rowOf(usb1) >= 0);
    QSignalSpy chosen(&bench.picker, &PortPicker::chosen);
    for (const QString& port : {usb1, QStringLiteral("sim:trouble")}) {
        bench.choose(port);
        QCOMPARE(bench.picker.port(), port);
        const int before = bench.picker.count();
        bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A"))); // comes before it in the list
        QTRY_COMPARE(bench.picker.count(), before + 1);
        QCOMPARE(bench.picker.port(), port);
        QCOMPARE(bench.picker.currentData().toString(), port);
        bench.plugs.unplug(usb0);
        QTRY_COMPARE(bench.picker.count(), before);
        QCOMPARE(bench.picker.port(), port);
        QCOMPARE(bench.picker.currentData().toString(), port);
    }
    QCOMPARE(chosen.count(), 2); // by the user, and by nobody else
}

void TestPortPicker::aChosenAdapterThatIsGoneStays()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A")));
    bench.plugs.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    bench.choose(usb0);
    QVERIFY(!bench.picker.isMissing());
    bench.plugs.unplug(usb0);
    QTRY_VERIFY(bench.picker.isMissing());
    QCOMPARE(bench.picker.port(), usb0);
    QVERIFY2(bench.picker.currentText().contains(QStringLiteral("not there now")),
             qPrintable(bench.picker.currentText()));
    QVERIFY(bench.picker.currentText().contains(QStringLiteral("USB Serial"))); // still known
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(!bench.picker.isMissing());
    QCOMPARE(bench.picker.port(), usb0);
    QVERIFY(!bench.picker.currentText().contains(QStringLiteral("not there now")));
}

void TestPortPicker::theSameAdapterElsewhereIsFollowed()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    bench.choose(usb0);
    bench.plugs.unplug(usb0);
    QTRY_VERIFY(bench.picker.isMissing());
    QSignalSpy chosen(&bench.picker, &PortPicker::chosen);
    bench.plugs.plug(gui::adapter(usb1, QStringLiteral("A")));
    QTRY_COMPARE(bench.picker.port(), usb1);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(bench.picker.currentData().toString(), usb1);
    QCOMPARE(bench.rowOf(usb0), -1);
}

void TestPortPicker::oneWithoutSerialNumberIsNotFollowed()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb0, QString()));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    bench.choose(usb0);
    bench.plugs.unplug(usb0);
    QTRY_VERIFY(bench.picker.isMissing());
    bench.plugs.plug(gui::adapter(usb1, QString())); // perhaps another one
    QTRY_VERIFY(bench.rowOf(usb1) >= 0);
    QCOMPARE(bench.picker.port(), usb0);
}

void TestPortPicker::anOpenListStaysOpen()
{
    Bench bench;
    bench.plugs.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(bench.rowOf(usb1) >= 0);
    bench.choose(usb1);
    bench.picker.show();
    bench.picker.showPopup();
    QTRY_VERIFY(bench.picker.view()->isVisible());
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    QVERIFY(bench.picker.view()->isVisible());
    QCOMPARE(bench.picker.view()->currentIndex().data(Qt::UserRole).toString(), usb1);
    bench.picker.hidePopup();
}

void TestPortPicker::suggestionsGiveWay()
{
    Bench bench;
    QTRY_VERIFY(bench.ports.hasLooked());
    bench.picker.suggest(QStringLiteral("sim:demo"));
    QCOMPARE(bench.picker.port(), QStringLiteral("sim:demo"));
    bench.choose(QStringLiteral("sim:lx"));
    bench.picker.suggest(QStringLiteral("sim:demo"));
    QCOMPARE(bench.picker.port(), QStringLiteral("sim:lx"));
}

void TestPortPicker::typedNamesAreEntries_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("port");
    QTest::newRow("address") << QStringLiteral("tcp://10.0.0.7:4000")
                             << QStringLiteral("tcp://10.0.0.7:4000");
    QTest::newRow("host and port")
        << QStringLiteral(" bench-3.local:4000 ") << QStringLiteral("tcp://bench-3.local:4000");
    QTest::newRow("device") << QStringLiteral("ttyACM4") << QStringLiteral("/dev/ttyACM4");
    QTest::newRow("path") << QStringLiteral("/dev/pts/7") << QStringLiteral("/dev/pts/7");
    QTest::newRow("servos") << QStringLiteral("sim:sts3215@1") << QStringLiteral("sim:sts3215@1");
}

void TestPortPicker::typedNamesAreEntries()
{
    QFETCH(const QString, typed);
    QFETCH(const QString, port);
    QCOMPARE(ui::PortDialog::portFrom(typed), port);
    Bench bench;
    bench.picker.setPort(port);
    QCOMPARE(bench.picker.port(), port);
    QVERIFY(bench.picker.currentIndex() >= 0);
    QVERIFY(!bench.picker.isMissing()); // nobody knows
    bench.plugs.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(bench.rowOf(usb0) >= 0);
    QCOMPARE(bench.picker.port(), port);
    bench.choose(QStringLiteral("sim:demo"));
    QVERIFY(bench.rowOf(port) >= 0); // still to be had
}

void TestPortPicker::theLastEntryAsksForAName()
{
    Bench bench;
    bench.choose(QStringLiteral("sim:demo"));
    QSignalSpy asked(&bench.picker, &PortPicker::otherWanted);
    const int last = bench.picker.count() - 1;
    bench.picker.setCurrentIndex(last);
    Q_EMIT bench.picker.activated(last);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(bench.picker.port(), QStringLiteral("sim:demo"));
    QCOMPARE(bench.picker.currentData().toString(), QStringLiteral("sim:demo"));
}

void TestPortPicker::theWheelChoosesNothing()
{
    Bench bench;
    bench.choose(QStringLiteral("sim:demo"));
    bench.picker.show();
    QWheelEvent turn({5, 5}, bench.picker.mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&bench.picker, &turn);
    QCOMPARE(bench.picker.currentData().toString(), QStringLiteral("sim:demo"));
}

QTEST_MAIN(TestPortPicker)
#include "tst_port_picker.moc"
