// SPDX-License-Identifier: GPL-3.0-or-later
// Holds names and texts to the terms of the field: words that were replaced do not come back into
// the sources, the translations or the documents.
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QtTest>

namespace {
QString contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesBelow(const QStringList& folders, const QStringList& patterns)
{
    QStringList files;
    for (const QString& folder : folders) {
        QDirIterator it(QStringLiteral(SOURCE_DIR "/") + folder, patterns, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext())
            files.append(it.next());
    }
    return files;
}

/// "file:line: text" of each line that the expression matches.
QStringList matches(const QStringList& files, const QRegularExpression& banned)
{
    QStringList found;
    for (const QString& path : files) {
        if (path.endsWith(QLatin1String("/tst_language.cpp")))
            continue;
        const QStringList lines = contentOf(path).split(QLatin1Char('\n'));
        for (int i = 0; i < lines.size(); ++i) {
            if (lines[i].contains(banned)) {
                found.append(QStringLiteral("%1:%2: %3")
                                 .arg(QDir(QStringLiteral(SOURCE_DIR)).relativeFilePath(path),
                                      QString::number(i + 1), lines[i].trimmed().left(100)));
            }
        }
    }
    return found;
}
} // namespace

class TestLanguage : public QObject {
    Q_OBJECT
private slots:
    void filesAreFound();
    void replacedNames_data();
    void replacedNames();
    void americanSpelling();
    void textsArePlain();
    void chineseIsUniform();
    void listsHaveTheCommaOfTheirLanguage();
};

void TestLanguage::filesAreFound()
{
    QVERIFY(filesBelow({QStringLiteral("src")}, {QStringLiteral("*.cpp")}).size() > 100);
    QVERIFY(filesBelow({QStringLiteral("resources")}, {QStringLiteral("*.json")}).size() > 5);
    QVERIFY(QStringLiteral("void moveWished();")
                .contains(QRegularExpression(QStringLiteral("[a-z](Wished|Wanted)\\b"))));
}

void TestLanguage::replacedNames_data()
{
    QTest::addColumn<QString>("pattern");
    // Word boundaries of CamelCase: a capital after it, or the end.
    QTest::newRow("signals end in Requested") << QStringLiteral("[a-z](Wished|Wanted)\\b");
    QTest::newRow("limits are min and max")
        << QStringLiteral("\\b(most|least)(Cycles|Period|Ms|Legs|Rows|Servos|Bytes|Pause)\\b");
    QTest::newRow("defaults") << QStringLiteral("\\busual[A-Z]|\\busualPause\\b");
    for (const char* word :
         {"Deed",        "Feeder",       "FeedWish",       "MoveWish",  "HistoryKeeper",
          "Inbox",       "LoosePost",    "LooseThread",    "SweepLook", "SnapshotShelf",
          "ShelfChoice", "SimBag",       "SimulatedHand",  "ServoEar",  "FaultDice",
          "BentGoal",    "Surroundings", "ServoRecipe",    "LateGuard", "Kinship",
          "Tongue",      "Scribe",       "CommissionLook", "Stillness", "FlagMeter",
          "Sieve",       "DesktopLook",  "RoomyColumn",    "Manner"}) {
        QTest::newRow(word)
            << QStringLiteral("\\b%1(?![a-z])|[a-z]%1(?![a-z])").arg(QLatin1String(word));
    }
    QTest::newRow("file names") << QStringLiteral(
        "\\b[a-z_]+_(deeds|look|settle|deal|manner)\\.(h|cpp)\\b");
}

