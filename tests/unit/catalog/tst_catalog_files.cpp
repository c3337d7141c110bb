// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the user's own: what they add and replace, and what bad rows and hostile files cost.
#include "catalog/catalog.h"
#include "catalog/value.h"
#include "support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace catalog;

namespace {
constexpr auto AnyName = R"({"en": "Name", "zh": "名称"})";

/// A small, sound map "bench" with the registers given, and a series that leads to it.
QByteArray testMapFile(const QByteArray& registers)
{
    return R"({"maps": [{"key": "bench", "registers": [
        {"key": "firmware_major", "address": 0, "size": 1, "area": "EPROM", "access": "ro",
         "encoding": "unsigned", "name": {"en": "Firmware", "zh": "固件"}})" +
           (registers.isEmpty() ? QByteArray() : ",\n" + registers) + R"(]}],
        "series": [{"key": "BENCH", "map": "bench", "firmware": ["50.0", "50.255"],
                    "byte_order": "little"}]})";
}

QByteArray registerRow(const QByteArray& members)
{
    return R"({"key": "extra", "address": 10, "size": 2, "area": "EPROM", "access": "ro",
        "encoding": "unsigned", "name": )" +
           QByteArray(AnyName) + (members.isEmpty() ? QByteArray() : ", " + members) + "}";
}

const Identity TestIdentity{50, 1, 0, 200, 1};
} // namespace

class TestCatalogFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void validFile();
    void badRowSkipsOnlyThatRow_data();
    void badRowSkipsOnlyThatRow();
    void conflictsBetweenRows_data();
    void conflictsBetweenRows();
    void overlapOnlyUnderACondition();
    void hostileFile_data();
    void hostileFile();
    void nonFiles();
    void manyBadRowsAreSummedUp();
    void aModelOfAnUnknownSeriesIsSaid();
    void missingFolderIsEmpty();
    void addsAModel();
    void replacesModelMapAndSeries();
    void laterFilesWin();
    void aModelTwiceInOneFileIsReported();
    void badModelsAndSeries_data();
    void badModelsAndSeries();
    void seriesWithoutItsMap();

private:
    void write(const QString& name, const QByteArray& content) const;
    Catalog::LoadResult load() const { return Catalog::load({m_dir->path()}); }
    std::unique_ptr<QTemporaryDir> m_dir;
};

void TestCatalogFiles::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    m_dir = std::make_unique<QTemporaryDir>();
    QVERIFY(m_dir->isValid());
}

