// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in maps against the register sheets (tests/data/catalog), and the texts that every
// register must carry.
#include "catalog/catalog.h"
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QFile>
#include <QtTest>

using namespace catalog;

namespace {
QString encodingName(const Register& reg)
{
    switch (reg.encoding) {
    case Encoding::Unsigned:
        return QStringLiteral("unsigned");
    case Encoding::SignBit:
        return QStringLiteral("sign-bit-%1").arg(reg.signBit);
    case Encoding::SignBit11Ext12:
        return QStringLiteral("sign-bit-11-ext-12");
    case Encoding::TwosComplement:
        return QStringLiteral("twos-complement");
    case Encoding::Bits:
        return QStringLiteral("bits");
    case Encoding::Enum:
        return QStringLiteral("enum");
    }
    return {};
}

/// The sheet's word for it; what cannot be written has none.
QString persistenceName(const Register& reg)
{
    switch (reg.persistence) {
    case Persistence::ByArea:
        return {};
    case Persistence::Kept:
        return QStringLiteral("yes");
    case Persistence::Lost:
        return QStringLiteral("no");
    case Persistence::AfterSave:
        return QStringLiteral("only after save (18)");
    case Persistence::NotStated:
        return QStringLiteral("not stated");
    }
    return {};
}

QString numberText(const std::optional<std::int64_t>& number)
{
    return number ? QString::number(*number) : QString();
}

/// The register in the sheet's words and order of columns.
QStringList cells(const Register& reg)
{
    return {QString::number(reg.address),
            QString::number(reg.size),
            reg.key,
            reg.name.zh,
            areaName(reg.area),
            accessName(reg.access),
            numberText(reg.defaultRaw),
            numberText(reg.min),
            numberText(reg.max),
            reg.unit,
            QString::number(reg.scale, 'g', 12),
            encodingName(reg)};
}

QList<QStringList> readSheet(const QString& name)
{
    QFile file(QStringLiteral(TEST_DATA_DIR "/catalog/") + name);
    QList<QStringList> rows;
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    const QString content = QString::fromUtf8(file.readAll());
    for (const QString& line : content.split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        rows << line.split(QLatin1Char(','));
    return rows;
}

const Identity Modbus209{20, 9, -1, -1, -1, base::Protocol::Modbus};
const Identity AnyLx{-1, -1, -1, -1, -1, base::Protocol::Lx};

/// What a series or firmware changes on purpose: "key column" → value instead of the sheet's.
using Changes = QMap<QString, QString>;
} // namespace

class TestCatalogDataSheet : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void registersMatchTheSheet_data();
    void registersMatchTheSheet();
    void textsInBothLanguages();
    void namedValuesAreDistinct();
    void rolesAreUnique();
    void lxMatchesTheSheet();
    void defaultsAreValid();
    void warningThresholds();

private:
    QList<ProfilePtr> profiles() const;
    const Catalog m_catalog = Catalog::load().catalog;
};

void TestCatalogDataSheet::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

QList<ProfilePtr> TestCatalogDataSheet::profiles() const
{
    return {m_catalog.resolve({3, 10, 0, 9, 3}),   m_catalog.resolve({2, 45, 0, 8, 42}),
            m_catalog.resolve({2, 53, 0, 8, 42}),  m_catalog.resolve({0, 4, 1, 5, 15}),
            m_catalog.resolve({0, 4, 1, 5, 12}),   m_catalog.resolve({9, 9, 0, 99, 9}),
            m_catalog.resolve({3, 41, 0, 10, 10}), m_catalog.resolve({3, 46, 0, 10, 10}),
            m_catalog.resolve({1, 6, 0, 6, 16}),   m_catalog.resolve({3, 20, 1, 9, 15}),
            m_catalog.resolve(Modbus209),          m_catalog.resolve(AnyLx)};
}

