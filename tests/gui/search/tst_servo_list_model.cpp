// SPDX-License-Identifier: GPL-3.0-or-later
// The list of servos shows what is known about each, its state and its remarks, and follows the
// workbench.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/search/servo_delegate.h"
#include "ui/search/servo_list_model.h"
#include "ui/widgets/rate_text.h"

#include <QAbstractItemModelTester>
#include <QPainter>
#include <QSignalSpy>

using ui::ServoListModel;
using ui::ServoRow;

namespace {
struct ServoListFixture : gui::WorkbenchFixture {
    ServoListModel model{workbench.registry(), workbench.catalog()};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};

    ServoRow row(int id) const
    {
        return model.index(model.rowOf(ref(id)), 0).data(ServoListModel::RowRole).value<ServoRow>();
    }
    QString cell(int id, ServoListModel::Column column) const
    {
        return model.index(model.rowOf(ref(id)), column).data().toString();
    }
};

QString remarks(const ServoRow& row)
{
    QStringList words;
    for (const ui::ServoRemark& remark : row.remarks)
        words << remark.text;
    return words.join(u'\n');
}

session::ServoEntry entryForProfile(const catalog::ProfilePtr& profile)
{
    session::ServoEntry entry;
    entry.ref = 1;
    entry.servo.id = 1;
    entry.servo.baud = 1000000;
    entry.servo.profile = profile;
    if (profile)
        entry.servo.protocol = profile->protocol;
    return entry;
}
} // namespace

class TestServoListModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void servosAreDescribed();
    void statesAsText_data();
    void statesAsText();
    void problemsAreMarked();
    void theOddFirmwareIsMarked();
    void overheatedLxIsMarked();
    void unknownServosAreUsable();
    void newerFirmwareShowsItsDate();
    void silentServosAreMarked();
    void unreadStatusIsNotOk();
    void followsAChangedId();
    void removedServosDisappear();
    void lastSeenKeepsUpdating();
    void aStaleReplyIsNotGreen();
    void followsTheLanguage();
    void rowsArePainted();
};

void TestServoListModel::servosAreDescribed()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:demo")));
    QVERIFY(fixture.search());
    QCOMPARE(fixture.model.rowCount(), 6);
    QCOMPARE(fixture.cell(3, ServoListModel::Model), QStringLiteral("STS3250"));
    QCOMPARE(fixture.cell(3, ServoListModel::Map), QStringLiteral("sts-sms"));
    QCOMPARE(fixture.cell(3, ServoListModel::Line), QStringLiteral("TTL"));
    QCOMPARE(fixture.cell(4, ServoListModel::Line), QStringLiteral("RS485"));
    QCOMPARE(fixture.cell(3, ServoListModel::Rate), QStringLiteral("1 M"));
    QVERIFY(fixture.cell(3, ServoListModel::Firmware).startsWith(QStringLiteral("3.")));
    QCOMPARE(fixture.cell(3, ServoListModel::LastSeen), QStringLiteral("now"));
    const QString tip =
        fixture.model.index(2, ServoListModel::Model).data(Qt::ToolTipRole).toString();
    for (const char* part : {"ID 3", "STS3250", "sts-sms", "TTL", "1 M", "OK", "Feetech", "now"})
        QVERIFY2(tip.contains(QLatin1String(part)), qPrintable(tip));
}

void TestServoListModel::statesAsText_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("state");
    QTest::newRow("OK") << QStringLiteral("sim:demo") << 1 << QStringLiteral("OK");
    QTest::newRow("voltage") << QStringLiteral("sim:demo") << 6 << QStringLiteral("voltage");
    QTest::newRow("overload") << QStringLiteral("sim:trouble") << 5 << QStringLiteral("overload");
    QTest::newRow("Modbus") << QStringLiteral("sim:smsmb@1") << 1 << QStringLiteral("OK");
}

void TestServoListModel::statesAsText()
{
    QFETCH(const QString, port);
    QFETCH(const int, id);
    QFETCH(const QString, state);
    ServoListFixture fixture;
    QVERIFY(fixture.open(port));
    QVERIFY(fixture.search({.firstId = 1, .lastId = 10, .bauds = {}}));
    QCOMPARE(fixture.row(id).alarm, state);
    QCOMPARE(fixture.row(id).alarmTone,
             state == QLatin1String("OK") ? ui::Tone::Good : ui::Tone::Bad);
}

