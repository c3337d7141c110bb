// SPDX-License-Identifier: GPL-3.0-or-later
// The list of servos says of each what is known, in what state it is and what is remarkable, and
// follows the desk.
#include "gui/desk_bench.h"
#include "text/language.h"
#include "ui/models/servo_list_model.h"
#include "ui/widgets/servo_delegate.h"

#include <QAbstractItemModelTester>
#include <QPainter>
#include <QSignalSpy>

using ui::ServoListModel;
using ui::ServoRow;

namespace {
struct Bench : gui::DeskBench {
    ServoListModel model{desk};
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

session::ServoEntry entryWith(const catalog::ProfilePtr& profile)
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
    void statesInWords_data();
    void statesInWords();
    void troubleIsMarked();
    void overheatedLxIsSeen();
    void unknownServosStayUsable();
    void newerFirmwareIsDated();
    void silentOnesSaySo();
    void whatWasNotReadIsNotFine();
    void itFollowsAChangedId();
    void servosThatLeaveGo();
    void lastSeenGoesOn();
    void anOldAnswerIsNotGreen();
    void languageIsFollowed();
    void rowsAreDrawn();
};

void TestServoListModel::servosAreDescribed()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:demo")));
    QVERIFY(bench.search());
    QCOMPARE(bench.model.rowCount(), 6);
    QCOMPARE(bench.cell(3, ServoListModel::Model), QStringLiteral("STS3250"));
    QCOMPARE(bench.cell(3, ServoListModel::Map), QStringLiteral("sts-sms"));
    QCOMPARE(bench.cell(3, ServoListModel::Line), QStringLiteral("TTL"));
    QCOMPARE(bench.cell(4, ServoListModel::Line), QStringLiteral("RS485"));
    QCOMPARE(bench.cell(3, ServoListModel::Rate), QStringLiteral("1 M"));
    QVERIFY(bench.cell(3, ServoListModel::Firmware).startsWith(QStringLiteral("3.")));
    QCOMPARE(bench.cell(3, ServoListModel::LastSeen), QStringLiteral("now"));
    const QString tip =
        bench.model.index(2, ServoListModel::Model).data(Qt::ToolTipRole).toString();
    for (const char* part : {"ID 3", "STS3250", "sts-sms", "TTL", "1 M", "fine", "Feetech", "now"})
        QVERIFY2(tip.contains(QLatin1String(part)), qPrintable(tip));
}

void TestServoListModel::statesInWords_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("state");
    QTest::newRow("fine") << QStringLiteral("sim:demo") << 1 << QStringLiteral("fine");
    QTest::newRow("voltage") << QStringLiteral("sim:demo") << 6 << QStringLiteral("voltage");
    QTest::newRow("overload") << QStringLiteral("sim:trouble") << 5 << QStringLiteral("overload");
    QTest::newRow("Modbus") << QStringLiteral("sim:smsmb@1") << 1 << QStringLiteral("fine");
}

void TestServoListModel::statesInWords()
{
    QFETCH(const QString, port);
    QFETCH(const int, id);
    QFETCH(const QString, state);
    Bench bench;
    QVERIFY(bench.open(port));
    QVERIFY(bench.search({.firstId = 1, .lastId = 10, .bauds = {}}));
    QCOMPARE(bench.row(id).alarm, state);
    QCOMPARE(bench.row(id).alarmTone,
             state == QLatin1String("fine") ? ui::Tone::Good : ui::Tone::Bad);
}

void TestServoListModel::troubleIsMarked()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:trouble")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 10, .bauds = {}}));
    QVERIFY2(remarks(bench.row(1)).contains(QStringLiteral("Two servos with this ID?")),
             qPrintable(remarks(bench.row(1))));
    QVERIFY2(remarks(bench.row(4)).contains(QStringLiteral("EPROM lock open")),
             qPrintable(remarks(bench.row(4))));
    QVERIFY(!remarks(bench.row(5)).contains(QStringLiteral("lock")));
    QVERIFY(!remarks(bench.row(5)).contains(QStringLiteral("Two servos")));
}

void TestServoListModel::overheatedLxIsSeen()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:lx")));
    QVERIFY(
        bench.search({.firstId = 1, .lastId = 5, .bauds = {}, .protocols = {base::Protocol::Lx}}));
    QCOMPARE(bench.row(3).alarm, QStringLiteral("temperature"));
    QCOMPARE(bench.row(1).alarm, QStringLiteral("fine"));
    QCOMPARE(bench.cell(1, ServoListModel::Firmware), QString()); // LX tells none
}

void TestServoListModel::unknownServosStayUsable()
{
    const auto loaded = catalog::Catalog::load();
    const ServoRow nameless = ui::servoRow(entryWith(nullptr), std::nullopt, {});
    QVERIFY(!nameless.model.isEmpty());
    QCOMPARE(nameless.alarm, QStringLiteral("not identified"));
    const auto generic = loaded.catalog.resolve({3, 10, 0, 99, 1});
    const ServoRow known = ui::servoRow(entryWith(generic), std::nullopt, {});
    QVERIFY2(known.model.contains(QStringLiteral("99.1")), qPrintable(known.model));
    QCOMPARE(known.map, QStringLiteral("sts-sms"));
    const auto strange = loaded.catalog.resolve({7, 1, 0, 99, 1});
    QVERIFY(remarks(ui::servoRow(entryWith(strange), std::nullopt, {}))
                .contains(QStringLiteral("read only")));
}