void TestCatalogFiles::write(const QString& name, const QByteArray& content) const
{
    QFile file(m_dir->filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

void TestCatalogFiles::validFile()
{
    write(QStringLiteral("bench.json"),
          testMapFile(registerRow(R"("min": 5, "unit": "V", "scale": 0.1)")));
    const auto loaded = load();
    QVERIFY(loaded.warnings.empty());
    const ProfilePtr profile = loaded.catalog.resolve(TestIdentity);
    QCOMPARE(profile->mapKey, QStringLiteral("bench"));
    QCOMPARE(profile->modelName, QStringLiteral("BENCH (200.1)"));
    const Register* extra = profile->find(QStringLiteral("extra"));
    QVERIFY(extra);
    QCOMPARE(*extra->min, 5);
    QCOMPARE(formatValue(85, *extra, valueFormat(*extra, *profile, noLookup), false),
             QStringLiteral("8.5 V"));
}

void TestCatalogFiles::badRowSkipsOnlyThatRow_data()
{
    QTest::addColumn<QByteArray>("row");
    QTest::addColumn<QString>("about");
    const auto row = [](const char* title, QByteArray content, const char* about) {
        QTest::newRow(title) << content << QString::fromLatin1(about);
    };
    const auto changed = [](const char* from, const char* to) {
        return registerRow({}).replace(from, to);
    };
    row("not an object", "42", "object");
    row("null", "null", "object");
    row("list", "[]", "object");
    row("no key", changed(R"("key": "extra", )", ""), "key");
    row("empty key", changed("extra", ""), "key");
    row("key is a number", changed(R"("extra")", "7"), "key");
    row("no address", changed(R"("address": 10, )", ""), "address");
    row("address is a text", changed("10", R"("10")"), "address");
    row("address is a fraction", changed("10", "10.5"), "address");
    row("negative address", changed("10", "-1"), "address");
    row("address beyond the table", changed("10", "256"), "address");
    row("reaches beyond the table", changed("10", "255"), "beyond");
    row("no size", changed(R"("size": 2, )", ""), "size");
    row("size 0", changed(R"("size": 2)", R"("size": 0)"), "size");
    row("size 3", changed(R"("size": 2)", R"("size": 3)"), "size");
    row("size 8", changed(R"("size": 2)", R"("size": 8)"), "size");
    row("absurd size", changed(R"("size": 2)", R"("size": 1e300)"), "size");
    row("unknown area", changed("EPROM", "ROM"), "area");
    row("unknown access", changed(R"("ro")", R"("wo")"), "access");
    row("unknown encoding", changed("unsigned", "gray-code"), "encoding");
    row("sign bit of nothing", changed("unsigned", "sign-bit-"), "encoding");
    row("sign bit outside", changed("unsigned", "sign-bit-16"), "sign bit");
    row("no name", changed(R"("name")", R"("comment")"), "name");
    row("name in one language", changed(R"(, "zh": "名称")", ""), "zh");
    row("min above max", registerRow(R"("min": 5, "max": 4)"), "min");
    row("max does not fit", registerRow(R"("max": 65536)"), "fit");
    row("negative min", registerRow(R"("min": -1)"), "fit");
    row("default does not fit", registerRow(R"("default": 70000)"), "default");
    row("default is a text", registerRow(R"("default": "1")"), "default");
    row("scale 0", registerRow(R"("scale": 0)"), "scale");
    row("scale NaN", registerRow(R"("scale": "NaN")"), "scale");
    row("absurd scale", registerRow(R"("scale": 1e200)"), "scale");
    row("unknown role", registerRow(R"("role": "coffee")"), "coffee");
    row("flag is a number", registerRow(R"("dangerous": 1)"), "dangerous");
    row("misspelled member", registerRow(R"("maximum": 5)"), "maximum");
    row("values not a list", registerRow(R"("values": {})"), "values");
    row("value without a key",
        registerRow(R"("values": [{"value": 1, "name": {"en": "a", "zh": "b"}}])"), "values");
    row("value does not fit",
        registerRow(R"("values": [{"value": 65536, "key": "x", "name": {"en": "a", "zh": "b"}}])"),
        "values");
    row("value twice",
        registerRow(R"("values": [{"value": 1, "key": "x", "name": {"en": "a", "zh": "b"}},
                                  {"value": 1, "key": "y", "name": {"en": "c", "zh": "d"}}])"),
        "twice");
    row("key that is another raw value",
        registerRow(R"("values": [{"value": 1, "key": "2", "name": {"en": "a", "zh": "b"}}])"),
        "another");
    row("scale_by names nothing", registerRow(R"("scale_by": "nothing")"), "scale_by");
    row("variant without condition", registerRow(R"("variants": [{"scale": 2}])"), "variants");
    row("variant by nothing", registerRow(R"("variants": [{"when": "nothing", "equals": 1}])"),
        "when");
    row("variant with a bad scale",
        registerRow(R"("variants": [{"when": "firmware_major", "equals": 1, "scale": 0}])"),
        "scale");
    row("condition with a fraction", registerRow(R"("only": [{"firmware_from": 2.5}])"),
        "firmware_from");
    row("condition with a bad version", registerRow(R"("only": [{"firmware_from": "2.999"}])"),
        "version");
    row("rule that moves the register", registerRow(R"("set": [{"when": {}, "address": 0}])"),
        "address");
    row("rule with a bad size", registerRow(R"("set": [{"when": {}, "size": 5}])"), "size");
    row("rule that is no object", registerRow(R"("set": [7])"), "object");
    row("help too long", registerRow("\"source\": \"" + QByteArray(100000, 'x') + "\""), "length");
    row("writable without help", changed(R"("ro")", R"("rw")"), "help");
}

void TestCatalogFiles::badRowSkipsOnlyThatRow()
{
    QFETCH(QByteArray, row);
    QFETCH(QString, about);
    write(QStringLiteral("bench.json"),
          testMapFile(row + R"(, {"key": "last", "address": 20, "size": 1, "area": "SRAM",
              "access": "ro", "encoding": "unsigned", "name": )" +
                      AnyName + "}"));
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    const LoadWarning& warning = loaded.warnings.front();
    QVERIFY(warning.file.endsWith(QStringLiteral("bench.json")));
    QVERIFY2(warning.where.startsWith(QStringLiteral("registers")), qPrintable(warning.where));
    QVERIFY2(warning.detail.contains(about), qPrintable(warning.detail));
    QVERIFY(warning.detail.size() < 200);
    const ProfilePtr profile = loaded.catalog.resolve(TestIdentity);
    QCOMPARE(profile->registers.size(), std::size_t(2));
    QVERIFY(profile->find(QStringLiteral("last")));
}

