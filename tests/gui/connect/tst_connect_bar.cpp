// SPDX-License-Identifier: GPL-3.0-or-later
// The top row: the port in the fields is opened, settings that worked are remembered for the
// adapter, and failures are reported with cause and remedy.
#include "gui/workbench_fixture.h"
#include "session/connection.h"
#include "sim/host/sim_link.h"
#include "support/port_endpoints.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/connect/connect_bar.h"
#include "ui/connect/link_error_banner.h"
#include "ui/connect/link_meter.h"
#include "ui/connect/port_picker.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/welcome.h"
#include "unit/transport/pty_pair.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

using session::LinkState;
using session::PortRequest;

namespace {
const QString demo = QStringLiteral("sim:demo");

struct ConnectBarFixture : gui::WorkbenchFixture {
    ui::Banner banner;
    ui::ConnectBar bar{workbench, commands, settings, ports};
    ui::LinkErrorBanner trouble{workbench.link(), ports, bar, banner};

    const QString serial = QStringLiteral("5A2F31");

    ConnectBarFixture() { bar.show(); }

    template <typename Widget>
    Widget* find(const char* name) const
    {
        return bar.findChild<Widget*>(QString::fromLatin1(name));
    }
    /// As the user does.
    void choose(const QString& port) const
    {
        auto* picker = find<ui::PortPicker>("portPicker");
        picker->setCurrentIndex(picker->findData(port));
        Q_EMIT picker->activated(picker->findData(port));
    }
    bool connected(const QString& port)
    {
        choose(port);
        find<QToolButton>("connectButton")->click();
        return support::waitFor([this] { return workbench.link().state() == LinkState::Open; });
    }
    /// An adapter that was in use, and is in the list of ports no more.
    bool unplugged()
    {
        PtyPair adapter;
        portList.plug(gui::adapter(adapter.path, serial));
        if (!support::waitFor([&] { return ports.find(adapter.path) != nullptr; }) ||
            !connected(adapter.path))
            return false;
        adapter.dropConnection();
        portList.unplug(adapter.path);
        return support::waitFor([this] {
            return workbench.link().state() == LinkState::Lost && ports.ports().empty();
        });
    }
    bool disconnected()
    {
        workbench.closing().disconnectFrom();
        return support::waitFor([this] { return workbench.link().state() == LinkState::Off; });
    }
    QString labelText(const char* label) const
    {
        return banner.findChild<QLabel*>(QString::fromLatin1(label))->text();
    }
    QToolButton* offered() const
    {
        for (QToolButton* button :
             banner.findChildren<QToolButton*>(QStringLiteral("bannerAction"))) {
            if (!button->isHidden())
                return button;
        }
        return nullptr;
    }
    /// A button added to a visible banner is shown by an event.
    QToolButton* offer() const
    {
        (void)support::waitFor([this] { return offered() != nullptr; });
        return offered();
    }
};

PortRequest full()
{
    PortRequest request;
    request.name = QStringLiteral("/dev/ttyUSB5");
    request.baud = 57600;
    request.parity = session::Parity::Odd;
    request.protocol = base::Protocol::Lx;
    request.maxReplyLateness = std::chrono::milliseconds(40);
    request.frameSilence = std::chrono::microseconds(2500);
    request.retries = 0;
    return request;
}
} // namespace

class TestConnectBar : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void fieldsHaveLabels();
    void aCustomRate();
    void oneClickOpensTheSimulatedBus();
    void theButtonMatchesItsText();
    void withoutAPortTheListOpens();
    void settingsAreRememberedPerAdapter();
    void theLastPortIsSuggested();
    void statisticsAreShown();
    void anAwaitedAdapterIsReportedMissing();
    void aStopIsNoError();
    void searchesAreNoErrors();
    void failuresAreReported_data();
    void failuresAreReported();
    void aBusyPortNamesItsOwner();
    void failuresFollowTheLanguage();
    void closedMessagesStayClosed();
    void unpluggedAndBack();
    void aClosedMessageEndsReconnecting();
    void aBridgeIsTriedAgain();
    void aPortTakenByAnotherProgramIsLeftToIt();
    void brailleServiceIsReported();
    void ratesAreFormatted();
};

