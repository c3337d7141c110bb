// SPDX-License-Identifier: GPL-3.0-or-later
// Parsing the command line: values, commands and options.
#include "cli/input/arguments.h"
#include "cli/parser.h"
#include "support/test_main.h"
#include "text/language.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace {
QStringList words(const char* line)
{
    return QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}
} // namespace

class TestCliArguments : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        text::installTranslator(QStringLiteral("en"));
    }
    void ids_data();
    void ids();
    void bauds_data();
    void bauds();
    void assignments_data();
    void assignments();
    void nearNames_data();
    void nearNames();
    void optionsMayBeAnywhere_data();
    void optionsMayBeAnywhere();
    void valuesAreAssigned();
    void negativeGoalsAreNoOptions();
    void helpIsPerCommand_data();
    void helpIsPerCommand();
    void languageOptionIsFoundAnywhere();
    void everyCommandIsDescribed();
    void theHelpIsAvailableAsData();
};

void TestCliArguments::ids_data()
{
    QTest::addColumn<QStringList>("typed");
    QTest::addColumn<QList<int>>("expected"); // empty: refused
    const auto row = [](const char* line, const QList<int>& expected) {
        QTest::newRow(line) << words(line) << expected;
    };
    row("1", {1});
    row("0 253", {0, 253});
    row("3-5", {3, 4, 5});
    row("1,7 2", {1, 7, 2});
    row("2 1-3 2", {2, 1, 3});
    row("254", {});
    row("-1", {});
    row("5-3", {});
    row("1-", {});
    row("1,,2", {});
    row("one", {});
    row("1.5", {});
}

void TestCliArguments::ids()
{
    QFETCH(QStringList, typed);
    QFETCH(QList<int>, expected);
    const auto ids = cli::parseIds(typed);
    QCOMPARE(ids.has_value(), !expected.isEmpty());
    if (ids)
        QCOMPARE(QList<int>(ids->begin(), ids->end()), expected);
    else
        QCOMPARE(ids.error().code, base::ErrorCode::BadArgument);
}

void TestCliArguments::bauds_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("count"); // 0: refused
    QTest::newRow("one") << QStringLiteral("1000000") << 1;
    QTest::newRow("several") << QStringLiteral("1000000,115200,76800") << 3;
    QTest::newRow("all") << QStringLiteral("all") << 14;
    QTest::newRow("strange") << QStringLiteral("31") << 0;
    QTest::newRow("trailing comma") << QStringLiteral("115200,") << 0;
    QTest::newRow("negative") << QStringLiteral("-115200") << 0;
    QTest::newRow("empty") << QString() << 0;
}

void TestCliArguments::bauds()
{
    QFETCH(QString, typed);
    QFETCH(int, count);
    const auto bauds = cli::parseBauds(typed);
    QCOMPARE(bauds ? int(bauds->size()) : 0, count);
}

void TestCliArguments::assignments_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("key"); // empty: refused
    QTest::addColumn<QString>("value");
    QTest::newRow("plain") << QStringLiteral("id=3") << QStringLiteral("id") << QStringLiteral("3");
    QTest::newRow("second sign belongs to the value")
        << QStringLiteral("a=b=c") << QStringLiteral("a") << QStringLiteral("b=c");
    QTest::newRow("no sign") << QStringLiteral("id") << QString() << QString();
    QTest::newRow("no key") << QStringLiteral("=3") << QString() << QString();
    QTest::newRow("no value") << QStringLiteral("id=") << QString() << QString();
}

void TestCliArguments::assignments()
{
    QFETCH(QString, typed);
    QFETCH(QString, key);
    QFETCH(QString, value);
    const auto assignment = cli::parseAssignment(typed);
    QCOMPARE(assignment ? assignment->first : QString(), key);
    QCOMPARE(assignment ? assignment->second : QString(), value);
}

void TestCliArguments::nearNames_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("first"); // empty: nothing is near
    QTest::newRow("swapped letters")
        << QStringLiteral("goal_positoin") << QStringLiteral("goal_position");
    QTest::newRow("part of it") << QStringLiteral("temperature")
                                << QStringLiteral("max_temperature");
    QTest::newRow("capitals") << QStringLiteral("LOCK") << QStringLiteral("lock");
    QTest::newRow("far off") << QStringLiteral("xyzzy_plugh") << QString();
}

void TestCliArguments::nearNames()
{
    QFETCH(QString, typed);
    QFETCH(QString, first);
    const QStringList known{QStringLiteral("goal_position"), QStringLiteral("max_temperature"),
                            QStringLiteral("lock"), QStringLiteral("goal_speed")};
    QCOMPARE(cli::nearest(typed, known).value(0), first);
}

void TestCliArguments::optionsMayBeAnywhere_data()
{
    QTest::addColumn<QStringList>("typed");
    for (const char* line :
         {"--port P --baud 115200 --timeout 40 --retries 1 --json scan --ids 1-5",
          "scan --ids 1-5 --port P --baud 115200 --timeout 40 --retries 1 --json",
          "--port=P scan --baud=115200 --ids=1-5 --timeout=40 --retries=1 --json"})
        QTest::newRow(line) << words(line);
}

