// SPDX-License-Identifier: GPL-3.0-or-later
// The memory page on the simulated bus: what a technician does with a servo's table, by keyboard
// and mouse, and what the servo really holds afterwards, proven by switching it off and on.
#include "gui/steady_clock.h"
#include "session/settings.h"
#include "support/own_data_folder.h"
#include "text/language.h"
#include "ui/editors/register_delegate.h"
#include "ui/pages/lock_badge.h"
#include "ui/pages/memory_page.h"
#include "ui/pages/memory_view.h"
#include "ui/pages/register_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using ui::Command;
using ui::MemoryColumn;
using ui::MemoryModel;

class TestMemoryPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();

    void choosingReadsAndWritesNothing();
    void keptSurvivesPowerOff();
    void temporaryDoesNot();
    void physicalValuesAreTyped();
    void listsAreChosen();
    void bitsAreTicked();
    void twoQuickEditsAreBothHonoured();
    void refusedValuesSayWhy();
    void dangerousRowsAskOnce();
    void aChangeOfModeIsNamedFirst();
    void limitsThatChangeNoModeAskNothing();
    void rubbishWritesNothing();
    void readOnlyRowsSaySo();
    void filtersWhileTyping();
    void liveReadingFollowsTheRowsInSight();
    void historyTellsWhatWasWritten();
    void padlockTellsWhoOpenedIt();
    void copiesRowsAsText();
    void exportsTheTable();
    void aWriteToAServoThatIsGoneEnds();
    void everyFamilyHasATable_data();
    void everyFamilyHasATable();
    void changesLanguageWhileOpen();
};

namespace {
constexpr int patience = 20'000;
const QString positionP = QStringLiteral("position_p");
const QString unread = QStringLiteral("not read");

/// Also what no key has, such as Chinese.
void paste(QWidget* widget, const QString& text)
{
    QApplication::clipboard()->setText(text);
    QTest::keyClick(widget, Qt::Key_V, Qt::ControlModifier);
}

/// The page in a window of its own, with a bus that has been searched.
struct Bench {
    gui::SteadyClock steady; ///< nothing has just moved
    QTemporaryDir folder;
    support::OwnDataFolder place; ///< before the session
    session::Session session;
    session::Desk desk{session};
    session::Settings settings;
    ui::Selection selection;
    ui::Commands commands{desk, selection};
    ui::MemoryPage page;

    explicit Bench(const QString& port = QStringLiteral("sim:demo"))
        : settings(folder.filePath(QStringLiteral("settings.ini")))
        , page(desk, commands, selection, settings)
    {
        page.resize(1000, 620);
        page.show();
        page.activateWindow();
        active = QTest::qWaitForWindowActive(&page);
        session::PortRequest request;
        request.name = port;
        desk.connectTo(request);
        open =
            QTest::qWaitFor([this] { return desk.state() == session::LinkState::Open; }, patience);
        jobs::ScanSpec spec;
        spec.lastId = 8;
        desk.search(spec);
        found = QTest::qWaitFor([this] { return !desk.searching() && !desk.servos().empty(); },
                                patience);
    }

    /// Chooses a servo and waits for its table.
    bool choose(std::size_t index = 0)
    {
        selection.select(desk.servos().at(index));
        return QTest::qWaitFor([this] { return entry().tableRead && !desk.busy(); }, patience) &&
               QTest::qWaitFor([this] { return !state(lastKey()).contains(unread); }, patience);
    }

    const session::ServoEntry& entry() const { return *desk.servo(selection.current()); }
    ui::MemoryView& view() const { return *page.findChild<ui::MemoryView*>(); }
    ui::RegisterPanel& panel() const { return *page.findChild<ui::RegisterPanel*>(); }
    ui::RegisterEditor* editor() const
    {
        return page.findChild<ui::RegisterDelegate*>()->openEditor();
    }
    template <typename Widget>
    Widget* child(const char* name) const
    {
        return page.findChild<Widget*>(QString::fromLatin1(name));
    }

    QString lastKey() const { return entry().servo.profile->registers.back().key; }
    QModelIndex at(const QString& key, MemoryColumn column) const
    {
        const QAbstractItemModel* model = view().model();
        for (int row = 0; row < model->rowCount(); ++row) {
            if (model->index(row, 0).data(MemoryModel::KeyRole).toString() == key)
                return model->index(row, static_cast<int>(column));
        }
        return {};
    }
    QString shown(const QString& key, MemoryColumn column) const
    {
        return at(key, column).data().toString();
    }
    QString state(const QString& key) const { return shown(key, MemoryColumn::State); }

