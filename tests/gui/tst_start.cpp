// SPDX-License-Identifier: GPL-3.0-or-later
// A start with files that somebody has spoilt: hostile model files and broken settings cost
// themselves and one message each, never the start; and the first start offers the simulated bus in
// one click.
#include "gui/window_bench.h"
#include "session/paths.h"
#include "sim/sim_link.h"
#include "text/notice_words.h"
#include "ui/app/message_log.h"

#include <QDir>
#include <QPushButton>
#include <QStackedWidget>

namespace {
void writeFile(const QString& path, const QByteArray& content)
{
    QVERIFY(QDir().mkpath(QFileInfo(path).path()));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}
} // namespace

class TestStart : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        QDir(session::modelFolder()).removeRecursively();
    }
    void cleanup() { QDir(session::modelFolder()).removeRecursively(); }

    void hostileModelFilesAreNamedAndPassedOver()
    {
        const QString folder = session::modelFolder() + QLatin1Char('/');
        writeFile(folder + QStringLiteral("deep.json"), QByteArray(20000, '['));
        writeFile(folder + QStringLiteral("wrong.json"),
                  R"({"format": 1, "models": [{"major": "nine", "name": 5}]})");
        writeFile(folder + QStringLiteral("binary.json"), QByteArray("\0\xff\xfe{}", 5));
        gui::WindowBench bench;
        const QString log = bench.find<ui::MessageLog>("messageLog")->toPlainText();
        for (const char* name : {"deep.json", "wrong.json", "binary.json"})
            QVERIFY2(log.contains(QLatin1String(name)), qPrintable(log));
        QVERIFY(bench.ready(1)); // the built-in models are all there
        QCOMPARE(bench.entry().servo.profile->modelName, QStringLiteral("STS3215"));
    }

    /// The window has no "recover".
    void theWindowNamesItsOwnMenuForOpenChanges()
    {
        const gui::WindowBench bench;
        const QString words = text::describe({base::NoticeCode::LockLeftOpen, 1, {}});
        QVERIFY2(words.contains(QStringLiteral("Use Port → Interrupted writes when")),
                 qPrintable(words));
    }

    void brokenSettingsArePutAsideAndNamed()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("servodesk.ini"));
        writeFile(path, "[general\nversion=\x01\x02\n\xff\xfe");
        session::Settings settings(path);
        session::Session session;
        ui::Bench bench(session);
        ui::ThemeSwitch theme;
        ui::LanguageSwitch language;
        language.apply(QStringLiteral("en"));
        theme.apply(settings.theme());
        ui::MainWindow window(bench, settings, theme, language);
        window.show();
        const QString log = window.findChild<ui::MessageLog*>()->toPlainText();
        QVERIFY(!settings.brokenCopy().isEmpty());
        QVERIFY2(log.contains(settings.brokenCopy()), qPrintable(log));
    }

    /// The one servo that is there is not taken for the one that was asked for.
    void aServoThatIsSelectedAndAbsentIsNamed()
    {
        gui::WindowBench bench;
        bench.window->start(
            {.port = session::PortRequest{.name = QStringLiteral("sim:sts3215@6")}, .select = 1});
        QTRY_VERIFY(bench.desk().lastSearch() && !bench.desk().searching());
        QCOMPARE(bench.desk().servos().size(), std::size_t(1));
        QCOMPARE(bench.selection().current(), 0);
        const auto* log = bench.find<ui::MessageLog>("messageLog");
        QVERIFY2(log->toPlainText().contains(QStringLiteral("No answer: ID 1")),
                 qPrintable(log->toPlainText()));
    }

    void anExchangedServoIsNamed()
    {
        gui::WindowBench bench;
        QVERIFY(bench.connectTo(QStringLiteral("sim:sts3215@1,scs15@2")));
        QVERIFY(bench.choose(1));
        bench.desk().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.unplug(0);
            bus.servo(2)->poke(QStringLiteral("id"), 1);
        });
        const auto* log = bench.find<ui::MessageLog>("messageLog");
        const QString words = QStringLiteral("Another servo answers under ID 1: SCS15");
        QTRY_VERIFY2(log->toPlainText().contains(words), qPrintable(log->toPlainText()));
    }

    void theFirstStartOffersTheSimulatedBusInOneClick()
    {
        gui::WindowBench bench;
        auto* button = bench.find<QPushButton>("welcomeSimulation");
        QVERIFY(button != nullptr);
        QVERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(bench.desk().state(), session::LinkState::Open);
        QVERIFY(bench.desk().simulated());
        QTRY_COMPARE(bench.desk().servos().size(), std::size_t(6));
        QVERIFY(!button->isVisible());
    }
};

QTEST_MAIN(TestStart)
#include "tst_start.moc"
