// SPDX-License-Identifier: GPL-3.0-or-later
// The memory page on the simulated bus: what a technician does with the table of a servo, by
// keyboard and mouse, and what the servo really holds afterwards, proven by switching it off and
// on.
#include "gui/press_clock.h"
#include "session/settings.h"
#include "support/temporary_data_folder.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/memory/lock_badge.h"
#include "ui/memory/memory_page.h"
#include "ui/memory/memory_toolbar.h"
#include "ui/memory/memory_view.h"
#include "ui/memory/register_delegate.h"
#include "ui/memory/register_panel.h"

#include <QAction>
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
#include <QMenu>
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

    void selectingReadsAndWritesNothing();
    void savedSurvivesPowerOff();
    void temporaryDoesNot();
    void physicalValuesAreTyped();
    void listsAreChosen();
    void bitsAreTicked();
    void twoQuickEditsAreBothWritten();
    void refusedValuesSayWhy();
    void dangerousRowsAskOnce();
    void theMidpointIsAskedFor();
    void aModeChangeIsAnnouncedFirst();
    void limitsThatChangeNoModeAskNothing();
    void invalidInputWritesNothing();
    void readOnlyRowsAreMarked();
    void filtersWhileTyping();
    void pollingFollowsTheVisibleRows();
    void historyShowsWrites();
    void padlockShowsWhoOpenedIt();
    void columnsCanBeHidden();
    void copiesRowsAsText();
    void exportsTheTable();
    void otherPagesCopyPresentValues();
    void aWriteToAMissingServoEnds();
    void everyFamilyHasATable_data();
    void everyFamilyHasATable();
    void changesLanguageWhileOpen();
};

namespace {
const QString positionP = QStringLiteral("position_p");
const QString unread = QStringLiteral("not read");

/// Also what no key has, such as Chinese.
void setClipboard(QWidget* widget, const QString& text)
{
    QApplication::clipboard()->setText(text);
    QTest::keyClick(widget, Qt::Key_V, Qt::ControlModifier);
}

/// The page in a window of its own, with a bus that has been searched.
struct MemoryPageFixture {
    gui::AdvancingClock pressClock; ///< nothing has just moved
    QTemporaryDir folder;
    support::TemporaryDataFolder place; ///< before the session
    session::Session session;
    session::Workbench workbench{session};
    session::Settings settings;
    ui::Selection selection;
    ui::Commands commands{workbench, selection};
    ui::MemoryPage page;

    explicit MemoryPageFixture(const QString& port = QStringLiteral("sim:demo"))
        : settings(folder.filePath(QStringLiteral("settings.ini")))
        , page(workbench, commands, selection, settings)
    {
        page.resize(1000, 620);
        page.show();
        page.activateWindow();
        active = QTest::qWaitForWindowActive(&page);
        session::PortRequest request;
        request.name = port;
        workbench.link().connectTo(request);
        open = support::waitFor(
            [this] { return workbench.link().state() == session::LinkState::Open; });
        jobs::ScanSpec spec;
        spec.lastId = 8;
        workbench.search().start(spec);
        found = support::waitFor([this] {
            return !workbench.search().isSearching() && !workbench.registry().order().empty();
        });
    }

    /// Chooses a servo and waits for its table.
    bool choose(std::size_t index = 0)
    {
        selection.select(workbench.registry().order().at(index));
        return support::waitFor(
                   [this] { return entry().hasFullTable && !workbench.tasks().isBusy(); }) &&
               support::waitFor([this] { return !state(lastKey()).contains(unread); });
    }

