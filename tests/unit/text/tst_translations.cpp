// SPDX-License-Identifier: GPL-3.0-or-later
// The Chinese translation: every text of the sources has one, the program shows it, and the
// language follows the system of the user.
#include "support/test_main.h"
#include "support/test_paths.h"
#include "text/language.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

namespace {
struct Message {
    QString context;
    QString source;
    QString comment;
    QString translation;
    QStringList plurals; ///< "%n servo(s)": one form in Chinese, two in English
    bool finished = true;
    QString name() const { return context + QStringLiteral(" | ") + source; }
    QString identity() const { return name() + QStringLiteral(" | ") + comment; }
};

QList<Message> messagesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    bool isPlural = false;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"message") {
            isPlural = xml.attributes().value(QLatin1String("numerus")) == u"yes";
            messages.append({context, {}, {}, {}, {}, true});
        } else if (xml.name() == u"source") {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == u"comment") {
            messages.last().comment = xml.readElementText();
        } else if (xml.name() == u"translation") {
            messages.last().finished = xml.attributes().value(QLatin1String("type")).isEmpty();
            if (!isPlural)
                messages.last().translation = xml.readElementText();
        } else if (xml.name() == u"numerusform") {
            messages.last().plurals.append(xml.readElementText());
            messages.last().translation = messages.last().plurals.first();
        }
    }
    return messages;
}

/// "%1", "%2", "%L1", "%n".
QStringList placeholdersOf(const QString& text)
{
    static const QRegularExpression gap(QStringLiteral("%L?(?:\\d+|n)"));
    QStringList gaps;
    for (auto it = gap.globalMatch(text); it.hasNext();)
        gaps.append(it.next().captured());
    gaps.sort();
    gaps.removeDuplicates();
    return gaps;
}

