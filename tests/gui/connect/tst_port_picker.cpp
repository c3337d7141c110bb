// SPDX-License-Identifier: GPL-3.0-or-later
// The list of ports follows the connected adapters; the choice of the user stays.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/connect/port_dialog.h"
#include "ui/connect/port_picker.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSignalSpy>

using ui::PortPicker;

namespace {
const QString usb0 = QStringLiteral("/dev/ttyUSB0");
const QString usb1 = QStringLiteral("/dev/ttyUSB1");

struct PickerFixture {
    gui::FakePortList portList;
    session::PortWatcher ports{nullptr, portList.lister()};
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
    void simulatedBusesAreOffered_data();
    void simulatedBusesAreOffered();
    void pluggingKeepsTheSelection();
    void aMissingSelectedAdapterStays();
    void theSameAdapterAtAnotherPathIsFollowed();
    void anAdapterWithoutSerialNumberIsNotFollowed();
    void anOpenListStaysOpen();
    void suggestionsYieldToTheUser();
    void typedNamesAreEntries_data();
    void typedNamesAreEntries();
    void theLastEntryAsksForAName();
    void theWheelSelectsNothing();
};

void TestPortPicker::adaptersAreDescribed()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("5A2F31")));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    const QString text = fixture.picker.itemText(fixture.rowOf(usb0));
    QCOMPARE(text, QStringLiteral("ttyUSB0 — USB Serial · QinHeng · 5A2F31"));
    const QString tip = fixture.picker.itemData(fixture.rowOf(usb0), Qt::ToolTipRole).toString();
    for (const char* part : {"/dev/ttyUSB0", "QinHeng", "5A2F31", "1a86:7523"})
        QVERIFY2(tip.contains(QLatin1String(part)), qPrintable(tip));
}

void TestPortPicker::simulatedBusesAreOffered_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("Chinese") << "zh_CN";
}

void TestPortPicker::simulatedBusesAreOffered()
{
    QFETCH(QString, language);
    text::installTranslator(language);
    const auto english = qScopeGuard([] { text::installTranslator(QStringLiteral("en")); });
    PickerFixture fixture;
    QStringList descriptions;
    for (const QString& name : session::simulatedPorts()) {
        QVERIFY2(fixture.rowOf(name) >= 0, qPrintable(name));
        const QString text = fixture.picker.itemText(fixture.rowOf(name));
        const QString about = text.section(QStringLiteral(" — "), 1);
        QVERIFY2(about.size() > 5 && !descriptions.contains(about), qPrintable(text));
        static const QRegularExpression han(QStringLiteral("\\p{Han}"));
        QCOMPARE(about.contains(han), language != QLatin1String("en"));
        descriptions << about;
    }
    QCOMPARE(fixture.picker.port(), QString());
    QCOMPARE(fixture.picker.currentIndex(), -1);
}

void TestPortPicker::pluggingKeepsTheSelection()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(fixture.rowOf(usb1) >= 0);
    QSignalSpy chosen(&fixture.picker, &PortPicker::portSelected);
    for (const QString& port : {usb1, QStringLiteral("sim:trouble")}) {
        fixture.choose(port);
        QCOMPARE(fixture.picker.port(), port);
        const int before = fixture.picker.count();
        fixture.portList.plug(
            gui::adapter(usb0, QStringLiteral("A"))); // comes before it in the list
        QTRY_COMPARE(fixture.picker.count(), before + 1);
        QCOMPARE(fixture.picker.port(), port);
        QCOMPARE(fixture.picker.currentData().toString(), port);
        fixture.portList.unplug(usb0);
        QTRY_COMPARE(fixture.picker.count(), before);
        QCOMPARE(fixture.picker.port(), port);
        QCOMPARE(fixture.picker.currentData().toString(), port);
    }
    QCOMPARE(chosen.count(), 2); // by the user only
}

void TestPortPicker::aMissingSelectedAdapterStays()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("A")));
    fixture.portList.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    fixture.choose(usb0);
    QVERIFY(!fixture.picker.isMissing());
    fixture.portList.unplug(usb0);
    QTRY_VERIFY(fixture.picker.isMissing());
    QCOMPARE(fixture.picker.port(), usb0);
    QVERIFY2(fixture.picker.currentText().contains(QStringLiteral("not plugged in")),
             qPrintable(fixture.picker.currentText()));
    QVERIFY(fixture.picker.currentText().contains(QStringLiteral("USB Serial"))); // still known
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(!fixture.picker.isMissing());
    QCOMPARE(fixture.picker.port(), usb0);
    QVERIFY(!fixture.picker.currentText().contains(QStringLiteral("not plugged in")));
}