    const session::ServoEntry& entry() const
    {
        return *workbench.registry().servo(selection.current());
    }
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
        QWidget* keyReceiver = editor()->is().front();
        setClipboard(keyReceiver, text);
        QTest::keyClick(keyReceiver, Qt::Key_Return);
    }
    QDialog* question() const { return page.findChild<QDialog*>(QStringLiteral("question")); }
    bool idle()
    {
        return support::waitFor(
            [this] { return !workbench.tasks().isBusy() && !entry().writing(); });
    }
    /// The servos are off for a moment, then everything is read again.
    bool powerCycle()
    {
        workbench.link().powerCycle();
        workbench.writes().readTable(selection.current());
        return support::waitFor(
            [this] { return !workbench.tasks().isBusy() && !entry().isReadingTable; });
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
    // As the window does it: warnings of the platform about its folders are not the program's.
    QApplication::setStyle(QStringLiteral("Fusion"));
}

void TestMemoryPage::init()
{
    // The offscreen platform warns about every window; it is about the platform.
    QTest::failOnWarning(
        QRegularExpression(QStringLiteral("^(?!This plugin does not support propagateSizeHints)")));
    text::installTranslator(QStringLiteral("en"));
}

void TestMemoryPage::selectingReadsAndWritesNothing()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.active && fixture.open && fixture.found);
    QVERIFY(fixture.child<QLabel>("memoryNothing")->isVisible());
    QSignalSpy eventSpy(&fixture.workbench, &session::Workbench::eventOccurred);
    QVERIFY(fixture.choose());
    QVERIFY(fixture.view().isVisible());
    QVERIFY(fixture.view().model()->rowCount() > 50);
    for (const catalog::Register& reg : fixture.entry().servo.profile->registers)
        QVERIFY2(fixture.shown(reg.key, MemoryColumn::Value) != QStringLiteral("—"),
                 qPrintable(reg.key));
    QVERIFY(fixture.entry().writes.empty());
    for (const QList<QVariant>& one : eventSpy)
        QVERIFY(one.front().value<session::Event>().kind != session::Event::Kind::Written);
    QCOMPARE(fixture.page.findChild<ui::LockBadge*>()->lock(), ui::LockBadge::Lock::Closed);
    QCOMPARE(fixture.raw("torque_switch"), 0);
}

void TestMemoryPage::savedSurvivesPowerOff()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(positionP, QStringLiteral("40"));
    QVERIFY(fixture.entry().writing());
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("… pending")) ||
                fixture.state(positionP).startsWith(QStringLiteral("✓ kept")));
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("✓ kept")));
    QCOMPARE(fixture.shown(positionP, MemoryColumn::Value), QStringLiteral("40"));
    QVERIFY(fixture.shown(positionP, MemoryColumn::Name).contains(QStringLiteral("•")));
    QVERIFY(!fixture.entry().snapshotPath.isEmpty());
    QVERIFY(QFile::exists(fixture.entry().snapshotPath));
    QVERIFY(fixture.powerCycle());
    QCOMPARE(fixture.raw("position_p"), 40);
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("✓ kept")));
    QCOMPARE(fixture.raw("lock"), 1);
}

void TestMemoryPage::temporaryDoesNot()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const auto before = fixture.raw("position_p");
    fixture.goTo(positionP);
    ui::RegisterEditor* editor = fixture.panel().editor();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor->is().front(), QStringLiteral("41"));
    auto* button = fixture.child<QPushButton>("writeTemporarily");
    fixture.panel().ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("◷ temporary")));
    QCOMPARE(fixture.raw("position_p"), 41);
    QVERIFY(fixture.powerCycle());
    QCOMPARE(fixture.raw("position_p"), before);
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("≠ changed since the write")));
    // Where nothing lasts, there is nothing to choose.
    fixture.goTo(QStringLiteral("goal_position"));
    QVERIFY(!button->isVisible());
}

void TestMemoryPage::physicalValuesAreTyped()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(QStringLiteral("max_voltage"), QStringLiteral("8.5"), MemoryColumn::Physical);
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("max_voltage"), 85);
    QTRY_COMPARE(fixture.shown(QStringLiteral("max_voltage"), MemoryColumn::Physical),
                 QStringLiteral("8.5 V"));
    // The toggle brings the unit to the front, for reading and for typing.
    QTest::mouseClick(fixture.child<QAbstractButton>("physicalFirst"), Qt::LeftButton);
    fixture.type(QStringLiteral("max_voltage"), QStringLiteral("8.4"), MemoryColumn::Name);
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("max_voltage"), 84);
}

void TestMemoryPage::listsAreChosen()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const QString torque = QStringLiteral("torque_switch");
    fixture.goTo(torque);
    QTest::keyClick(&fixture.view(), Qt::Key_Return);
    QVERIFY(fixture.editor());
    auto* list = fixture.editor()->findChild<QComboBox*>(QStringLiteral("valueList"));
    QTest::keyClick(list, Qt::Key_Down);
    QVERIFY(list->currentText().startsWith(QStringLiteral("1 — ")));
    QVERIFY(!fixture.entry().writing());
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("torque_switch"), 1);
}

