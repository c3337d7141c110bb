// SPDX-License-Identifier: GPL-3.0-or-later
// The search as a technician sees it: estimate, progress, stop, servos as they are found, marked
// problems, and the possible reasons if no servo answers.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/search/search_panel.h"
#include "ui/search/servo_list_model.h"
#include "ui/widgets/thin_progress.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using ui::Command;

namespace {
struct SearchPanelFixture : gui::WorkbenchFixture {
    ui::SearchPanel panel{workbench, commands, selection, settings};

    explicit SearchPanelFixture(const QString& port = {})
    {
        panel.resize(300, 700);
        panel.show();
        if (!port.isEmpty() && !open(port))
            qFatal("no port");
    }

    template <typename Widget>
    Widget* find(const char* name) const
    {
        return panel.findChild<Widget*>(QString::fromLatin1(name));
    }
    void setIds(int first, int last) const
    {
        find<QSpinBox>("firstId")->setValue(first);
        find<QSpinBox>("lastId")->setValue(last);
    }
    bool searched()
    {
        find<QPushButton>("searchButton")->click();
        return workbench.search().isSearching() &&
               support::waitFor([this] { return !workbench.search().isSearching(); });
    }
    QListView* list() const { return find<QListView>("servoList"); }
    QModelIndex index(int id) const
    {
        for (int row = 0; row < list()->model()->rowCount(); ++row) {
            const QModelIndex one = list()->model()->index(row, 0);
            if (one.data().toInt() == id)
                return one;
        }
        return {};
    }
    QString status() const { return find<QLabel>("searchStatus")->text(); }
};
} // namespace

class TestSearchPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void searchNeedsAPort();
    void theEstimateComesFirst();
    void foundServosAppear();
    void progressIsShownAndStops();
    void problemsAreMarked();
    void otherRatesAreSearched();
    void anEmptyBusLeadsToTheDiagnosis();
    void commissioningHidesTheWayToTheDiagnosis();
    void missingServosLeadToTheDiagnosis();
    void selectionSyncsBothWays();
    void severalServosAreSelectedTogether();
    void theMenuActsOnTheSelection();
    void searchSettingsAreRemembered();
    void invalidSettingsAreHarmless();
    void losingThePortEndsTheSearch();
    void followsTheLanguage();
};

void TestSearchPanel::searchNeedsAPort()
{
    SearchPanelFixture fixture;
    QVERIFY(!fixture.find<QPushButton>("searchButton")->isEnabled());
    QVERIFY(!fixture.find<QPushButton>("stopSearchButton")->isEnabled());
    QVERIFY(fixture.find<QLabel>("servoListEmpty")->isVisible());
}

void TestSearchPanel::theEstimateComesFirst()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(0, 253);
    const QString all = fixture.find<QLabel>("searchEstimate")->text();
    QVERIFY2(all.contains(QStringLiteral("254")) && all.contains(QStringLiteral("about")),
             qPrintable(all));
    fixture.find<QComboBox>("searchRates")->setCurrentIndex(2);
    const QString everywhere = fixture.find<QLabel>("searchEstimate")->text();
    QVERIFY2(everywhere.contains(QStringLiteral("rates: 14")), qPrintable(everywhere));
    QVERIFY(everywhere != all);
    QVERIFY(!fixture.workbench.search().isSearching());
}

void TestSearchPanel::foundServosAppear()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(6, 0); // the wrong way round: what is meant is clear
    QSignalSpy rows(fixture.list()->model(), &QAbstractItemModel::rowsInserted);
    QVERIFY(fixture.searched());
    QCOMPARE(rows.count(), 6); // one by one
    QVERIFY(fixture.list()->isVisible());
    QVERIFY2(fixture.status().contains(QStringLiteral("6 servos")), qPrintable(fixture.status()));
    QCOMPARE(fixture.selection.current(), 0); // searching selects nothing
}