void TestCatalogFiles::conflictsBetweenRows_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("about");
    QTest::newRow("same key") << 40 << QStringLiteral("extra") << QStringLiteral("twice");
    QTest::newRow("first byte") << 10 << QStringLiteral("other") << QStringLiteral("address 10");
    QTest::newRow("second byte") << 11 << QStringLiteral("other") << QStringLiteral("\"extra\"");
    QTest::newRow("runs into it") << 9 << QStringLiteral("other") << QStringLiteral("address 10");
}

void TestCatalogFiles::conflictsBetweenRows()
{
    QFETCH(int, address);
    QFETCH(QString, key);
    QFETCH(QString, about);
    QByteArray second = registerRow({});
    second.replace("10", QByteArray::number(address)).replace("extra", key.toUtf8());
    write(QStringLiteral("bench.json"), testMapFile(registerRow({}) + "," + second));
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY2(loaded.warnings.front().detail.contains(about),
             qPrintable(loaded.warnings.front().detail));
    const ProfilePtr profile = loaded.catalog.resolve(TestIdentity);
    QCOMPARE(profile->registers.size(), std::size_t(2));
    QCOMPARE(profile->find(QStringLiteral("extra"))->address, 10);
}

void TestCatalogFiles::overlapOnlyUnderACondition()
{
    // From firmware 50.5 on "extra" grows into the neighbor: only that neighbor is lost.
    QByteArray neighbor = registerRow({});
    neighbor.replace("10", "12").replace("extra", "neighbour");
    const QByteArray grows =
        registerRow(R"("set": [{"when": {"firmware_from": "50.5"}, "size": 4}])");
    write(QStringLiteral("bench.json"), testMapFile(grows + "," + neighbor));
    const auto overlapping = load();
    QCOMPARE(overlapping.warnings.size(), std::size_t(1));
    QVERIFY(overlapping.warnings.front().where.contains(QStringLiteral("neighbour")));

    // A neighbor that ends where the growth begins is sound.
    neighbor.chop(1);
    neighbor += R"(, "only": [{"firmware_to": "50.4"}]})";
    write(QStringLiteral("bench.json"), testMapFile(grows + "," + neighbor));
    const auto sound = load();
    QVERIFY(sound.warnings.empty());
    const auto keysAt = [&](int minor) {
        return sound.catalog.resolve({50, minor, 0, 200, 1})->registers.size();
    };
    QCOMPARE(keysAt(4), std::size_t(3));
    QCOMPARE(keysAt(5), std::size_t(2));
}