void TestLanguage::replacedNames()
{
    QFETCH(QString, pattern);
    QStringList files = filesBelow(
        {QStringLiteral("src"), QStringLiteral("ui"), QStringLiteral("tests")},
        {QStringLiteral("*.cpp"), QStringLiteral("*.h"), QStringLiteral("CMakeLists.txt")});
    files << QStringLiteral(SOURCE_DIR "/CONTRIBUTING.md")
          << QStringLiteral(SOURCE_DIR "/README.md");
    const QStringList found = matches(files, QRegularExpression(pattern));
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

/// In comments and documents. Keys of files ("centred") keep the spelling they were released with.
void TestLanguage::americanSpelling()
{
    const QString british = QStringLiteral(
        "(centre|centring|colour|behaviour|neighbour|favour|honour|recognis|synchronis|initialis|"
        "normalis|organis|serialis|labelled|labelling|cancelled|cancelling|travelled|licence|"
        "catalogue)");
    const QStringList sources =
        filesBelow({QStringLiteral("src"), QStringLiteral("ui"), QStringLiteral("tests")},
                   {QStringLiteral("*.cpp"), QStringLiteral("*.h")});
    QStringList documents = filesBelow({QStringLiteral("resources")}, {QStringLiteral("*.md")});
    for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
        documents << QStringLiteral(SOURCE_DIR "/") + QLatin1String(name);
    const auto insensitive = QRegularExpression::CaseInsensitiveOption;
    const QStringList found =
        matches(sources, QRegularExpression(QStringLiteral("//.*") + british, insensitive)) +
        matches(documents, QRegularExpression(british, insensitive));
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

/// What a user reads: phrases that took a second reading, and second words for one thing.
void TestLanguage::textsArePlain()
{
    const QRegularExpression banned(
        QStringLiteral("<(source|numerusform)>[^<]*\\b(nobody|somebody|everybody|anybody|usual|of "
                       "late|gone on "
                       "with|so many|so much|come to it|is none|paces|put back|left alone|left "
                       "out|proven|on the wire|switch(ed|es)? (on|off)|take torque "
                       "off|takes torque off|said nothing|what became of|answer(s|ed|ing)?|legs?|"
                       "IDs to come|confirmed as locked|a protection is)\\b"),
        QRegularExpression::CaseInsensitiveOption);
    QVERIFY(QStringLiteral("<source>The servo answers as ID 1").contains(banned));
    const QString texts = QStringLiteral(SOURCE_DIR "/translations/servodesk_zh_CN.ts");
    QVERIFY(contentOf(texts).count(QStringLiteral("<source>")) > 2000);
    const QStringList found = matches({texts}, banned);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

/// One Chinese term for one thing, full-width punctuation, and no space before a percent sign.
void TestLanguage::chineseIsUniform()
{
    const QString words = QStringLiteral("单击|此电脑|此计算机|延迟定时器|数据手册|回车键");
    const QRegularExpression banned(
        QStringLiteral("<(translation|numerusform)>[^<]*(仿真|往返测试|回程差|释放扭矩|关闭扭矩|"
                       "校中|恢复默认值|撤回|退回|"
                       "清除报警|紧急停止|工作模式|搁置|插入下一个|[^行]程数|编码器故障|台舵机|%1|"
                       "\\p{Han}[;!?]|[!?]\\p{Han}|\\d %[^\\dL]|“ |” \\p{Han})")
            .arg(words));
    QVERIFY(QStringLiteral("<translation>打开仿真总线").contains(banned));
    const QString texts = QStringLiteral(SOURCE_DIR "/translations/servodesk_zh_CN.ts");
    const QString help = QStringLiteral(SOURCE_DIR "/resources/help/help_zh.md");
    const QStringList found = matches({texts}, banned) + matches({help}, QRegularExpression(words));
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

/// text::joinItems, report::listComma. Models of limits are typed with commas.
void TestLanguage::listsHaveTheCommaOfTheirLanguage()
{
    const QRegularExpression banned(
        QStringLiteral("(?<!limits\\.models)\\.join\\((QStringLiteral\\()?u?\", \"\\)"));
    QVERIFY(QStringLiteral("names.join(QStringLiteral(\", \"))").contains(banned));
    const QStringList sources =
        filesBelow({QStringLiteral("ui"), QStringLiteral("src/cli"), QStringLiteral("src/text"),
                    QStringLiteral("src/report")},
                   {QStringLiteral("*.cpp"), QStringLiteral("*.h")});
    const QStringList found = matches(sources, banned);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

SERVODESK_GUILESS_TEST(TestLanguage)
#include "tst_language.moc"