void TestSearchPanel::progressIsShownAndStops()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(0, 253);
    fixture.find<QComboBox>("searchRates")->setCurrentIndex(2);
    fixture.find<QPushButton>("searchButton")->click();
    auto* bar = fixture.find<ui::ThinProgress>("searchProgress");
    QTRY_VERIFY(bar->value() > bar->minimum() && bar->value() < bar->maximum());
    QVERIFY2(fixture.status().contains(QStringLiteral("left")), qPrintable(fixture.status()));
    auto* stop = fixture.find<QPushButton>("stopSearchButton");
    QVERIFY(stop->isEnabled());
    QElapsedTimer took;
    took.start();
    fixture.workbench.search().stop(); // what Command::StopSearch does in the window
    QTRY_VERIFY(!fixture.workbench.search().isSearching());
    QVERIFY2(took.elapsed() < 100, qPrintable(QString::number(took.elapsed())));
    QTRY_VERIFY(fixture.status().startsWith(QStringLiteral("Stopped")));
    QVERIFY(!stop->isEnabled());
}

void TestSearchPanel::problemsAreMarked()
{
    SearchPanelFixture fixture(QStringLiteral("sim:trouble"));
    fixture.setIds(0, 10);
    QVERIFY(fixture.searched());
    const auto tip = [&](int id) { return fixture.index(id).data(Qt::ToolTipRole).toString(); };
    QVERIFY2(tip(1).contains(QStringLiteral("Two servos with this ID?")), qPrintable(tip(1)));
    QVERIFY2(tip(4).contains(QStringLiteral("EPROM unlocked")), qPrintable(tip(4)));
    QVERIFY2(tip(5).contains(QStringLiteral("overload")), qPrintable(tip(5)));
}

void TestSearchPanel::otherRatesAreSearched()
{
    SearchPanelFixture fixture(QStringLiteral("sim:trouble"));
    fixture.setIds(2, 3);
    fixture.find<QComboBox>("searchRates")->setCurrentIndex(1); // chosen: 1 M and 115200 at first
    auto* rates = fixture.panel.findChild<QListWidget*>(QStringLiteral("rateList"));
    for (int row = 0; row < rates->count(); ++row) {
        const int rate = rates->item(row)->data(Qt::UserRole).toInt();
        rates->item(row)->setCheckState(rate == 500000 || rate == 115200 ? Qt::Checked
                                                                         : Qt::Unchecked);
    }
    fixture.find<QComboBox>("searchProtocol")->setCurrentIndex(2); // Feetech
    QVERIFY(fixture.searched());
    QCOMPARE(fixture.list()->model()->rowCount(), 2);
    QCOMPARE(fixture.index(2).siblingAtColumn(ui::ServoListModel::Rate).data().toString(),
             QStringLiteral("500 k"));
    QCOMPARE(fixture.index(3).siblingAtColumn(ui::ServoListModel::Rate).data().toString(),
             QStringLiteral("115200"));
    QCOMPARE(fixture.workbench.link().baud(), 1000000); // as before
}

void TestSearchPanel::anEmptyBusLeadsToTheDiagnosis()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    auto* findOut = fixture.find<QPushButton>("findOutButton");
    QVERIFY(!findOut->isVisible());
    fixture.setIds(100, 110);
    QVERIFY(fixture.searched());
    QTRY_VERIFY(findOut->isVisible());
    QCOMPARE(fixture.find<QLabel>("servoListEmpty")->text(), QStringLiteral("No servo replied."));
    QVERIFY(!fixture.find<QPushButton>("whyButton")->isVisible());
    QSignalSpy asked(fixture.action(Command::Diagnose), &QAction::triggered);
    findOut->click();
    QCOMPARE(asked.count(), 1);
}