    void goTo(const QString& key, MemoryColumn column = MemoryColumn::Value)
    {
        view().setFocus();
        view().setCurrentIndex(at(key, column));
        view().scrollTo(at(key, column));
    }
    /// Enter on the row, the value, Enter.
    void type(const QString& key, const QString& text, MemoryColumn column = MemoryColumn::Value)
    {
        goTo(key, column);
        QTest::keyClick(&view(), Qt::Key_Return);
        if (editor() == nullptr)
            return;
        editor()->selectAll();
        QWidget* taker = editor()->keyTakers().front();
        paste(taker, text);
        QTest::keyClick(taker, Qt::Key_Return);
    }
    QDialog* question() const { return page.findChild<QDialog*>(QStringLiteral("question")); }
    bool idle()
    {
        return QTest::qWaitFor([this] { return !desk.busy() && !entry().writing(); }, patience);
    }
    /// The servos are off for a moment, then everything is read again.
    bool powerCycle()
    {
        desk.powerCycle();
        desk.readTable(selection.current());
        return QTest::qWaitFor([this] { return !desk.busy() && !entry().reading; }, patience);
    }
    std::optional<std::int64_t> raw(const char* key) const
    {
        return entry().servo.raw(QString::fromLatin1(key));
    }

    bool active = false;
    bool open = false;
    bool found = false;
};

void answer(QDialog* question, const char* button)
{
    QTest::mouseClick(question->findChild<QPushButton*>(QString::fromLatin1(button)),
                      Qt::LeftButton);
}

QString allText(const QWidget* widget)
{
    QStringList words;
    for (const QLabel* label : widget->findChildren<QLabel*>())
        words << label->text();
    return words.join(u'\n');
}

} // namespace

void TestMemoryPage::initTestCase()
{
    // As the window does it: what the platform says about its folders is not the program's doing.
    QApplication::setStyle(QStringLiteral("Fusion"));
}

void TestMemoryPage::init()
{
    // The offscreen platform says this of every window; it is about the platform.
    QTest::failOnWarning(
        QRegularExpression(QStringLiteral("^(?!This plugin does not support propagateSizeHints)")));
    text::installTranslator(QStringLiteral("en"));
}

void TestMemoryPage::choosingReadsAndWritesNothing()
{
    Bench bench;
    QVERIFY(bench.active && bench.open && bench.found);
    QVERIFY(bench.child<QLabel>("memoryNothing")->isVisible());
    QSignalSpy told(&bench.desk, &session::Desk::happened);
    QVERIFY(bench.choose());
    QVERIFY(bench.view().isVisible());
    QVERIFY(bench.view().model()->rowCount() > 50);
    for (const catalog::Register& reg : bench.entry().servo.profile->registers)
        QVERIFY2(bench.shown(reg.key, MemoryColumn::Value) != QStringLiteral("—"),
                 qPrintable(reg.key));
    QVERIFY(bench.entry().writes.empty());
    for (const QList<QVariant>& one : told)
        QVERIFY(one.front().value<session::Event>().kind != session::Event::Kind::Written);
    QCOMPARE(bench.page.findChild<ui::LockBadge*>()->lock(), ui::LockBadge::Lock::Closed);
    QCOMPARE(bench.raw("torque_switch"), 0);
}

void TestMemoryPage::keptSurvivesPowerOff()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(positionP, QStringLiteral("40"));
    QVERIFY(bench.entry().writing());
    QTRY_VERIFY_WITH_TIMEOUT(bench.state(positionP).startsWith(QStringLiteral("… pending")) ||
                                 bench.state(positionP).startsWith(QStringLiteral("✓ kept")),
                             patience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state(positionP).startsWith(QStringLiteral("✓ kept")), patience);
    QCOMPARE(bench.shown(positionP, MemoryColumn::Value), QStringLiteral("40"));
    QVERIFY(bench.shown(positionP, MemoryColumn::Name).contains(QStringLiteral("•")));
    QVERIFY(!bench.entry().snapshotPath.isEmpty());
    QVERIFY(QFile::exists(bench.entry().snapshotPath));
    QVERIFY(bench.powerCycle());
    QCOMPARE(bench.raw("position_p"), 40);
    QTRY_VERIFY(bench.state(positionP).startsWith(QStringLiteral("✓ kept")));
    QCOMPARE(bench.raw("lock"), 1);
}