void TestConnectBar::fieldsHaveLabels()
{
    ConnectBarFixture fixture;
    QVERIFY(!fixture.bar.request().baud && !fixture.bar.request().protocol); // auto
    const PortRequest wanted = full();
    fixture.bar.setRequest(wanted);
    const PortRequest barRequest = fixture.bar.request();
    QCOMPARE(barRequest.name, wanted.name);
    QVERIFY(barRequest.baud == wanted.baud);
    QVERIFY(barRequest.parity == wanted.parity);
    QVERIFY(barRequest.protocol == wanted.protocol);
    QVERIFY(barRequest.maxReplyLateness == wanted.maxReplyLateness);
    QVERIFY(barRequest.frameSilence == wanted.frameSilence);
    QVERIFY(barRequest.retries == wanted.retries);
    QVERIFY(
        fixture.find<QToolButton>("moreButton")->toolTip().contains(QStringLiteral("(changed)")));
}

void TestConnectBar::aCustomRate()
{
    ConnectBarFixture fixture;
    PortRequest odd;
    odd.name = demo;
    odd.baud = 74880;
    fixture.bar.setRequest(odd);
    QCOMPARE(fixture.bar.request().baud.value_or(0), 74880);
}

void TestConnectBar::oneClickOpensTheSimulatedBus()
{
    ConnectBarFixture fixture;
    ui::Welcome welcome(fixture.commands);
    welcome.show();
    QVERIFY(fixture.find<ui::Pill>("simulatedBadge")->isHidden());
    welcome.findChild<QPushButton*>(QStringLiteral("welcomeSimulation"))->click();
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QVERIFY(fixture.workbench.link().isSimulated());
    QVERIFY(fixture.find<ui::Pill>("simulatedBadge")->isVisible());
    QCOMPARE(fixture.bar.request().name, fixture.workbench.link().lastRequest().name);
}

void TestConnectBar::theButtonMatchesItsText()
{
    ConnectBarFixture fixture;
    auto* button = fixture.find<QToolButton>("connectButton");
    QCOMPARE(button->accessibleName(), QStringLiteral("Connect"));
    QVERIFY(fixture.connected(demo));
    QCOMPARE(button->accessibleName(), QStringLiteral("Disconnect"));
    QVERIFY(!fixture.find<ui::PortPicker>("portPicker")->isEnabled());
    QSignalSpy pressed(fixture.action(ui::Command::Disconnect), &QAction::triggered);
    button->click();
    QCOMPARE(pressed.count(), 1);
    QVERIFY(fixture.disconnected());
    QCOMPARE(button->accessibleName(), QStringLiteral("Connect"));
    QVERIFY(fixture.find<ui::PortPicker>("portPicker")->isEnabled());
}

void TestConnectBar::withoutAPortTheListOpens()
{
    ConnectBarFixture fixture;
    fixture.find<QToolButton>("connectButton")->click();
    auto* picker = fixture.find<ui::PortPicker>("portPicker");
    QTRY_VERIFY(picker->view()->isVisible());
    QCOMPARE(fixture.workbench.link().state(), LinkState::Off);
    picker->hidePopup();
}

void TestConnectBar::settingsAreRememberedPerAdapter()
{
    ConnectBarFixture fixture;
    auto* baud = fixture.find<QComboBox>("baudBox");
    auto* protocol = fixture.find<QComboBox>("protocolBox");
    fixture.choose(demo);
    baud->setCurrentIndex(baud->findData(500000));
    protocol->setCurrentIndex(protocol->findData(QStringLiteral("feetech")));
    fixture.bar.findChild<QSpinBox*>(QStringLiteral("timeoutBox"))->setValue(60);
    fixture.find<QToolButton>("connectButton")->click();
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QCOMPARE(fixture.workbench.link().baud(), 500000);
    QVERIFY(fixture.disconnected());

    fixture.choose(QStringLiteral("sim:lx")); // never used: as it comes
    QVERIFY(!fixture.bar.request().baud);
    QVERIFY(!fixture.bar.request().protocol);
    QVERIFY(!fixture.bar.request().maxReplyLateness);
    fixture.choose(demo);
    QCOMPARE(fixture.bar.request().baud.value_or(0), 500000);
    QVERIFY(fixture.bar.request().protocol == base::Protocol::Feetech);
    QVERIFY(fixture.bar.request().maxReplyLateness == std::chrono::milliseconds(60));
    // And in the next session.
    ui::ConnectBar later(fixture.workbench, fixture.commands, fixture.settings, fixture.ports);
    QCOMPARE(later.request().name, demo);
    QCOMPARE(later.request().baud.value_or(0), 500000);
}