void TestMemoryPage::bitsAreTicked()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const QString key = QStringLiteral("led_alarm_condition");
    const auto before = fixture.raw("led_alarm_condition");
    QVERIFY(before);
    fixture.goTo(key);
    QTest::keyClick(&fixture.view(), Qt::Key_Return);
    QVERIFY(fixture.editor());
    auto* box = fixture.editor()->findChild<QCheckBox*>(QStringLiteral("bit4"));
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QCOMPARE(fixture.editor()->inputText().toLongLong(), *before ^ 16);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("led_alarm_condition"), *before ^ 16);
}

void TestMemoryPage::twoQuickEditsAreBothWritten()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(positionP, QStringLiteral("50"));
    fixture.type(positionP, QStringLiteral("51"));
    const auto write = fixture.entry().writes.find(positionP);
    QVERIFY(write != fixture.entry().writes.end());
    QCOMPARE(write->second.pending, 2);
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("position_p"), 51);
    fixture.workbench.writes().loadHistory(fixture.selection.current());
    QTRY_COMPARE(fixture.entry().history.size(), std::size_t(2));
    const auto& history = fixture.entry().history;
    QCOMPARE(history[history.size() - 2].intent.items.front().newRaw, 50);
    QCOMPARE(history[history.size() - 1].intent.items.front().newRaw, 51);
}

void TestMemoryPage::refusedValuesSayWhy()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    // Inside the range of the register, but the minimum must stay below the maximum.
    const QString key = QStringLiteral("min_angle_limit");
    const auto before = fixture.raw("min_angle_limit");
    fixture.type(QStringLiteral("max_angle_limit"), QStringLiteral("3000"));
    QVERIFY(fixture.idle());
    fixture.type(key, QStringLiteral("3500"));
    QVERIFY(fixture.idle());
    QTRY_VERIFY2(fixture.state(key).startsWith(QStringLiteral("✗ refused")),
                 qPrintable(fixture.state(key)));
    const QString tip = fixture.at(key, MemoryColumn::State).data(Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains(QStringLiteral("3500")) && tip.contains(QStringLiteral("not changed")),
             qPrintable(tip));
    QCOMPARE(fixture.raw("min_angle_limit"), before);
}

void TestMemoryPage::dangerousRowsAskOnce()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const QString key = QStringLiteral("unload_condition");
    const auto before = fixture.raw("unload_condition");
    fixture.type(key, QStringLiteral("32"));
    QVERIFY(fixture.question());
    QVERIFY(!fixture.entry().writing());
    QVERIFY(allText(fixture.question()).contains(QStringLiteral("protection")));
    answer(fixture.question(), "questionNo");
    QTRY_VERIFY(!fixture.question());
    QVERIFY(!fixture.entry().writing());
    QCOMPARE(fixture.raw("unload_condition"), before);

    fixture.type(key, QStringLiteral("32"));
    QVERIFY(fixture.question());
    answer(fixture.question(), "questionYes");
    QVERIFY(fixture.idle());
    QTRY_VERIFY(!fixture.question());
    QCOMPARE(fixture.raw("unload_condition"), 32);
    QTRY_VERIFY(fixture.state(key).startsWith(QStringLiteral("✓ kept")));
}

/// 128 in the torque switch makes the present position the midpoint.
void TestMemoryPage::theMidpointIsAskedFor()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    QAction* center = fixture.commands.action(ui::Command::Center);
    const QSignalSpy asked(center, &QAction::triggered); // its dialog asks
    const auto enter = [&fixture] {
        const QModelIndex cell = fixture.at(QStringLiteral("torque_switch"), MemoryColumn::Value);
        fixture.view().model()->setData(cell, 128);
    };
    QVERIFY(center->isEnabled());
    enter();
    QCOMPARE(asked.size(), 1);
    QVERIFY(!fixture.question());
    QVERIFY(!fixture.entry().writing());

    center->setEnabled(false);
    enter();
    QVERIFY(fixture.question());
    answer(fixture.question(), "questionNo");
    QTRY_VERIFY(!fixture.question());
    QVERIFY(!fixture.entry().writing());
    QCOMPARE(asked.size(), 1);
}

void TestMemoryPage::aModeChangeIsAnnouncedFirst()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const QString key = QStringLiteral("operating_mode");
    fixture.goTo(key);
    QTest::keyClick(&fixture.view(), Qt::Key_Return);
    QVERIFY(fixture.editor());
    auto* list = fixture.editor()->findChild<QComboBox*>(QStringLiteral("valueList"));
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(fixture.question());
    const QString words = allText(fixture.question());
    QVERIFY2(words.contains(QStringLiteral("“position” to “speed”")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("torque off")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("is set to 0")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("Torque stays off")), qPrintable(words));
    QVERIFY(!fixture.entry().writing());
    answer(fixture.question(), "questionYes");
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("operating_mode"), 1);
    QCOMPARE(fixture.raw("torque_switch"), 0);
    QCOMPARE(fixture.raw("goal_speed"), 0);
}

