// SPDX-License-Identifier: GPL-3.0-or-later
// LeRobot's calibration file and the arm's own: what LeRobot writes is read, what is saved is read
// by another program (Python's json), keys of others survive, and broken, foreign and hostile files
// are refused with the place.
#include "jobs/arm/arm.h"
#include "jobs/arm/lerobot_file.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using base::ErrorCode;

namespace {
/// As LeRobot writes it.
const QByteArray lerobotText = R"({
    "shoulder_pan": {
        "id": 1,
        "drive_mode": 0,
        "homing_offset": 530,
        "range_min": 866,
        "range_max": 3231
    },
    "gripper": {
        "id": 6,
        "drive_mode": 1,
        "homing_offset": -1407,
        "range_min": 2031,
        "range_max": 3476,
        "norm_mode": 2
    }
}
)";

class Files {
public:
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    QString write(const QByteArray& text, const char* name = "calibration.json") const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no file");
        return file.fileName();
    }

private:
    QTemporaryDir m_folder;
};

/// The values of a key as Python reads them, one line a joint.
QString readByPython(const QString& path, const char* key)
{
    QProcess python;
    python.start(
        QStringLiteral("python3"),
        {QStringLiteral("-c"),
         QStringLiteral("import json,sys\n"
                        "for name, joint in sorted(json.load(open(sys.argv[1])).items()):\n"
                        "    print(name, joint.get(sys.argv[2]))"),
         path, QLatin1String(key)});
    if (!python.waitForFinished() || python.exitCode() != 0)
        return QString::fromUtf8(python.readAllStandardError());
    return QString::fromUtf8(python.readAllStandardOutput());
}
} // namespace

class TestLerobotFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aFileOfLerobotIsRead()
    {
        const Files files;
        const auto file = jobs::loadLerobotFile(files.write(lerobotText));
        QVERIFY(file);
        QCOMPARE(file->joints.size(), std::size_t(2));
        QCOMPARE(file->joints[0],
                 (jobs::LerobotJoint{QStringLiteral("shoulder_pan"), 1, 0, {530, 866, 3231}}));
        QCOMPARE(file->joints[1],
                 (jobs::LerobotJoint{QStringLiteral("gripper"), 6, 1, {-1407, 2031, 3476}}));
        QVERIFY(file->find(QStringLiteral("elbow_flex")) == nullptr);
    }

    void anotherProgramReadsWhatIsSaved()
    {
        const Files files;
        auto file = jobs::loadLerobotFile(files.write(lerobotText));
        QVERIFY(file);
        file->joints[0].calibration = {-2047, 1, 4094};
        const QString saved = files.path("saved.json");
        QVERIFY(jobs::saveLerobotFile(*file, saved));
        QCOMPARE(readByPython(saved, "homing_offset"),
                 QStringLiteral("gripper -1407\nshoulder_pan -2047\n"));
        QCOMPARE(readByPython(saved, "range_min"),
                 QStringLiteral("gripper 2031\nshoulder_pan 1\n"));
        QCOMPARE(readByPython(saved, "range_max"),
                 QStringLiteral("gripper 3476\nshoulder_pan 4094\n"));
        QCOMPARE(readByPython(saved, "id"), QStringLiteral("gripper 6\nshoulder_pan 1\n"));
        QCOMPARE(readByPython(saved, "drive_mode"), QStringLiteral("gripper 1\nshoulder_pan 0\n"));
        // A key of another program.
        QCOMPARE(readByPython(saved, "norm_mode"),
                 QStringLiteral("gripper 2\nshoulder_pan None\n"));
    }

    /// Into an existing file: other keys and the direction stay, joints of another arm are refused.
    void anExistingFileIsCompletedOnly()
    {
        const Files files;
        const QString path = files.write(lerobotText);
        const std::vector<jobs::LerobotJoint> ours{
            {QStringLiteral("gripper"), 6, 0, {1, 2, 3}},
            {QStringLiteral("shoulder_pan"), 1, 0, {4, 5, 6}}};
        const auto file = jobs::lerobotFileFor(path, ours);
        QVERIFY(file);
        QCOMPARE(file->joints[0].driveMode, 1);
        QCOMPARE(file->joints[0].calibration.homingOffset, 1);
        QVERIFY(jobs::lerobotFileFor(files.path("new.json"), ours));
        const auto other = jobs::lerobotFileFor(path, {ours[0]});
        QVERIFY(!other);
        QVERIFY(other.error().detail.contains(QStringLiteral("shoulder_pan")));
        QVERIFY(!jobs::lerobotFileFor(files.write("{", "broken.json"), ours));
    }

    void otherFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        const auto joint = [](const QByteArray& inside) { return "{\"pan\": {" + inside + "}}"; };
        const QByteArray good = "\"id\": 1, \"drive_mode\": 0, \"homing_offset\": 1, "
                                "\"range_min\": 2, \"range_max\": 3";
        QTest::newRow("empty") << QByteArray() << QString();
        QTest::newRow("cut") << lerobotText.left(120) << QString();
        QTest::newRow("noise") << QByteArray("\xff\xfe\x00\x01", 4) << QString();
        QTest::newRow("a list") << QByteArray("[1, 2]") << QString();
        QTest::newRow("no joint") << QByteArray("{}") << QStringLiteral("no joints");
        QTest::newRow("a number") << QByteArray("{\"pan\": 3}") << QStringLiteral("pan");
        QTest::newRow("a missing key")
            << joint("\"id\": 1, \"drive_mode\": 0, \"homing_offset\": 1, \"range_min\": 2")
            << QStringLiteral("range_max");
        QTest::newRow("a text") << joint(good + ", \"range_max\": \"3\"") << QString();
        QTest::newRow("a fraction")
            << joint("\"id\": 1.5, \"drive_mode\": 0, \"homing_offset\": 1, "
                     "\"range_min\": 2, \"range_max\": 3")
            << QStringLiteral("id");
        QTest::newRow("beyond an int")
            << joint("\"id\": 1, \"drive_mode\": 0, \"homing_offset\": 99999999999, "
                     "\"range_min\": 2, \"range_max\": 3")
            << QStringLiteral("homing_offset");
        QTest::newRow("a joint twice")
            << "{\"pan\": {" + good + "}, \"pan\": {" + good + "}}" << QStringLiteral("pan");
        QTest::newRow("an ID twice")
            << "{\"pan\": {" + good + "}, \"lift\": {" + good + "}}" << QStringLiteral("ID 1");
        QTest::newRow("deep") << QByteArray(100'000, '[') << QString();
    }
    void otherFilesAreRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        const Files files;
        const QString path = files.write(text);
        const auto file = jobs::loadLerobotFile(path);
        QVERIFY(!file);
        QCOMPARE(file.error().code, ErrorCode::FileFormat);
        QVERIFY2(file.error().detail.contains(path), qPrintable(file.error().detail));
        QVERIFY2(file.error().detail.contains(place), qPrintable(file.error().detail));
    }

    void aMissingFileIsSaid()
    {
        const Files files;
        QCOMPARE(jobs::loadLerobotFile(files.path("none.json")).error().code,
                 ErrorCode::FileMissing);
        QCOMPARE(jobs::saveLerobotFile({}, QStringLiteral("/dev/full")).error().code,
                 ErrorCode::DiskFull);
    }

    void lerobotsOwnFilesAreFound()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("robots/so_follower")));
        const QString path = folder.filePath(QStringLiteral("robots/so_follower/arm.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        qputenv("HF_LEROBOT_CALIBRATION", folder.path().toUtf8());
        QCOMPARE(jobs::findLerobotFiles(), QStringList(path));
        qputenv("HF_LEROBOT_CALIBRATION", "/nowhere");
        QVERIFY(jobs::findLerobotFiles().isEmpty());
        qunsetenv("HF_LEROBOT_CALIBRATION");
    }

    void builtInArmsAreComplete()
    {
        for (const QString& name : jobs::builtInArms()) {
            const auto arm = jobs::loadArm(name);
            QVERIFY2(arm, qPrintable(name));
            QVERIFY(arm->joints.size() >= 6);
        }
        const auto lekiwi = jobs::loadArm(QStringLiteral("lekiwi"));
        QCOMPARE(lekiwi->joints.back().id, 9);
        QCOMPARE(lekiwi->joints.back().kind, base::JointKind::Wheel);
    }

    void anArmIsSavedAndLoaded()
    {
        const Files files;
        jobs::Arm arm = *jobs::loadArm(QStringLiteral("so101"));
        arm.name = QStringLiteral("left \"arm\"");
        arm.joints[1].isReversed = true;
        arm.joints[2].id = 33;
        QVERIFY(jobs::saveArm(arm, files.path("arm.json")));
        const auto loaded = jobs::loadArm(files.path("arm.json"));
        QVERIFY(loaded);
        QCOMPARE(*loaded, arm);
    }

    void brokenArmsAreRefused_data()
    {
        QTest::addColumn<QByteArray>("joints");
        QTest::addColumn<QString>("place");
        QTest::newRow("none") << QByteArray("[]") << QStringLiteral("joints");
        QTest::newRow("an ID beyond")
            << QByteArray(R"([{"name": "a", "id": 254, "kind": "wheel"}])")
            << QStringLiteral("joints[0].id");
        QTest::newRow("an unknown kind")
            << QByteArray(R"([{"name": "a", "id": 1, "kind": "knee"}])")
            << QStringLiteral("joints[0].kind");
        QTest::newRow("an ID twice") << QByteArray(R"([{"name": "a", "id": 1, "kind": "wheel"},
                              {"name": "b", "id": 1, "kind": "wheel"}])")
                                     << QStringLiteral("joints[1].id");
        QTest::newRow("a slip in a name")
            << QByteArray(R"([{"name": "a", "id": 1, "kind": "wheel", "revresed": true}])")
            << QStringLiteral("revresed");
    }
    void brokenArmsAreRefused()
    {
        QFETCH(QByteArray, joints);
        QFETCH(QString, place);
        const Files files;
        const auto arm = jobs::loadArm(files.write(
            R"({"format": "servodesk-arm", "version": 1, "name": "x", "joints": )" + joints + '}'));
        QVERIFY(!arm);
        QCOMPARE(arm.error().code, ErrorCode::FileFormat);
        QVERIFY2(arm.error().detail.contains(place), qPrintable(arm.error().detail));
    }
};

SERVODESK_GUILESS_TEST(TestLerobotFile)
#include "tst_lerobot_file.moc"
