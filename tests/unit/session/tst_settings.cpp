// SPDX-License-Identifier: GPL-3.0-or-later
// What is remembered comes back; a file that is broken, hostile or from another version costs
// nothing but what cannot be used.
#include "session/settings.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using session::PortRequest;
using session::Settings;

class TestSettings : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void emptySettingsAreFine();
    void everythingRoundTrips();
    void eachAdapterHasItsOwnSettings_data();
    void eachAdapterHasItsOwnSettings();
    void clearedSettingsAreRemoved();
    void brokenFilesAreBackedUp_data();
    void brokenFilesAreBackedUp();
    void invalidValuesAreIgnored_data();
    void invalidValuesAreIgnored();
    void aNewerVersionsFileSurvives();
    void choicesKeepTheirType_data();
    void choicesKeepTheirType();
    void choicesOfAnotherTypeAreIgnored_data();
    void choicesOfAnotherTypeAreIgnored();
    void anUnwritablePathIsIgnored();
    void onlyTheOwnerMayRead();

private:
    QString path() const { return m_folder->filePath(QStringLiteral("servodesk.ini")); }
    void write(const QByteArray& content) const;
    QByteArray read() const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSettings::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestSettings::write(const QByteArray& content) const
{
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

QByteArray TestSettings::read() const
{
    QFile file(path());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestSettings::emptySettingsAreFine()
{
    const Settings settings(path());
    QVERIFY(settings.brokenCopy().isEmpty());
    QVERIFY(settings.language().isEmpty());
    QCOMPARE(settings.theme(), session::Theme::System);
    QVERIFY(settings.lastPort().isEmpty());
    QVERIFY(!settings.lastRequestFor(QStringLiteral("/dev/ttyUSB0")).baud);
    QVERIFY(settings.windowGeometry().isEmpty());
    QCOMPARE(settings.pageValue(QStringLiteral("memory/rate"), 5).toInt(), 5);
    QVERIFY(!QFile::exists(path())); // looking writes nothing
}

void TestSettings::everythingRoundTrips()
{
    PortRequest used;
    used.name = QStringLiteral("/dev/ttyUSB3");
    used.baud = 128000;
    used.parity = session::Parity::Even;
    used.protocol = base::Protocol::Modbus;
    used.maxReplyLateness = std::chrono::milliseconds(80);
    used.frameSilence = std::chrono::microseconds(2500);
    used.retries = 4;
    const QByteArray geometry("\x00\x01\xFF;=[]\n%", 9);
    {
        Settings settings(path());
        settings.setLanguage(QStringLiteral("zh_CN"));
        settings.setTheme(session::Theme::Dark);
        settings.saveRequest(QStringLiteral("usb:1a86:7523#5A2F31"), used);
        settings.setWindow(geometry, "state");
    }
    QVERIFY(read().contains("version=1"));
    const Settings settings(path());
    QVERIFY(settings.brokenCopy().isEmpty());
    QCOMPARE(settings.language(), QStringLiteral("zh_CN"));
    QCOMPARE(settings.theme(), session::Theme::Dark);
    QCOMPARE(settings.windowGeometry(), geometry);
    QCOMPARE(settings.windowState(), QByteArray("state"));
    QCOMPARE(settings.lastPort(), used.name);
    QCOMPARE(settings.lastAdapter(), QStringLiteral("usb:1a86:7523#5A2F31"));
    const PortRequest again = settings.lastRequestFor(settings.lastAdapter());
    QCOMPARE(again.name, used.name);
    QVERIFY(again.baud == used.baud);
    QVERIFY(again.parity == used.parity);
    QVERIFY(again.protocol == used.protocol);
    QVERIFY(again.maxReplyLateness == used.maxReplyLateness);
    QVERIFY(again.frameSilence == used.frameSilence);
    QVERIFY(again.retries == used.retries);
}

void TestSettings::eachAdapterHasItsOwnSettings_data()
{
    QTest::addColumn<QString>("key");
    // What would be groups, comments, escapes or equal after folding in an ini file.
    for (const char* key :
         {"usb:1a86:7523#A", "usb:1a86:7523#a", "usb:1a86:7523@/dev/ttyUSB0", "/dev/ttyUSB0",
          "/dev//ttyUSB0", "tcp://bench:4000", "sim:sts3215@1,scs15@2", "a]b", "a=b", "a%b", "a;b",
          "\xE8\x88\xB5\xE6\x9C\xBA", " blank ", "General"})
        QTest::newRow(key) << QString::fromUtf8(key);
}

void TestSettings::eachAdapterHasItsOwnSettings()
{
    QFETCH(const QString, key);
    const auto requestAt = [](int baud) {
        PortRequest request;
        request.name = QStringLiteral("port");
        request.baud = baud;
        return request;
    };
    {
        Settings settings(path());
        for (const char* other : {"usb:1a86:7523#B", "/dev/ttyUSB", "tcp://bench:400", "General/"})
            settings.saveRequest(QString::fromLatin1(other), requestAt(9600));
        settings.saveRequest(key, requestAt(57600));
    }
    const Settings settings(path());
    QVERIFY(settings.brokenCopy().isEmpty());
    QCOMPARE(settings.lastRequestFor(key).baud.value_or(0), 57600);
    QCOMPARE(settings.lastRequestFor(QStringLiteral("/dev/ttyUSB")).baud.value_or(0), 9600);
    QVERIFY(!settings.lastRequestFor(QStringLiteral("usb:1a86")).baud);
}

void TestSettings::clearedSettingsAreRemoved()
{
    const QString key = QStringLiteral("usb:1a86:7523#A");
    PortRequest request;
    request.name = QStringLiteral("/dev/ttyUSB0");
    request.baud = 38400;
    request.frameSilence = std::chrono::microseconds(3000);
    {
        Settings settings(path());
        settings.saveRequest(key, request);
        request.baud.reset();
        request.frameSilence.reset();
        settings.saveRequest(key, request);
    }
    const PortRequest again = Settings(path()).lastRequestFor(key);
    QVERIFY(!again.baud);
    QVERIFY(!again.frameSilence);
}

void TestSettings::brokenFilesAreBackedUp_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("no ini") << QByteArray("{\"version\": 1}\nlanguage\n");
    QTest::newRow("cut in a group") << QByteArray("[interface]\nlanguage=zh_CN\n[adapt");
    QTest::newRow("binary") << QByteArray("[interface]\nlanguage=\0\0\0zh", 26);
    QTest::newRow("objects") << QByteArray("[a]\nb=@Variant(\\0\\0\\0\\x7f)\n");
    QTest::newRow("endless") << QByteArray(2 * 1024 * 1024, 'x');
}

void TestSettings::brokenFilesAreBackedUp()
{
    QFETCH(const QByteArray, content);
    write(content);
    {
        Settings settings(path());
        QVERIFY(!settings.brokenCopy().isEmpty());
        QFile copy(settings.brokenCopy());
        QVERIFY(copy.open(QIODevice::ReadOnly));
        QCOMPARE(copy.readAll(), content);
        QVERIFY(settings.language().isEmpty());
        settings.setLanguage(QStringLiteral("en"));
    }
    QVERIFY(!read().contains('x' + QByteArray("xx")));
    const Settings again(path());
    QVERIFY(again.brokenCopy().isEmpty());
    QCOMPARE(again.language(), QStringLiteral("en"));
}

void TestSettings::invalidValuesAreIgnored_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("no number") << QByteArray("baud=fast");
    QTest::newRow("negative") << QByteArray("baud=-1");
    QTest::newRow("nothing") << QByteArray("baud=0");
    QTest::newRow("beyond every wire") << QByteArray("baud=99999999");
    QTest::newRow("overflow") << QByteArray("baud=99999999999999999999");
    QTest::newRow("list") << QByteArray("baud=1, 2, 3");
    QTest::newRow("bytes") << QByteArray("baud=@ByteArray(115200)");
    QTest::newRow("invalid") << QByteArray("baud=@Invalid()");
    QTest::newRow("rectangle") << QByteArray("baud=@Rect(1 2 3 4)");
}