void TestCatalogDataSheet::registersMatchTheSheet_data()
{
    QTest::addColumn<QString>("sheet");
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<Changes>("changes");

    const QString steps = QStringLiteral("0.0146484375");
    QTest::newRow("STS 3.10")
        << QStringLiteral("registers-sts-sms.csv") << Identity{3, 10, 0, 9, 3}
        << Changes{
               {QStringLiteral("baud_rate default"), QStringLiteral("0")},
               {QStringLiteral("baud_rate max"), QStringLiteral("7")},
               {QStringLiteral("acceleration_limit access"), QStringLiteral("rw")},
               {QStringLiteral("return_delay name_zh"), QStringLiteral("预留（SMS 为返回延时）")},
               {QStringLiteral("return_delay unit"), QString()},
               {QStringLiteral("return_delay scale"), QStringLiteral("1")},
               {QStringLiteral("position_offset encoding"), QStringLiteral("sign-bit-11-ext-12")},
               {QStringLiteral("goal_speed scale"), steps},
               {QStringLiteral("present_speed scale"), steps}};
    QTest::newRow("SMS 2.53")
        << QStringLiteral("registers-sts-sms.csv") << Identity{2, 53, 0, 8, 42}
        << Changes{{QStringLiteral("acceleration_limit access"), QStringLiteral("rw")},
                   {QStringLiteral("baud_rate default"), QStringLiteral("4")},
                   {QStringLiteral("min_speed_limit name_zh"), QStringLiteral("Hts(ns)")},
                   {QStringLiteral("min_speed_limit unit"), QStringLiteral("ns")},
                   {QStringLiteral("min_speed_limit scale"), QStringLiteral("20.83")}};
    QTest::newRow("SCS 0.4, range not known")
        << QStringLiteral("registers-scs.csv") << Identity{0, 4, 1, 5, 12}
        << Changes{{QStringLiteral("reserved_7 access"), QStringLiteral("ro")},
                   {QStringLiteral("position_i access"), QStringLiteral("ro")}};
    QTest::newRow("HLS 3.46") << QStringLiteral("registers-hls.csv") << Identity{3, 46, 0, 10, 10}
                              << Changes{};
    // Bits that nobody documents are shown as a number and not offered for editing.
    QTest::newRow("SMCL 1.6") << QStringLiteral("registers-smcl.csv") << Identity{1, 6, 0, 6, 16}
                              << Changes{{QStringLiteral("phase access"), QStringLiteral("ro")}};
    QTest::newRow("SCS2 3.20, range not known")
        << QStringLiteral("registers-scs2.csv") << Identity{3, 20, 1, 9, 20}
        << Changes{{QStringLiteral("reserved_7 access"), QStringLiteral("ro")},
                   {QStringLiteral("phase access"), QStringLiteral("ro")}};
    QTest::newRow("Modbus 20.9") << QStringLiteral("registers-sms-modbus.csv") << Modbus209
                                 << Changes{};
}

void TestCatalogDataSheet::registersMatchTheSheet()
{
    QFETCH(QString, sheet);
    QFETCH(Identity, identity);
    QFETCH(Changes, changes);
    QList<QStringList> rows = readSheet(sheet);
    QVERIFY2(rows.size() > 40, "the sheet could not be read");
    const QStringList columns = rows.takeFirst();
    const ProfilePtr profile = m_catalog.resolve(identity);
    QCOMPARE(qsizetype(profile->registers.size()), rows.size());
    for (qsizetype i = 0; i < rows.size(); ++i) {
        const QStringList found = cells(profile->registers[std::size_t(i)]);
        for (qsizetype c = 0; c < columns.size(); ++c) {
            const QString what = rows[i][2] + QLatin1Char(' ') + columns[c];
            const QString wanted = changes.contains(what) ? changes.take(what) : rows[i][c];
            QVERIFY2(found[c] == wanted, qPrintable(what + QStringLiteral(": ") + found[c] +
                                                    QStringLiteral(" != ") + wanted));
        }
    }
    QVERIFY2(changes.isEmpty(), qPrintable(changes.keys().join(QLatin1Char(' '))));
}

