// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware page as a technician sees it: every version, the odd one, what it means for the
// robot's software, and the list as a file.
#include "gui/main_window_fixture.h"
#include "support/test_main.h"

#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

namespace {
const QString mixed = QStringLiteral("sim:sts3215@1,sts3215@2+firmware-minor=9,sts3215@3,scs15@4");

struct Fixture : gui::MainWindowFixture {
    explicit Fixture(const QString& port, const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("firmware");
        if (!connectTo(port))
            qFatal("no bus");
    }
    QString cell(int row, int column)
    {
        return find<QTableWidget>("firmwareTable")->item(row, column)->text();
    }
    QString summary() { return find<QLabel>("firmwareSummary")->text(); }
};
} // namespace

class TestFirmwarePage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void theOddOneIsNamed()
    {
        Fixture fixture(mixed);
        QTRY_COMPARE(fixture.find<QTableWidget>("firmwareTable")->rowCount(), 4);
        const QStringList versions{QStringLiteral("3.10"), QStringLiteral("3.9"),
                                   QStringLiteral("3.10"), QStringLiteral("0.4")};
        for (int row = 0; row < 4; ++row) {
            QCOMPARE(fixture.cell(row, 0), QString::number(row + 1));
            QCOMPARE(fixture.cell(row, 3), versions[row]);
            QCOMPARE(fixture.cell(row, 5).isEmpty(), row != 1);
        }
        QCOMPARE(fixture.cell(1, 4), QStringLiteral("3.10 (2025-03)"));
        QVERIFY(fixture.summary().contains(QStringLiteral("LeRobot refuses")));
        QVERIFY(fixture.find<QLabel>("firmwareSource")->isVisible());
        fixture.setLanguage(QStringLiteral("zh_CN"));
        QTRY_COMPARE(fixture.cell(1, 5), QStringLiteral("与同型号的其他舵机不同"));
    }

    void equalVersionsAreSaid()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        QTRY_COMPARE(fixture.summary(), QStringLiteral("All 2 servos run firmware 3.10."));
        QVERIFY(!fixture.find<QLabel>("firmwareSource")->isVisible());
    }

    /// A spreadsheet takes 3.10 for 3.1.
    void theListIsSaved()
    {
        Fixture fixture(mixed);
        QTRY_COMPARE(fixture.find<QTableWidget>("firmwareTable")->rowCount(), 4);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("list.csv"));
        fixture.find<QPushButton>("firmwareSave")->click();
        auto* dialog = fixture.find<QFileDialog>("firmwareSaveDialog");
        QVERIFY(dialog != nullptr);
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
        QTRY_VERIFY(QFile::exists(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QCOMPARE(lines.size(), 6);
        QVERIFY2(lines[2].startsWith("2,STS3215,9.3,v3.9,v3.10,Differs"), lines[2].constData());
    }
};

SERVODESK_TEST(TestFirmwarePage)
#include "tst_firmware_page.moc"