void TestMemoryPage::limitsThatChangeNoModeAskNothing()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(QStringLiteral("min_angle_limit"), QStringLiteral("100"));
    QVERIFY(!fixture.question());
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("min_angle_limit"), 100);
    fixture.type(QStringLiteral("max_angle_limit"), QStringLiteral("3900"));
    QVERIFY(!fixture.question());
    QVERIFY(fixture.idle());
    // Now the way to multi-turn: the minimum alone is no change yet, the maximum is.
    fixture.type(QStringLiteral("min_angle_limit"), QStringLiteral("0"));
    QVERIFY(!fixture.question());
    fixture.type(QStringLiteral("max_angle_limit"), QStringLiteral("0"));
    QVERIFY(fixture.question()); // the first write may still be on its way
    QVERIFY(allText(fixture.question()).contains(QStringLiteral("multi-turn")));
    answer(fixture.question(), "questionNo");
    QTRY_VERIFY(!fixture.question());
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.raw("max_angle_limit"), 3900);
}

void TestMemoryPage::invalidInputWritesNothing()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const auto before = fixture.raw("position_p");
    for (const QString& rubbish :
         {QStringLiteral("abc"), QStringLiteral("300"), QStringLiteral("-1"), QStringLiteral("1e3"),
          QStringLiteral("12 apples"), QStringLiteral("０"), QStringLiteral(" ")}) {
        fixture.type(positionP, rubbish);
        QVERIFY2(fixture.editor(), qPrintable(rubbish));
        QVERIFY(fixture.child<QLabel>("editorMessage"));
        QTest::keyClick(fixture.editor()->is().front(), Qt::Key_Escape);
        QVERIFY(!fixture.editor());
    }
    QVERIFY(fixture.entry().writes.empty());
    QCOMPARE(fixture.raw("position_p"), before);
    // The same in the panel.
    fixture.goTo(positionP);
    ui::RegisterEditor* editor = fixture.panel().editor();
    editor->selectAll();
    QTest::keyClicks(editor->is().front(), QStringLiteral("999"));
    QVERIFY(fixture.child<QLabel>("registerComplaint")->isVisibleTo(&fixture.panel()));
    QTest::mouseClick(fixture.child<QPushButton>("writeValue"), Qt::LeftButton);
    QVERIFY(fixture.entry().writes.empty());
}

void TestMemoryPage::readOnlyRowsAreMarked()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(QStringLiteral("present_voltage"), QStringLiteral("1"));
    QVERIFY(!fixture.editor());
    auto* banner = fixture.child<QWidget>("memoryBanner");
    QVERIFY(banner->isVisible());
    QVERIFY(allText(banner).contains(QStringLiteral("read-only")));
    QVERIFY(allText(banner).contains(QStringLiteral("Present voltage"))); // not its key
    QVERIFY(!fixture.panel().editor());
}

void TestMemoryPage::filtersWhileTyping()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const int all = fixture.view().model()->rowCount();
    fixture.commands.action(Command::FindRegister)->trigger();
    auto* find = fixture.child<QLineEdit>("registerFind");
    QVERIFY(find->hasFocus());
    setClipboard(find, QStringLiteral("卸载"));
    QVERIFY(fixture.view().model()->rowCount() < all);
    QVERIFY(fixture.at(QStringLiteral("unload_condition"), MemoryColumn::Name).isValid());
    QTest::keyClicks(find, QStringLiteral("nowhere"));
    QVERIFY(fixture.child<QLabel>("memoryNothing")->isVisible());
    find->clear();
    QCOMPARE(fixture.view().model()->rowCount(), all);
    QTest::mouseClick(fixture.child<QAbstractButton>("rowsChanged"), Qt::LeftButton);
    QVERIFY(fixture.view().model()->rowCount() < all / 2);
    QTest::mouseClick(fixture.child<QAbstractButton>("rowsAll"), Qt::LeftButton);
    fixture.child<QComboBox>("groupFilter")->setCurrentIndex(3);
    for (int row = 0; row < fixture.view().model()->rowCount(); ++row)
        QCOMPARE(fixture.view().model()->index(row, 0).data(MemoryModel::AreaRole).toInt(),
                 static_cast<int>(catalog::Area::Feedback));
    QVERIFY(fixture.view().model()->rowCount() > 5);
}

