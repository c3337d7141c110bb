// SPDX-License-Identifier: GPL-3.0-or-later
// The search as a technician sees it: estimate, progress, stop, servos as they are found, trouble
// marked, and where nobody answers, why that may be.
#include "gui/desk_bench.h"
#include "text/language.h"
#include "ui/models/servo_list_model.h"
#include "ui/pages/search_panel.h"
#include "ui/widgets/thin_progress.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>

using ui::Command;

namespace {
struct Bench : gui::DeskBench {
    ui::SearchPanel panel{desk, commands, selection, settings};

    explicit Bench(const QString& port = {})
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
        return desk.searching() && QTest::qWaitFor([this] { return !desk.searching(); }, 60000);
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
    bool checklistShown() const { return find<QScrollArea>("checklistScroll")->isVisible(); }
};
} // namespace

class TestSearchPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void nothingCanBeSearchedWithoutAPort();
    void theEstimateComesFirst();
    void servosAppear();
    void progressIsShownAndStops();
    void troubleIsMarked();
    void otherRatesAreSearched();
    void anEmptyBusIsExplained();
    void theChecklistLeavesRoomForCommissioning();
    void wideningFromTheChecklist();
    void missingOnesAreExplained();
    void selectionBothWays();
    void severalAreChosenTogether();
    void theMenuIsOfTheSelected();
    void choicesAreRemembered();
    void nonsenseInTheSettingsIsHarmless();
    void losingThePortEndsIt();
    void theLanguageIsFollowed();
};

void TestSearchPanel::nothingCanBeSearchedWithoutAPort()
{
    Bench bench;
    QVERIFY(!bench.find<QPushButton>("searchButton")->isEnabled());
    QVERIFY(!bench.find<QPushButton>("stopSearchButton")->isEnabled());
    QVERIFY(bench.find<QLabel>("servoListEmpty")->isVisible());
}

void TestSearchPanel::theEstimateComesFirst()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(0, 253);
    const QString all = bench.find<QLabel>("searchEstimate")->text();
    QVERIFY2(all.contains(QStringLiteral("254")) && all.contains(QStringLiteral("about")),
             qPrintable(all));
    bench.find<QComboBox>("searchRates")->setCurrentIndex(2);
    const QString everywhere = bench.find<QLabel>("searchEstimate")->text();
    QVERIFY2(everywhere.contains(QStringLiteral("rates: 14")), qPrintable(everywhere));
    QVERIFY(everywhere != all);
    QVERIFY(!bench.desk.searching());
}

void TestSearchPanel::servosAppear()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(6, 0); // the wrong way round: what is meant is clear
    QSignalSpy rows(bench.list()->model(), &QAbstractItemModel::rowsInserted);
    QVERIFY(bench.searched());
    QCOMPARE(rows.count(), 6); // one by one
    QVERIFY(bench.list()->isVisible());
    QVERIFY(!bench.checklistShown());
    QVERIFY2(bench.status().contains(QStringLiteral("servos: 6")), qPrintable(bench.status()));
    QCOMPARE(bench.selection.current(), 0); // searching selects nothing
}

void TestSearchPanel::progressIsShownAndStops()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(0, 253);
    bench.find<QComboBox>("searchRates")->setCurrentIndex(2);
    bench.find<QPushButton>("searchButton")->click();
    auto* bar = bench.find<ui::ThinProgress>("searchProgress");
    QTRY_VERIFY_WITH_TIMEOUT(bar->value() > bar->minimum() && bar->value() < bar->maximum(), 10000);
    QVERIFY2(bench.status().contains(QStringLiteral("left")), qPrintable(bench.status()));
    auto* stop = bench.find<QPushButton>("stopSearchButton");
    QVERIFY(stop->isEnabled());
    QElapsedTimer took;
    took.start();
    bench.desk.stopSearch(); // what Command::StopSearch does in the window
    QTRY_VERIFY(!bench.desk.searching());
    QVERIFY2(took.elapsed() < 100, qPrintable(QString::number(took.elapsed())));
    QTRY_VERIFY(bench.status().startsWith(QStringLiteral("Stopped")));
    QVERIFY(!stop->isEnabled());
    QVERIFY(!bench.checklistShown()); // it was the user who ended it
}

