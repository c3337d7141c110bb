// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshot files: what was saved comes back, the text is stable, files of format 1 load for ever,
// and whatever somebody made of a file is named with its place.
#include "snapshot/snapshot.h"
#include "support/file_size_limit.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "support/text.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <limits>

using base::ErrorCode;
using catalog::Access;
using catalog::Area;
using snapshot::Snapshot;
using support::contentOf;

namespace {
const QString goldenPath = QStringLiteral(TEST_DATA_DIR "/snapshot/format-1.servo.json");

/// What format-1.servo.json says.
Snapshot golden()
{
    Snapshot snapshot;
    snapshot.program = QStringLiteral("ServoDesk 0.1.0");
    snapshot.at = QDateTime({2025, 1, 31}, {12, 34, 56}, Qt::UTC);
    snapshot.label = QStringLiteral("left \"knee\"");
    snapshot.note = QStringLiteral("before the repair\n左膝");
    snapshot.port = QStringLiteral("/dev/ttyUSB0");
    snapshot.baud = 1000000;
    snapshot.servo = {7,
                      QStringLiteral("STS3215"),
                      QStringLiteral("9.3"),
                      QStringLiteral("3.10"),
                      QStringLiteral("sts-sms"),
                      QStringLiteral("feetech")};
    const QString deg = QStringLiteral("deg");
    const QString volt = QStringLiteral("V");
    snapshot.registers = {
        {QStringLiteral("firmware_major"), 0, 3, 3.0, {}, Area::Factory, Access::ReadOnly},
        {QStringLiteral("min_angle"), 9, 1, 360.0 / 4096, deg, Area::Eprom, Access::ReadWrite},
        {QStringLiteral("max_voltage"), 14, 81, 8.1, volt, Area::Eprom, Access::ReadWrite},
        {QStringLiteral("position_offset"), 31, -2047, -2047 * 360.0 / 4096, deg, Area::Eprom,
         Access::ReadWrite},
        {QStringLiteral("goal_position"), 42, {}, {}, deg, Area::Sram, Access::ReadWrite},
        {QStringLiteral("present_voltage"), 62, 120, 12.0, volt, Area::Feedback, Access::ReadOnly},
    };
    return snapshot;
}

QByteArray goldenText()
{
    return contentOf(goldenPath);
}

void overwrite(const QString& path, const QByteArray& content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}
} // namespace