void TestMemoryPage::pollingFollowsTheVisibleRows()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    const auto chooseRate = [&](const char* action) { fixture.child<QAction>(action)->trigger(); };
    chooseRate("liveRate0");
    fixture.goTo(QStringLiteral("firmware_major"));
    fixture.child<QComboBox>("groupFilter")->setCurrentIndex(3); // feedback
    const catalog::Register* voltage =
        fixture.entry().servo.profile->find(QStringLiteral("present_voltage"));
    const catalog::Register* mode =
        fixture.entry().servo.profile->find(QStringLiteral("operating_mode"));
    const auto readAt = [&](const catalog::Register* reg) {
        return *fixture.entry().servo.image.readAt(reg->offset);
    };
    const auto voltageBefore = readAt(voltage);
    const auto modeBefore = readAt(mode);
    chooseRate("liveRate20");
    QTRY_VERIFY(readAt(voltage) > voltageBefore);
    QCOMPARE(readAt(mode), modeBefore);                          // not in sight, so not asked
    fixture.child<QComboBox>("groupFilter")->setCurrentIndex(1); // EPROM
    fixture.goTo(QStringLiteral("operating_mode"));
    QTRY_VERIFY(readAt(mode) > modeBefore);
    // The choice is remembered.
    QCOMPARE(fixture.settings.pageValue(QStringLiteral("memory/live_hz"), 0).toInt(), 20);
}

void TestMemoryPage::historyShowsWrites()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.type(QStringLiteral("position_d"), QStringLiteral("33"));
    QVERIFY(fixture.idle());
    auto* list = fixture.child<QListView>("historyList");
    QTRY_VERIFY(list->model()->rowCount() > 0 &&
                list->model()->index(0, 0).data().toString().contains(QStringLiteral("→ 33 ✓")));
    QVERIFY(list->isVisible());
}

void TestMemoryPage::padlockShowsWhoOpenedIt()
{
    MemoryPageFixture fixture(QStringLiteral("sim:trouble"));
    QVERIFY(fixture.found);
    std::size_t open = 0;
    while (
        open < fixture.workbench.registry().order().size() &&
        fixture.workbench.registry().servo(fixture.workbench.registry().order()[open])->servo.id !=
            4)
        ++open;
    QVERIFY(open < fixture.workbench.registry().order().size());
    QVERIFY(fixture.choose(open));
    auto* badge = fixture.page.findChild<ui::LockBadge*>();
    QTRY_COMPARE(badge->lock(), ui::LockBadge::Lock::OpenByOthers);
    QVERIFY(allText(badge).contains(QStringLiteral("EPROM left unlocked")));
    QVERIFY(badge->toolTip().contains(QStringLiteral("Another program")));
    auto* close = fixture.child<QToolButton>("closeLock");
    QTRY_VERIFY(close->isVisible() && close->isEnabled());
    QTest::mouseClick(close, Qt::LeftButton);
    QTRY_COMPARE(badge->lock(), ui::LockBadge::Lock::Closed);
    QVERIFY(!close->isVisible());
}

void TestMemoryPage::columnsCanBeHidden()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.page.resize(1400, 600);
    const int range = static_cast<int>(MemoryColumn::Range);
    QTRY_VERIFY(!fixture.view().isColumnHidden(range));
    auto* menu = fixture.page.findChild<ui::MemoryToolbar*>()->columnMenu();
    Q_EMIT menu->aboutToShow();
    menu->findChild<QAction*>(QStringLiteral("column_range"))->trigger();
    QVERIFY(fixture.view().isColumnHidden(range));
    fixture.page.resize(1500, 600); // fits its columns again
    QVERIFY(fixture.view().isColumnHidden(range));
    QCOMPARE(
        fixture.settings.pageValue(QStringLiteral("memory/hidden_columns"), QString()).toString(),
        QStringLiteral("range"));
    Q_EMIT menu->aboutToShow();
    auto* again = menu->findChild<QAction*>(QStringLiteral("column_range"));
    QVERIFY(!again->isChecked());
    again->trigger();
    QVERIFY(!fixture.view().isColumnHidden(range));

    // Nothing is typed into a column that is not seen.
    QTest::mouseClick(fixture.child<QAbstractButton>("physicalFirst"), Qt::LeftButton);
    fixture.goTo(QStringLiteral("max_voltage"));
    Q_EMIT menu->aboutToShow();
    menu->findChild<QAction*>(QStringLiteral("column_physical"))->trigger();
    QVERIFY(fixture.view().isColumnHidden(static_cast<int>(MemoryColumn::Physical)));
    QTest::keyClick(&fixture.view(), Qt::Key_Return);
    QVERIFY(fixture.editor());
    QVERIFY(fixture.editor()->height() > 10);
    QTest::keyClick(fixture.editor(), Qt::Key_Escape);
}