/// "Nothing found" of an earlier search is not shown while servos are set up one by one.
void TestSearchPanel::commissioningHidesTheWayToTheDiagnosis()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(100, 110);
    QVERIFY(fixture.searched());
    auto* findOut = fixture.find<QPushButton>("findOutButton");
    QTRY_VERIFY(findOut->isVisible());
    session::Task line;
    line.name = QStringLiteral("commission");
    line.isLongRunning = true;
    line.quiet = true;
    line.work = [](session::TaskContext& context) -> base::Result<void> {
        while (!context.stop.isRequested())
            context.device.bus.clock().sleepFor(std::chrono::milliseconds(5));
        return {};
    };
    fixture.workbench.tasks().perform(0, std::move(line));
    QTRY_VERIFY(!findOut->isVisible());
    QVERIFY2(fixture.status().contains(QLatin1String("Commissioning is running")),
             qPrintable(fixture.status()));
    fixture.workbench.tasks().stop();
    QTRY_VERIFY(!fixture.status().contains(QLatin1String("Commissioning")));
}

void TestSearchPanel::missingServosLeadToTheDiagnosis()
{
    SearchPanelFixture fixture(QStringLiteral("sim:trouble"));
    fixture.setIds(1, 5);
    auto* why = fixture.find<QPushButton>("whyButton");
    QVERIFY(!why->isVisible());
    QVERIFY(fixture.searched());
    QTRY_VERIFY(why->isVisible());
    QSignalSpy asked(fixture.action(Command::Diagnose), &QAction::triggered);
    why->click();
    QCOMPARE(asked.count(), 1);
}

void TestSearchPanel::selectionSyncsBothWays()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(1, 6);
    QVERIFY(fixture.searched());
    QTest::mouseClick(fixture.list()->viewport(), Qt::LeftButton, {},
                      fixture.list()->visualRect(fixture.index(3)).center());
    QCOMPARE(fixture.selection.current(), fixture.ref(3));
    QTest::keyClick(fixture.list(), Qt::Key_Down);
    QCOMPARE(fixture.selection.current(), fixture.ref(4));
    fixture.selection.select(fixture.ref(1));
    QCOMPARE(fixture.list()->currentIndex(), fixture.index(1));
    fixture.selection.select(0);
    QVERIFY(!fixture.list()->selectionModel()->hasSelection());
    QCOMPARE(fixture.selection.current(), 0);
    // A search that finds it again changes nothing.
    fixture.selection.select(fixture.ref(2));
    QVERIFY(fixture.searched());
    QCOMPARE(fixture.selection.current(), fixture.ref(2));
    QCOMPARE(fixture.list()->currentIndex(), fixture.index(2));
}

void TestSearchPanel::severalServosAreSelectedTogether()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(1, 6);
    QVERIFY(fixture.searched());
    const auto click = [&](int id, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(fixture.list()->viewport(), Qt::LeftButton, keys,
                          fixture.list()->visualRect(fixture.index(id)).center());
    };
    const auto chosen = [&] { return fixture.selection.selected(); };
    using Refs = std::vector<session::ServoRef>;
    click(3, {});
    QSignalSpy current(&fixture.selection, &ui::Selection::changed);
    click(1, Qt::ControlModifier);
    QCOMPARE(chosen(), (Refs{fixture.ref(3), fixture.ref(1)}));
    QCOMPARE(current.count(), 0); // the page stays with the one it shows
    click(3, Qt::ControlModifier);
    QCOMPARE(chosen(), (Refs{fixture.ref(1)}));
    QCOMPARE(fixture.selection.current(), fixture.ref(1));
    click(1, {});
    click(3, Qt::ShiftModifier);
    QCOMPARE(chosen().size(), std::size_t(3));
    QCOMPARE(chosen().front(), fixture.ref(1));
    fixture.selection.select(fixture.ref(2));
    QCOMPARE(fixture.list()->selectionModel()->selectedIndexes().size(), 1);
}