void TestConnectBar::theLastPortIsSuggested()
{
    gui::WorkbenchFixture fixture;
    const QString usb3 = QStringLiteral("/dev/ttyUSB3");
    PortRequest used;
    used.name = QStringLiteral("/dev/ttyUSB0");
    used.baud = 38400;
    fixture.settings.saveRequest(QStringLiteral("usb:1a86:7523#5A2F31"), used);
    fixture.portList.plug(gui::adapter(QStringLiteral("/dev/ttyUSB0"), QStringLiteral("OTHER")));
    fixture.portList.plug(gui::adapter(usb3, QStringLiteral("5A2F31")));
    ui::ConnectBar bar(fixture.workbench, fixture.commands, fixture.settings, fixture.ports);
    QTRY_COMPARE(bar.request().name, usb3); // it has another path today
    QCOMPARE(bar.request().baud.value_or(0), 38400);
}

void TestConnectBar::statisticsAreShown()
{
    ConnectBarFixture fixture;
    auto* status = fixture.find<ui::Pill>("linkStatus");
    QCOMPARE(status->text(), QStringLiteral("not connected"));
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    fixture.workbench.polling().subscribe(
        QStringLiteral("test"),
        {{{fixture.ref(1), {QStringLiteral("present_position")}}}, std::chrono::milliseconds(10)});
    static const QRegularExpression busy(
        QStringLiteral("^[1-9][0-9]* reads/s · 0 errors · bus load [0-9]+ %$"));
    QTRY_VERIFY2(busy.match(status->text()).hasMatch(), qPrintable(status->text()));
    QVERIFY(status->toolTip().contains(QStringLiteral("Round trip")));
}

/// As while a sweep test runs: the link is not lost yet, but it is no good link either.
void TestConnectBar::anAwaitedAdapterIsReportedMissing()
{
    ConnectBarFixture fixture;
    auto* status = fixture.find<ui::Pill>("linkStatus");
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    session::Connection& connection = *fixture.workbench.link().connection();
    const bus::ReconnectScope reconnect(connection.bus(), std::chrono::minutes(5));
    const auto wire = connection.simulation();
    wire->with([](sim::VirtualBus& bus) { bus.cutLink(); });
    QTRY_COMPARE(status->text(), QStringLiteral("adapter disconnected, waiting up to 5 s"));
    QVERIFY(status->toolTip().contains(QStringLiteral("not be turned back on")));
    QCOMPARE(fixture.workbench.link().state(), LinkState::Open);
    wire->with([](sim::VirtualBus& bus) { bus.restoreLink(); });
    QTRY_VERIFY2(status->text().contains(QStringLiteral("reads/s")), qPrintable(status->text()));
}

/// Every servo answers the stop, and the program does not wait for the answers.
void TestConnectBar::aStopIsNoError()
{
    ConnectBarFixture fixture;
    auto* status = fixture.find<ui::Pill>("linkStatus");
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1,sts3215@2")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    const auto sum = [&] { return fixture.workbench.link().statistics().total; };
    const auto before = sum().foreign;
    fixture.workbench.emergencyStop().trigger();
    QTRY_VERIFY(sum().foreign > before);
    fixture.workbench.writes().readTable(fixture.ref(1));
    const auto answered = sum().ok;
    QTRY_VERIFY(sum().ok > answered);
    QTRY_VERIFY(!status->text().startsWith(QStringLiteral("0 reads/s")));
    QVERIFY2(status->text().contains(QStringLiteral(" 0 errors")), qPrintable(status->text()));
}

void TestConnectBar::searchesAreNoErrors()
{
    ui::LinkMeter meter;
    bus::Statistics now;
    bus::Counters& servo = now.byId[1];
    servo.ok = 1;
    meter.addStatistics(now, false, {});
    servo.timeouts = 1;
    meter.addStatistics(now, false, std::chrono::milliseconds(900)); // a search begins
    servo.timeouts = 3;
    now.byId[100].timeouts = 250;
    now.total.badChecksums = 2;
    meter.addStatistics(now, true, std::chrono::seconds(1));
    servo.timeouts = 5;
    meter.addStatistics(now, true, std::chrono::seconds(2)); // it has ended
    QCOMPARE(meter.values().errors, std::uint64_t(1));
    now.total.foreign = 1;
    now.byId[77].timeouts = 4; // a free ID that a change of ID has asked for
    now.total.ok = 100;
    now.wireTime = std::chrono::milliseconds(500);
    meter.addStatistics(now, false, std::chrono::seconds(4));
    QCOMPARE(meter.values().errors, std::uint64_t(2));
    QCOMPARE(meter.values().readsPerSecond, 50);
    QCOMPARE(meter.values().busLoad, 0.25);
    meter.reset();
    QCOMPARE(meter.values().errors, std::uint64_t(0));
}