void TestCatalogFiles::hostileFile_data()
{
    QTest::addColumn<QByteArray>("content");
    const QByteArray deep = QByteArray(200000, '[');
    QByteArray rows;
    for (int i = 0; i < 5000; ++i)
        rows += "1,";
    rows += "1";
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("not JSON") << QByteArray("servo = fast\n");
    QTest::newRow("cut off") << testMapFile({}).chopped(7);
    QTest::newRow("binary") << QByteArray("\x00\xFF\xFE\x01\x02", 5);
    QTest::newRow("list outside") << QByteArray("[1, 2]");
    QTest::newRow("number outside") << QByteArray("7");
    QTest::newRow("nested without end") << deep;
    QTest::newRow("nested deeply") << deep + QByteArray(200000, ']');
    QTest::newRow("huge") << "{\"comment\": \"" + QByteArray(5 * 1024 * 1024, 'x') + "\"}";
    QTest::newRow("maps is a text") << QByteArray(R"({"maps": "all"})");
    QTest::newRow("too many models") << "{\"models\": [" + rows + "]}";
    QTest::newRow("too many registers")
        << R"({"maps": [{"key": "m", "registers": [)" + rows + "]}]}";
    QTest::newRow("map without registers")
        << QByteArray(R"({"maps": [{"key": "m", "registers": []}]})");
    QTest::newRow("misspelled list") << QByteArray(R"({"model": []})");
    QTest::newRow("map without key") << QByteArray(R"({"maps": [{"registers": []}]})");
}

void TestCatalogFiles::hostileFile()
{
    QFETCH(QByteArray, content);
    write(QStringLiteral("bad.json"), content);
    write(QStringLiteral("good.json"), testMapFile({}));
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY(loaded.warnings.front().file.endsWith(QStringLiteral("bad.json")));
    QVERIFY(!loaded.warnings.front().detail.isEmpty());
    QVERIFY(loaded.warnings.front().detail.size() < 200);
    QVERIFY(loaded.catalog.mapKeys().contains(QStringLiteral("bench")));
    QCOMPARE(loaded.catalog.resolve({3, 10, 0, 9, 3})->modelName, QStringLiteral("STS3215"));
}

void TestCatalogFiles::nonFiles()
{
    QVERIFY(QDir(m_dir->path()).mkdir(QStringLiteral("folder.json")));
    QVERIFY(QFile::link(m_dir->filePath(QStringLiteral("gone")),
                        m_dir->filePath(QStringLiteral("link.json"))));
    write(QStringLiteral("notes.txt"), "not looked at");
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(2));
    QVERIFY(loaded.warnings[0].file.endsWith(QStringLiteral("folder.json")));
    QVERIFY(loaded.warnings[1].file.endsWith(QStringLiteral("link.json")));
}

void TestCatalogFiles::manyBadRowsAreSummedUp()
{
    QByteArray rows;
    for (int i = 0; i < 400; ++i)
        rows += "{},";
    write(QStringLiteral("bad.json"), testMapFile(rows + "{}"));
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(50));
    QVERIFY(loaded.warnings.back().detail.contains(QStringLiteral("more")));
    QVERIFY(loaded.catalog.mapKeys().contains(QStringLiteral("bench")));
}

/// Its line of servos would be unknown, and with it what the line can do.
void TestCatalogFiles::aModelOfAnUnknownSeriesIsSaid()
{
    const auto file = [](const QByteArray& series) {
        return R"({"models": [{"id": "200.200", "name": "BENCH1", "byte_order": "little", "series": ")" +
               series + R"("}]})";
    };
    write(QStringLiteral("model.json"), file("STS"));
    QCOMPARE(load().warnings.size(), std::size_t(0));
    write(QStringLiteral("model.json"), file("STs"));
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QCOMPARE(loaded.warnings[0].where, QStringLiteral("model BENCH1"));
    QVERIFY(loaded.warnings[0].file.endsWith(QStringLiteral("model.json")));
    QVERIFY(loaded.warnings[0].detail.contains(QStringLiteral("\"STs\"")));
}

void TestCatalogFiles::missingFolderIsEmpty()
{
    const auto loaded = Catalog::load({m_dir->filePath(QStringLiteral("nowhere"))});
    QVERIFY(loaded.warnings.empty());
    QVERIFY(loaded.catalog.models().size() > 100);

    write(QStringLiteral("file"), "{}");
    const auto noFolder = Catalog::load({m_dir->filePath(QStringLiteral("file"))});
    QCOMPARE(noFolder.warnings.size(), std::size_t(1));
    QVERIFY(noFolder.warnings.front().detail.contains(QStringLiteral("folder")));
}