void TestSearchPanel::theMenuActsOnTheSelection()
{
    SearchPanelFixture fixture(QStringLiteral("sim:sts3215@1"));
    fixture.setIds(0, 2);
    QVERIFY(fixture.searched());
    fixture.selection.select(fixture.ref(1));
    Q_EMIT fixture.list()->customContextMenuRequested(
        fixture.list()->visualRect(fixture.index(1)).center());
    const QPointer<QMenu> menu = fixture.find<QMenu>("servoMenu");
    QVERIFY(menu != nullptr && menu->isVisible());
    for (const Command command :
         {Command::ReadTable, Command::SetId, Command::SetBaud, Command::Center, Command::Identify,
          Command::RestoreDefaults, Command::Reboot, Command::ClearAlarm})
        QVERIFY(menu->actions().contains(fixture.action(command)));
    menu->close();
    QTRY_VERIFY(menu == nullptr);
}

void TestSearchPanel::searchSettingsAreRemembered()
{
    SearchPanelFixture fixture;
    fixture.setIds(7, 42);
    fixture.find<QComboBox>("searchRates")->setCurrentIndex(1);
    fixture.find<QComboBox>("searchProtocol")->setCurrentIndex(4);
    fixture.find<QCheckBox>("searchSlowly")->setChecked(true);
    ui::SearchPanel later(fixture.workbench, fixture.commands, fixture.selection, fixture.settings);
    QCOMPARE(later.findChild<QSpinBox*>(QStringLiteral("firstId"))->value(), 7);
    QCOMPARE(later.findChild<QSpinBox*>(QStringLiteral("lastId"))->value(), 42);
    QCOMPARE(later.findChild<QComboBox*>(QStringLiteral("searchRates"))->currentIndex(), 1);
    QCOMPARE(later.findChild<QComboBox*>(QStringLiteral("searchProtocol"))->currentIndex(), 4);
    QVERIFY(later.findChild<QCheckBox*>(QStringLiteral("searchSlowly"))->isChecked());
}

void TestSearchPanel::invalidSettingsAreHarmless()
{
    gui::WorkbenchFixture fixture;
    fixture.settings.setPageValue(QStringLiteral("search/first_id"), 9000);
    fixture.settings.setPageValue(QStringLiteral("search/last_id"), QStringLiteral("many"));
    fixture.settings.setPageValue(QStringLiteral("search/rates"), -3);
    fixture.settings.setPageValue(QStringLiteral("search/protocol"), 77);
    fixture.settings.setPageValue(QStringLiteral("search/chosen_rates"),
                                  QStringList{QStringLiteral("fast"), QStringLiteral("-1")});
    const ui::SearchPanel panel(fixture.workbench, fixture.commands, fixture.selection,
                                fixture.settings);
    QVERIFY(panel.findChild<QSpinBox*>(QStringLiteral("firstId"))->value() <= 253);
    QVERIFY(panel.findChild<QComboBox*>(QStringLiteral("searchRates"))->currentIndex() >= 0);
    QVERIFY(panel.findChild<QComboBox*>(QStringLiteral("searchProtocol"))->currentIndex() >= 0);
}

void TestSearchPanel::losingThePortEndsTheSearch()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(0, 253);
    fixture.find<QPushButton>("searchButton")->click();
    QVERIFY(fixture.workbench.search().isSearching());
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QVERIFY(!fixture.workbench.search().isSearching());
    QVERIFY(!fixture.find<QPushButton>("searchButton")->isEnabled());
}

void TestSearchPanel::followsTheLanguage()
{
    SearchPanelFixture fixture(QStringLiteral("sim:demo"));
    fixture.setIds(1, 6);
    QVERIFY(fixture.searched());
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&fixture.panel, &change);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    for (const QString& words :
         {fixture.find<QPushButton>("searchButton")->text(), fixture.status(),
          fixture.find<QPushButton>("whyButton")->text(),
          fixture.index(6).siblingAtColumn(ui::ServoListModel::Alarm).data().toString()})
        QVERIFY2(words.contains(han), qPrintable(words));
}

SERVODESK_TEST(TestSearchPanel)
#include "tst_search_panel.moc"
