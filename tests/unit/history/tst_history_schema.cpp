// SPDX-License-Identifier: GPL-3.0-or-later
// An update never loses the history: the statements of landed versions do not change, and a file of
// each of these versions is brought up to the present one with its rows.
#include "history/history.h"
#include "history/history_file.h"
#include "history/history_schema.h"
#include "support/test_main.h"
#include "unit/results/sweep_example.h"

#include <QCryptographicHash>
#include <QTemporaryDir>
#include <QtTest>

#include <array>

using history::historyMigrations;
using namespace std::chrono_literals;

namespace {
/// Of the statements that lead to version 1, 2 …, in the order of their landing. Add a line with
/// each new version; never change one: there are files that were made by those statements.
constexpr std::array landed{"0eee01e3d8cb9222e88e70f159ecd3998ab2ef058972fa3380244226be4c1131",
                            "6b731107be0790cbb88efb147512db4a430e80ed5f8e3945aa239995e86c3ad9"};

QByteArray hashOf(const QStringList& statements)
{
    return QCryptographicHash::hash(statements.join(QLatin1Char('\n')).toUtf8(),
                                    QCryptographicHash::Sha256)
        .toHex();
}

void run(const history::HistoryFile& file, const QString& sql)
{
    if (const auto done = file.run(sql); !done)
        qFatal("%s: %s", qPrintable(sql), qPrintable(done.error().detail));
}

/// As the program left it when `version` was the newest, with one row where it had a table.
QString makeFile(const QTemporaryDir& folder, int version)
{
    const QString path = folder.filePath(QStringLiteral("history.sqlite"));
    const auto file = history::HistoryFile::open(path, 1s);
    if (!file)
        qFatal("no file");
    run(**file, QStringLiteral("PRAGMA foreign_keys = OFF"));
    const auto tables = (*file)->run(QStringLiteral(
        "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"));
    for (const QVariantList& table : tables->rows)
        run(**file, QStringLiteral("DROP TABLE %1").arg(table.front().toString()));
    for (int step = 0; step < version; ++step) {
        for (const QString& sql : historyMigrations()[std::size_t(step)])
            run(**file, sql);
    }
    run(**file, QStringLiteral("PRAGMA user_version = %1").arg(version));
    if (version > 0)
        run(**file, QStringLiteral(
                        "INSERT INTO runs (uuid, kind, at, program, port, simulated, verdict, "
                        "ended, operator, note, length) VALUES ('a', 'sweep', 5, 'old', 'sim', 1, "
                        "'pass', 'finished', 'Li', 'kept', 7)"));
    return path;
}
} // namespace

class TestHistorySchema : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void landedStatementsDoNotChange()
    {
        QCOMPARE(historyMigrations().size(), landed.size());
        for (std::size_t i = 0; i < landed.size(); ++i)
            QCOMPARE(hashOf(historyMigrations()[i]), QByteArray(landed.at(i)));
    }

    void everyLandedVersionIsBroughtUp()
    {
        for (int version = 0; version <= int(historyMigrations().size()); ++version) {
            const QTemporaryDir folder;
            const auto file = history::HistoryFile::open(makeFile(folder, version), 1s);
            QVERIFY2(file, QByteArray::number(version));
            const auto now = (*file)->run(QStringLiteral("PRAGMA user_version"));
            QCOMPARE(now->rows.front().front().toInt(), int(historyMigrations().size()));
            const auto sound = (*file)->run(QStringLiteral("PRAGMA integrity_check"));
            QCOMPARE(sound->rows.front().front().toString(), QStringLiteral("ok"));
            const auto kept = (*file)->run(QStringLiteral("SELECT note, length FROM runs"));
            QVERIFY(kept);
            QCOMPARE(kept->rows.size(), std::size_t(version > 0 ? 1 : 0));
            if (version > 0)
                QCOMPARE(kept->rows.front().front().toString(), QStringLiteral("kept"));
        }
    }

    /// What was brought up can be used: a run is saved and found beside the old one.
    void aFileThatWasBroughtUpIsUsed()
    {
        const QTemporaryDir folder;
        const QString path = makeFile(folder, 1);
        const auto history = history::History::open(path, 1s);
        QVERIFY(history);
        QVERIFY((*history)->add(sweep_example::finishedRun()));
        const auto runs = (*history)->runs();
        QVERIFY(runs);
        QCOMPARE(runs->size(), std::size_t(2));
    }
};

SERVODESK_GUILESS_TEST(TestHistorySchema)
#include "tst_history_schema.moc"