void TestMemoryPage::temporaryDoesNot()
{
    Bench bench;
    QVERIFY(bench.choose());
    const auto before = bench.raw("position_p");
    bench.goTo(positionP);
    ui::RegisterEditor* editor = bench.panel().editor();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor->keyTakers().front(), QStringLiteral("41"));
    auto* button = bench.child<QPushButton>("writeTemporarily");
    bench.panel().ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state(positionP).startsWith(QStringLiteral("◷ temporary")),
                             patience);
    QCOMPARE(bench.raw("position_p"), 41);
    QVERIFY(bench.powerCycle());
    QCOMPARE(bench.raw("position_p"), before);
    QTRY_VERIFY(bench.state(positionP).startsWith(QStringLiteral("≠ changed since")));
    // Where nothing lasts, there is nothing to choose.
    bench.goTo(QStringLiteral("goal_position"));
    QVERIFY(!button->isVisible());
}

void TestMemoryPage::physicalValuesAreTyped()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(QStringLiteral("max_voltage"), QStringLiteral("8.5"), MemoryColumn::Physical);
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("max_voltage"), 85);
    QTRY_COMPARE(bench.shown(QStringLiteral("max_voltage"), MemoryColumn::Physical),
                 QStringLiteral("8.5 V"));
    // The toggle brings the unit to the front, for reading and for typing.
    QTest::mouseClick(bench.child<QToolButton>("physicalFirst"), Qt::LeftButton);
    bench.type(QStringLiteral("max_voltage"), QStringLiteral("8.4"), MemoryColumn::Name);
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("max_voltage"), 84);
}

void TestMemoryPage::listsAreChosen()
{
    Bench bench;
    QVERIFY(bench.choose());
    const QString torque = QStringLiteral("torque_switch");
    bench.goTo(torque);
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QVERIFY(bench.editor());
    auto* list = bench.editor()->findChild<QComboBox*>(QStringLiteral("valueList"));
    QTest::keyClick(list, Qt::Key_Down);
    QVERIFY(list->currentText().startsWith(QStringLiteral("1 — ")));
    QVERIFY(!bench.entry().writing());
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("torque_switch"), 1);
}

void TestMemoryPage::bitsAreTicked()
{
    Bench bench;
    QVERIFY(bench.choose());
    const QString key = QStringLiteral("led_alarm_condition");
    const auto before = bench.raw("led_alarm_condition");
    QVERIFY(before);
    bench.goTo(key);
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QVERIFY(bench.editor());
    auto* box = bench.editor()->findChild<QCheckBox*>(QStringLiteral("bit4"));
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QCOMPARE(bench.editor()->typed().toLongLong(), *before ^ 16);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("led_alarm_condition"), *before ^ 16);
}

void TestMemoryPage::twoQuickEditsAreBothHonoured()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(positionP, QStringLiteral("50"));
    bench.type(positionP, QStringLiteral("51"));
    const auto write = bench.entry().writes.find(positionP);
    QVERIFY(write != bench.entry().writes.end());
    QCOMPARE(write->second.pending, 2);
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("position_p"), 51);
    bench.desk.loadHistory(bench.selection.current());
    QTRY_COMPARE(bench.entry().history.size(), std::size_t(2));
    const auto& history = bench.entry().history;
    QCOMPARE(history[history.size() - 2].intent.items.front().newRaw, 50);
    QCOMPARE(history[history.size() - 1].intent.items.front().newRaw, 51);
}

void TestMemoryPage::refusedValuesSayWhy()
{
    Bench bench;
    QVERIFY(bench.choose());
    // Inside the range of the register, but the minimum must stay below the maximum.
    const QString key = QStringLiteral("min_angle_limit");
    const auto before = bench.raw("min_angle_limit");
    bench.type(QStringLiteral("max_angle_limit"), QStringLiteral("3000"));
    QVERIFY(bench.idle());
    bench.type(key, QStringLiteral("3500"));
    QVERIFY(bench.idle());
    QTRY_VERIFY2(bench.state(key).startsWith(QStringLiteral("✗ refused")),
                 qPrintable(bench.state(key)));
    const QString tip = bench.at(key, MemoryColumn::State).data(Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains(QStringLiteral("3500")) && tip.contains(QStringLiteral("not touched")),
             qPrintable(tip));
    QCOMPARE(bench.raw("min_angle_limit"), before);
}

