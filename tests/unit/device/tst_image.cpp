// SPDX-License-Identifier: GPL-3.0-or-later
// The newest reading of a byte counts, in any order of arrival.
#include "device/image.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using namespace std::chrono_literals;

class TestImage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /// A poll of before the write is fetched after the write's read-back.
    void aLateBlockDoesNotOverwriteNewerValues()
    {
        device::Image image;
        image.store(21, base::Bytes{32}, 2s);
        image.store(20, base::Bytes{7, 41, 9}, 1s);
        QCOMPARE(*image.bytes(20, 3), (base::Bytes{7, 32, 9}));
        QCOMPARE(*image.readAt(21), base::Duration(2s));
        QCOMPARE(*image.readAt(20), base::Duration(1s));
        image.store(21, base::Bytes{40}, 3s);
        QCOMPARE(*image.bytes(21, 1), (base::Bytes{40}));
    }

    void clearedValuesAreTakenFromAnyReading()
    {
        device::Image image;
        image.store(5, base::Bytes{1}, 2s);
        image.invalidate(5, 1);
        QVERIFY(!image.readAt(5));
        image.store(5, base::Bytes{3}, 1s);
        QCOMPARE(*image.bytes(5, 1), (base::Bytes{3}));
    }

    /// What was read before a write without a read-back is not brought back by another reader.
    void invalidatedValuesAreTakenFromLaterReadingsOnly()
    {
        device::Image polled;
        polled.store(5, base::Bytes{1}, 2s);
        device::Image image = polled;
        image.invalidate(5, 1, 3s);
        image.mergeNewer(polled, 1s);
        QVERIFY(!image.readAt(5));
        polled.store(5, base::Bytes{0}, 4s);
        image.mergeNewer(polled, 1s);
        QCOMPARE(*image.bytes(5, 1), (base::Bytes{0}));
    }
};

SERVODESK_GUILESS_TEST(TestImage)
#include "tst_image.moc"