QStringList identitiesOf(const QList<Message>& messages)
{
    QStringList identities;
    for (const Message& message : messages)
        identities.append(message.identity());
    identities.sort();
    return identities;
}
} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_messages = messagesOf(m_file);
        QVERIFY(!m_messages.isEmpty());
    }

    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void everySourceTextIsInTheTsFiles_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QStringList>("options");
        QTest::newRow("Chinese") << m_file << QStringList();
        QTest::newRow("plurals of English")
            << m_english << QStringList(QStringLiteral("-pluralonly"));
    }
    void everySourceTextIsInTheTsFiles()
    {
        QFETCH(const QString, path);
        QFETCH(const QStringList, options);
        const QTemporaryDir folder;
        const QString copy = folder.filePath(QFileInfo(path).fileName());
        QVERIFY(QFile::copy(path, copy));
        QProcess lupdate;
        lupdate.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        lupdate.start(QStringLiteral(LUPDATE), QStringLiteral(LUPDATE_ARGUMENTS).split(u'\n') +
                                                   options +
                                                   QStringList{QStringLiteral("-ts"), copy});
        QVERIFY(lupdate.waitForFinished());
        QCOMPARE(lupdate.exitCode(), 0);
        const QStringList now = identitiesOf(messagesOf(copy));
        const QStringList before = identitiesOf(messagesOf(path));
        for (const QString& identity : now)
            QVERIFY2(before.contains(identity), qPrintable(hint + identity));
        for (const QString& identity : before)
            QVERIFY2(now.contains(identity), qPrintable(hint + identity));
    }

    void everyTextIsTranslated()
    {
        for (const Message& message : m_messages) {
            QVERIFY2(message.finished, qPrintable(message.name()));
            QVERIFY2(!message.translation.isEmpty(), qPrintable(message.name()));
            QVERIFY2(placeholdersOf(message.translation) == placeholdersOf(message.source),
                     qPrintable(message.name()));
        }
    }

    void pluralsHaveTheirForms()
    {
        const QList<Message> english = messagesOf(m_english);
        QVERIFY(!english.isEmpty());
        for (const Message& message : english) {
            QVERIFY2(message.finished && message.plurals.size() == 2, qPrintable(message.name()));
            for (const QString& form : message.plurals) {
                QCOMPARE(placeholdersOf(form), placeholdersOf(message.source));
                QVERIFY2(!form.contains(u"(s)"), qPrintable(form));
            }
        }
        (void)text::installTranslator(QStringLiteral("en"));
        QCOMPARE(QCoreApplication::translate("cli", "%n row(s) written to %1", nullptr, 1),
                 QStringLiteral("1 row written to %1"));
        QCOMPARE(QCoreApplication::translate("cli", "%n row(s) written to %1", nullptr, 0),
                 QStringLiteral("0 rows written to %1"));
        (void)text::installTranslator(QStringLiteral("zh_CN"));
        QCOMPARE(QCoreApplication::translate("cli", "%n row(s) written to %1", nullptr, 1),
                 QStringLiteral("已向 %1 写入 1 行"));
    }

    void theTranslationIsUsed()
    {
        const auto shown = [](const Message& message) {
            return QCoreApplication::translate(message.context.toUtf8(), message.source.toUtf8(),
                                               message.comment.toUtf8());
        };
        QCOMPARE(text::installTranslator(QStringLiteral("zh_CN")), QStringLiteral("zh_CN"));
        for (const Message& message : m_messages)
            QCOMPARE(shown(message), message.translation);
        QCOMPARE(text::installTranslator(QStringLiteral("en")), QStringLiteral("en"));
        for (const Message& message : m_messages) {
            if (message.plurals.isEmpty())
                QCOMPARE(shown(message), message.source);
        }
    }

    /// The reports show both languages, whatever the language of the interface.
    void theChineseIsFoundInEveryLanguage()
    {
        for (const char* language : {"en", "zh_CN"}) {
            (void)text::installTranslator(QLatin1String(language));
            for (const Message& message : m_messages) {
                if (message.plurals.isEmpty())
                    QCOMPARE(text::inChinese(message.context.toUtf8(), message.source.toUtf8(),
                                             message.comment.toUtf8()),
                             message.translation);
            }
        }
        QCOMPARE(text::inChinese("SweepText", "no text of this program"), QString());
    }

    void theLanguageIsChosenByItsName_data()
    {
        QTest::addColumn<QString>("asked");
        QTest::addColumn<bool>("chinese");
        QTest::newRow("English") << QStringLiteral("en") << false;
        QTest::newRow("English of a country") << QStringLiteral("en_GB") << false;
        QTest::newRow("Chinese") << QStringLiteral("zh") << true;
        QTest::newRow("simplified Chinese") << QStringLiteral("zh_CN") << true;
        QTest::newRow("with a hyphen") << QStringLiteral("zh-TW") << true;
        QTest::newRow("capitals") << QStringLiteral("ZH_cn") << true;
        QTest::newRow("a locale's name") << QStringLiteral("zh_CN.UTF-8") << true;
        QTest::newRow("not spoken") << QStringLiteral("de") << false;
    }
    void theLanguageIsChosenByItsName()
    {
        QFETCH(const QString, asked);
        QFETCH(const bool, chinese);
        const QString expected = chinese ? QStringLiteral("zh_CN") : QStringLiteral("en");
        QCOMPARE(text::installTranslator(asked), expected);
        QCOMPARE(text::isUiChinese(), chinese);
        const Message& message = m_messages.first();
        QCOMPARE(QCoreApplication::translate(message.context.toUtf8(), message.source.toUtf8(),
                                             message.comment.toUtf8()),
                 chinese ? message.translation : message.source);
    }

    void theSystemLanguageIsUsed_data()
    {
        QTest::addColumn<QStringList>("variables");
        QTest::addColumn<QByteArray>("language");
        const auto row = [](const char* name, const QStringList& variables, const char* language) {
            QTest::newRow(name) << variables << QByteArray(language);
        };
        row("nothing set", {}, "en");
        row("C", {QStringLiteral("LANG=C.UTF-8")}, "en");
        row("English", {QStringLiteral("LANG=en_US.UTF-8")}, "en");
        row("Chinese", {QStringLiteral("LANG=zh_CN.UTF-8")}, "zh_CN");
        row("traditional Chinese", {QStringLiteral("LANG=zh_TW.UTF-8")}, "zh_CN");
        row("another", {QStringLiteral("LANG=de_DE.UTF-8")}, "en");
        row("messages only",
            {QStringLiteral("LANG=en_US.UTF-8"), QStringLiteral("LC_MESSAGES=zh_CN.UTF-8")},
            "zh_CN");
        row("overruled", {QStringLiteral("LANG=zh_CN.UTF-8"), QStringLiteral("LC_ALL=en_US.UTF-8")},
            "en");
        row("second choice",
            {QStringLiteral("LANG=de_DE.UTF-8"), QStringLiteral("LANGUAGE=de:zh_CN:en")}, "zh_CN");
    }
    void theSystemLanguageIsUsed()
    {
        QFETCH(const QStringList, variables);
        QFETCH(const QByteArray, language);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"LANG", "LANGUAGE", "LC_ALL", "LC_MESSAGES"})
            environment.remove(QLatin1String(name));
        environment.insert(QStringLiteral("LC_CTYPE"), QStringLiteral("C.UTF-8"));
        for (const QString& variable : variables)
            environment.insert(variable.section(u'=', 0, 0), variable.section(u'=', 1));
        QProcess program;
        program.setProcessEnvironment(environment);
        program.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("tst_translations"), QStringLiteral("print-language")});
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.readAllStandardOutput(), language);
    }

private:
    const QString m_file = QStringLiteral(SOURCE_DIR "/translations/servodesk_zh_CN.ts");
    const QString m_english = QStringLiteral(SOURCE_DIR "/translations/servodesk_en.ts");
    const QString hint = QStringLiteral("run the target update_translations: ");
    QList<Message> m_messages;
};

static int runTestTranslations(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (argc == 2 && qstrcmp(argv[1], "print-language") == 0) {
        std::fputs(qPrintable(text::installTranslator({})), stdout);
        return 0;
    }
    TestTranslations test;
    return QTest::qExec(&test, argc, argv);
}
SERVODESK_TEST_RUN(runTestTranslations)

#include "tst_translations.moc"