void TestConnectBar::failuresAreReported_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("remedy");
    QTest::newRow("missing") << QStringLiteral("/dev/ttyUSB77")
                             << QStringLiteral("Port not found (/dev/ttyUSB77)")
                             << QStringLiteral("Plug the adapter in");
    QTest::newRow("no address") << QStringLiteral("tcp://bench")
                                << QStringLiteral("tcp://host:port")
                                << QStringLiteral("Correct the value");
    QTest::newRow("nobody there") << QStringLiteral("tcp://127.0.0.1:1")
                                  << QStringLiteral("could not be opened")
                                  << QStringLiteral("check the host and port");
}

void TestConnectBar::failuresAreReported()
{
    QFETCH(const QString, port);
    QFETCH(const QString, what);
    QFETCH(const QString, remedy);
    ConnectBarFixture fixture;
    PortRequest request;
    request.name = port;
    fixture.bar.setRequest(request);
    fixture.bar.connectNow();
    QTRY_VERIFY(!fixture.banner.isHidden());
    QVERIFY2(fixture.labelText("bannerWhat").contains(what),
             qPrintable(fixture.labelText("bannerWhat")));
    QVERIFY2(fixture.labelText("bannerMore").contains(remedy),
             qPrintable(fixture.labelText("bannerMore")));
    QCOMPARE(fixture.workbench.link().state(), LinkState::Off);
    // The remedy was followed, more or less: what is chosen now is tried.
    fixture.choose(demo);
    fixture.offer()->click();
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QVERIFY(fixture.banner.isHidden());
    QVERIFY(fixture.settings.lastPort() == demo); // what failed is not remembered
}

void TestConnectBar::aBusyPortNamesItsOwner()
{
    PtyPair pty;
    session::Session other;
    PortRequest request;
    request.name = pty.path;
    const auto taken = other.connect(request);
    QVERIFY(taken.has_value());
    ConnectBarFixture fixture;
    fixture.bar.setRequest(request);
    fixture.bar.connectNow();
    QTRY_VERIFY(!fixture.banner.isHidden());
    const QString holder = QStringLiteral("(%1)").arg(QCoreApplication::applicationPid());
    QVERIFY2(fixture.labelText("bannerWhat").contains(holder),
             qPrintable(fixture.labelText("bannerWhat")));
    QVERIFY(fixture.labelText("bannerMore").contains(QStringLiteral("Close the other program")));
}

void TestConnectBar::failuresFollowTheLanguage()
{
    ConnectBarFixture fixture;
    fixture.banner.showMessage({base::ErrorCode::PortPermission, {}, QStringLiteral("uucp")});
    QVERIFY(
        fixture.labelText("bannerMore").contains(QStringLiteral("sudo usermod -aG uucp $USER")));
    QVERIFY(fixture.labelText("bannerMore").contains(QStringLiteral("log in again")));
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&fixture.banner, &change);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    QVERIFY(fixture.labelText("bannerWhat").contains(han));
    QVERIFY(
        fixture.labelText("bannerMore").contains(QStringLiteral("sudo usermod -aG uucp $USER")));
}

void TestConnectBar::closedMessagesStayClosed()
{
    ConnectBarFixture fixture;
    fixture.banner.showMessage({base::ErrorCode::PortBusy});
    QVERIFY(!fixture.banner.isHidden());
    fixture.banner.findChild<QToolButton*>(QStringLiteral("bannerClose"))->click();
    QVERIFY(fixture.banner.isHidden());
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&fixture.banner, &change);
    QVERIFY(fixture.banner.isHidden());
}

void TestConnectBar::unpluggedAndBack()
{
    PtyPair after;
    ConnectBarFixture fixture;
    QVERIFY(fixture.unplugged());
    QVERIFY(!fixture.banner.isHidden());
    QVERIFY2(fixture.labelText("bannerWhat").contains(QStringLiteral("was unplugged")),
             qPrintable(fixture.labelText("bannerWhat")));
    QCOMPARE(fixture.offer()->accessibleName(), QStringLiteral("Reconnect"));
    QCOMPARE(fixture.find<ui::Pill>("linkStatus")->text(), QStringLiteral("disconnected"));

    fixture.portList.plug(gui::adapter(after.path, fixture.serial));
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QCOMPARE(fixture.workbench.link().lastRequest().name, after.path);
    QCOMPARE(fixture.bar.request().name, after.path);
    QVERIFY(fixture.banner.isHidden());
    // No servo is known, so none is asked; opening a port tries whether its adapter echoes.
    QByteArray sent = QByteArray::fromStdString(after.receive(8));
    const QByteArray echoProbe = QByteArray::fromHex("fffffe04020001fa");
    QVERIFY(sent.startsWith(echoProbe));
    QCOMPARE(sent.replace(echoProbe, QByteArray()).toHex(), QByteArray());
    QVERIFY(fixture.workbench.link().statistics().byId.empty());
}