void TestCatalogFiles::addsAModel()
{
    write(QStringLiteral("mine.json"), R"({"models": [
        {"id": "9.77", "name": "STS7777", "series": "STS", "byte_order": "little",
         "min_voltage": 6, "max_voltage": 8.4, "note": {"en": "ours", "zh": "自制"}},
        {"id": "5.99", "name": "SCS9999", "series": "SCS", "byte_order": "big",
         "steps_per_turn": 1024, "angle_range_deg": 180}]})");
    const auto loaded = load();
    QVERIFY(loaded.warnings.empty());
    const ProfilePtr sts = loaded.catalog.resolve({3, 10, 0, 9, 77});
    QCOMPARE(sts->modelName, QStringLiteral("STS7777"));
    QCOMPARE(*sts->maxVoltage, 8.4);
    QCOMPARE(sts->mapKey, QStringLiteral("sts-sms"));
    const ProfilePtr scs = loaded.catalog.resolve({0, 4, 1, 5, 99});
    const Register* goal = scs->byRole(Role::GoalPosition);
    QCOMPARE(toPhysical(512, valueFormat(*goal, *scs, noLookup)), 90.0);
    QCOMPARE(loaded.catalog.model(QStringLiteral("STS7777"))->line, Line::Ttl);
}

void TestCatalogFiles::replacesModelMapAndSeries()
{
    const auto count = Catalog::load().catalog.models().size();
    QByteArray file = testMapFile({});
    file.replace("bench", "scs").replace("BENCH", "SCS");
    file.replace(R"("50.0", "50.255")", R"("0.0", "0.39")").replace("little", "big");
    file.chop(1);
    file += R"(, "models": [{"id": "9.3", "name": "MYSTS", "series": "STS", "byte_order": "little"},
                            {"name": "scs125", "series": "SCS", "byte_order": "big"}]})";
    write(QStringLiteral("mine.json"), file);
    const auto loaded = load();
    QVERIFY(loaded.warnings.empty());
    QCOMPARE(loaded.catalog.models().size(), count);
    QCOMPARE(loaded.catalog.resolve({3, 10, 0, 9, 3})->modelName, QStringLiteral("MYSTS"));
    QVERIFY(!loaded.catalog.model(QStringLiteral("STS3215")));
    QVERIFY(!loaded.catalog.model(QStringLiteral("SCS125"))->angleRangeDeg);
    QCOMPARE(loaded.catalog.resolve({0, 4, 1, 5, 15})->registers.size(), std::size_t(1));
}

void TestCatalogFiles::laterFilesWin()
{
    const QByteArray model = R"({"models": [{"id": "9.3", "name": "FIRST", "series": "STS",
        "byte_order": "little"}]})";
    write(QStringLiteral("a.json"), model);
    write(QStringLiteral("b.json"), QByteArray(model).replace("FIRST", "SECOND"));
    QTemporaryDir other;
    QFile file(other.filePath(QStringLiteral("a.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(model).replace("FIRST", "THIRD"));
    file.close();
    QCOMPARE(load().catalog.resolve({3, 10, 0, 9, 3})->modelName, QStringLiteral("SECOND"));
    const auto both = Catalog::load({m_dir->path(), other.path()});
    QCOMPARE(both.catalog.resolve({3, 10, 0, 9, 3})->modelName, QStringLiteral("THIRD"));
}

void TestCatalogFiles::aModelTwiceInOneFileIsReported()
{
    const auto row = [](const QByteArray& id, const QByteArray& name) {
        return R"({"id": ")" + id + R"(", "name": ")" + name +
               R"(", "series": "STS", "byte_order": "little"})";
    };
    write(QStringLiteral("a.json"), R"({"models": [)" + row("200.1", "BENCH1") + "," +
                                        row("200.1", "BENCH2") + "," + row("200.3", "BENCH3") +
                                        "," + row("200.5", "STS3215") + "," + row("9.3", "OTHER") +
                                        "]}");
    write(QStringLiteral("b.json"), R"({"models": [)" + row("200.3", "MINE") + "]}");
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY(loaded.warnings[0].file.endsWith(QStringLiteral("a.json")));
    QCOMPARE(loaded.warnings[0].where, QStringLiteral("models[1] BENCH2"));
    QVERIFY(loaded.warnings[0].detail.contains(QStringLiteral("model BENCH1")));
    QCOMPARE(loaded.catalog.resolve({3, 10, 0, 200, 1})->modelName, QStringLiteral("BENCH2"));
    QCOMPARE(loaded.catalog.resolve({3, 10, 0, 200, 3})->modelName, QStringLiteral("MINE"));
}

