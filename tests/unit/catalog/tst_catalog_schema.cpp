// SPDX-License-Identifier: GPL-3.0-or-later
// The schema is what a user writes a file by: the built-in files must obey it, and the loader must
// know the members and words that it promises. Checked with the part of JSON Schema that it uses.
#include "catalog/catalog.h"
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace {
QJsonObject readJson(const QString& name)
{
    QFile file(QStringLiteral(SOURCE_DIR "/resources/models/") + name);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

class Schema {
public:
    explicit Schema(QJsonObject root)
        : m_root(std::move(root))
    {}

    /// Path and reason of the first violation; empty if there is none.
    QString violation(const QJsonValue& value) const { return check(value, m_root, {}); }

private:
    QString check(const QJsonValue& value, const QJsonValue& ruleValue, const QString& path) const
    {
        if (ruleValue.isBool())
            return ruleValue.toBool() ? QString() : path + QStringLiteral(": not allowed");
        QJsonObject rule = ruleValue.toObject();
        if (const QString ref = rule.value(QStringLiteral("$ref")).toString(); !ref.isEmpty()) {
            const QString name = ref.section(QLatin1Char('/'), -1);
            rule = m_root.value(QStringLiteral("$defs")).toObject().value(name).toObject();
            if (rule.isEmpty())
                return path + QStringLiteral(": no definition ") + ref;
        }
        const QJsonArray words = rule.value(QStringLiteral("enum")).toArray();
        if (!words.isEmpty() && !words.contains(value))
            return path + QStringLiteral(": not one of the words");
        const QString type = rule.value(QStringLiteral("type")).toString();
        if (type == QStringLiteral("object"))
            return checkObject(value, rule, path);
        if (type == QStringLiteral("array"))
            return checkArray(value, rule, path);
        return checkScalar(value, rule, type, path);
    }

    QString checkObject(const QJsonValue& value, const QJsonObject& rule, const QString& path) const
    {
        if (!value.isObject())
            return path + QStringLiteral(": no object");
        const QJsonObject object = value.toObject();
        for (const QJsonValue& name : rule.value(QStringLiteral("required")).toArray()) {
            if (!object.contains(name.toString()))
                return path + QStringLiteral(": lacks ") + name.toString();
        }
        const QJsonObject properties = rule.value(QStringLiteral("properties")).toObject();
        const bool open = rule.value(QStringLiteral("additionalProperties")).toBool(true);
        for (const QString& name : object.keys()) {
            const QString below = path + QLatin1Char('/') + name;
            if (!properties.contains(name) && !open)
                return below + QStringLiteral(": unknown");
            const QString wrong = properties.contains(name)
                                      ? check(object.value(name), properties.value(name), below)
                                      : QString();
            if (!wrong.isEmpty())
                return wrong;
        }
        return {};
    }

    QString checkArray(const QJsonValue& value, const QJsonObject& rule, const QString& path) const
    {
        if (!value.isArray())
            return path + QStringLiteral(": no list");
        const QJsonArray items = value.toArray();
        for (int i = 0; i < items.size(); ++i) {
            const QString wrong = check(items.at(i), rule.value(QStringLiteral("items")),
                                        path + QStringLiteral("[%1]").arg(i));
            if (!wrong.isEmpty())
                return wrong;
        }
        return {};
    }

    static QString checkScalar(const QJsonValue& value, const QJsonObject& rule,
                               const QString& type, const QString& path)
    {
        const bool fits = type.isEmpty() ||
                          (type == QStringLiteral("string") && value.isString()) ||
                          (type == QStringLiteral("boolean") && value.isBool()) ||
                          (type == QStringLiteral("number") && value.isDouble()) ||
                          (type == QStringLiteral("integer") && value.isDouble() &&
                           value.toDouble() == std::floor(value.toDouble()));
        if (!fits)
            return path + QStringLiteral(": not of type ") + type;
        const QString pattern = rule.value(QStringLiteral("pattern")).toString();
        if (!pattern.isEmpty() && !QRegularExpression(pattern).match(value.toString()).hasMatch())
            return path + QStringLiteral(": does not match ") + pattern;
        if (value.toDouble() < rule.value(QStringLiteral("minimum")).toDouble(-1e300) ||
            value.toDouble() > rule.value(QStringLiteral("maximum")).toDouble(1e300))
            return path + QStringLiteral(": out of bounds");
        return {};
    }

    QJsonObject m_root;
};
} // namespace

class TestCatalogSchema : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void builtInFilesConform_data();
    void builtInFilesConform();
    void rejectsMistakes();
    void loaderKnowsEveryRole();
};