void TestSearchPanel::troubleIsMarked()
{
    Bench bench(QStringLiteral("sim:trouble"));
    bench.setIds(0, 10);
    QVERIFY(bench.searched());
    const auto tip = [&](int id) { return bench.index(id).data(Qt::ToolTipRole).toString(); };
    QVERIFY2(tip(1).contains(QStringLiteral("Two servos with this ID?")), qPrintable(tip(1)));
    QVERIFY2(tip(4).contains(QStringLiteral("EPROM lock open")), qPrintable(tip(4)));
    QVERIFY2(tip(5).contains(QStringLiteral("overload")), qPrintable(tip(5)));
}

void TestSearchPanel::otherRatesAreSearched()
{
    Bench bench(QStringLiteral("sim:trouble"));
    bench.setIds(2, 3);
    bench.find<QComboBox>("searchRates")->setCurrentIndex(1); // chosen: 1 M and 115200 at first
    auto* rates = bench.panel.findChild<QListWidget*>(QStringLiteral("rateList"));
    for (int row = 0; row < rates->count(); ++row) {
        const int rate = rates->item(row)->data(Qt::UserRole).toInt();
        rates->item(row)->setCheckState(rate == 500000 || rate == 115200 ? Qt::Checked
                                                                         : Qt::Unchecked);
    }
    bench.find<QComboBox>("searchProtocol")->setCurrentIndex(2); // Feetech
    QVERIFY(bench.searched());
    QCOMPARE(bench.list()->model()->rowCount(), 2);
    QCOMPARE(bench.index(2).siblingAtColumn(ui::ServoListModel::Rate).data().toString(),
             QStringLiteral("500 k"));
    QCOMPARE(bench.index(3).siblingAtColumn(ui::ServoListModel::Rate).data().toString(),
             QStringLiteral("115200"));
    QCOMPARE(bench.desk.baud(), 1000000); // as before
}

void TestSearchPanel::anEmptyBusIsExplained()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(100, 110);
    QVERIFY(bench.searched());
    QTRY_VERIFY(bench.checklistShown());
    for (int row = 1; row <= 5; ++row) {
        const auto* heading =
            bench.find<QToolButton>(qPrintable(QStringLiteral("checklistRow%1").arg(row)));
        QVERIFY(heading != nullptr);
        QCOMPARE(heading->isChecked(), row <= 2); // what fits is open, the rest one click away
    }
    QVERIFY(bench.find<QCheckBox>("check1_ids") != nullptr);
    QVERIFY(bench.find<QCheckBox>("check1_rate") != nullptr);
    QVERIFY(bench.find<QCheckBox>("check1_protocol") != nullptr); // at 1 M only Feetech is met
    QVERIFY(bench.find<QCheckBox>("check1_driver") == nullptr);   // ruled out
    QVERIFY(bench.find<QCheckBox>("check1_supply") == nullptr);   // simulated
    QStringList words;
    for (const QLabel* label : bench.find<QWidget>("checklist")->findChildren<QLabel*>())
        words << label->text();
    const QString all = words.join(u'\n');
    QVERIFY2(all.contains(QStringLiteral("100–110")), qPrintable(all));
    QVERIFY(all.contains(QStringLiteral("The port was opened")));
    bench.find<QPushButton>("whyButton")->click();
    QVERIFY(!bench.checklistShown());
}

/// "Nothing found" of a search before is no news while servos are set up one by one.
void TestSearchPanel::theChecklistLeavesRoomForCommissioning()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(100, 110);
    QVERIFY(bench.searched());
    QTRY_VERIFY(bench.checklistShown());
    session::Task line;
    line.name = QStringLiteral("commission");
    line.lasting = true;
    line.quiet = true;
    line.work = [](session::TaskContext& context) -> base::Result<void> {
        while (!context.stop.requested())
            context.device.bus.clock().sleepFor(std::chrono::milliseconds(5));
        return {};
    };
    bench.desk.perform(0, std::move(line));
    QTRY_VERIFY(!bench.checklistShown());
    QVERIFY2(bench.status().contains(QLatin1String("Commissioning is running")),
             qPrintable(bench.status()));
    bench.desk.stopTask();
    QTRY_VERIFY(!bench.status().contains(QLatin1String("Commissioning")));
}