void TestCatalogFiles::badModelsAndSeries_data()
{
    QTest::addColumn<QByteArray>("list");
    QTest::addColumn<QByteArray>("row");
    QTest::addColumn<QString>("about");
    const auto model = [](const char* title, QByteArray members, const char* about) {
        QTest::newRow(title) << QByteArray("models")
                             << QByteArray(
                                    R"({"name": "X", "series": "STS", "byte_order": "little")") +
                                    members + "}"
                             << QString::fromLatin1(about);
    };
    const auto series = [](const char* title, QByteArray members, const char* about) {
        QTest::newRow(title) << QByteArray("series")
                             << QByteArray(R"({"key": "X", "byte_order": "little")") + members + "}"
                             << QString::fromLatin1(about);
    };
    model("number as a number", R"(, "id": 9.1)", "id");
    model("number of three parts", R"(, "id": "9.1.0")", "version");
    model("number too large", R"(, "id": "9.300")", "version");
    model("negative number", R"(, "id": "-1.-1")", "version");
    model("voltages crossed", R"(, "min_voltage": 9, "max_voltage": 6)", "min_voltage");
    model("voltage absurd", R"(, "max_voltage": -5)", "absurd");
    model("no steps", R"(, "steps_per_turn": 0)", "steps");
    model("range 0", R"(, "angle_range_deg": 0)", "absurd");
    model("baud rate 0", R"(, "default_baud": 0)", "default_baud");
    model("note in one language", R"(, "note": {"en": "x"})", "zh");
    model("misspelled member", R"(, "angle": 300)", "angle");
    series("no firmware", "", "firmware");
    series("firmware crossed", R"(, "firmware": ["3.9", "3.0"])", "firmware");
    series("one version", R"(, "firmware": ["3.9"])", "firmware");
    series("unknown line", R"(, "firmware": ["60.0", "60.1"], "line": "can")", "line");
    series("unknown centring", R"(, "firmware": ["60.0", "60.1"], "centering": "push")",
           "centering");
    series(
        "mode without command",
        R"(, "firmware": ["60.0", "60.1"], "modes": [{"key": "p", "name": {"en": "a", "zh": "b"}}])",
        "modes");
}

void TestCatalogFiles::badModelsAndSeries()
{
    QFETCH(QByteArray, list);
    QFETCH(QByteArray, row);
    QFETCH(QString, about);
    const auto count = Catalog::load().catalog.models().size();
    write(QStringLiteral("bad.json"), "{\"" + list + "\": [" + row + "]}");
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY2(loaded.warnings.front().detail.contains(about),
             qPrintable(loaded.warnings.front().detail));
    QVERIFY(loaded.warnings.front().where.startsWith(QString::fromLatin1(list)));
    QCOMPARE(loaded.catalog.models().size(), count);
    QVERIFY(!loaded.catalog.model(QStringLiteral("X")));
}

void TestCatalogFiles::seriesWithoutItsMap()
{
    write(QStringLiteral("bad.json"), R"({"series": [{"key": "BENCH", "map": "missing",
        "firmware": ["50.0", "50.9"], "byte_order": "little"}]})");
    const auto loaded = load();
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY(loaded.warnings.front().detail.contains(QStringLiteral("missing")));
    const ProfilePtr profile = loaded.catalog.resolve(TestIdentity);
    QCOMPARE(profile->series, QStringLiteral("BENCH"));
    QCOMPARE(profile->mapKey, QStringLiteral("unknown"));
    QVERIFY(!profile->writable);
}

SERVODESK_GUILESS_TEST(TestCatalogFiles)
#include "tst_catalog_files.moc"
