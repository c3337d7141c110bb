// SPDX-License-Identifier: GPL-3.0-or-later
// The top row: what is opened is what the fields say, what worked is remembered for the adapter,
// and what failed is told with its cause and its remedy.
#include "gui/desk_bench.h"
#include "session/connection.h"
#include "sim/sim_link.h"
#include "text/language.h"
#include "ui/models/link_meter.h"
#include "ui/models/rate_words.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/connect_bar.h"
#include "ui/widgets/link_trouble.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/port_picker.h"
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

struct Bench : gui::DeskBench {
    ui::Banner banner;
    ui::ConnectBar bar{desk, commands, settings, ports};
    ui::LinkTrouble trouble{desk, ports, bar, banner};

    Bench() { bar.show(); }

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
        return QTest::qWaitFor([this] { return desk.state() == LinkState::Open; }, 10000);
    }
    bool disconnected()
    {
        desk.disconnectFrom();
        return QTest::qWaitFor([this] { return desk.state() == LinkState::Off; }, 10000);
    }
    QString told(const char* label) const
    {
        return banner.findChild<QLabel*>(QString::fromLatin1(label))->text();
    }
    QToolButton* offer() const
    {
        for (QToolButton* button :
             banner.findChildren<QToolButton*>(QStringLiteral("bannerAction"))) {
            if (!button->isHidden())
                return button;
        }
        return nullptr;
    }
};

PortRequest full()
{
    PortRequest request;
    request.name = QStringLiteral("/dev/ttyUSB5");
    request.baud = 57600;
    request.parity = session::Parity::Odd;
    request.protocol = base::Protocol::Lx;
    request.patience = std::chrono::milliseconds(40);
    request.silence = std::chrono::microseconds(2500);
    request.retries = 0;
    return request;
}
} // namespace

class TestConnectBar : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void fieldsSayWhatIsAsked();
    void aRateOfOnesOwn();
    void oneClickOpensTheSimulatedBus();
    void theButtonDoesWhatItSays();
    void withoutAPortTheListOpens();
    void rememberedForEachAdapter();
    void theLastOneIsSuggested();
    void figuresAreShown();
    void anAdapterThatIsAwaitedIsSaidToBeGone();
    void aStopIsNoError();
    void searchesAreNoErrors();
    void failuresAreTold_data();
    void failuresAreTold();
    void aBusyPortNamesItsHolder();
    void failuresFollowTheLanguage();
    void closedMessagesStayClosed();
    void unpluggedAndBack();
    void brailleServiceIsNamed();
    void ratesAreWritten();
};

void TestConnectBar::fieldsSayWhatIsAsked()
{
    Bench bench;
    QVERIFY(!bench.bar.request().baud && !bench.bar.request().protocol); // auto
    const PortRequest wanted = full();
    bench.bar.setRequest(wanted);
    const PortRequest said = bench.bar.request();
    QCOMPARE(said.name, wanted.name);
    QVERIFY(said.baud == wanted.baud);
    QVERIFY(said.parity == wanted.parity);
    QVERIFY(said.protocol == wanted.protocol);
    QVERIFY(said.patience == wanted.patience);
    QVERIFY(said.silence == wanted.silence);
    QVERIFY(said.retries == wanted.retries);
    QVERIFY(bench.find<QToolButton>("moreButton")->toolTip().contains(QStringLiteral("is set")));
}

void TestConnectBar::aRateOfOnesOwn()
{
    Bench bench;
    PortRequest odd;
    odd.name = demo;
    odd.baud = 74880;
    bench.bar.setRequest(odd);
    QCOMPARE(bench.bar.request().baud.value_or(0), 74880);
}

void TestConnectBar::oneClickOpensTheSimulatedBus()
{
    Bench bench;
    ui::Welcome welcome(bench.commands);
    welcome.show();
    QVERIFY(bench.find<ui::Pill>("simulatedBadge")->isHidden());
    welcome.findChild<QPushButton*>(QStringLiteral("welcomeSimulation"))->click();
    QTRY_COMPARE(bench.desk.state(), LinkState::Open);
    QVERIFY(bench.desk.simulated());
    QVERIFY(bench.find<ui::Pill>("simulatedBadge")->isVisible());
    QCOMPARE(bench.bar.request().name, bench.desk.lastRequest().name);
}