class TestSnapshot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("knee.servo.json"));
    }

    void formatOneLoads() { QCOMPARE(snapshot::loadSnapshot(goldenPath).value(), golden()); }

    void theTextIsStable()
    {
        QCOMPARE(snapshot::encodeSnapshot(golden()), goldenText());
        Snapshot shuffled = golden();
        std::reverse(shuffled.registers.begin(), shuffled.registers.end());
        QCOMPARE(snapshot::encodeSnapshot(shuffled), goldenText());
    }

    void roundingNoiseIsNotSaved()
    {
        Snapshot snapshot = golden();
        snapshot.registers[2].value = std::nextafter(8.1, 9.0);
        QCOMPARE(snapshot::encodeSnapshot(snapshot), goldenText());
    }

    void nanIsSavedAsUnknown()
    {
        Snapshot snapshot = golden();
        snapshot.registers[0].value = std::numeric_limits<double>::quiet_NaN();
        const auto loaded = snapshot::decodeSnapshot(snapshot::encodeSnapshot(snapshot)).value();
        QVERIFY(!loaded.registers[0].value);
        QCOMPARE(loaded.registers[0].raw.value(), 3);
    }

    void saveAndLoadRoundTrip()
    {
        QVERIFY(snapshot::saveSnapshot(golden(), m_path));
        QCOMPARE(contentOf(m_path), goldenText());
        QCOMPARE(snapshot::loadSnapshot(m_path).value(), golden());
    }

    void aSnapshotWithoutRegistersRoundTrips()
    {
        Snapshot snapshot = golden();
        snapshot.registers.clear();
        QCOMPARE(snapshot::decodeSnapshot(snapshot::encodeSnapshot(snapshot)).value(), snapshot);
    }

    void unknownFieldsAreIgnored()
    {
        const QByteArray text =
            goldenText()
                .replace("{\n  \"format\"", "{\n  \"mood\": {\"a\": [1]},\n  \"format\"")
                .replace("{\"key\"", "{\"colour\": null, \"key\"")
                .replace("{\"id\"", "{\"serial\": \"x\", \"id\"");
        QCOMPARE(snapshot::decodeSnapshot(text).value(), golden());
    }

    void otherTimeZonesAndByteOrderMarksAreUnderstood()
    {
        QByteArray text = goldenText().replace("12:34:56Z", "14:34:56+02:00");
        QCOMPARE(snapshot::decodeSnapshot(text).value(), golden());
        QCOMPARE(snapshot::decodeSnapshot("\xef\xbb\xbf" + text).value(), golden());
    }

    void corruptFilesAreRefusedWithThePosition_data()
    {
        QTest::addColumn<QByteArray>("old");
        QTest::addColumn<QByteArray>("changed");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* old, const char* changed,
                            const char* place) {
            QTest::newRow(name) << QByteArray(old) << QByteArray(changed)
                                << QString::fromLatin1(place);
        };
        row("syntax", "\"baud\": 1000000,", "\"baud\": 1000000", "line 10: ");
        row("another format", "servodesk-snapshot", "servodesk-run", "format: not a ServoDesk");
        row("no format", "\"format\"", "\"form\"", "format: ");
        row("newer", "\"version\": 1", "\"version\": 2", "version: format 2 is of a newer");
        row("version zero", "\"version\": 1", "\"version\": 0", "version: ");
        row("version a text", "\"version\": 1", "\"version\": \"1\"", "version: ");
        row("no such day", "2025-01-31", "2025-02-31", "time: ");
        row("baud negative", "1000000", "-1", "baud: ");
        row("baud too large", "1000000", "4294967296", "baud: number too large");
        row("label a number", "\"label\": \"left \\\"knee\\\"\"", "\"label\": 5", "label: ");
        row("servo a list", "\"servo\": {", "\"servo\": [], \"x\": {", "servo: expected an obj");
        row("id missing", "\"id\": 7, ", "", "servo.id: ");
        row("id too large", "\"id\": 7", "\"id\": 256", "servo.id: expected 0 to 255");
        row("map empty", "\"map\": \"sts-sms\"", "\"map\": \"\"", "servo.map: must not be empty");
        row("registers an object", "\"registers\": [", "\"registers\": {}, \"x\": [",
            "registers: expected a list");
        row("register a number", "    {\"key\": \"min_angle\"", "    5, {\"key\": \"min_angle\"",
            "registers[1]: expected an object");
        row("key empty", "\"min_angle\"", "\"\"", "registers[1].key: ");
        row("key twice", "\"min_angle\"", "\"firmware_major\"",
            "registers[1].key: \"firmware_major\" is there twice");
        row("address negative", "\"address\": 9", "\"address\": -9", "registers[1].address: ");
        row("raw a text", "\"raw\": 81", "\"raw\": \"81\"", "registers[2].raw: ");
        row("raw a fraction", "\"raw\": 81", "\"raw\": 81.5", "registers[2].raw: ");
        row("raw beyond exactness", "\"raw\": 81", "\"raw\": 90071992547409930",
            "registers[2].raw: ");
        row("value a text", "8.1", "\"8.1\"", "registers[2].value: ");
        row("unit missing", "\"unit\": \"V\", \"area\": \"EPROM\"", "\"area\": \"EPROM\"",
            "registers[2].unit: ");
        row("area unknown", "\"FEEDBACK\"", "\"ROM\"", "registers[5].area: unknown word \"ROM\"");
        row("access unknown", "\"access\": \"ro\"}\n", "\"access\": \"wo\"}\n",
            "registers[5].access: ");
        row("not UTF-8", "左膝", "\xff\xfe", "line 7: ");
    }
    void corruptFilesAreRefusedWithThePosition()
    {
        QFETCH(const QByteArray, old);
        QFETCH(const QByteArray, changed);
        QFETCH(const QString, place);
        QByteArray text = goldenText();
        const auto at = text.indexOf(old);
        QVERIFY(at >= 0);
        overwrite(m_path, text.replace(at, old.size(), changed));
        const auto loaded = snapshot::loadSnapshot(m_path);
        QVERIFY(!loaded);
        QCOMPARE(int(loaded.error().code), int(ErrorCode::FileFormat));
        QVERIFY2(loaded.error().detail.startsWith(m_path + QStringLiteral(": ") + place),
                 qPrintable(loaded.error().detail));
    }

    void aTruncatedFileIsRefused()
    {
        const QByteArray text = goldenText().trimmed();
        for (qsizetype length = 0; length < text.size(); ++length) {
            const auto loaded = snapshot::decodeSnapshot(text.left(length));
            QVERIFY(!loaded);
            QCOMPARE(int(loaded.error().code), int(ErrorCode::FileFormat));
        }
    }

    void hostileFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("zero bytes") << QByteArray(1000, '\0');
        QTest::newRow("nested beyond sense") << QByteArray(100000, '[');
        QTest::newRow("nothing in it") << QByteArray("{}");
        QTest::newRow("another program's") << QByteArray("{\"name\": \"package\", \"version\": 1}");
        QTest::newRow("huge") << goldenText() + QByteArray(5 * 1024 * 1024, ' ');
    }
    void hostileFilesAreRefused()
    {
        QFETCH(const QByteArray, text);
        overwrite(m_path, text);
        const auto loaded = snapshot::loadSnapshot(m_path);
        QVERIFY(!loaded);
        QCOMPARE(int(loaded.error().code), int(ErrorCode::FileFormat));
        QVERIFY(loaded.error().detail.startsWith(m_path));
    }

    void aMissingFileIsReported()
    {
        const auto loaded = snapshot::loadSnapshot(m_path);
        QVERIFY(!loaded);
        QCOMPARE(int(loaded.error().code), int(ErrorCode::FileMissing));
        QCOMPARE(loaded.error().detail, m_path);
    }

    void aFolderIsNoSnapshot()
    {
        const auto loaded = snapshot::loadSnapshot(m_folder->path());
        QVERIFY(!loaded);
        QCOMPARE(int(loaded.error().code), int(ErrorCode::FileUnreadable));
        const auto saved = snapshot::saveSnapshot(golden(), m_folder->path());
        QVERIFY(!saved);
        QCOMPARE(int(saved.error().code), int(ErrorCode::FileUnwritable));
    }

    void aMissingFolderIsReported()
    {
        const auto saved =
            snapshot::saveSnapshot(golden(), m_folder->filePath(QStringLiteral("no/knee.json")));
        QVERIFY(!saved);
        QCOMPARE(int(saved.error().code), int(ErrorCode::FileUnwritable));
        QVERIFY(saved.error().detail.contains(QStringLiteral("no/knee.json")));
    }

    void anEmptyNameIsRefused()
    {
        QCOMPARE(int(snapshot::saveSnapshot(golden(), {}).error().code),
                 int(ErrorCode::FileUnwritable));
        QCOMPARE(int(snapshot::loadSnapshot({}).error().code), int(ErrorCode::FileMissing));
    }

    void aFailedSaveKeepsTheOldFile()
    {
        overwrite(m_path, "the old one");
        {
            const FileSizeLimit limit(goldenText().size() / 2);
            QVERIFY(!snapshot::saveSnapshot(golden(), m_path));
        }
        QCOMPARE(contentOf(m_path), QByteArray("the old one"));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
    }

    void aFullDiskIsReported()
    {
        const QString full = QStringLiteral("/dev/full");
        const auto saved = snapshot::saveSnapshot(golden(), full);
        QVERIFY(!saved);
        QCOMPARE(int(saved.error().code), int(ErrorCode::DiskFull));
        QVERIFY(saved.error().detail.contains(full));
        QVERIFY(!QFileInfo(full).isFile());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

SERVODESK_GUILESS_TEST(TestSnapshot)
#include "tst_snapshot.moc"