void TestMemoryPage::dangerousRowsAskOnce()
{
    Bench bench;
    QVERIFY(bench.choose());
    const QString key = QStringLiteral("unload_condition");
    const auto before = bench.raw("unload_condition");
    bench.type(key, QStringLiteral("32"));
    QVERIFY(bench.question());
    QVERIFY(!bench.entry().writing());
    QVERIFY(allText(bench.question()).contains(QStringLiteral("protection")));
    answer(bench.question(), "questionNo");
    QTRY_VERIFY(!bench.question());
    QVERIFY(!bench.entry().writing());
    QCOMPARE(bench.raw("unload_condition"), before);

    bench.type(key, QStringLiteral("32"));
    QVERIFY(bench.question());
    answer(bench.question(), "questionYes");
    QVERIFY(bench.idle());
    QTRY_VERIFY(!bench.question());
    QCOMPARE(bench.raw("unload_condition"), 32);
    QTRY_VERIFY(bench.state(key).startsWith(QStringLiteral("✓ kept")));
}

void TestMemoryPage::aChangeOfModeIsNamedFirst()
{
    Bench bench;
    QVERIFY(bench.choose());
    const QString key = QStringLiteral("operating_mode");
    bench.goTo(key);
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QVERIFY(bench.editor());
    auto* list = bench.editor()->findChild<QComboBox*>(QStringLiteral("valueList"));
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(bench.question());
    const QString words = allText(bench.question());
    QVERIFY2(words.contains(QStringLiteral("constant speed")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("torque off")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("is set to 0")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("Torque stays off")), qPrintable(words));
    QVERIFY(!bench.entry().writing());
    answer(bench.question(), "questionYes");
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("operating_mode"), 1);
    QCOMPARE(bench.raw("torque_switch"), 0);
    QCOMPARE(bench.raw("goal_speed"), 0);
}

void TestMemoryPage::limitsThatChangeNoModeAskNothing()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(QStringLiteral("min_angle_limit"), QStringLiteral("100"));
    QVERIFY(!bench.question());
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("min_angle_limit"), 100);
    bench.type(QStringLiteral("max_angle_limit"), QStringLiteral("3900"));
    QVERIFY(!bench.question());
    QVERIFY(bench.idle());
    // Now the way to multi-turn: the minimum alone is no change yet, the maximum is.
    bench.type(QStringLiteral("min_angle_limit"), QStringLiteral("0"));
    QVERIFY(!bench.question());
    bench.type(QStringLiteral("max_angle_limit"), QStringLiteral("0"));
    QVERIFY(bench.question()); // the first write may still be on its way
    QVERIFY(allText(bench.question()).contains(QStringLiteral("multi-turn")));
    answer(bench.question(), "questionNo");
    QTRY_VERIFY(!bench.question());
    QVERIFY(bench.idle());
    QCOMPARE(bench.raw("max_angle_limit"), 3900);
}

void TestMemoryPage::rubbishWritesNothing()
{
    Bench bench;
    QVERIFY(bench.choose());
    const auto before = bench.raw("position_p");
    for (const QString& rubbish :
         {QStringLiteral("abc"), QStringLiteral("300"), QStringLiteral("-1"), QStringLiteral("1e3"),
          QStringLiteral("12 apples"), QStringLiteral("０"), QStringLiteral(" ")}) {
        bench.type(positionP, rubbish);
        QVERIFY2(bench.editor(), qPrintable(rubbish));
        QVERIFY(bench.child<QLabel>("editorMessage"));
        QTest::keyClick(bench.editor()->keyTakers().front(), Qt::Key_Escape);
        QVERIFY(!bench.editor());
    }
    QVERIFY(bench.entry().writes.empty());
    QCOMPARE(bench.raw("position_p"), before);
    // The same in the panel.
    bench.goTo(positionP);
    ui::RegisterEditor* editor = bench.panel().editor();
    editor->selectAll();
    QTest::keyClicks(editor->keyTakers().front(), QStringLiteral("999"));
    QVERIFY(bench.child<QLabel>("registerComplaint")->isVisibleTo(&bench.panel()));
    QTest::mouseClick(bench.child<QPushButton>("writeValue"), Qt::LeftButton);
    QVERIFY(bench.entry().writes.empty());
}