void TestConnectBar::theButtonDoesWhatItSays()
{
    Bench bench;
    auto* button = bench.find<QToolButton>("connectButton");
    QCOMPARE(button->accessibleName(), QStringLiteral("Connect"));
    QVERIFY(bench.connected(demo));
    QCOMPARE(button->accessibleName(), QStringLiteral("Disconnect"));
    QVERIFY(!bench.find<ui::PortPicker>("portPicker")->isEnabled());
    QSignalSpy pressed(bench.action(ui::Command::Disconnect), &QAction::triggered);
    button->click();
    QCOMPARE(pressed.count(), 1);
    QVERIFY(bench.disconnected());
    QCOMPARE(button->accessibleName(), QStringLiteral("Connect"));
    QVERIFY(bench.find<ui::PortPicker>("portPicker")->isEnabled());
}

void TestConnectBar::withoutAPortTheListOpens()
{
    Bench bench;
    bench.find<QToolButton>("connectButton")->click();
    auto* picker = bench.find<ui::PortPicker>("portPicker");
    QTRY_VERIFY(picker->view()->isVisible());
    QCOMPARE(bench.desk.state(), LinkState::Off);
    picker->hidePopup();
}

void TestConnectBar::rememberedForEachAdapter()
{
    Bench bench;
    auto* baud = bench.find<QComboBox>("baudBox");
    auto* protocol = bench.find<QComboBox>("protocolBox");
    bench.choose(demo);
    baud->setCurrentIndex(baud->findData(500000));
    protocol->setCurrentIndex(protocol->findData(QStringLiteral("feetech")));
    bench.bar.findChild<QSpinBox*>(QStringLiteral("patienceBox"))->setValue(60);
    bench.find<QToolButton>("connectButton")->click();
    QTRY_COMPARE(bench.desk.state(), LinkState::Open);
    QCOMPARE(bench.desk.baud(), 500000);
    QVERIFY(bench.disconnected());

    bench.choose(QStringLiteral("sim:lx")); // never used: as it comes
    QVERIFY(!bench.bar.request().baud);
    QVERIFY(!bench.bar.request().protocol);
    QVERIFY(!bench.bar.request().patience);
    bench.choose(demo);
    QCOMPARE(bench.bar.request().baud.value_or(0), 500000);
    QVERIFY(bench.bar.request().protocol == base::Protocol::Feetech);
    QVERIFY(bench.bar.request().patience == std::chrono::milliseconds(60));
    // And in the next session.
    ui::ConnectBar later(bench.desk, bench.commands, bench.settings, bench.ports);
    QCOMPARE(later.request().name, demo);
    QCOMPARE(later.request().baud.value_or(0), 500000);
}

void TestConnectBar::theLastOneIsSuggested()
{
    gui::DeskBench bench;
    const QString usb3 = QStringLiteral("/dev/ttyUSB3");
    PortRequest used;
    used.name = QStringLiteral("/dev/ttyUSB0");
    used.baud = 38400;
    bench.settings.remember(QStringLiteral("usb:1a86:7523#5A2F31"), used);
    bench.plugs.plug(gui::adapter(QStringLiteral("/dev/ttyUSB0"), QStringLiteral("OTHER")));
    bench.plugs.plug(gui::adapter(usb3, QStringLiteral("5A2F31")));
    ui::ConnectBar bar(bench.desk, bench.commands, bench.settings, bench.ports);
    QTRY_COMPARE(bar.request().name, usb3); // it has another path today
    QCOMPARE(bar.request().baud.value_or(0), 38400);
}

void TestConnectBar::figuresAreShown()
{
    Bench bench;
    auto* status = bench.find<ui::Pill>("linkStatus");
    QCOMPARE(status->words(), QStringLiteral("not connected"));
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    bench.desk.wish(QStringLiteral("test"), {{{bench.ref(1), {QStringLiteral("present_position")}}},
                                             std::chrono::milliseconds(10)});
    static const QRegularExpression busy(
        QStringLiteral("^[1-9][0-9]* reads/s · 0 errors · wire [0-9]+ %$"));
    QTRY_VERIFY2_WITH_TIMEOUT(busy.match(status->words()).hasMatch(), qPrintable(status->words()),
                              5000);
    QVERIFY(status->toolTip().contains(QStringLiteral("Round trip")));
}

