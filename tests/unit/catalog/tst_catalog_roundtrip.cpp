// SPDX-License-Identifier: GPL-3.0-or-later
// Every value of every register of every map survives raw → wire → raw, raw → physical → raw and
// raw → text → raw.
#include "catalog/catalog.h"
#include "catalog/raw_range.h"
#include "catalog/value.h"
#include "support/test_main.h"

#include <QtTest>

using namespace catalog;

class TestCatalogRoundTrip : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void everyValue_data();
    void everyValue();
    void everyRawWordIsShownUnchanged();

private:
    const Catalog m_catalog = Catalog::load().catalog;
};

namespace {
/// Answers every question with one number: 0 opens motor mode, 4 sets phase bit 2 …
Lookup always(std::int64_t raw)
{
    return [raw](const QString&) { return std::optional(raw); };
}
} // namespace

void TestCatalogRoundTrip::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestCatalogRoundTrip::everyValue_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<Lookup>("lookup");
    const QList<QPair<const char*, Identity>> servos{
        {"STS3215", {3, 10, 0, 9, 3}},
        {"SMS 2.45", {2, 45, 0, 8, 42}},
        {"SMS 2.53", {2, 53, 0, 8, 42}},
        {"SCS15", {0, 4, 1, 5, 15}},
        {"SCS45 in steps", {0, 4, 1, 5, 12}},
        {"SCS1025", {0, 4, 1, 5, 5}},
        {"HLS 3.46", {3, 46, 0, 10, 10}},
        {"SMCL", {1, 6, 0, 6, 16}},
        {"SCS15-2", {3, 20, 1, 9, 15}},
        {"LX", {-1, -1, -1, -1, -1, base::Protocol::Lx}},
        {"SMSMB", {20, 9, -1, -1, -1, base::Protocol::Modbus}},
        {"unknown", {9, 9, 0, 99, 9}},
        {"unknown, high byte first", {9, 9, 1, 99, 9}}};
    for (const auto& [name, identity] : servos) {
        QTest::addRow("%s, nothing known", name) << identity << Lookup(noLookup);
        for (const int raw : {0, 1, 2, 3, 4, 255})
            QTest::addRow("%s, deciders %d", name, raw) << identity << always(raw);
    }
}

void TestCatalogRoundTrip::everyValue()
{
    QFETCH(Identity, identity);
    QFETCH(Lookup, lookup);
    const ProfilePtr profile = m_catalog.resolve(identity);
    for (const Register& reg : profile->registers) {
        const ValueFormat meaning = valueFormat(reg, *profile, lookup);
        const RawRange possible = representableRange(reg.size, meaning.encoding, meaning.signBit);
        const std::int64_t first = meaning.min.value_or(possible.min);
        const std::int64_t last = meaning.max.value_or(possible.max);
        QVERIFY2(first >= possible.min && last <= possible.max, qPrintable(reg.key));
        // Every value of small ranges; of whole words every fifth and the ends.
        const std::int64_t step = last - first > 16384 ? 5 : 1;
        for (std::int64_t raw = first; raw <= last;
             raw = std::min(raw + step, last + (raw == last))) {
            const base::Bytes wire = encodeRaw(raw, reg, meaning, profile->byteOrder);
            const bool good = wire.size() == std::size_t(reg.size) &&
                              decodeRaw(wire, reg, meaning, profile->byteOrder) == raw &&
                              toRaw(toPhysical(raw, meaning), meaning) == raw;
            if (!good)
                QFAIL(qPrintable(QStringLiteral("%1 = %2").arg(reg.key).arg(raw)));
            // Text is slow: every value of small registers, fewer and the ends of large ones.
            const std::int64_t every = step == 1 ? 13 : 130;
            if (last - first > 1024 && raw % every != 0 && raw != first && raw != last)
                continue;
            for (const bool chinese : {false, true}) {
                const QString text = formatValue(raw, reg, meaning, chinese);
                const auto back = parseValue(text, reg, meaning);
                if (!back || *back != raw)
                    QFAIL(qPrintable(
                        QStringLiteral("%1 = %2 as \"%3\"").arg(reg.key).arg(raw).arg(text)));
            }
        }
    }
}

void TestCatalogRoundTrip::everyRawWordIsShownUnchanged()
{
    const ProfilePtr profile = m_catalog.resolve({3, 10, 0, 9, 3});
    for (const Register& reg : profile->registers) {
        // Signed registers ignore the bits above the sign; all others keep every bit.
        if (reg.encoding == Encoding::SignBit || reg.encoding == Encoding::SignBit11Ext12)
            continue;
        const ValueFormat meaning = valueFormat(reg, *profile, noLookup);
        const std::uint64_t words = std::uint64_t{1} << (8 * reg.size);
        for (std::uint64_t word = 0; word < words; ++word) {
            const base::Bytes wire =
                base::writeUnsigned(word, std::size_t(reg.size), base::ByteOrder::Little);
            const std::int64_t raw = decodeRaw(wire, reg, meaning, base::ByteOrder::Little);
            if (encodeRaw(raw, reg, meaning, base::ByteOrder::Little) != wire)
                QFAIL(qPrintable(reg.key));
        }
    }
}

SERVODESK_GUILESS_TEST(TestCatalogRoundTrip)
#include "tst_catalog_roundtrip.moc"