void TestSearchPanel::wideningFromTheChecklist()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(100, 110);
    QVERIFY(bench.searched());
    QTRY_VERIFY(bench.checklistShown());
    bench.find<QPushButton>("searchWider")->click();
    QVERIFY(bench.desk.searching());
    QCOMPARE(bench.desk.lastSearchSpec().firstId, 0);
    QCOMPARE(bench.desk.lastSearchSpec().lastId, 253);
    QCOMPARE(bench.desk.lastSearchSpec().bauds.size(), session::knownRates().size());
    QCOMPARE(bench.desk.lastSearchSpec().protocols.size(), base::allProtocols.size());
    QTRY_COMPARE_WITH_TIMEOUT(bench.list()->model()->rowCount(), 6, 20000);
    QVERIFY(!bench.checklistShown());
    bench.desk.stopSearch();
    QTRY_VERIFY(!bench.desk.searching());
}

void TestSearchPanel::missingOnesAreExplained()
{
    Bench bench(QStringLiteral("sim:trouble"));
    bench.setIds(1, 5);
    QVERIFY(bench.searched());
    auto* why = bench.find<QPushButton>("whyButton");
    QVERIFY(why->isVisible());
    QVERIFY(!bench.checklistShown());
    why->click();
    QVERIFY(bench.checklistShown());
    QVERIFY(bench.find<QToolButton>("checklistRow3")->isChecked());
    QVERIFY(bench.find<QToolButton>("checklistRow4")->isChecked()); // twins at ID 1
    QVERIFY(!bench.find<QToolButton>("checklistRow1")->isChecked());
    // What was ticked off stays so in the other language.
    bench.find<QCheckBox>("check3_rate")->setChecked(true);
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(bench.find<QWidget>("checklist"), &change);
    QVERIFY(bench.find<QCheckBox>("check3_rate")->isChecked());
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    QVERIFY(bench.find<QCheckBox>("check3_rate")->accessibleName().contains(han));
}

void TestSearchPanel::selectionBothWays()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(1, 6);
    QVERIFY(bench.searched());
    QTest::mouseClick(bench.list()->viewport(), Qt::LeftButton, {},
                      bench.list()->visualRect(bench.index(3)).center());
    QCOMPARE(bench.selection.current(), bench.ref(3));
    QTest::keyClick(bench.list(), Qt::Key_Down);
    QCOMPARE(bench.selection.current(), bench.ref(4));
    bench.selection.select(bench.ref(1));
    QCOMPARE(bench.list()->currentIndex(), bench.index(1));
    bench.selection.select(0);
    QVERIFY(!bench.list()->selectionModel()->hasSelection());
    QCOMPARE(bench.selection.current(), 0);
    // A search that finds it again changes nothing.
    bench.selection.select(bench.ref(2));
    QVERIFY(bench.searched());
    QCOMPARE(bench.selection.current(), bench.ref(2));
    QCOMPARE(bench.list()->currentIndex(), bench.index(2));
}

void TestSearchPanel::severalAreChosenTogether()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(1, 6);
    QVERIFY(bench.searched());
    const auto click = [&](int id, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(bench.list()->viewport(), Qt::LeftButton, keys,
                          bench.list()->visualRect(bench.index(id)).center());
    };
    const auto chosen = [&] { return bench.selection.chosen(); };
    using Refs = std::vector<session::ServoRef>;
    click(3, {});
    QSignalSpy current(&bench.selection, &ui::Selection::changed);
    click(1, Qt::ControlModifier);
    QCOMPARE(chosen(), (Refs{bench.ref(3), bench.ref(1)}));
    QCOMPARE(current.count(), 0); // the page stays with the one it shows
    click(3, Qt::ControlModifier);
    QCOMPARE(chosen(), (Refs{bench.ref(1)}));
    QCOMPARE(bench.selection.current(), bench.ref(1));
    click(1, {});
    click(3, Qt::ShiftModifier);
    QCOMPARE(chosen().size(), std::size_t(3));
    QCOMPARE(chosen().front(), bench.ref(1));
    bench.selection.select(bench.ref(2));
    QCOMPARE(bench.list()->selectionModel()->selectedIndexes().size(), 1);
}