void TestMemoryPage::readOnlyRowsSaySo()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(QStringLiteral("present_voltage"), QStringLiteral("1"));
    QVERIFY(!bench.editor());
    auto* banner = bench.child<QWidget>("memoryBanner");
    QVERIFY(banner->isVisible());
    QVERIFY(allText(banner).contains(QStringLiteral("only be read")));
    QVERIFY(allText(banner).contains(QStringLiteral("Present voltage"))); // not its key
    QVERIFY(!bench.panel().editor());
}

void TestMemoryPage::filtersWhileTyping()
{
    Bench bench;
    QVERIFY(bench.choose());
    const int all = bench.view().model()->rowCount();
    bench.commands.action(Command::FindRegister)->trigger();
    auto* find = bench.child<QLineEdit>("registerFind");
    QVERIFY(find->hasFocus());
    paste(find, QStringLiteral("卸载"));
    QVERIFY(bench.view().model()->rowCount() < all);
    QVERIFY(bench.at(QStringLiteral("unload_condition"), MemoryColumn::Name).isValid());
    QTest::keyClicks(find, QStringLiteral("nowhere"));
    QVERIFY(bench.child<QLabel>("memoryNothing")->isVisible());
    find->clear();
    QCOMPARE(bench.view().model()->rowCount(), all);
    QTest::mouseClick(bench.child<QToolButton>("rowsChanged"), Qt::LeftButton);
    QVERIFY(bench.view().model()->rowCount() < all / 2);
    QTest::mouseClick(bench.child<QToolButton>("rowsAll"), Qt::LeftButton);
    bench.child<QComboBox>("groupFilter")->setCurrentIndex(3);
    for (int row = 0; row < bench.view().model()->rowCount(); ++row)
        QCOMPARE(bench.view().model()->index(row, 0).data(MemoryModel::AreaRole).toInt(),
                 static_cast<int>(catalog::Area::Feedback));
    QVERIFY(bench.view().model()->rowCount() > 5);
}

void TestMemoryPage::liveReadingFollowsTheRowsInSight()
{
    Bench bench;
    QVERIFY(bench.choose());
    auto* rate = bench.child<QComboBox>("liveRate");
    rate->setCurrentIndex(rate->findData(0));
    bench.goTo(QStringLiteral("firmware_major"));
    bench.child<QComboBox>("groupFilter")->setCurrentIndex(3); // feedback
    const catalog::Register* voltage =
        bench.entry().servo.profile->find(QStringLiteral("present_voltage"));
    const catalog::Register* mode =
        bench.entry().servo.profile->find(QStringLiteral("operating_mode"));
    const auto readAt = [&](const catalog::Register* reg) {
        return *bench.entry().servo.image.readAt(reg->offset);
    };
    const auto voltageBefore = readAt(voltage);
    const auto modeBefore = readAt(mode);
    rate->setCurrentIndex(rate->findData(20));
    QTRY_VERIFY_WITH_TIMEOUT(readAt(voltage) > voltageBefore, patience);
    QCOMPARE(readAt(mode), modeBefore);                        // not in sight, so not asked
    bench.child<QComboBox>("groupFilter")->setCurrentIndex(1); // EPROM
    bench.goTo(QStringLiteral("operating_mode"));
    QTRY_VERIFY_WITH_TIMEOUT(readAt(mode) > modeBefore, patience);
    // The choice is remembered.
    QCOMPARE(bench.settings.choice(QStringLiteral("memory/live_hz"), 0).toInt(), 20);
}

void TestMemoryPage::historyTellsWhatWasWritten()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.type(QStringLiteral("position_d"), QStringLiteral("33"));
    QVERIFY(bench.idle());
    auto* list = bench.child<QListView>("historyList");
    QTRY_VERIFY_WITH_TIMEOUT(
        list->model()->rowCount() > 0 &&
            list->model()->index(0, 0).data().toString().contains(QStringLiteral("→ 33 ✓")),
        patience);
    QVERIFY(list->isVisible());
}

void TestMemoryPage::padlockTellsWhoOpenedIt()
{
    Bench bench(QStringLiteral("sim:trouble"));
    QVERIFY(bench.found);
    std::size_t open = 0;
    while (open < bench.desk.servos().size() &&
           bench.desk.servo(bench.desk.servos()[open])->servo.id != 4)
        ++open;
    QVERIFY(open < bench.desk.servos().size());
    QVERIFY(bench.choose(open));
    auto* badge = bench.page.findChild<ui::LockBadge*>();
    QTRY_COMPARE(badge->lock(), ui::LockBadge::Lock::OpenByOthers);
    QVERIFY(allText(badge).contains(QStringLiteral("not by ServoDesk")));
    auto* close = bench.child<QToolButton>("closeLock");
    QTRY_VERIFY(close->isVisible() && close->isEnabled());
    QTest::mouseClick(close, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(badge->lock(), ui::LockBadge::Lock::Closed, patience);
    QVERIFY(!close->isVisible());
}

void TestMemoryPage::copiesRowsAsText()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.goTo(positionP);
    bench.commands.action(Command::CopyRows)->trigger();
    const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines.at(1).startsWith(QStringLiteral("21\tposition_p\t")));
}