void TestCatalogDataSheet::textsInBothLanguages()
{
    static const QRegularExpression chinese(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
    for (const ProfilePtr& profile : profiles()) {
        for (const Register& reg : profile->registers) {
            QVERIFY2(!reg.name.en.isEmpty() && !reg.name.zh.isEmpty(), qPrintable(reg.key));
            QVERIFY2(reg.help.en.size() >= 15, qPrintable(reg.key));
            QVERIFY2(chinese.match(reg.help.zh).hasMatch(), qPrintable(reg.key));
            QVERIFY2(!chinese.match(reg.help.en + reg.name.en).hasMatch(), qPrintable(reg.key));
            QVERIFY2(!reg.source.isEmpty(), qPrintable(reg.key));
            for (const NamedValue& value : reg.values)
                QVERIFY2(!value.name.en.isEmpty() && !value.name.zh.isEmpty(),
                         qPrintable(value.key));
        }
    }
}

void TestCatalogDataSheet::namedValuesAreDistinct()
{
    static const QRegularExpression word(QStringLiteral("^[a-z0-9_]+$"));
    for (const ProfilePtr& profile : profiles()) {
        for (const Register& reg : profile->registers) {
            QSet<QString> words;
            for (const NamedValue& value : reg.values) {
                QVERIFY2(word.match(value.key).hasMatch(), qPrintable(value.key));
                for (const QString& name : QSet<QString>{value.key, value.name.en, value.name.zh}) {
                    QVERIFY2(!words.contains(name), qPrintable(reg.key + QLatin1Char(' ') + name));
                    words.insert(name);
                }
            }
            const bool named = reg.encoding == Encoding::Enum || reg.encoding == Encoding::Bits;
            QCOMPARE(!reg.values.empty(), named);
        }
    }
}

void TestCatalogDataSheet::rolesAreUnique()
{
    for (const ProfilePtr& profile : profiles()) {
        QSet<int> roles;
        for (const Register& reg : profile->registers) {
            if (reg.role == Role::None)
                continue;
            QVERIFY2(!roles.contains(int(reg.role)), qPrintable(reg.key));
            roles.insert(int(reg.role));
            QCOMPARE(profile->byRole(reg.role)->key, reg.key);
        }
        // Writable rows without a role are settings no task asks for.
        static const QSet<QString> quiet{QStringLiteral("secondary_id"),
                                         QStringLiteral("return_delay"), // STS: no function
                                         QStringLiteral("current_p"),
                                         QStringLiteral("current_i"),
                                         QStringLiteral("kp"),
                                         QStringLiteral("kd"),
                                         QStringLiteral("ki"),
                                         QStringLiteral("moving_threshold"),
                                         QStringLiteral("d_control_time"),
                                         QStringLiteral("max_speed_limit"),
                                         QStringLiteral("bridge_dead_time"),
                                         QStringLiteral("acceleration_limit"),
                                         QStringLiteral("acceleration_default"),
                                         QStringLiteral("speed_default")};
        for (const Register& reg : profile->registers)
            QVERIFY2(!reg.writable() || reg.role != Role::None || quiet.contains(reg.key),
                     qPrintable(reg.key));
    }
}

void TestCatalogDataSheet::lxMatchesTheSheet()
{
    QList<QStringList> rows = readSheet(QStringLiteral("lx-parameters.csv"));
    QVERIFY2(rows.size() == 20, "the sheet could not be read");
    rows.removeFirst();
    const ProfilePtr profile = m_catalog.resolve(AnyLx);
    QCOMPARE(qsizetype(profile->registers.size()), rows.size());
    for (const QStringList& row : rows) {
        const Register* reg = profile->find(row[0]);
        QVERIFY2(reg, qPrintable(row[0]));
        const QString written = QString::number(reg->writeOffset / 8);
        const QString saved = QString::number(reg->saveOffset / 8);
        const int place = reg->offset % 8 + 1;
        const QString places = reg->size == 1 ? QStringLiteral("p%1").arg(place)
                                              : QStringLiteral("p%1-%2").arg(place).arg(place + 1);
        const bool signedNumber = reg->encoding == Encoding::TwosComplement;
        const QString number = (signedNumber ? QLatin1Char('i') : QLatin1Char('u')) +
                               QString::number(8 * reg->size) +
                               (reg->size == 2 ? QStringLiteral("le") : QString());
        const bool named = reg->encoding == Encoding::Enum || reg->encoding == Encoding::Bits;
        // Voltages stay in the sheet's millivolts and are shown in volts; the sheet's upper bound
        // is what a warning follows, not a refusal.
        const bool voltage = row[10] == QStringLiteral("mV");
        const auto& most = voltage ? reg->warnAbove : reg->max;
        const QStringList found{reg->key,
                                reg->name.zh,
                                accessName(reg->access),
                                reg->writable() ? written : QString(),
                                QString::number(reg->address),
                                reg->saveOffset >= 0 ? saved : QString(),
                                places,
                                named ? encodingName(*reg) : number,
                                numberText(reg->min),
                                numberText(most),
                                voltage ? QStringLiteral("mV") : reg->unit,
                                QString::number(voltage ? reg->scale * 1000 : reg->scale),
                                numberText(reg->defaultRaw),
                                persistenceName(*reg)};
        QCOMPARE(found, row);
    }
}

void TestCatalogDataSheet::defaultsAreValid()
{
    for (const ProfilePtr& profile : profiles()) {
        for (const Register& reg : profile->registers) {
            if (!reg.defaultRaw)
                continue;
            QVERIFY2(!reg.min || *reg.defaultRaw >= *reg.min, qPrintable(reg.key));
            QVERIFY2(!reg.max || *reg.defaultRaw <= *reg.max, qPrintable(reg.key));
        }
    }
    // Model dependent: unknown, never "different".
    QVERIFY(!profiles().front()->byRole(Role::MaxVoltage)->defaultRaw);
}

void TestCatalogDataSheet::warningThresholds()
{
    const ProfilePtr sts = profiles().front();
    QCOMPARE(*sts->byRole(Role::ProtectionCurrent)->warnAbove, 511);
    QCOMPARE(*sts->byRole(Role::AngleResolution)->warnAbove, 128);
    QCOMPARE(*sts->byRole(Role::OvercurrentTime)->warnAbove, 254);
}

SERVODESK_GUILESS_TEST(TestCatalogDataSheet)
#include "tst_catalog_data_sheet.moc"
