// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning page on a simulated bag of servos: opening and starting
// write nothing, one click sets a servo up, the batch grows and can be gone on
// with, labels are copied. What a servo holds is asked of the simulation.
#include "gui/main_window_fixture.h"
#include "history/history.h"
#include "session/paths.h"
#include "sim/host/sim_link.h"
#include "support/commission_fixture.h"
#include "support/test_main.h"
#include "ui/commissioning/commission_page.h"
#include "ui/widgets/step_strip.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

namespace {

struct CommissionPageFixture {
    explicit CommissionPageFixture(const QString& language = QStringLiteral("en"))
    {
        ui::initProgram();
        languages.apply(language);
        context.commands.retranslate(); // the program speaks the language before it
                                        // has commands
        themes.apply(session::Theme::Light);
        page = std::make_unique<ui::CommissionPage>(context, settings);
        page->resize(1000, 640);
        page->show();
    }
    session::Workbench& workbench() { return context.workbench; }
    bool open()
    {
        workbench().link().connectTo({.name = QStringLiteral("sim:line")});
        return support::waitFor(
            [this] { return workbench().link().state() == session::LinkState::Open; });
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
        QTRY_VERIFY2(button->isVisible() && button->isEnabled(), name);
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
        const auto history = history::History::open(session::historyFile());
        const auto servos = (*history)->log().servos();
        for (const history::HistoryServo& one : *servos) {
            if (one.identity.id == id)
                return one.label;
        }
        return {};
    }
    bool ends()
    {
        return support::waitFor([this] { return !page->commissioning().isRunning(); });
    }
    int idOf(std::size_t place)
    {
        return workbench().link().connection()->simulation()->with(
            [place](sim::VirtualBus& wire) { return wire.servos()[place]->id(); });
    }

    gui::AdvancingClock steady; ///< nothing has just moved
    support::TemporaryDataFolder place;
    QTemporaryDir files;
    session::Settings settings{files.filePath(QStringLiteral("servodesk.ini"))};
    ui::LanguageSwitch languages;
    ui::ThemeSwitch themes;
    session::Session session;
    ui::AppContext context{session};
    std::unique_ptr<ui::CommissionPage> page; ///< goes first
};
} // namespace

class TestCommissionPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void showsWhyItCannotStart()
    {
        CommissionPageFixture context;
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!context.own<QLabel>("commissionWhy")->text().isEmpty());
        QVERIFY(!context.own<QPushButton>("commissionPlug")->isVisible());
        QVERIFY(context.open());
        // A file is proposed, so that it can be started at once.
        const QString proposed = context.own<QLineEdit>("commissionBatch")->text();
        QVERIFY(proposed.contains(QDate::currentDate().toString(Qt::ISODate)));
        QVERIFY(!QFile::exists(proposed));
        QTRY_VERIFY(context.own<QPushButton>("commissionStart")->isEnabled());
        context.own<QLineEdit>("commissionBatch")->clear();
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
        context.own<QLineEdit>("commissionBatch")->setText(QString(QChar(0)) + context.batchFile());
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!context.own<QLabel>("commissionWhy")->text().isEmpty());
        context.fill(7);
        QTRY_VERIFY(context.own<QPushButton>("commissionStart")->isEnabled());
        context.own<QSpinBox>("commissionLastId")->setValue(3);
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
    }

    /// It falls silent in the middle of its change of ID: counted at once, and named on leaving.
    void aRemovedServoIsCountedAndNamed()
    {
        CommissionPageFixture context;
        QVERIFY(context.open());
        context.fill(7);
        context.click("commissionStart");
        context.click("commissionPlug");
        context.workbench().link().connection()->simulation()->with([](sim::VirtualBus& wire) {
            wire.config().faults.muteWhen = [](const sim::VirtualServo& servo) {
                return servo.id() == 7;
            };
        });
        context.click("commissionContinue");
        QTRY_VERIFY(context.headline().contains(QStringLiteral("same servo")));
        QTRY_VERIFY(
            context.own<QLabel>("commissionSum")->text().contains(QStringLiteral("1 unfinished")));
        const auto detail = [&] { return context.own<QLabel>("commissionDetail")->text(); };
        QTRY_VERIFY2(detail().contains(QStringLiteral("EPROM was unlocked")), qPrintable(detail()));
        QVERIFY2(detail().contains(QStringLiteral("IDs: 1, 7")), qPrintable(detail()));
        QSignalSpy found(&context.workbench().closing(), &session::CloseSequence::openWritesFound);
        context.workbench().closing().findOpenWrites();
        QTRY_COMPARE(found.size(), 1);
        const auto unfinished = found.front().front().value<session::OpenWrites>();
        QVERIFY(!unfinished.ids.empty());
        QCOMPARE(unfinished.unlockedElsewhere, QStringList{QStringLiteral("1 / 7")});
        context.click("commissionStop");
        QVERIFY(context.ends());
        QTRY_VERIFY2(detail().contains(QStringLiteral("EPROM was unlocked")), qPrintable(detail()));
        QVERIFY2(detail().contains(QStringLiteral("IDs: 1, 7")), qPrintable(detail()));
    }

    void oneClickConfiguresAServo()
    {
        CommissionPageFixture context;
        QVERIFY(context.open());
        context.fill(7);
        context.click("commissionStart");
        QTRY_VERIFY(context.headline().contains(QStringLiteral("next servo")));
        QVERIFY(!context.own<QSpinBox>("commissionFirstId")->isEnabled());
        auto* steps = context.own<ui::StepStrip>("commissionSteps");
        auto* summary = context.own<QLabel>("commissionSum");
        QCOMPARE(steps->current(), 0); // connect
        QVERIFY(context.own<QLabel>("commissionNothing")->isVisible());
        QVERIFY2(summary->text().contains(QStringLiteral("Next IDs: 7–253 (247 IDs)")),
                 qPrintable(summary->text()));
        context.click("commissionPlug");
        QTRY_VERIFY(context.own<QPushButton>("commissionContinue")->isVisible());
        QCOMPARE(steps->current(), 2); // write: waits for the click
        QCOMPARE(context.idOf(0), 1);  // nothing before the click
        QCOMPARE(context.rows(), 0);
        context.click("commissionContinue");
        QTRY_COMPARE(context.rows(), 1);
        QCOMPARE(context.idOf(0), 7);
        QTRY_VERIFY(context.headline().contains(QStringLiteral("Disconnect the servo: ID 7")));
        QCOMPARE(steps->current(), 4);
        QCOMPARE(steps->accessibleName(), QStringLiteral("Step 5 of 5: Unplug"));
        QVERIFY(!context.own<QLabel>("commissionNothing")->isVisible());
        QTRY_VERIFY2(summary->text().contains(QStringLiteral("Next IDs: 8–253 (246 IDs)")),
                     qPrintable(summary->text()));
        auto* saved = context.own<QLabel>("commissionSaved");
        QVERIFY(saved->isVisible() && QFile::exists(saved->toolTip()));
        QVERIFY(saved->text().contains(QFileInfo(saved->toolTip()).fileName()));
        QVERIFY(context.own<QTableView>("commissionTable")
                    ->model()
                    ->index(0, 0)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(saved->toolTip()));
        QCOMPARE(context.nameOf(7), context.cell(0, 1)); // the history calls it so from now on
        QVERIFY(context.cell(0, 0).startsWith(QChar(0x2714)));
        context.click("commissionCopy");
        QCOMPARE(QGuiApplication::clipboard()->text(), QString::fromUtf8("STS3215 · ID 7 · 1 M"));
        context.click("commissionUnplug");
        QTRY_VERIFY(context.headline().contains(QStringLiteral("next servo")));
        context.click("commissionStop");
        QVERIFY(context.ends());
        QVERIFY(context.own<QSpinBox>("commissionFirstId")->isEnabled());
        context.click("commissionReport");
        auto* dialog = context.own<QFileDialog>("commissionReportDialog");
        QVERIFY(dialog != nullptr);
        QVERIFY(dialog->selectedFiles().front().endsWith(QStringLiteral("/batch.pdf")));
        const QString report = context.files.filePath(QStringLiteral("batch.pdf"));
        Q_EMIT dialog->fileSelected(report);
        dialog->close();
        QTRY_VERIFY(QFile::exists(report));
        QTRY_VERIFY(context.own<QFrame>("commissionBanner")->isVisible());

        // Gone on with: ID 7 is known to be given, the next one is set aside by
        // hand.
        context.click("commissionStart");
        QTRY_COMPARE(context.rows(), 1);
        context.click("commissionPlug");
        QTRY_VERIFY(context.own<QPushButton>("commissionContinue")->isVisible());
        QVERIFY(
            context.own<QPushButton>("commissionContinue")->text().contains(QStringLiteral("8")));
        context.click("commissionAside");
        QTRY_COMPARE(context.rows(), 2);
        QCOMPARE(context.idOf(1), 1);
        context.click("commissionStop");
        QVERIFY(context.ends());
    }

    /// A factory servo at the old place of one that was left in the middle may be that one.
    void aPossiblyStartedServoIsExplained_data()
    {
        QTest::addColumn<bool>("automatic");
        QTest::newRow("with a click") << false;
        QTest::newRow("without asking") << true;
    }
    void aPossiblyStartedServoIsExplained()
    {
        QFETCH(const bool, automatic);
        CommissionPageFixture context;
        results::CommissionBatch batch;
        results::PendingCommission begun;
        begun.at = QDateTime::currentDateTimeUtc();
        begun.servo = support::templateOf("sts3215", {}).servo;
        begun.oldBaud = begun.newBaud = 1'000'000;
        begun.newId = 9;
        begun.isIdSent = true;
        begun.lockOpen = true;
        batch.pending = {begun};
        QVERIFY(results::saveCommissionBatch(batch, context.batchFile()));
        QVERIFY(context.open());
        context.fill(7);
        context.own<QCheckBox>("commissionAutomatic")->setChecked(automatic);
        context.click("commissionStart");
        QTRY_VERIFY(context.headline().contains(QStringLiteral("next servo")));
        context.click("commissionPlug");
        auto* same = context.own<QPushButton>("commissionSame");
        QTRY_VERIFY(same->isVisible());
        const QString words = context.own<QLabel>("commissionDetail")->text();
        QVERIFY2(words.contains(QStringLiteral("was not finished")), qPrintable(words));
        QVERIFY2(words.contains(QStringLiteral("ID is 9")), qPrintable(words));
        QVERIFY2(words.contains(same->text()), qPrintable(words));
        QCOMPARE(context.idOf(0), 1);
        context.click("commissionSame");
        QTRY_COMPARE(context.rows(), 1);
        QCOMPARE(context.idOf(0), 9);
        QVERIFY(context.page->commissioning().batch().pending.empty());
        context.click("commissionStop");
        QVERIFY(context.ends());
    }

    void aBadTemplateIsReportedBeforeAnyWrite()
    {
        CommissionPageFixture context;
        QVERIFY(context.open());
        context.fill(7);
        context.own<QLineEdit>("commissionTemplate")->setText(QStringLiteral("/nowhere/t.json"));
        QTRY_VERIFY(context.own<QFrame>("commissionBanner")->isVisible());
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
        QVERIFY(!QFile::exists(context.batchFile()));
    }

    void theBatchIsShownBeforeTheStart()
    {
        CommissionPageFixture context;
        results::CommissionBatch batch;
        results::CommissionRow row;
        row.at = QDateTime::fromSecsSinceEpoch(1'700'000'000, Qt::UTC);
        row.servo.model = QStringLiteral("STS3215");
        row.newId = 7;
        row.label = QStringLiteral("the seventh");
        batch.rows = {row};
        QVERIFY(results::saveCommissionBatch(batch, context.batchFile()));
        context.fill(7);
        QTRY_COMPARE(context.rows(), 1);
        QCOMPARE(context.cell(0, 1), row.label);
        QVERIFY(!context.own<QFrame>("commissionBanner")->isVisible());

        QVERIFY(context.open());
        const QString broken = context.files.filePath(QStringLiteral("broken.csv"));
        QFile state(results::commissionStatePath(broken));
        QVERIFY(state.open(QIODevice::WriteOnly) && state.write("{\"format\":") > 0);
        state.close();
        context.own<QLineEdit>("commissionBatch")->setText(broken);
        QTRY_VERIFY(context.own<QFrame>("commissionBanner")->isVisible());
        QCOMPARE(context.rows(), 0);
        QVERIFY(!context.own<QPushButton>("commissionStart")->isEnabled());
        context.fill(7);
        QTRY_COMPARE(context.rows(), 1);
        QTRY_VERIFY(context.own<QPushButton>("commissionStart")->isEnabled());
    }

    void dangerousRowsAreConfirmedOnce()
    {
        CommissionPageFixture context;
        QVERIFY(context.open());
        const QString file = context.files.filePath(QStringLiteral("t.servo.json"));
        QVERIFY(snapshot::saveSnapshot(
            support::templateOf("sts3215", {{"position_p", 24}, {"angle_resolution", 0}}), file));
        context.fill(7);
        auto* too = context.own<QCheckBox>("commissionDangerous");
        QVERIFY(!too->isVisible());
        context.own<QLineEdit>("commissionTemplate")->setText(file);
        QTRY_VERIFY(too->isVisible());
        too->setChecked(true);
        const auto question = [&](const char* name) {
            return support::waitFor([&] { return context.own<QPushButton>(name) != nullptr; });
        };
        context.click("commissionStart");
        QVERIFY(question("questionNo"));
        context.own<QPushButton>("questionNo")->click();
        QTRY_VERIFY(context.own<QPushButton>("questionNo") == nullptr);
        QVERIFY(!context.page->commissioning().isRunning());
        context.click("commissionStart");
        QVERIFY(question("questionYes"));
        context.own<QPushButton>("questionYes")->click();
        QTRY_VERIFY(context.headline().contains(QStringLiteral("next servo")));
        context.click("commissionStop");
        QVERIFY(context.ends());
    }

    /// One that is not in the template may be 0 in the servo, as the lower one is when new.
    void templatesWithoutAngleLimitsNeedConsent()
    {
        CommissionPageFixture context;
        const catalog::Catalog& catalog = context.workbench().catalog();
        const auto keys = [&](const std::vector<std::pair<const char*, std::int64_t>>& rows) {
            return session::dangerousKeys(catalog, support::templateOf("sts3215", rows));
        };
        const QString min = QStringLiteral("min_angle_limit");
        const QString max = QStringLiteral("max_angle_limit");
        QCOMPARE(keys({{"max_angle_limit", 0}}), QStringList{max});
        QCOMPARE(keys({{"min_angle_limit", 0}, {"max_angle_limit", 0}}), (QStringList{min, max}));
        QVERIFY(keys({{"min_angle_limit", 0}, {"max_angle_limit", 4095}}).isEmpty());
        QVERIFY(keys({{"min_angle_limit", 0}}).isEmpty()); // the upper one is above it
        QVERIFY(keys({{"position_p", 0}}).isEmpty());
    }

    void closingThePortEndsTheBatch()
    {
        CommissionPageFixture context;
        QVERIFY(context.open());
        context.fill(7);
        context.own<QCheckBox>("commissionAutomatic")->setChecked(true);
        context.click("commissionStart");
        QTRY_VERIFY(context.headline().contains(QStringLiteral("next servo")));
        context.workbench().closing().disconnectFrom();
        QVERIFY(context.ends());
    }

    void everyFieldHasItsName()
    {
        CommissionPageFixture context;
        for (const char* name : {"commissionBatch", "commissionTemplate", "commissionLabel"}) {
            auto* field = context.own<QLineEdit>(name);
            QVERIFY(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty());
            const QString words = field->accessibleName();
            const auto labels = context.page->findChildren<QLabel*>();
            const auto shown = [&](const QLabel* one) { return one->text() == words; };
            QVERIFY2(std::any_of(labels.begin(), labels.end(), shown), name);
        }
    }
};

SERVODESK_TEST(TestCommissionPage)
#include "tst_commission_page.moc"