void TestCatalogSchema::builtInFilesConform_data()
{
    QTest::addColumn<QString>("file");
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/models"));
    for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files)) {
        if (name != QLatin1String("schema.json"))
            QTest::newRow(qPrintable(name)) << name;
    }
}

void TestCatalogSchema::builtInFilesConform()
{
    QFETCH(QString, file);
    const QJsonObject schema = readJson(QStringLiteral("schema.json"));
    const QJsonObject content = readJson(file);
    QVERIFY(!schema.isEmpty() && !content.isEmpty());
    const QString violation = Schema(schema).violation(content);
    QVERIFY2(violation.isEmpty(), qPrintable(violation));
}

void TestCatalogSchema::rejectsMistakes()
{
    const Schema schema(readJson(QStringLiteral("schema.json")));
    const auto refuses = [&](const char* json) {
        return !schema.violation(QJsonDocument::fromJson(json).object()).isEmpty();
    };
    QVERIFY(!refuses(
        R"({"models": [{"id": "9.1", "name": "X", "series": "STS", "byte_order": "little"}]})"));
    QVERIFY(refuses(R"({"model": []})"));
    QVERIFY(refuses(
        R"({"models": [{"id": 9.1, "name": "X", "series": "STS", "byte_order": "little"}]})"));
    QVERIFY(refuses(R"({"models": [{"name": "X", "series": "STS", "byte_order": "middle"}]})"));
    QVERIFY(refuses(R"({"maps": [{"key": "m", "registers": [{"key": "a"}]}]})"));
}

void TestCatalogSchema::loaderKnowsEveryRole()
{
    const QJsonArray roles = readJson(QStringLiteral("schema.json"))[QStringLiteral("$defs")]
                                 .toObject()[QStringLiteral("register")]
                                 .toObject()[QStringLiteral("properties")]
                                 .toObject()[QStringLiteral("role")]
                                 .toObject()[QStringLiteral("enum")]
                                 .toArray();
    QVERIFY(roles.size() > 50);
    QJsonArray rows;
    for (int i = 0; i < roles.size(); ++i) {
        rows << QJsonObject{
            {QStringLiteral("key"), QStringLiteral("r%1").arg(i)},
            {QStringLiteral("address"), i},
            {QStringLiteral("size"), 1},
            {QStringLiteral("role"), roles[i]},
            {QStringLiteral("area"), QStringLiteral("SRAM")},
            {QStringLiteral("access"), QStringLiteral("ro")},
            {QStringLiteral("encoding"), QStringLiteral("unsigned")},
            {QStringLiteral("name"), QJsonObject{{QStringLiteral("en"), QStringLiteral("a")},
                                                 {QStringLiteral("zh"), QStringLiteral("b")}}}};
    }
    const QJsonObject map{{QStringLiteral("key"), QStringLiteral("all")},
                          {QStringLiteral("registers"), rows}};
    const QJsonObject content{{QStringLiteral("maps"), QJsonArray{map}}};
    QTemporaryDir dir;
    QFile file(dir.filePath(QStringLiteral("all.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(content).toJson());
    file.close();
    const auto loaded = catalog::Catalog::load({dir.path()});
    for (const auto& warning : loaded.warnings)
        qInfo() << warning.where << warning.detail;
    QVERIFY(loaded.warnings.empty());
}

SERVODESK_GUILESS_TEST(TestCatalogSchema)
#include "tst_catalog_schema.moc"