void TestMemoryPage::exportsTheTable()
{
    Bench bench;
    QVERIFY(bench.choose());
    QTemporaryDir folder;
    const auto save = [&](const QString& path) {
        bench.commands.action(Command::ExportTable)->trigger();
        auto* dialog = bench.page.findChild<QFileDialog*>(QStringLiteral("exportDialog"));
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(path);
        dialog->reject();
        QTRY_VERIFY(!bench.page.findChild<QFileDialog*>(QStringLiteral("exportDialog")));
    };
    const QString path = folder.filePath(QStringLiteral("table.csv"));
    save(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray csv = file.readAll();
    QVERIFY(csv.contains(",position_p,"));
    QCOMPARE(csv.count('\n'), bench.view().model()->rowCount() + 1);
    auto* banner = bench.child<QWidget>("memoryBanner");
    QVERIFY(allText(banner).contains(path));
    save(folder.filePath(QStringLiteral("no/such/folder.csv")));
    QVERIFY(banner->isVisible());
    QVERIFY(allText(banner).contains(QStringLiteral("cannot be written")));
}

void TestMemoryPage::aWriteToAServoThatIsGoneEnds()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.desk.disconnectFrom();
    QTRY_COMPARE_WITH_TIMEOUT(bench.desk.state(), session::LinkState::Off, patience);
    bench.type(positionP, QStringLiteral("44"));
    QTRY_VERIFY_WITH_TIMEOUT(bench.state(positionP).startsWith(QStringLiteral("✗ ")), patience);
    QVERIFY(!bench.entry().writing());
    // What is on the screen is marked as old.
    QVERIFY(bench.at(QStringLiteral("position_d"), MemoryColumn::Value)
                .data(MemoryModel::StaleRole)
                .toBool());
}

void TestMemoryPage::everyFamilyHasATable_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<bool>("asks");
    QTest::newRow("SCS") << "sim:scs15@1"
                         << "position_p"
                         << "20" << false;
    QTest::newRow("HLS") << "sim:hls3625@1"
                         << "position_p"
                         << "20" << false;
    QTest::newRow("Modbus") << "sim:modbus"
                            << "max_temperature"
                            << "69" << true;
    QTest::newRow("LX") << "sim:lx"
                        << "temp_limit"
                        << "80" << false;
}

void TestMemoryPage::everyFamilyHasATable()
{
    QFETCH(QString, port);
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(bool, asks);
    Bench bench(port);
    QVERIFY(bench.open && bench.found);
    QVERIFY(bench.choose());
    bench.type(key, value);
    QCOMPARE(bench.question() != nullptr, asks);
    if (asks)
        answer(bench.question(), "questionYes");
    QVERIFY(bench.idle());
    QTRY_VERIFY2(bench.state(key).startsWith(QStringLiteral("✓ kept")),
                 qPrintable(bench.state(key) +
                            bench.at(key, MemoryColumn::State).data(Qt::ToolTipRole).toString()));
    QVERIFY(bench.powerCycle());
    QCOMPARE(bench.entry().servo.raw(key), value.toLongLong());
}

void TestMemoryPage::changesLanguageWhileOpen()
{
    Bench bench;
    QVERIFY(bench.choose());
    bench.goTo(QStringLiteral("unload_condition"));
    text::installTranslator(QStringLiteral("zh_CN"));
    QTRY_COMPARE(bench.shown(QStringLiteral("unload_condition"), MemoryColumn::Name),
                 QStringLiteral("卸载条件"));
    QTRY_VERIFY(bench.child<QLabel>("registerTitle")->text().contains(QStringLiteral("卸载条件")));
    text::installTranslator(QStringLiteral("en"));
    QTRY_VERIFY(bench.child<QLabel>("registerTitle")->text().contains(QStringLiteral("Unload")));
}

QTEST_MAIN(TestMemoryPage)

#include "tst_memory_page.moc"