void TestServoListModel::problemsAreMarked()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:trouble")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 10, .bauds = {}}));
    QVERIFY2(remarks(fixture.row(1)).contains(QStringLiteral("Two servos with this ID?")),
             qPrintable(remarks(fixture.row(1))));
    QVERIFY2(remarks(fixture.row(4)).contains(QStringLiteral("EPROM unlocked")),
             qPrintable(remarks(fixture.row(4))));
    QVERIFY(!remarks(fixture.row(5)).contains(QStringLiteral("lock")));
    QVERIFY(!remarks(fixture.row(5)).contains(QStringLiteral("Two servos")));
}

/// LeRobot refuses a bus whose servos differ.
void TestServoListModel::theOddFirmwareIsMarked()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral(
        "sim:sts3215@1+firmware-minor=9,sts3215@2,sts3215@3,sts3250@4+firmware-minor=9")));
    QVERIFY(fixture.search({.firstId = 1, .lastId = 3, .bauds = {}}));
    QVERIFY(fixture.search({.firstId = 4, .lastId = 4, .bauds = {}}));
    const QString differs = QStringLiteral("Firmware differs from the others");
    for (const int id : {1, 2, 3, 4}) {
        const QString all = remarks(fixture.row(id));
        QVERIFY2(all.contains(differs) == (id == 1), qPrintable(all));
    }
}

void TestServoListModel::overheatedLxIsMarked()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:lx")));
    QVERIFY(fixture.search(
        {.firstId = 1, .lastId = 5, .bauds = {}, .protocols = {base::Protocol::Lx}}));
    QCOMPARE(fixture.row(3).alarm, QStringLiteral("temperature"));
    QCOMPARE(fixture.row(1).alarm, QStringLiteral("OK"));
    QCOMPARE(fixture.cell(1, ServoListModel::Firmware), QString()); // LX has none
}

void TestServoListModel::unknownServosAreUsable()
{
    const auto loaded = catalog::Catalog::load();
    const ServoRow unknownRow = ui::servoRow(entryForProfile(nullptr), std::nullopt, {});
    QVERIFY(!unknownRow.model.isEmpty());
    QCOMPARE(unknownRow.alarm, QStringLiteral("not identified"));
    const auto generic = loaded.catalog.resolve({3, 10, 0, 99, 1});
    const ServoRow known = ui::servoRow(entryForProfile(generic), std::nullopt, {});
    QVERIFY2(known.model.contains(QStringLiteral("99.1")), qPrintable(known.model));
    QCOMPARE(known.map, QStringLiteral("sts-sms"));
    const auto unknownProfile = loaded.catalog.resolve({7, 1, 0, 99, 1});
    QVERIFY(remarks(ui::servoRow(entryForProfile(unknownProfile), std::nullopt, {}))
                .contains(QStringLiteral("read-only")));
}

void TestServoListModel::newerFirmwareShowsItsDate()
{
    const auto loaded = catalog::Catalog::load();
    const auto profile = loaded.catalog.resolve({3, 9, 0, 9, 3});
    const ServoRow row =
        ui::servoRow(entryForProfile(profile), loaded.catalog.newerFirmware(*profile), {});
    QCOMPARE(remarks(row), QStringLiteral("Newer firmware exists: 3.10 (2025-03)"));
    QVERIFY(row.toolTipText().contains(QStringLiteral("3.10 (2025-03)")));
}

void TestServoListModel::silentServosAreMarked()
{
    session::ServoEntry entry =
        entryForProfile(catalog::Catalog::load().catalog.resolve({3, 10, 0, 9, 3}));
    entry.silent = true;
    entry.servo.status = 32; // of its last answer
    const ServoRow row = ui::servoRow(entry, std::nullopt, std::chrono::seconds(200));
    QVERIFY(row.isSilent);
    QCOMPARE(row.alarm, QStringLiteral("no reply"));
    QCOMPARE(row.lastSeen, QStringLiteral("3 min ago"));
}

void TestServoListModel::unreadStatusIsNotOk()
{
    const auto loaded = catalog::Catalog::load();
    for (const auto protocol : {base::Protocol::Modbus, base::Protocol::Lx}) {
        const auto profile = loaded.catalog.resolve({20, 8, -1, -1, -1, protocol});
        QCOMPARE(ui::servoRow(entryForProfile(profile), std::nullopt, {}).alarm,
                 QStringLiteral("not read"));
    }
}

