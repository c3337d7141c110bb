// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning page on a simulated bag of servos: opening and starting
// write nothing, one click sets a servo up, the batch grows and can be gone on
// with, labels are copied. What a servo holds is asked of the simulation.
#include "gui/window_bench.h"
#include "record/history.h"
#include "sim/sim_link.h"
#include "support/commission_bench.h"
#include "ui/pages/commission_page.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

namespace {
constexpr int longTime = 60'000;

struct LineBench {
    explicit LineBench(const QString& language = QStringLiteral("en"))
    {
        ui::initProgram();
        languages.apply(language);
        bench.commands.retranslate(); // the program speaks the language before it
                                      // has commands
        themes.apply(session::Theme::Light);
        page = std::make_unique<ui::CommissionPage>(bench, settings);
        page->resize(1000, 640);
        page->show();
    }
    session::Desk& desk() { return bench.desk; }
    bool open()
    {
        desk().connectTo({.name = QStringLiteral("sim:line")});
        return QTest::qWaitFor([this] { return desk().state() == session::LinkState::Open; },
                               longTime);
    }
    template <typename Widget>
    Widget* own(const char* name)
    {
        return page->findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* name)
    {
        auto* button = own<QPushButton>(name);
        QVERIFY2(button != nullptr, name);
        QTRY_VERIFY2_WITH_TIMEOUT(button->isVisible() && button->isEnabled(), name, longTime);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QString headline() { return own<QLabel>("commissionHeadline")->text(); }
    int rows() { return own<QTableView>("commissionTable")->model()->rowCount(); }
    QString cell(int row, int column)
    {
        return own<QTableView>("commissionTable")->model()->index(row, column).data().toString();
    }
    QString batchFile() const { return files.filePath(QStringLiteral("batch.csv")); }
    void fill(int firstId)
    {
        own<QLineEdit>("commissionBatch")->setText(batchFile());
        own<QSpinBox>("commissionFirstId")->setValue(firstId);
    }
    QString nameOf(int id)
    {
        const auto history = record::History::open(session::historyFile());
        const auto servos = (*history)->log().servos();
        for (const record::HistoryServo& one : *servos) {
            if (one.who.id == id)
                return one.label;
        }
        return {};
    }
    bool ends()
    {
        return QTest::qWaitFor([this] { return !page->line().running(); }, longTime);
    }
    int idOf(std::size_t place)
    {
        return desk().connection()->simulation()->with(
            [place](sim::VirtualBus& wire) { return wire.servos()[place]->id(); });
    }

    gui::SteadyClock steady; ///< nothing has just moved
    support::OwnDataFolder place;
    QTemporaryDir files;
    session::Settings settings{files.filePath(QStringLiteral("servodesk.ini"))};
    ui::LanguageSwitch languages;
    ui::ThemeSwitch themes;
    session::Session session;
    ui::Bench bench{session};
    std::unique_ptr<ui::CommissionPage> page; ///< goes first
};
} // namespace

class TestCommissionPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void saysWhyItCannotBegin()
    {
        LineBench bench;
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!bench.own<QLabel>("commissionWhy")->text().isEmpty());
        QVERIFY(!bench.own<QPushButton>("commissionPlug")->isVisible());
        QVERIFY(bench.open());
        // A file is proposed, so that it can be started at once.
        const QString proposed = bench.own<QLineEdit>("commissionBatch")->text();
        QVERIFY(proposed.contains(QDate::currentDate().toString(Qt::ISODate)));
        QVERIFY(!QFile::exists(proposed));
        QTRY_VERIFY(bench.own<QPushButton>("commissionStart")->isEnabled());
        bench.own<QLineEdit>("commissionBatch")->clear();
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
        bench.own<QLineEdit>("commissionBatch")->setText(QString(QChar(0)) + bench.batchFile());
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!bench.own<QLabel>("commissionWhy")->text().isEmpty());
        bench.fill(7);
        QTRY_VERIFY(bench.own<QPushButton>("commissionStart")->isEnabled());
        bench.own<QSpinBox>("commissionLastId")->setValue(3);
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
    }

    /// It falls silent in the middle of its change of ID: counted at once, and named on leaving.
    void aServoThatWentAwayIsCountedAndNamed()
    {
        LineBench bench;
        QVERIFY(bench.open());
        bench.fill(7);
        bench.click("commissionStart");
        bench.click("commissionPlug");
        bench.desk().connection()->simulation()->with([](sim::VirtualBus& wire) {
            wire.config().faults.muteWhen = [](const sim::VirtualServo& servo) {
                return servo.id() == 7;
            };
        });
        bench.click("commissionContinue");
        QTRY_VERIFY_WITH_TIMEOUT(bench.headline().contains(QStringLiteral("same servo")), longTime);
        QTRY_VERIFY(
            bench.own<QLabel>("commissionSum")->text().contains(QStringLiteral("1 unfinished")));
        const auto detail = [&] { return bench.own<QLabel>("commissionDetail")->text(); };
        QTRY_VERIFY2(detail().contains(QStringLiteral("EPROM lock was opened")),
                     qPrintable(detail()));
        QVERIFY2(detail().contains(QStringLiteral("IDs: 1, 7")), qPrintable(detail()));
        QSignalSpy found(&bench.desk(), &session::Desk::unfinishedFound);
        bench.desk().findUnfinished();
        QTRY_COMPARE_WITH_TIMEOUT(found.size(), 1, longTime);
        const auto unfinished = found.front().front().value<session::UnfinishedWrites>();
        QVERIFY(!unfinished.ids.empty());
        QCOMPARE(unfinished.openElsewhere, QStringList{QStringLiteral("1 / 7")});
        bench.click("commissionStop");
        QVERIFY(bench.ends());
        QTRY_VERIFY2(detail().contains(QStringLiteral("EPROM lock was opened")),
                     qPrintable(detail()));
        QVERIFY2(detail().contains(QStringLiteral("IDs: 1, 7")), qPrintable(detail()));
    }

    void oneClickSetsAServoUp()
    {
        LineBench bench;
        QVERIFY(bench.open());
        bench.fill(7);
        bench.click("commissionStart");
        QTRY_VERIFY(bench.headline().contains(QStringLiteral("next servo")));
        QVERIFY(!bench.own<QSpinBox>("commissionFirstId")->isEnabled());
        bench.click("commissionPlug");
        QTRY_VERIFY_WITH_TIMEOUT(bench.own<QPushButton>("commissionContinue")->isVisible(),
                                 longTime);
        QCOMPARE(bench.idOf(0), 1); // nothing before the click
        QCOMPARE(bench.rows(), 0);
        bench.click("commissionContinue");
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows(), 1, longTime);
        QCOMPARE(bench.idOf(0), 7);
        QTRY_VERIFY(bench.headline().contains(QStringLiteral("Unplug: ID 7")));
        auto* saved = bench.own<QLabel>("commissionSaved");
        QVERIFY(saved->isVisible() && QFile::exists(saved->toolTip()));
        QVERIFY(saved->text().contains(QFileInfo(saved->toolTip()).fileName()));
        QVERIFY(bench.own<QTableView>("commissionTable")
                    ->model()
                    ->index(0, 0)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(saved->toolTip()));
        QCOMPARE(bench.nameOf(7), bench.cell(0, 1)); // the history calls it so from now on
        QVERIFY(bench.cell(0, 0).startsWith(QChar(0x2714)));
        bench.click("commissionCopy");
        QCOMPARE(QGuiApplication::clipboard()->text(), QString::fromUtf8("STS3215 · ID 7 · 1 M"));
        bench.click("commissionUnplug");
        QTRY_VERIFY_WITH_TIMEOUT(bench.headline().contains(QStringLiteral("next servo")), longTime);
        bench.click("commissionStop");
        QVERIFY(bench.ends());
        QVERIFY(bench.own<QSpinBox>("commissionFirstId")->isEnabled());

        // Gone on with: ID 7 is known to be given, the next one is set aside by
        // hand.
        bench.click("commissionStart");
        QTRY_COMPARE(bench.rows(), 1);
        bench.click("commissionPlug");
        QTRY_VERIFY_WITH_TIMEOUT(bench.own<QPushButton>("commissionContinue")->isVisible(),
                                 longTime);
        QVERIFY(bench.own<QPushButton>("commissionContinue")->text().contains(QStringLiteral("8")));
        bench.click("commissionAside");
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows(), 2, longTime);
        QCOMPARE(bench.idOf(1), 1);
        bench.click("commissionStop");
        QVERIFY(bench.ends());
    }

    /// A factory servo at the old place of one that was left in the middle may be that one.
    void aServoThatMayHaveBeenBegunIsExplained_data()
    {
        QTest::addColumn<bool>("automatic");
        QTest::newRow("with a click") << false;
        QTest::newRow("without asking") << true;
    }
    void aServoThatMayHaveBeenBegunIsExplained()
    {
        QFETCH(const bool, automatic);
        LineBench bench;
        record::CommissionBatch batch;
        record::CommissionPending begun;
        begun.at = QDateTime::currentDateTimeUtc();
        begun.servo = support::templateOf("sts3215", {}).servo;
        begun.oldBaud = begun.newBaud = 1'000'000;
        begun.newId = 9;
        begun.idSent = true;
        begun.lockOpen = true;
        batch.pending = {begun};
        QVERIFY(record::saveCommissionBatch(batch, bench.batchFile()));
        QVERIFY(bench.open());
        bench.fill(7);
        bench.own<QCheckBox>("commissionAutomatic")->setChecked(automatic);
        bench.click("commissionStart");
        QTRY_VERIFY(bench.headline().contains(QStringLiteral("next servo")));
        bench.click("commissionPlug");
        auto* same = bench.own<QPushButton>("commissionSame");
        QTRY_VERIFY_WITH_TIMEOUT(same->isVisible(), longTime);
        const QString words = bench.own<QLabel>("commissionDetail")->text();
        QVERIFY2(words.contains(QStringLiteral("left unfinished")), qPrintable(words));
        QVERIFY2(words.contains(QStringLiteral("ID 9")), qPrintable(words));
        QVERIFY2(words.contains(same->text()), qPrintable(words));
        QCOMPARE(bench.idOf(0), 1);
        bench.click("commissionSame");
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows(), 1, longTime);
        QCOMPARE(bench.idOf(0), 9);
        QVERIFY(bench.page->line().batch().pending.empty());
        bench.click("commissionStop");
        QVERIFY(bench.ends());
    }

    void aBadTemplateIsToldBeforeAnythingIsWritten()
    {
        LineBench bench;
        QVERIFY(bench.open());
        bench.fill(7);
        bench.own<QLineEdit>("commissionTemplate")->setText(QStringLiteral("/nowhere/t.json"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.own<QFrame>("commissionBanner")->isVisible(), longTime);
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!QFile::exists(bench.batchFile()));
    }

    void theBatchIsShownBeforeTheStart()
    {
        LineBench bench;
        record::CommissionBatch batch;
        record::CommissionRow row;
        row.at = QDateTime::fromSecsSinceEpoch(1'700'000'000, Qt::UTC);
        row.servo.model = QStringLiteral("STS3215");
        row.newId = 7;
        row.label = QStringLiteral("the seventh");
        batch.rows = {row};
        QVERIFY(record::saveCommissionBatch(batch, bench.batchFile()));
        bench.fill(7);
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows(), 1, longTime);
        QCOMPARE(bench.cell(0, 1), row.label);
        QVERIFY(!bench.own<QFrame>("commissionBanner")->isVisible());

        QVERIFY(bench.open());
        const QString broken = bench.files.filePath(QStringLiteral("broken.csv"));
        QFile state(record::commissionStatePath(broken));
        QVERIFY(state.open(QIODevice::WriteOnly) && state.write("{\"format\":") > 0);
        state.close();
        bench.own<QLineEdit>("commissionBatch")->setText(broken);
        QTRY_VERIFY_WITH_TIMEOUT(bench.own<QFrame>("commissionBanner")->isVisible(), longTime);
        QCOMPARE(bench.rows(), 0);
        QVERIFY(!bench.own<QPushButton>("commissionStart")->isEnabled());
        bench.fill(7);
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows(), 1, longTime);
        QTRY_VERIFY(bench.own<QPushButton>("commissionStart")->isEnabled());
    }

    void dangerousRowsAreAskedForOnce()
    {
        LineBench bench;
        QVERIFY(bench.open());
        const QString file = bench.files.filePath(QStringLiteral("t.servo.json"));
        QVERIFY(record::saveSnapshot(
            support::templateOf("sts3215", {{"position_p", 24}, {"angle_resolution", 0}}), file));
        bench.fill(7);
        auto* too = bench.own<QCheckBox>("commissionDangerous");
        QVERIFY(!too->isVisible());
        bench.own<QLineEdit>("commissionTemplate")->setText(file);
        QTRY_VERIFY_WITH_TIMEOUT(too->isVisible(), longTime);
        too->setChecked(true);
        const auto question = [&](const char* name) {
            return QTest::qWaitFor([&] { return bench.own<QPushButton>(name) != nullptr; },
                                   longTime);
        };
        bench.click("commissionStart");
        QVERIFY(question("questionNo"));
        bench.own<QPushButton>("questionNo")->click();
        QTRY_VERIFY(bench.own<QPushButton>("questionNo") == nullptr);
        QVERIFY(!bench.page->line().running());
        bench.click("commissionStart");
        QVERIFY(question("questionYes"));
        bench.own<QPushButton>("questionYes")->click();
        QTRY_VERIFY(bench.headline().contains(QStringLiteral("next servo")));
        bench.click("commissionStop");
        QVERIFY(bench.ends());
    }

    void closingThePortEndsTheLine()
    {
        LineBench bench;
        QVERIFY(bench.open());
        bench.fill(7);
        bench.own<QCheckBox>("commissionAutomatic")->setChecked(true);
        bench.click("commissionStart");
        QTRY_VERIFY(bench.headline().contains(QStringLiteral("next servo")));
        bench.desk().disconnectFrom();
        QVERIFY(bench.ends());
    }

    void everyFieldHasItsName()
    {
        LineBench bench;
        for (const char* name : {"commissionBatch", "commissionTemplate", "commissionLabel"}) {
            auto* field = bench.own<QLineEdit>(name);
            QVERIFY(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty());
            const QString words = field->accessibleName();
            const auto labels = bench.page->findChildren<QLabel*>();
            const auto shown = [&](const QLabel* one) { return one->text() == words; };
            QVERIFY2(std::any_of(labels.begin(), labels.end(), shown), name);
        }
    }
};

QTEST_MAIN(TestCommissionPage)
#include "tst_commission_page.moc"