void TestCliArguments::optionsMayBeAnywhere()
{
    QFETCH(QStringList, typed);
    const auto parsed = cli::parseCommandLine(typed);
    QVERIFY(parsed.has_value());
    QCOMPARE(parsed->command->name, "scan");
    QCOMPARE(parsed->globals.port, QStringLiteral("P"));
    QCOMPARE(parsed->globals.baud, std::optional(115200));
    QCOMPARE(parsed->globals.maxReplyLateness,
             std::optional<base::Duration>(std::chrono::milliseconds(40)));
    QCOMPARE(parsed->globals.retries, std::optional(1));
    QVERIFY(parsed->json);
    QCOMPARE(parsed->values.option("--ids"), std::optional(QStringLiteral("1-5")));
}

void TestCliArguments::valuesAreAssigned()
{
    const auto parsed =
        cli::parseCommandLine(words("write 7 position_p=20 max_voltage=8.5V --temporary"));
    QVERIFY(parsed.has_value());
    QCOMPARE(parsed->values.argument("ID"), QStringLiteral("7"));
    QCOMPARE(parsed->values.arguments("KEY=VALUE"), words("position_p=20 max_voltage=8.5V"));
    QVERIFY(parsed->values.has("--temporary"));
    QVERIFY(!parsed->values.has("--dangerous"));
    const auto nested = cli::parseCommandLine(words("snapshot save 3 f.servo.json"));
    QVERIFY(nested.has_value());
    QCOMPARE(nested->command->name, "snapshot save");
    QCOMPARE(nested->values.argument("FILE"), QStringLiteral("f.servo.json"));
}

void TestCliArguments::negativeGoalsAreNoOptions()
{
    const auto parsed = cli::parseCommandLine(words("move 1=-90deg 2=-5 --speed -20"));
    QVERIFY(parsed.has_value());
    QCOMPARE(parsed->values.arguments("ID=POS"), words("1=-90deg 2=-5"));
    QCOMPARE(parsed->values.option("--speed"), std::optional(QStringLiteral("-20")));
}

void TestCliArguments::helpIsPerCommand_data()
{
    QTest::addColumn<QStringList>("typed");
    QTest::addColumn<QString>("command");
    QTest::newRow("program") << words("--help") << QString();
    QTest::newRow("short") << words("-h") << QString();
    QTest::newRow("command") << words("scan --help") << QStringLiteral("scan");
    QTest::newRow("member of a group")
        << words("snapshot show -h") << QStringLiteral("snapshot show");
    QTest::newRow("although words are missing") << words("write --help") << QStringLiteral("write");
}

void TestCliArguments::helpIsPerCommand()
{
    QFETCH(QStringList, typed);
    QFETCH(QString, command);
    const auto parsed = cli::parseCommandLine(typed);
    QVERIFY(parsed.has_value());
    QCOMPARE(parsed->action, cli::ParsedCommandLine::Action::Help);
    QCOMPARE(parsed->command ? QString::fromLatin1(parsed->command->name) : QString(), command);
}

void TestCliArguments::languageOptionIsFoundAnywhere()
{
    QCOMPARE(cli::requestedLanguage(words("scan --lang zh_CN --json")), QStringLiteral("zh_CN"));
    QCOMPARE(cli::requestedLanguage(words("--lang=en scan")), QStringLiteral("en"));
    QCOMPARE(cli::requestedLanguage(words("scan")), QString());
    QVERIFY(!cli::requestedLanguage(words("scan --lang")).has_value());
    QVERIFY(!cli::requestedLanguage(words("scan --lang=de")).has_value());
}

void TestCliArguments::everyCommandIsDescribed()
{
    const QString all = cli::helpText(nullptr);
    for (const cli::Command& command : cli::commands()) {
        QVERIFY(all.contains(QString::fromLatin1(command.name)));
        QVERIFY(command.run != nullptr);
        const QString own = cli::helpText(&command);
        QCOMPARE(own.count(QStringLiteral("\n  servodesk-cli ")), 2); // examples
        for (const cli::Option& option : command.options)
            QVERIFY2(own.contains(QString::fromLatin1(option.flag)), command.name);
        for (const cli::Positional& positional : command.positionals)
            QVERIFY2(own.contains(QString::fromUtf8(positional.name)), command.name);
    }
}

/// Manual page and completions are made of it, and need every option.
void TestCliArguments::theHelpIsAvailableAsData()
{
    const QJsonObject help = QJsonDocument::fromJson(cli::helpJson(nullptr).text()).object();
    QSet<QString> flags;
    std::size_t count = 0;
    for (const QJsonValue& group : help[QLatin1String("groups")].toArray()) {
        for (const QJsonValue& command : group[QLatin1String("commands")].toArray()) {
            ++count;
            QCOMPARE(command[QLatin1String("examples")].toArray().size(), 2);
            for (const QJsonValue& option : command[QLatin1String("options")].toArray())
                flags << option[QLatin1String("flag")].toString();
        }
    }
    QCOMPARE(count, cli::commands().size());
    for (const cli::Command& command : cli::commands()) {
        for (const cli::Option& option : command.options)
            QVERIFY2(flags.contains(QString::fromLatin1(option.flag)), command.name);
    }
    QCOMPARE(std::size_t(help[QLatin1String("options")].toArray().size()),
             cli::globalOptions().size());
}

SERVODESK_GUILESS_TEST(TestCliArguments)
#include "tst_cli_arguments.moc"
