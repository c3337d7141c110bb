// SPDX-License-Identifier: GPL-3.0-or-later
// What a shell offers while a command line is typed: commands, members of a group, options and the
// values that are known; the value of an option is never taken for a command.
#include "cli/completion.h"
#include "support/test_main.h"

#include <QtTest>

namespace {
QStringList wordsFor(const char* line)
{
    QStringList words;
    for (const cli::Completion& one : cli::completionsOf(QString::fromUtf8(line)))
        words << one.word;
    return words;
}
} // namespace

class TestCompletion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void wordsAreOffered_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QStringList>("offered");
        const auto row = [](const char* line, const QStringList& offered) {
            QTest::newRow(line) << QByteArray(line) << offered;
        };
        row("servodesk-cli sca", {"scan"});
        row("servodesk-cli arm t", {"test"});
        row("servodesk-cli help snap", {"snapshot"});
        row("servodesk-cli --port sim:demo sca", {"scan"});
        row("servodesk-cli --port sim:de", {"sim:demo"});
        row("servodesk-cli scan --port sim:de", {"sim:demo"});
        row("servodesk-cli --protocol fee", {"feetech"});
        row("servodesk-cli --lang zh", {"zh_CN"});
        row("servodesk-cli --baud ", {"auto"});
        row("servodesk-cli move 1=90deg --how ", {"write", "sync", "async"});
        row("servodesk-cli arm test --joi", {"--joint"});
        row("servodesk-cli arm test --joint scan --tor", {"--torque"});
        row("servodesk-cli scan --ti", {"--timeout"});
        row("servodesk-cli history sh", {"show"});
        // Only files or numbers fit.
        row("servodesk-cli scan ", {});
        row("servodesk-cli snapshot save 1 ", {});
        row("servodesk-cli arm test --torque ", {});
    }
    void wordsAreOffered()
    {
        QFETCH(QByteArray, line);
        QFETCH(QStringList, offered);
        QCOMPARE(wordsFor(line.constData()), offered);
    }

    void everyCommandIsOfferedOnce()
    {
        QStringList words = wordsFor("servodesk-cli ");
        QVERIFY(words.contains(QStringLiteral("history")));
        QVERIFY(words.contains(QStringLiteral("help")));
        QCOMPARE(words.removeDuplicates(), 0);
        const auto members = wordsFor("servodesk-cli arm ");
        QVERIFY(members.contains(QStringLiteral("calibrate")));
        QVERIFY(!members.contains(QString()));
    }

    /// A line each, the explanation behind a tab.
    void theTextHasTheHelp()
    {
        const QString text =
            cli::completionText(cli::completionsOf(QStringLiteral("servodesk-cli sca")));
        QCOMPARE(text, QStringLiteral("scan\tsearch the bus without writing anything\n"));
    }
};

SERVODESK_GUILESS_TEST(TestCompletion)
#include "tst_completion.moc"