void TestSettings::invalidValuesAreIgnored()
{
    QFETCH(const QByteArray, line);
    write("[General]\nversion=1\n[interface]\nlanguage=klingon\ntheme=pink\n[adapters]\nX\\" +
          line +
          "\nX\\parity=maybe\nX\\protocol=smoke\nX\\retries=-4\nX\\patience_ms=1e9\n"
          "X\\silence_us=0\n[port]\nlast=/dev/ttyUSB0\n");
    const Settings settings(path());
    QVERIFY(settings.brokenCopy().isEmpty());
    QVERIFY(settings.language().isEmpty());
    QCOMPARE(settings.theme(), session::Theme::System);
    const PortRequest request = settings.lastRequestFor(QStringLiteral("X"));
    QVERIFY(!request.baud);
    QVERIFY(request.parity == session::Parity::None);
    QVERIFY(!request.protocol);
    QVERIFY(!request.retries);
    QVERIFY(!request.maxReplyLateness);
    QVERIFY(!request.frameSilence);
    QCOMPARE(settings.lastPort(), QStringLiteral("/dev/ttyUSB0")); // the good part counts
}

void TestSettings::aNewerVersionsFileSurvives()
{
    write("[General]\nversion=7\nhologram=on\n[interface]\nlanguage=en\ntheme=neon\n"
          "[adapters]\nX\\baud=9600\nX\\colour=blue\n[holodeck]\nsize=4\n");
    {
        Settings settings(path());
        QVERIFY(settings.brokenCopy().isEmpty());
        QCOMPARE(settings.language(), QStringLiteral("en"));
        QCOMPARE(settings.theme(), session::Theme::System);
        PortRequest request;
        request.name = QStringLiteral("X");
        request.baud = 19200;
        settings.saveRequest(QStringLiteral("X"), request);
    }
    const QByteArray now = read();
    for (const char* line :
         {"version=7", "hologram=on", "theme=neon", "X\\colour=blue", "size=4", "X\\baud=19200"})
        QVERIFY2(now.contains(line), line);
}