void TestServoListModel::followsAChangedId()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 10, .bauds = {}}));
    const session::ServoRef ref = fixture.ref(1);
    const QPersistentModelIndex index = fixture.model.index(fixture.model.rowOf(ref), 0);
    fixture.workbench.writes().write(
        ref, {{{QStringLiteral("id"), 7}}, false, device::Consent::confirmed()});
    QTRY_COMPARE(fixture.ref(7), ref);
    QTRY_COMPARE(index.data().toInt(), 7);
    QCOMPARE(fixture.model.rowOf(ref), index.row());
    const auto& order = fixture.workbench.registry().order();
    for (std::size_t i = 0; i < order.size(); ++i)
        QCOMPARE(fixture.model.refAt(int(i)), order[i]);
}

void TestServoListModel::removedServosDisappear()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:demo")));
    QVERIFY(fixture.search({.firstId = 1, .lastId = 3, .bauds = {}}));
    QCOMPARE(fixture.model.rowCount(), 3);
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QCOMPARE(fixture.model.rowCount(), 3); // still to be looked at
    QVERIFY(fixture.open(QStringLiteral("sim:lx")));
    QCOMPARE(fixture.model.rowCount(), 0);
}

void TestServoListModel::lastSeenKeepsUpdating()
{
    QCOMPARE(ui::timeAgoText(std::chrono::milliseconds(400)), QStringLiteral("now"));
    QCOMPARE(ui::timeAgoText(std::chrono::seconds(12)), QStringLiteral("12 s ago"));
    QCOMPARE(ui::timeAgoText(std::chrono::seconds(125)), QStringLiteral("2 min ago"));
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    const auto selected = [&] {
        fixture.model.updateAges();
        return fixture.cell(1, ServoListModel::LastSeen);
    };
    QTRY_VERIFY(selected().endsWith(QStringLiteral("s ago")));
}

/// It is not read any more, so "OK" would be unproven; a fault that was read stays red.
void TestServoListModel::aStaleReplyIsNotGreen()
{
    using namespace std::chrono_literals;
    session::ServoEntry entry =
        entryForProfile(catalog::Catalog::load().catalog.resolve({3, 10, 0, 9, 3}));
    QCOMPARE(ui::servoRow(entry, std::nullopt, 4s).alarmTone, ui::Tone::Good);
    const ServoRow old = ui::servoRow(entry, std::nullopt, 36s);
    QCOMPARE(old.alarmTone, ui::Tone::Quiet);
    QCOMPARE(old.lastSeen, QStringLiteral("36 s ago"));
    entry.servo.status = 32;
    QCOMPARE(ui::servoRow(entry, std::nullopt, 36s).alarmTone, ui::Tone::Bad);
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(fixture.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    QCOMPARE(fixture.row(1).alarm, QStringLiteral("OK"));
    const auto selected = [&] {
        fixture.model.updateAges();
        return fixture.row(1).alarmTone;
    };
    QTRY_COMPARE(selected(), ui::Tone::Quiet);
}

void TestServoListModel::followsTheLanguage()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:trouble")));
    QVERIFY(fixture.search({.firstId = 4, .lastId = 5, .bauds = {}}));
    QSignalSpy header(&fixture.model, &QAbstractItemModel::headerDataChanged);
    text::installTranslator(QStringLiteral("zh_CN"));
    fixture.model.retranslate();
    QCOMPARE(header.count(), 1);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    QVERIFY2(fixture.row(5).alarm.contains(han), qPrintable(fixture.row(5).alarm));
}

/// What is drawn fits its place, and remarks take a line of their own.
void TestServoListModel::rowsArePainted()
{
    ServoListFixture fixture;
    QVERIFY(fixture.open(QStringLiteral("sim:trouble")));
    QVERIFY(fixture.search({.firstId = 4, .lastId = 5, .bauds = {}}));
    const ui::ServoDelegate delegate;
    QStyleOptionViewItem option;
    option.font = QFont();
    const QModelIndex locked = fixture.model.index(0, 0);
    const QModelIndex plain = fixture.model.index(1, 0);
    QVERIFY(delegate.sizeHint(option, locked).height() > delegate.sizeHint(option, plain).height());
    QImage image(300, delegate.sizeHint(option, locked).height(), QImage::Format_RGB32);
    image.fill(Qt::white);
    const QImage empty = image;
    option.rect = image.rect();
    QPainter painter(&image);
    delegate.paint(&painter, option, locked);
    painter.end();
    QVERIFY(image != empty);
}

SERVODESK_TEST(TestServoListModel)
#include "tst_servo_list_model.moc"
