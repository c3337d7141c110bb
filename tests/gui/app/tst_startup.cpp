// SPDX-License-Identifier: GPL-3.0-or-later
// A start with damaged files: hostile model files and broken settings cost themselves and one
// message each, never the start; and the first start offers the simulated bus in one click.
#include "gui/main_window_fixture.h"
#include "session/paths.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "text/notice_text.h"
#include "ui/app/message_log.h"

#include <QDir>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>

namespace {
void writeFile(const QString& path, const QByteArray& content)
{
    QVERIFY(QDir().mkpath(QFileInfo(path).path()));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}
} // namespace

class TestStartup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        QDir(session::modelFolder()).removeRecursively();
    }
    void cleanup() { QDir(session::modelFolder()).removeRecursively(); }

    void badModelFilesAreReportedAndSkipped()
    {
        const QString folder = session::modelFolder() + QLatin1Char('/');
        writeFile(folder + QStringLiteral("deep.json"), QByteArray(20000, '['));
        writeFile(folder + QStringLiteral("wrong.json"),
                  R"({"format": 1, "models": [{"major": "nine", "name": 5}]})");
        writeFile(folder + QStringLiteral("binary.json"), QByteArray("\0\xff\xfe{}", 5));
        gui::MainWindowFixture fixture;
        const QString log = fixture.find<ui::MessageLog>("messageLog")->toPlainText();
        for (const char* name : {"deep.json", "wrong.json", "binary.json"})
            QVERIFY2(log.contains(QLatin1String(name)), qPrintable(log));
        QVERIFY(fixture.ready(1)); // the built-in models are all there
        QCOMPARE(fixture.entry().servo.profile->modelName, QStringLiteral("STS3215"));
    }

    /// The window has no "recover".
    void theWindowPointsToItsMenuForOpenChanges()
    {
        const gui::MainWindowFixture fixture;
        const QString words = text::describe({base::NoticeCode::LockLeftOpen, 1, {}});
        QVERIFY2(words.contains(QStringLiteral("Use Port → Interrupted writes when")),
                 qPrintable(words));
    }

    void brokenSettingsAreBackedUpAndReported()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("servodesk.ini"));
        writeFile(path, "[general\nversion=\x01\x02\n\xff\xfe");
        session::Settings settings(path);
        session::Session session;
        ui::AppContext fixture(session);
        ui::ThemeSwitch theme;
        ui::LanguageSwitch language;
        language.apply(QStringLiteral("en"));
        theme.apply(settings.theme());
        ui::MainWindow window(fixture, settings, theme, language);
        window.show();
        const QString log = window.findChild<ui::MessageLog*>()->toPlainText();
        QVERIFY(!settings.brokenCopy().isEmpty());
        QVERIFY2(log.contains(settings.brokenCopy()), qPrintable(log));
    }

    /// The only servo found is not selected in place of the requested one.
    void aMissingSelectedServoIsReported()
    {
        gui::MainWindowFixture fixture;
        fixture.window->start(
            {.port = session::PortRequest{.name = QStringLiteral("sim:sts3215@6")}, .select = 1});
        QTRY_VERIFY(fixture.workbench().search().lastReport() &&
                    !fixture.workbench().search().isSearching());
        QCOMPARE(fixture.workbench().registry().order().size(), std::size_t(1));
        QCOMPARE(fixture.selection().current(), 0);
        const auto* log = fixture.find<ui::MessageLog>("messageLog");
        QVERIFY2(log->toPlainText().contains(QStringLiteral("No reply: ID 1")),
                 qPrintable(log->toPlainText()));
    }

    void aReplacedServoIsReported()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.connectTo(QStringLiteral("sim:sts3215@1,scs15@2")));
        QVERIFY(fixture.choose(1));
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.unplug(0);
            bus.servo(2)->poke(QStringLiteral("id"), 1);
        });
        const auto* log = fixture.find<ui::MessageLog>("messageLog");
        const QString words = QStringLiteral("A different servo now replies with ID 1: SCS15");
        QTRY_VERIFY2(log->toPlainText().contains(words), qPrintable(log->toPlainText()));
    }

    /// Also when it is worded anew, in another language.
    void theLogKeepsWhatEachSearchFound()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.connectTo(QStringLiteral("sim:sts3215@1,sts3215@2")));
        auto* log = fixture.find<ui::MessageLog>("messageLog");
        const auto has = [log](const char* words) {
            return log->toPlainText().contains(QLatin1String(words));
        };
        QTRY_VERIFY2(has("2 servos found"), qPrintable(log->toPlainText()));
        fixture.workbench().search().start({.firstId = 9, .lastId = 9, .bauds = {}});
        QTRY_VERIFY2(has("0 servos found"), qPrintable(log->toPlainText()));
        QEvent change(QEvent::LanguageChange);
        QCoreApplication::sendEvent(log, &change);
        QVERIFY2(has("2 servos found") && has("0 servos found"), qPrintable(log->toPlainText()));
    }

    /// One that is opened later shows what was found and selected before.
    void pagesAreMadeWhenTheyAreFirstShown()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.find<QWidget>("positionDial") == nullptr);
        QVERIFY(fixture.ready(2));
        // Reads the servos, whatever page is shown.
        QVERIFY(fixture.find<QWidget>("positionDial") != nullptr);
        QVERIFY(fixture.find<QWidget>("sweepPage") == nullptr);
        fixture.action(ui::Command::PageSweep)->trigger();
        QVERIFY(fixture.isShown("sweepPage"));
        const auto* servos = fixture.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(servos->rowCount(), 6);
        for (int row = 0; row < servos->rowCount(); ++row) {
            const bool isSelected = servos->item(row, 0)->text().startsWith(QLatin1String("2 "));
            QCOMPARE(servos->item(row, 0)->checkState() == Qt::Checked, isSelected);
        }
    }

    void theFirstStartOffersTheSimulatedBusInOneClick()
    {
        gui::MainWindowFixture fixture;
        auto* button = fixture.find<QPushButton>("welcomeSimulation");
        QVERIFY(button != nullptr);
        QVERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Open);
        QVERIFY(fixture.workbench().link().isSimulated());
        QTRY_COMPARE(fixture.workbench().registry().order().size(), std::size_t(6));
        QVERIFY(!button->isVisible());
    }

    void theFirstStartOffersTheSimulatedArmInOneClick()
    {
        gui::MainWindowFixture fixture;
        QTest::mouseClick(fixture.find<QPushButton>("welcomeArm"), Qt::LeftButton);
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Open);
        QTRY_COMPARE(fixture.workbench().registry().order().size(), std::size_t(6));
        QTRY_VERIFY(fixture.isShown("armPage"));
    }
};

SERVODESK_TEST(TestStartup)
#include "tst_startup.moc"