void TestConnectBar::aClosedMessageEndsReconnecting()
{
    PtyPair after;
    ConnectBarFixture fixture;
    QVERIFY(fixture.unplugged());
    fixture.banner.findChild<QToolButton*>(QStringLiteral("bannerClose"))->click();
    fixture.portList.plug(gui::adapter(after.path, fixture.serial));
    QTRY_VERIFY(fixture.ports.find(after.path) != nullptr);
    QCOMPARE(fixture.workbench.link().state(), LinkState::Lost);
    QVERIFY(!fixture.workbench.link().isOpening());
}

/// It has no adapter whose return could be seen.
void TestConnectBar::aBridgeIsTriedAgain()
{
    support::TcpPort bridge = support::listenOnLoopback();
    ConnectBarFixture fixture;
    fixture.bar.setRequest({.name = bridge.port});
    fixture.bar.connectNow();
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    ::close(bridge.listener);
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Lost);
    // A message that came meanwhile, such as that a stop was not sent, is neither replaced nor does
    // closing it end anything.
    fixture.banner.showMessage({base::ErrorCode::PortPermission});
    const QString other = fixture.labelText("bannerWhat");
    QSignalSpy failed(&fixture.workbench.link(), &session::LinkController::connectFailed);
    QTRY_VERIFY(failed.count() > 0);
    QCOMPARE(fixture.workbench.link().state(), LinkState::Lost);
    QVERIFY(!fixture.banner.isHidden());
    QCOMPARE(fixture.labelText("bannerWhat"), other);
    fixture.banner.findChild<QToolButton*>(QStringLiteral("bannerClose"))->click();
    QVERIFY(fixture.trouble.isWaiting());
    bridge = support::listenOnLoopback(0, 1, bridge.number);
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QVERIFY(fixture.banner.isHidden());
    ::close(bridge.listener);
}

/// What another program has opened meanwhile is its own; the user may ask again.
void TestConnectBar::aPortTakenByAnotherProgramIsLeftToIt()
{
    PtyPair after;
    ConnectBarFixture fixture;
    QVERIFY(fixture.unplugged());
    session::Session other;
    auto taken = other.connect({.name = after.path});
    QVERIFY(taken.has_value());
    QSignalSpy failed(&fixture.workbench.link(), &session::LinkController::connectFailed);
    fixture.portList.plug(gui::adapter(after.path, fixture.serial));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(fixture.labelText("bannerMore").contains(QStringLiteral("Close the other program")));
    QCOMPARE(fixture.offer()->accessibleName(), QStringLiteral("Reconnect"));
    QVERIFY(!fixture.trouble.isWaiting());
    taken->reset();
    fixture.offer()->click();
    QTRY_COMPARE(fixture.workbench.link().state(), LinkState::Open);
    QVERIFY(fixture.banner.isHidden());
}

void TestConnectBar::brailleServiceIsReported()
{
    ConnectBarFixture fixture;
    fixture.portList.adaptersClaimedByBrltty({QStringLiteral("1a86:7523")});
    QTRY_VERIFY(!fixture.banner.isHidden());
    QVERIFY(fixture.labelText("bannerWhat").contains(QStringLiteral("1a86:7523")));
    QVERIFY(fixture.labelText("bannerMore").contains(QStringLiteral("sudo apt remove brltty")));
}

void TestConnectBar::ratesAreFormatted()
{
    QCOMPARE(ui::rateText(1000000).remove(QChar(0x202F)), QStringLiteral("1000000"));
    QCOMPARE(ui::rateText(1000000).size(), 9);
    QCOMPARE(ui::rateText(4800).size(), 5);
    QCOMPARE(ui::shortRate(1000000), QStringLiteral("1 M"));
    QCOMPARE(ui::shortRate(500000), QStringLiteral("500 k"));
    QCOMPARE(ui::shortRate(115200), QStringLiteral("115200"));
    QCOMPARE(ui::spanText(std::chrono::milliseconds(940)), QStringLiteral("0.9 s"));
    QCOMPARE(ui::spanText(std::chrono::seconds(42)), QStringLiteral("42 s"));
    QCOMPARE(ui::spanText(std::chrono::seconds(200)), QStringLiteral("3 min"));
}

SERVODESK_TEST(TestConnectBar)
#include "tst_connect_bar.moc"