/// As while a sweep test runs: the link is not lost yet, but it is no good link either.
void TestConnectBar::anAdapterThatIsAwaitedIsSaidToBeGone()
{
    Bench bench;
    auto* status = bench.find<ui::Pill>("linkStatus");
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    session::Connection& connection = *bench.desk.connection();
    const bus::LinkPatience patience(connection.bus(), std::chrono::minutes(5));
    const auto wire = connection.simulation();
    wire->with([](sim::VirtualBus& bus) { bus.cutLink(); });
    QTRY_COMPARE(status->words(), QStringLiteral("adapter gone, waiting up to 5 s"));
    QVERIFY(status->toolTip().contains(QStringLiteral("not switched on")));
    QCOMPARE(bench.desk.state(), LinkState::Open);
    wire->with([](sim::VirtualBus& bus) { bus.restoreLink(); });
    QTRY_VERIFY2(status->words().contains(QStringLiteral("reads/s")), qPrintable(status->words()));
}

/// Every servo answers to the stop, and nobody waits for it.
void TestConnectBar::aStopIsNoError()
{
    Bench bench;
    auto* status = bench.find<ui::Pill>("linkStatus");
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1,sts3215@2")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    const auto sum = [&] { return bench.desk.statistics().total; };
    const auto before = sum().foreign;
    bench.desk.emergencyStop();
    QTRY_VERIFY(sum().foreign > before);
    bench.desk.readTable(bench.ref(1));
    const auto answered = sum().ok;
    QTRY_VERIFY(sum().ok > answered);
    QTRY_VERIFY_WITH_TIMEOUT(!status->words().startsWith(QStringLiteral("0 reads/s")), 5000);
    QVERIFY2(status->words().contains(QStringLiteral(" 0 errors")), qPrintable(status->words()));
}

void TestConnectBar::searchesAreNoErrors()
{
    ui::LinkMeter meter;
    bus::Statistics now;
    bus::Counters& servo = now.byId[1];
    servo.ok = 1;
    meter.look(now, false, {});
    servo.timeOuts = 1;
    meter.look(now, false, std::chrono::milliseconds(900)); // a search begins
    servo.timeOuts = 3;
    now.byId[100].timeOuts = 250;
    now.total.badChecks = 2;
    meter.look(now, true, std::chrono::seconds(1));
    servo.timeOuts = 5;
    meter.look(now, true, std::chrono::seconds(2)); // it has ended
    QCOMPARE(meter.figures().errors, std::uint64_t(1));
    now.total.foreign = 1;
    now.byId[77].timeOuts = 4; // a free ID that a change of ID has asked for
    now.total.ok = 100;
    now.wireTime = std::chrono::milliseconds(500);
    meter.look(now, false, std::chrono::seconds(4));
    QCOMPARE(meter.figures().errors, std::uint64_t(2));
    QCOMPARE(meter.figures().readsPerSecond, 50);
    QCOMPARE(meter.figures().wireUse, 0.25);
    meter.reset();
    QCOMPARE(meter.figures().errors, std::uint64_t(0));
}

void TestConnectBar::failuresAreTold_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("remedy");
    QTest::newRow("missing") << QStringLiteral("/dev/ttyUSB77")
                             << QStringLiteral("There is no such port (/dev/ttyUSB77)")
                             << QStringLiteral("Plug the adapter in");
    QTest::newRow("no address") << QStringLiteral("tcp://bench")
                                << QStringLiteral("tcp://host:port")
                                << QStringLiteral("Correct the value");
    QTest::newRow("nobody there") << QStringLiteral("tcp://127.0.0.1:1")
                                  << QStringLiteral("could not be opened")
                                  << QStringLiteral("check host and port");
}

void TestConnectBar::failuresAreTold()
{
    QFETCH(const QString, port);
    QFETCH(const QString, what);
    QFETCH(const QString, remedy);
    Bench bench;
    PortRequest request;
    request.name = port;
    bench.bar.setRequest(request);
    bench.bar.connectNow();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.banner.isHidden(), 10000);
    QVERIFY2(bench.told("bannerWhat").contains(what), qPrintable(bench.told("bannerWhat")));
    QVERIFY2(bench.told("bannerMore").contains(remedy), qPrintable(bench.told("bannerMore")));
    QCOMPARE(bench.desk.state(), LinkState::Off);
    // The remedy was followed, more or less: what is chosen now is tried.
    bench.choose(demo);
    bench.offer()->click();
    QTRY_COMPARE(bench.desk.state(), LinkState::Open);
    QVERIFY(bench.banner.isHidden());
    QVERIFY(bench.settings.lastPort() == demo); // what failed is not remembered
}

