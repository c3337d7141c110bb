// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of servodesk: what it accepts, and its messages for invalid options.
#include "support/test_main.h"
#include "support/test_paths.h"
#include "ui/app/options.h"

#include <QProcess>
#include <QtTest>

using ui::parseOptions;

namespace {
ui::ParsedOptions parse(const char* line)
{
    return parseOptions((QStringLiteral("servodesk ") + QString::fromLatin1(line))
                            .split(QLatin1Char(' '), Qt::SkipEmptyParts));
}
} // namespace

class TestOptions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void allOptionsAreAccepted()
    {
        const auto parsed =
            parse("--port tcp://bench:4000 --baud 115200 --protocol lx --lang zh_CN "
                  "--theme dark --page memory --select 7 --screenshot x.png "
                  "--after 20 --size 1920x1080");
        QCOMPARE(parsed.error, QString());
        const ui::Options& options = parsed.options;
        QCOMPARE(options.port->name, QStringLiteral("tcp://bench:4000"));
        QCOMPARE(options.port->baud, std::optional<int>(115200));
        QCOMPARE(options.port->protocol, std::optional(base::Protocol::Lx));
        QCOMPARE(options.language, QStringLiteral("zh_CN"));
        QCOMPARE(options.theme, std::optional(session::Theme::Dark));
        QCOMPARE(options.page, QStringLiteral("memory"));
        QCOMPARE(options.select, std::optional<int>(7));
        QCOMPARE(options.screenshot, QStringLiteral("x.png"));
        QCOMPARE(options.afterMs, 20);
        QCOMPARE(options.size, QSize(1920, 1080));
    }

    void autoMeansAnyRateAndProtocol()
    {
        const auto parsed = parse("--port sim:demo --baud auto --protocol auto");
        QVERIFY(parsed.error.isEmpty());
        QVERIFY(!parsed.options.port->baud);
        QVERIFY(!parsed.options.port->protocol);
    }

    void invalidOptionsAreReported_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("named");
        QTest::newRow("baud") << "--port x --baud fast"
                              << "fast";
        QTest::newRow("protocol") << "--port x --protocol morse"
                                  << "morse";
        QTest::newRow("theme") << "--theme pink"
                               << "pink";
        QTest::newRow("page") << "--page nowhere"
                              << "nowhere";
        QTest::newRow("size") << "--size huge"
                              << "huge";
        QTest::newRow("ID") << "--select -3"
                            << "-3";
        QTest::newRow("option") << "--colour red"
                                << "colour";
        QTest::newRow("no such file") << "sim:demo"
                                      << "sim:demo";
    }
    void invalidOptionsAreReported()
    {
        QFETCH(QString, line);
        QFETCH(QString, named);
        const auto parsed = parse(line.toLatin1().constData());
        QVERIFY2(parsed.error.contains(named), qPrintable(parsed.error));
    }

    void helpListsEveryOption()
    {
        const QString help = parse("--help").print;
        for (const char* option : {"port", "baud", "protocol", "lang", "theme", "page", "select",
                                   "screenshot", "after", "size", "self-test"})
            QVERIFY2(help.contains(QStringLiteral("--") + QLatin1String(option)), option);
    }

    /// On a simulated bus: search, pages, write, undo, sweep, report. The user's data stay alone.
    void theSelfTestTriesEverything()
    {
        const QTemporaryDir home;
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("SERVODESK_DATA_DIR"));
        for (const char* name : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
            environment.insert(QLatin1String(name), home.path());
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        program.setProcessEnvironment(environment);
        program.start(QStringLiteral(BIN_DIR "/servodesk"), {QStringLiteral("--self-test")});
        QVERIFY(program.waitForFinished(120'000));
        const QString printed = QString::fromUtf8(program.readAllStandardOutput());
        QVERIFY2(program.exitCode() == 0, qPrintable(printed));
        for (const char* step : {"✓ Search the simulated bus", "✓ Open the page History",
                                 "✓ Undo the write", "✓ Run a sweep test", "✓ Save the report"})
            QVERIFY2(printed.contains(QString::fromUtf8(step)), step);
        QVERIFY(!QFileInfo::exists(home.filePath(QStringLiteral("servodesk"))));
        QVERIFY(!QFileInfo::exists(home.filePath(QStringLiteral(".local"))));
    }

    void helpAndVersionNeedNoDisplay_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("printed");
        for (const char* option : {"--help", "-h", "--help-all"})
            QTest::newRow(option) << QString::fromLatin1(option) << "--screenshot";
        for (const char* option : {"--version", "-v"})
            QTest::newRow(option) << QString::fromLatin1(option) << "servodesk 0.";
    }
    void helpAndVersionNeedNoDisplay()
    {
        QFETCH(QString, option);
        QFETCH(QString, printed);
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY"})
            environment.remove(QLatin1String(display));
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
        program.setProcessEnvironment(environment);
        program.start(QStringLiteral(BIN_DIR "/servodesk"), {option});
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.readAllStandardError(), QByteArray());
        QCOMPARE(program.exitCode(), 0);
        QVERIFY(QString::fromUtf8(program.readAllStandardOutput()).contains(printed));
    }
};

SERVODESK_GUILESS_TEST(TestOptions)
#include "tst_options.moc"