void TestPortPicker::theSameAdapterAtAnotherPathIsFollowed()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    fixture.choose(usb0);
    fixture.portList.unplug(usb0);
    QTRY_VERIFY(fixture.picker.isMissing());
    QSignalSpy chosen(&fixture.picker, &PortPicker::portSelected);
    fixture.portList.plug(gui::adapter(usb1, QStringLiteral("A")));
    QTRY_COMPARE(fixture.picker.port(), usb1);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(fixture.picker.currentData().toString(), usb1);
    QCOMPARE(fixture.rowOf(usb0), -1);
}

void TestPortPicker::anAdapterWithoutSerialNumberIsNotFollowed()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb0, QString()));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    fixture.choose(usb0);
    fixture.portList.unplug(usb0);
    QTRY_VERIFY(fixture.picker.isMissing());
    fixture.portList.plug(gui::adapter(usb1, QString())); // perhaps another one
    QTRY_VERIFY(fixture.rowOf(usb1) >= 0);
    QCOMPARE(fixture.picker.port(), usb0);
}

void TestPortPicker::anOpenListStaysOpen()
{
    PickerFixture fixture;
    fixture.portList.plug(gui::adapter(usb1, QStringLiteral("B")));
    QTRY_VERIFY(fixture.rowOf(usb1) >= 0);
    fixture.choose(usb1);
    fixture.picker.show();
    fixture.picker.showPopup();
    QTRY_VERIFY(fixture.picker.view()->isVisible());
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    QVERIFY(fixture.picker.view()->isVisible());
    QCOMPARE(fixture.picker.view()->currentIndex().data(Qt::UserRole).toString(), usb1);
    fixture.picker.hidePopup();
}

void TestPortPicker::suggestionsYieldToTheUser()
{
    PickerFixture fixture;
    QTRY_VERIFY(fixture.ports.isReady());
    fixture.picker.suggest(QStringLiteral("sim:demo"));
    QCOMPARE(fixture.picker.port(), QStringLiteral("sim:demo"));
    fixture.choose(QStringLiteral("sim:lx"));
    fixture.picker.suggest(QStringLiteral("sim:demo"));
    QCOMPARE(fixture.picker.port(), QStringLiteral("sim:lx"));
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
    PickerFixture fixture;
    fixture.picker.setPort(port);
    QCOMPARE(fixture.picker.port(), port);
    QVERIFY(fixture.picker.currentIndex() >= 0);
    QVERIFY(!fixture.picker.isMissing()); // it is unknown
    fixture.portList.plug(gui::adapter(usb0, QStringLiteral("A")));
    QTRY_VERIFY(fixture.rowOf(usb0) >= 0);
    QCOMPARE(fixture.picker.port(), port);
    fixture.choose(QStringLiteral("sim:demo"));
    QVERIFY(fixture.rowOf(port) >= 0); // still to be had
}

void TestPortPicker::theLastEntryAsksForAName()
{
    PickerFixture fixture;
    fixture.choose(QStringLiteral("sim:demo"));
    QSignalSpy asked(&fixture.picker, &PortPicker::otherPortRequested);
    const int last = fixture.picker.count() - 1;
    fixture.picker.setCurrentIndex(last);
    Q_EMIT fixture.picker.activated(last);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(fixture.picker.port(), QStringLiteral("sim:demo"));
    QCOMPARE(fixture.picker.currentData().toString(), QStringLiteral("sim:demo"));
}

void TestPortPicker::theWheelSelectsNothing()
{
    PickerFixture fixture;
    fixture.choose(QStringLiteral("sim:demo"));
    fixture.picker.show();
    QWheelEvent turn({5, 5}, fixture.picker.mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&fixture.picker, &turn);
    QCOMPARE(fixture.picker.currentData().toString(), QStringLiteral("sim:demo"));
}

SERVODESK_TEST(TestPortPicker)
#include "tst_port_picker.moc"