void TestSettings::choicesKeepTheirType_data()
{
    QTest::addColumn<QVariant>("value");
    QTest::addColumn<QVariant>("byDefault");
    QTest::newRow("yes") << QVariant(true) << QVariant(false);
    QTest::newRow("no") << QVariant(false) << QVariant(true);
    QTest::newRow("number") << QVariant(-17) << QVariant(3);
    QTest::newRow("fraction") << QVariant(0.1) << QVariant(1.0);
    QTest::newRow("text") << QVariant(QStringLiteral("a, b; \"c\" = 5")) << QVariant(QString());
    QTest::newRow("numeral") << QVariant(QStringLiteral("17")) << QVariant(QString());
    QTest::newRow("list") << QVariant(QStringList{QStringLiteral("1"), QStringLiteral("2")})
                          << QVariant(QStringList());
    QTest::newRow("list of one") << QVariant(QStringList{QStringLiteral("1")})
                                 << QVariant(QStringList());
    QTest::newRow("empty list") << QVariant(QStringList())
                                << QVariant(QStringList{QStringLiteral("1")});
    QTest::newRow("bytes") << QVariant(QByteArray("\0\1\2", 3)) << QVariant(QByteArray());
}

void TestSettings::choicesKeepTheirType()
{
    QFETCH(const QVariant, value);
    QFETCH(const QVariant, byDefault);
    const QString key = QStringLiteral("page/choice");
    {
        Settings settings(path());
        QCOMPARE(settings.pageValue(key, byDefault), byDefault);
        settings.setPageValue(key, value);
        QCOMPARE(settings.pageValue(key, byDefault), value);
    }
    QCOMPARE(Settings(path()).pageValue(key, byDefault), value);
}

void TestSettings::choicesOfAnotherTypeAreIgnored_data()
{
    QTest::addColumn<QByteArray>("stored");
    QTest::addColumn<QVariant>("byDefault");
    QTest::newRow("text for a number") << QByteArray("fast") << QVariant(5);
    QTest::newRow("fraction for a number") << QByteArray("1.5") << QVariant(5);
    QTest::newRow("number for yes or no") << QByteArray("1") << QVariant(false);
    QTest::newRow("infinite") << QByteArray("inf") << QVariant(1.5);
    QTest::newRow("list for a text") << QByteArray("a, b") << QVariant(QStringLiteral("c"));
    QTest::newRow("text for bytes") << QByteArray("a") << QVariant(QByteArray("b"));
    QTest::newRow("bytes for a list") << QByteArray("@ByteArray(a)") << QVariant(QStringList());
}

void TestSettings::choicesOfAnotherTypeAreIgnored()
{
    QFETCH(const QByteArray, stored);
    QFETCH(const QVariant, byDefault);
    write("[General]\nversion=1\n[page]\nchoice=" + stored + "\n");
    QCOMPARE(Settings(path()).pageValue(QStringLiteral("page/choice"), byDefault), byDefault);
}

void TestSettings::anUnwritablePathIsIgnored()
{
    // A folder where the file should be: neither readable nor writable, for root as well.
    QVERIFY(QDir().mkpath(path()));
    Settings settings(path());
    QVERIFY(settings.brokenCopy().isEmpty());
    QVERIFY(settings.language().isEmpty());
    settings.setLanguage(QStringLiteral("en"));
    QCOMPARE(settings.language(), QStringLiteral("en")); // as long as the program runs
}

/// A new file, one that an earlier version made for all to read, and one that is put aside.
void TestSettings::onlyTheOwnerMayRead()
{
    constexpr QFileDevice::Permissions others = QFileDevice::ReadGroup | QFileDevice::WriteGroup |
                                                QFileDevice::ReadOther | QFileDevice::WriteOther;
    const auto readable = [&](const QString& file) { return QFile::permissions(file) & others; };
    Settings(path()).setLanguage(QStringLiteral("en"));
    QVERIFY(QFile::exists(path()));
    QCOMPARE(readable(path()), QFileDevice::Permissions());
    QVERIFY(QFile::setPermissions(path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner |
                                              QFileDevice::ReadGroup | QFileDevice::ReadOther));
    {
        Settings settings(path());
        QCOMPARE(readable(path()), QFileDevice::Permissions());
        QCOMPARE(settings.language(), QStringLiteral("en"));
        settings.setLanguage(QStringLiteral("zh_CN"));
    }
    QCOMPARE(readable(path()), QFileDevice::Permissions());
    write("no settings at all");
    QVERIFY(QFile::setPermissions(path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner |
                                              QFileDevice::ReadOther));
    const Settings settings(path());
    QVERIFY(!settings.brokenCopy().isEmpty());
    QCOMPARE(readable(settings.brokenCopy()), QFileDevice::Permissions());
}

SERVODESK_GUILESS_TEST(TestSettings)
#include "tst_settings.moc"