void TestConnectBar::aBusyPortNamesItsHolder()
{
    PtyPair pty;
    session::Session other;
    PortRequest request;
    request.name = pty.path;
    const auto taken = other.connect(request);
    QVERIFY(taken.has_value());
    Bench bench;
    bench.bar.setRequest(request);
    bench.bar.connectNow();
    QTRY_VERIFY(!bench.banner.isHidden());
    const QString holder = QStringLiteral("(%1)").arg(QCoreApplication::applicationPid());
    QVERIFY2(bench.told("bannerWhat").contains(holder), qPrintable(bench.told("bannerWhat")));
    QVERIFY(bench.told("bannerMore").contains(QStringLiteral("Close the other program")));
}

void TestConnectBar::failuresFollowTheLanguage()
{
    Bench bench;
    bench.banner.present({base::ErrorCode::PortPermission, {}, QStringLiteral("uucp")});
    QVERIFY(bench.told("bannerMore").contains(QStringLiteral("sudo usermod -aG uucp $USER")));
    QVERIFY(bench.told("bannerMore").contains(QStringLiteral("log in again")));
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&bench.banner, &change);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    QVERIFY(bench.told("bannerWhat").contains(han));
    QVERIFY(bench.told("bannerMore").contains(QStringLiteral("sudo usermod -aG uucp $USER")));
}

void TestConnectBar::closedMessagesStayClosed()
{
    Bench bench;
    bench.banner.present({base::ErrorCode::PortBusy});
    QVERIFY(!bench.banner.isHidden());
    bench.banner.findChild<QToolButton*>(QStringLiteral("bannerClose"))->click();
    QVERIFY(bench.banner.isHidden());
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&bench.banner, &change);
    QVERIFY(bench.banner.isHidden());
}

void TestConnectBar::unpluggedAndBack()
{
    const QString serial = QStringLiteral("5A2F31");
    auto before = std::make_unique<PtyPair>();
    PtyPair after;
    Bench bench;
    bench.plugs.plug(gui::adapter(before->path, serial));
    QTRY_VERIFY(bench.ports.find(before->path) != nullptr);
    QVERIFY(bench.connected(before->path));
    const QString old = before->path;
    before.reset(); // the cable
    QTRY_COMPARE_WITH_TIMEOUT(bench.desk.state(), LinkState::Lost, 1000);
    bench.plugs.unplug(old);
    QVERIFY(!bench.banner.isHidden());
    QVERIFY2(bench.told("bannerWhat").contains(QStringLiteral("was unplugged")),
             qPrintable(bench.told("bannerWhat")));
    QVERIFY(bench.offer() == nullptr);
    QCOMPARE(bench.find<ui::Pill>("linkStatus")->words(), QStringLiteral("unplugged"));

    QTRY_VERIFY(bench.ports.ports().empty());
    bench.plugs.plug(gui::adapter(after.path, serial));
    QTRY_VERIFY_WITH_TIMEOUT(bench.offer() != nullptr, 5000);
    QVERIFY(bench.told("bannerWhat").contains(after.path));
    QCOMPARE(bench.desk.state(), LinkState::Lost); // nothing is opened unasked
    QCOMPARE(bench.offer()->accessibleName(), QStringLiteral("Connect again"));
    bench.offer()->click();
    QTRY_COMPARE(bench.desk.state(), LinkState::Open);
    QCOMPARE(bench.desk.lastRequest().name, after.path);
    QVERIFY(bench.banner.isHidden());
}

void TestConnectBar::brailleServiceIsNamed()
{
    Bench bench;
    bench.plugs.takenByBraille({QStringLiteral("1a86:7523")});
    QTRY_VERIFY(!bench.banner.isHidden());
    QVERIFY(bench.told("bannerWhat").contains(QStringLiteral("1a86:7523")));
    QVERIFY(bench.told("bannerMore").contains(QStringLiteral("sudo apt remove brltty")));
}

void TestConnectBar::ratesAreWritten()
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

QTEST_MAIN(TestConnectBar)
#include "tst_connect_bar.moc"