void TestServoListModel::newerFirmwareIsDated()
{
    const auto loaded = catalog::Catalog::load();
    const auto profile = loaded.catalog.resolve({3, 9, 0, 9, 3});
    const ServoRow row =
        ui::servoRow(entryWith(profile), loaded.catalog.newerFirmware(*profile), {});
    QCOMPARE(remarks(row), QStringLiteral("Firmware 3.10 known (2025-03)"));
    QVERIFY(row.everything().contains(QStringLiteral("3.10 known")));
}

void TestServoListModel::silentOnesSaySo()
{
    session::ServoEntry entry =
        entryWith(catalog::Catalog::load().catalog.resolve({3, 10, 0, 9, 3}));
    entry.silent = true;
    entry.servo.status = 32; // of its last answer
    const ServoRow row = ui::servoRow(entry, std::nullopt, std::chrono::seconds(200));
    QVERIFY(row.silent);
    QCOMPARE(row.alarm, QStringLiteral("no answer"));
    QCOMPARE(row.lastSeen, QStringLiteral("3 min ago"));
}

void TestServoListModel::whatWasNotReadIsNotFine()
{
    const auto loaded = catalog::Catalog::load();
    for (const auto protocol : {base::Protocol::Modbus, base::Protocol::Lx}) {
        const auto profile = loaded.catalog.resolve({20, 8, -1, -1, -1, protocol});
        QCOMPARE(ui::servoRow(entryWith(profile), std::nullopt, {}).alarm,
                 QStringLiteral("not read"));
    }
}

void TestServoListModel::itFollowsAChangedId()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 10, .bauds = {}}));
    const session::ServoRef ref = bench.ref(1);
    const QPersistentModelIndex index = bench.model.index(bench.model.rowOf(ref), 0);
    bench.desk.write(ref, {{{QStringLiteral("id"), 7}}, false, true});
    QTRY_COMPARE(bench.ref(7), ref);
    QTRY_COMPARE(index.data().toInt(), 7);
    QCOMPARE(bench.model.rowOf(ref), index.row());
    const auto& order = bench.desk.servos();
    for (std::size_t i = 0; i < order.size(); ++i)
        QCOMPARE(bench.model.refAt(int(i)), order[i]);
}

void TestServoListModel::servosThatLeaveGo()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:demo")));
    QVERIFY(bench.search({.firstId = 1, .lastId = 3, .bauds = {}}));
    QCOMPARE(bench.model.rowCount(), 3);
    bench.desk.disconnectFrom();
    QTRY_COMPARE(bench.desk.state(), session::LinkState::Off);
    QCOMPARE(bench.model.rowCount(), 3); // still to be looked at
    QVERIFY(bench.open(QStringLiteral("sim:lx")));
    QCOMPARE(bench.model.rowCount(), 0);
}

void TestServoListModel::lastSeenGoesOn()
{
    QCOMPARE(ui::agoWords(std::chrono::milliseconds(400)), QStringLiteral("now"));
    QCOMPARE(ui::agoWords(std::chrono::seconds(12)), QStringLiteral("12 s ago"));
    QCOMPARE(ui::agoWords(std::chrono::seconds(125)), QStringLiteral("2 min ago"));
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    const auto ticked = [&] {
        bench.model.tick();
        return bench.cell(1, ServoListModel::LastSeen);
    };
    QTRY_VERIFY_WITH_TIMEOUT(ticked().endsWith(QStringLiteral("s ago")), 5000);
}

/// Nothing asks it any more, so it is not known to be fine; a fault that was seen stays red.
void TestServoListModel::anOldAnswerIsNotGreen()
{
    using namespace std::chrono_literals;
    session::ServoEntry entry =
        entryWith(catalog::Catalog::load().catalog.resolve({3, 10, 0, 9, 3}));
    QCOMPARE(ui::servoRow(entry, std::nullopt, 4s).alarmTone, ui::Tone::Good);
    const ServoRow old = ui::servoRow(entry, std::nullopt, 36s);
    QCOMPARE(old.alarmTone, ui::Tone::Quiet);
    QCOMPARE(old.lastSeen, QStringLiteral("36 s ago"));
    entry.servo.status = 32;
    QCOMPARE(ui::servoRow(entry, std::nullopt, 36s).alarmTone, ui::Tone::Bad);
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:sts3215@1")));
    QVERIFY(bench.search({.firstId = 0, .lastId = 2, .bauds = {}}));
    QCOMPARE(bench.row(1).alarm, QStringLiteral("fine"));
    const auto ticked = [&] {
        bench.model.tick();
        return bench.row(1).alarmTone;
    };
    QTRY_COMPARE_WITH_TIMEOUT(ticked(), ui::Tone::Quiet, 20000);
}

void TestServoListModel::languageIsFollowed()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:trouble")));
    QVERIFY(bench.search({.firstId = 4, .lastId = 5, .bauds = {}}));
    QSignalSpy header(&bench.model, &QAbstractItemModel::headerDataChanged);
    text::installTranslator(QStringLiteral("zh_CN"));
    bench.model.retranslate();
    QCOMPARE(header.count(), 1);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    QVERIFY2(bench.row(5).alarm.contains(han), qPrintable(bench.row(5).alarm));
}

/// What is drawn fits its place, and remarks take a line of their own.
void TestServoListModel::rowsAreDrawn()
{
    Bench bench;
    QVERIFY(bench.open(QStringLiteral("sim:trouble")));
    QVERIFY(bench.search({.firstId = 4, .lastId = 5, .bauds = {}}));
    const ui::ServoDelegate delegate;
    QStyleOptionViewItem option;
    option.font = QFont();
    const QModelIndex locked = bench.model.index(0, 0);
    const QModelIndex plain = bench.model.index(1, 0);
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

QTEST_MAIN(TestServoListModel)
#include "tst_servo_list_model.moc"