void TestSearchPanel::theMenuIsOfTheSelected()
{
    Bench bench(QStringLiteral("sim:sts3215@1"));
    bench.setIds(0, 2);
    QVERIFY(bench.searched());
    bench.selection.select(bench.ref(1));
    Q_EMIT bench.list()->customContextMenuRequested(
        bench.list()->visualRect(bench.index(1)).center());
    const QPointer<QMenu> menu = bench.find<QMenu>("servoMenu");
    QVERIFY(menu != nullptr && menu->isVisible());
    for (const Command command :
         {Command::ReadTable, Command::SetId, Command::SetBaud, Command::Center, Command::Identify,
          Command::RestoreDefaults, Command::Reboot, Command::ClearAlarm})
        QVERIFY(menu->actions().contains(bench.action(command)));
    menu->close();
    QTRY_VERIFY(menu == nullptr);
}

void TestSearchPanel::choicesAreRemembered()
{
    Bench bench;
    bench.setIds(7, 42);
    bench.find<QComboBox>("searchRates")->setCurrentIndex(1);
    bench.find<QComboBox>("searchProtocol")->setCurrentIndex(4);
    bench.find<QCheckBox>("searchSlowly")->setChecked(true);
    ui::SearchPanel later(bench.desk, bench.commands, bench.selection, bench.settings);
    QCOMPARE(later.findChild<QSpinBox*>(QStringLiteral("firstId"))->value(), 7);
    QCOMPARE(later.findChild<QSpinBox*>(QStringLiteral("lastId"))->value(), 42);
    QCOMPARE(later.findChild<QComboBox*>(QStringLiteral("searchRates"))->currentIndex(), 1);
    QCOMPARE(later.findChild<QComboBox*>(QStringLiteral("searchProtocol"))->currentIndex(), 4);
    QVERIFY(later.findChild<QCheckBox*>(QStringLiteral("searchSlowly"))->isChecked());
}

void TestSearchPanel::nonsenseInTheSettingsIsHarmless()
{
    gui::DeskBench bench;
    bench.settings.setChoice(QStringLiteral("search/first_id"), 9000);
    bench.settings.setChoice(QStringLiteral("search/last_id"), QStringLiteral("many"));
    bench.settings.setChoice(QStringLiteral("search/rates"), -3);
    bench.settings.setChoice(QStringLiteral("search/protocol"), 77);
    bench.settings.setChoice(QStringLiteral("search/chosen_rates"),
                             QStringList{QStringLiteral("fast"), QStringLiteral("-1")});
    const ui::SearchPanel panel(bench.desk, bench.commands, bench.selection, bench.settings);
    QVERIFY(panel.findChild<QSpinBox*>(QStringLiteral("firstId"))->value() <= 253);
    QVERIFY(panel.findChild<QComboBox*>(QStringLiteral("searchRates"))->currentIndex() >= 0);
    QVERIFY(panel.findChild<QComboBox*>(QStringLiteral("searchProtocol"))->currentIndex() >= 0);
}

void TestSearchPanel::losingThePortEndsIt()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(0, 253);
    bench.find<QPushButton>("searchButton")->click();
    QVERIFY(bench.desk.searching());
    bench.desk.disconnectFrom();
    QTRY_COMPARE(bench.desk.state(), session::LinkState::Off);
    QVERIFY(!bench.desk.searching());
    QVERIFY(!bench.find<QPushButton>("searchButton")->isEnabled());
    QVERIFY(!bench.checklistShown());
}

void TestSearchPanel::theLanguageIsFollowed()
{
    Bench bench(QStringLiteral("sim:demo"));
    bench.setIds(1, 6);
    QVERIFY(bench.searched());
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(&bench.panel, &change);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    for (const QString& words :
         {bench.find<QPushButton>("searchButton")->text(), bench.status(),
          bench.find<QPushButton>("whyButton")->text(),
          bench.index(6).siblingAtColumn(ui::ServoListModel::Alarm).data().toString()})
        QVERIFY2(words.contains(han), qPrintable(words));
}

QTEST_MAIN(TestSearchPanel)
#include "tst_search_panel.moc"