void TestMemoryPage::copiesRowsAsText()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.goTo(positionP);
    fixture.commands.action(Command::CopyRows)->trigger();
    const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines.at(1).startsWith(QStringLiteral("21\tposition_p\t")));
}

void TestMemoryPage::exportsTheTable()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    QTemporaryDir folder;
    const auto save = [&](const QString& path) {
        fixture.commands.action(Command::ExportTable)->trigger();
        auto* dialog = fixture.page.findChild<QFileDialog*>(QStringLiteral("exportDialog"));
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(path);
        dialog->reject();
        QTRY_VERIFY(!fixture.page.findChild<QFileDialog*>(QStringLiteral("exportDialog")));
    };
    const QString path = folder.filePath(QStringLiteral("table.csv"));
    save(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray csv = file.readAll();
    QVERIFY(csv.contains(",position_p,"));
    QCOMPARE(csv.count('\n'), fixture.view().model()->rowCount() + 1);
    auto* banner = fixture.child<QWidget>("memoryBanner");
    QVERIFY(allText(banner).contains(path));
    save(folder.filePath(QStringLiteral("no/such/folder.csv")));
    QVERIFY(banner->isVisible());
    QVERIFY(allText(banner).contains(QStringLiteral("cannot be written")));
}

/// The commands work from every page, where the table is not kept up to date.
void TestMemoryPage::otherPagesCopyPresentValues()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.goTo(positionP);
    fixture.page.hide();
    fixture.workbench.writes().write(fixture.selection.current(), {{{positionP, 41}}});
    QVERIFY(fixture.idle());
    QCOMPARE(fixture.entry().servo.raw(positionP), std::optional<std::int64_t>(41));
    fixture.commands.action(Command::CopyRows)->trigger();
    const QString copied = QApplication::clipboard()->text();
    QVERIFY2(copied.contains(QStringLiteral("\t41\t")), qPrintable(copied));
}

void TestMemoryPage::aWriteToAMissingServoEnds()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    fixture.type(positionP, QStringLiteral("44"));
    QTRY_VERIFY(fixture.state(positionP).startsWith(QStringLiteral("✗ ")));
    QVERIFY(!fixture.entry().writing());
    // What is on the screen is marked as old.
    QVERIFY(fixture.at(QStringLiteral("position_d"), MemoryColumn::Value)
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
    MemoryPageFixture fixture(port);
    QVERIFY(fixture.open && fixture.found);
    QVERIFY(fixture.choose());
    fixture.type(key, value);
    QCOMPARE(fixture.question() != nullptr, asks);
    if (asks)
        answer(fixture.question(), "questionYes");
    QVERIFY(fixture.idle());
    QTRY_VERIFY2(fixture.state(key).startsWith(QStringLiteral("✓ kept")),
                 qPrintable(fixture.state(key) +
                            fixture.at(key, MemoryColumn::State).data(Qt::ToolTipRole).toString()));
    QVERIFY(fixture.powerCycle());
    QCOMPARE(fixture.entry().servo.raw(key), value.toLongLong());
}

void TestMemoryPage::changesLanguageWhileOpen()
{
    MemoryPageFixture fixture;
    QVERIFY(fixture.choose());
    fixture.goTo(QStringLiteral("unload_condition"));
    text::installTranslator(QStringLiteral("zh_CN"));
    QTRY_COMPARE(fixture.shown(QStringLiteral("unload_condition"), MemoryColumn::Name),
                 QStringLiteral("卸载条件"));
    QTRY_VERIFY(
        fixture.child<QLabel>("registerTitle")->text().contains(QStringLiteral("卸载条件")));
    text::installTranslator(QStringLiteral("en"));
    QTRY_VERIFY(fixture.child<QLabel>("registerTitle")->text().contains(QStringLiteral("Unload")));
}

SERVODESK_TEST(TestMemoryPage)

#include "tst_memory_page.moc"
