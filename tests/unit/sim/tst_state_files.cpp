// SPDX-License-Identifier: GPL-3.0-or-later
// A state file carries what each kind of servo keeps over a restart of the simulator; a file of
// other servos, or of another version of the format, is refused and left alone.
#include "sim/servo/eprom_store.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "wire_fixture.h"
#include <sys/stat.h>
#include <unistd.h>

namespace {
bool waitedForDisk = false;
struct PersistenceCase {
    const char* model;
    const char* key; ///< survives
    int value;
    const char* lostKey; ///< does not
};
constexpr PersistenceCase rows[] = {
    {"sts3215", "max_temperature", 61, "goal_position"},
    {"scs15", "max_temperature", 61, "goal_position"},
    {"sm40blhv", "max_temperature", 61, "goal_position"},
    {"hls3606", "protection_current", 321, "goal_position"},
    {"sm60-360m", "position_offset", -77, "goal_position"},
    {"scs15-2", "position_offset", -77, "goal_position"},
    {"smsmb", "position_offset", -77, "goal_position"},
    {"lx16a", "temp_limit", 61, "move_angle"},
};
} // namespace

// Those of the C library are not reached: Qt calls these.
extern "C" int fsync(int)
{
    waitedForDisk = true;
    return 0;
}
extern "C" int fdatasync(int)
{
    waitedForDisk = true;
    return 0;
}

class TestStateFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void storePersistentValues_data()
    {
        QTest::addColumn<int>("row");
        for (int i = 0; i < int(std::size(rows)); ++i)
            QTest::newRow(rows[i].model) << i;
    }
    void storePersistentValues()
    {
        QFETCH(int, row);
        const PersistenceCase& kept = rows[row];
        const QString key = QString::fromLatin1(kept.key);
        const QString lostKey = QString::fromLatin1(kept.lostKey);
        const QByteArray servos = QByteArray(kept.model) + "@1," + kept.model + "@2";
        std::int64_t defaultValue = 0;
        {
            const auto bus = wire::bus(servos);
            auto store = sim::EpromStore::open(file(), *bus);
            QVERIFY(store);
            sim::VirtualServo& servo = *bus->servo(2);
            defaultValue = servo.raw(lostKey);
            if (servo.profile().byRole(catalog::Role::Lock) != nullptr)
                servo.poke(QStringLiteral("lock"), 0);
            servo.poke(key, kept.value);
            servo.poke(lostKey, 345);
            QVERIFY(store->saveChanges());
        }
        const auto bus = wire::bus(servos);
        QVERIFY(sim::EpromStore::open(file(), *bus));
        QCOMPARE(bus->servo(2)->raw(key), kept.value);
        QCOMPARE(bus->servo(2)->raw(lostKey), defaultValue);
        QVERIFY(bus->servo(1)->raw(key) != kept.value);
    }

    // A servo is not silent because the computer's disk is busy.
    void doNotWaitForTheDisk()
    {
        const auto bus = wire::bus("sts3215@1");
        auto store = sim::EpromStore::open(file(), *bus);
        QVERIFY(store);
        QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner);
        const QString alias = m_folder->filePath(QStringLiteral("alias.json"));
        QVERIFY(QFile::link(file(), alias));
        store = sim::EpromStore::open(alias, *bus);
        QVERIFY(store);
        const QByteArray before = content();
        bus->servo(1)->poke(QStringLiteral("lock"), 0);
        bus->servo(1)->poke(QStringLiteral("max_temperature"), 61);
        waitedForDisk = false;
        QVERIFY(store->saveChanges());
        QVERIFY(!waitedForDisk);
        QVERIFY(content() != before);
        QVERIFY(QFileInfo(alias).isSymLink());
        constexpr auto others = QFile::ReadGroup | QFile::ReadOther;
        QVERIFY((QFile::permissions(file()) & others) == 0);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::NoSymLinks).size(), 1);
    }

    void leaveAReadOnlyFileAlone()
    {
        const auto bus = wire::bus("sts3215@1");
        auto store = sim::EpromStore::open(file(), *bus);
        QVERIFY(store);
        const QByteArray before = content();
        QFile::setPermissions(file(), QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther);
        QVERIFY(chmod(qPrintable(m_folder->path()), 0777) == 0);
        bus->servo(1)->poke(QStringLiteral("lock"), 0);
        bus->servo(1)->poke(QStringLiteral("max_temperature"), 61);
        constexpr uid_t nobody = 65534; // root may write everything
        const bool root = geteuid() == 0;
        QVERIFY(!root || setresuid(nobody, nobody, 0) == 0);
        const auto saved = store->saveChanges();
        QVERIFY(!root || setresuid(0, 0, 0) == 0);
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, base::ErrorCode::FileUnwritable);
        QCOMPARE(content(), before);
    }

    void refuseOtherServos_data()
    {
        QTest::addColumn<QByteArray>("servos");
        QTest::newRow("another LX") << QByteArray("lx16a@1,lx224@2");
        QTest::newRow("another language") << QByteArray("lx16a@1,smsmb@2");
        QTest::newRow("fewer") << QByteArray("lx16a@1");
    }
    void refuseOtherServos()
    {
        QFETCH(QByteArray, servos);
        const auto first = wire::bus("lx16a@1,lx16a@2");
        QVERIFY(sim::EpromStore::open(file(), *first));
        const QByteArray before = content();
        const auto other = wire::bus(servos);
        const auto refused = sim::EpromStore::open(file(), *other);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, base::ErrorCode::FileFormat);
        QCOMPARE(content(), before);
    }

    // Version 1 held the first 256 bytes as they lay.
    void refuseAnotherVersion()
    {
        const auto bus = wire::bus("sts3215@1");
        base::Bytes image = bus->servo(1)->epromImage();
        QVERIFY(bus->servo(1)->setEpromImage(image));
        image[3] = 1;
        QVERIFY(!bus->servo(1)->setEpromImage(image));
    }

private:
    QString file() const { return m_folder->filePath(QStringLiteral("state.json")); }
    QByteArray content() const
    {
        QFile state(file());
        return state.open(QIODevice::ReadOnly) ? state.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

SERVODESK_GUILESS_TEST(TestStateFiles)
#include "tst_state_files.moc"
