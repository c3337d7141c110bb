// SPDX-License-Identifier: GPL-3.0-or-later
// Finding out which port the servos are on: every port has its result, nothing is left open, and
// one click connects to what was found.
#include "gui/main_window_fixture.h"
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/connect/find_servos_dialog.h"
#include "ui/widgets/rate_text.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

namespace {
const QString arm = QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@4");
const QString missing = QStringLiteral("sim:no-such-bus");

struct FinderFixture : gui::WorkbenchFixture {
    explicit FinderFixture(const QStringList& paths)
    {
        for (const QString& port : paths)
            portList.plug(gui::adapter(port, port));
        if (!support::waitFor(
                [&] { return ports.isReady() && int(ports.ports().size()) == paths.size(); }))
            qFatal("no ports");
        dialog = new ui::FindServosDialog(session, ports, nullptr);
        dialog->show();
    }
    ~FinderFixture() { delete dialog; }

    template <typename Widget>
    Widget* find(const char* name) const
    {
        return dialog->findChild<Widget*>(QString::fromLatin1(name));
    }
    QString result(const QString& port) const
    {
        const auto* table = find<QTableWidget>("findResults");
        const auto rows = table->findItems(port, Qt::MatchExactly);
        return rows.isEmpty() ? QString() : table->item(rows.front()->row(), 1)->text();
    }
    bool isDone() const { return !find<QWidget>("findProgress")->isVisible(); }
    QPushButton* connectButton() const { return find<QPushButton>("findConnect"); }

    QPointer<ui::FindServosDialog> dialog;
};
} // namespace

class TestFindServosDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        text::installTranslator(QStringLiteral("en"));
    }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void everyPortHasItsResult()
    {
        FinderFixture fixture({missing, arm, QStringLiteral("sim:lx")});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QVERIFY2(fixture.result(missing).contains(QStringLiteral("no-such-bus")),
                 qPrintable(fixture.result(missing)));
        QCOMPARE(fixture.result(arm), QStringLiteral("3 servos · ID 1–2, 4 (Feetech) · %1 baud")
                                          .arg(ui::rateText(1'000'000)));
        QCOMPARE(fixture.result(QStringLiteral("sim:lx")),
                 QStringLiteral("5 servos · ID 1–5 (LX) · %1 baud").arg(ui::rateText(115'200)));

        // The first find is selected; a port without servos cannot be connected to here.
        QSignalSpy requests(fixture.dialog, &ui::FindServosDialog::connectRequested);
        auto* table = fixture.find<QTableWidget>("findResults");
        QCOMPARE(table->selectedItems().front()->text(), QStringLiteral("sim:lx"));
        table->selectRow(table->findItems(missing, Qt::MatchExactly).front()->row());
        QVERIFY(!fixture.connectButton()->isEnabled());
        table->selectRow(table->findItems(arm, Qt::MatchExactly).front()->row());
        QVERIFY(fixture.connectButton()->isEnabled());
        fixture.connectButton()->click();
        QCOMPARE(requests.count(), 1);
        const auto request = requests.front().front().value<session::PortRequest>();
        QCOMPARE(request.name, arm);
        QCOMPARE(request.baud, std::optional(1'000'000));
        QTRY_VERIFY(!fixture.dialog);
    }

    void everyProtocolIsNamed()
    {
        const QString port = QStringLiteral("sim:sts3215@1:115200,lx16a@1,lx16a@2");
        FinderFixture fixture({port});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QCOMPARE(fixture.result(port),
                 QStringLiteral("3 servos · ID 1 (Feetech), ID 1–2 (LX) · %1 baud")
                     .arg(ui::rateText(115'200)));
    }

    /// The adapter was unplugged meanwhile.
    void searchingAgainForgetsTheResults()
    {
        FinderFixture fixture({arm});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QVERIFY(fixture.connectButton()->isEnabled());
        fixture.portList.unplug(arm);
        QTRY_VERIFY(fixture.ports.ports().empty());
        fixture.find<QPushButton>("findAgain")->click();
        QVERIFY(fixture.find<QLabel>("findEmpty")->isVisible());
        QVERIFY(!fixture.connectButton()->isEnabled());
    }

    void anotherRateIsFound()
    {
        FinderFixture fixture({QStringLiteral("sim:sts3215@7:57600")});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QCOMPARE(fixture.result(QStringLiteral("sim:sts3215@7:57600")),
                 QStringLiteral("1 servo · ID 7 (Feetech) · %1 baud").arg(ui::rateText(57'600)));
    }

    /// A search after connecting would leave LX out at this rate.
    void anLxServoAtAnotherRateIsConnectedToAsSuch()
    {
        const QString port = QStringLiteral("sim:lx16a@3:9600");
        FinderFixture fixture({port});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QSignalSpy requests(fixture.dialog, &ui::FindServosDialog::connectRequested);
        fixture.connectButton()->click();
        QCOMPARE(requests.count(), 1);
        const auto request = requests.front().front().value<session::PortRequest>();
        QCOMPARE(request.baud, std::optional(9600));
        QCOMPARE(request.protocol, std::optional(base::Protocol::Lx));
    }

    void stoppedPortsAreNotCalledSilent()
    {
        const QStringList ports{QStringLiteral("sim:sts3215@1:57600"),
                                QStringLiteral("sim:sts3215@2:57600")};
        FinderFixture fixture(ports);
        QTRY_VERIFY(fixture.find<QLabel>("findState")->text().contains(QStringLiteral("baud")));
        fixture.find<QPushButton>("findAgain")->click();
        QTRY_VERIFY(fixture.isDone());
        for (const QString& port : ports)
            QCOMPARE(fixture.result(port), QStringLiteral("Search not finished"));
        fixture.find<QPushButton>("findAgain")->click(); // all of it anew
        QVERIFY(!fixture.isDone());
        fixture.dialog->close();
        QTRY_VERIFY(!fixture.dialog);
    }

    /// With what the port was used with before, at the rate that was found.
    void theWindowConnectsToWhatWasFound()
    {
        gui::MainWindowFixture fixture;
        fixture.action(ui::Command::FindServos)->trigger();
        auto* dialog = fixture.window->findChild<ui::FindServosDialog*>();
        QVERIFY(dialog != nullptr);
        session::PortRequest found;
        found.name = QStringLiteral("sim:sts3215@1:500000,sts3215@2:500000");
        found.baud = 500'000;
        Q_EMIT dialog->connectRequested(found);
        dialog->close();
        QTRY_COMPARE(fixture.workbench().registry().order().size(), std::size_t(2));
        QCOMPARE(fixture.workbench().link().baud(), 500'000);
    }

    void withoutPortsItSaysWhatToDo()
    {
        FinderFixture fixture(QStringList{});
        QVERIFY(fixture.isDone());
        QVERIFY(!fixture.find<QTableWidget>("findResults")->isVisible());
        QVERIFY(fixture.find<QLabel>("findEmpty")->isVisible());
        text::installTranslator(QStringLiteral("zh_CN"));
        QTRY_COMPARE(fixture.dialog->windowTitle(), QStringLiteral("在所有端口上查找舵机"));
        fixture.portList.plug(gui::adapter(QStringLiteral("sim:scs15@3"), QStringLiteral("1")));
        QTRY_COMPARE(fixture.ports.ports().size(), std::size_t(1));
        fixture.find<QPushButton>("findAgain")->click();
        QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 120'000);
        QVERIFY(fixture.result(QStringLiteral("sim:scs15@3")).contains(QStringLiteral("ID 3")));
    }
};

SERVODESK_TEST(TestFindServosDialog)
#include "tst_find_servos_dialog.moc"
