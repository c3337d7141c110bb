// SPDX-License-Identifier: GPL-3.0-or-later
// Every value of every register that must ask, entered into the memory table of every family: a
// question or the action's own dialog comes first, and without it nothing is written. Undo and redo
// ask the same. See tst_consent for what is beneath, tst_cli_consent for the command line.
#include "gui/workbench_fixture.h"
#include "support/consent_rules.h"
#include "support/test_main.h"
#include "ui/app/undo_redo.h"
#include "ui/editors/write_question.h"
#include "ui/memory/memory_page.h"
#include "ui/memory/memory_view.h"
#include "ui/memory/register_panel.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

using support::consentFamilies;
using ui::Command;
using ui::MemoryModel;

class TestTableConsent : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyRiskyValueAsks_data();
    void everyRiskyValueAsks();
    void thePanelAsksLikeTheTable();
    void undoAndRedoAskAgain_data();
    void undoAndRedoAskAgain();
    void limitsAskInSpeedModeToo();
    void theQuestionNamesTheMode();
};

namespace {
struct ConsentFixture : gui::WorkbenchFixture {
    ui::MemoryPage page{workbench, commands, selection, settings};

    /// The servo is chosen, and its table has been read.
    bool isReady(const support::FamilyRules& rules)
    {
        session::PortRequest request;
        request.name = QStringLiteral("sim:") + QLatin1String(rules.servos);
        request.baud = rules.baud;
        workbench.link().connectTo(request);
        const bool open = support::waitFor(
            [this] { return workbench.link().state() == session::LinkState::Open; });
        jobs::ScanSpec spec;
        spec.lastId = 2;
        if (!open || !search(spec) || ref(1) == 0)
            return false;
        selection.select(ref(1));
        workbench.writes().readTable(ref(1));
        return support::waitFor(
            [this] { return entry().hasFullTable && !workbench.tasks().isBusy(); });
    }

    const session::ServoEntry& entry() const
    {
        return *workbench.registry().servo(selection.current());
    }
    QModelIndex cell(const QString& key) const
    {
        const QAbstractItemModel* model = page.findChild<ui::MemoryView*>()->model();
        for (int row = 0; row < model->rowCount(); ++row) {
            if (model->index(row, 0).data(MemoryModel::KeyRole).toString() == key)
                return model->index(row, static_cast<int>(ui::MemoryColumn::Value));
        }
        return {};
    }
    /// What the editor does with the value that was entered.
    void enter(const QString& key, std::int64_t raw)
    {
        page.findChild<ui::MemoryView*>()->model()->setData(cell(key), QVariant::fromValue(raw));
    }
    QDialog* question() const { return page.findChild<QDialog*>(QStringLiteral("question")); }
};
} // namespace

void TestTableConsent::everyRiskyValueAsks_data()
{
    QTest::addColumn<int>("family");
    for (std::size_t i = 0; i < consentFamilies().size(); ++i)
        QTest::newRow(consentFamilies()[i].servos) << int(i);
}

void TestTableConsent::everyRiskyValueAsks()
{
    QFETCH(const int, family);
    const support::FamilyRules& rules = consentFamilies()[std::size_t(family)];
    ConsentFixture fixture;
    QVERIFY(fixture.isReady(rules));
    QSignalSpy centered(fixture.commands.action(Command::Center), &QAction::triggered);
    int asked = 0;
    for (const catalog::Register& reg : fixture.entry().servo.profile->registers) {
        const auto present = fixture.entry().servo.raw(reg);
        for (const std::int64_t raw : support::specialValues(reg, present)) {
            if (!reg.writable() || raw == present || !support::mustAsk(rules, reg, raw))
                continue;
            const QByteArray what = reg.key.toLatin1() + '=' + QByteArray::number(qlonglong(raw));
            fixture.enter(reg.key, raw);
            QDialog* question = fixture.question();
            QVERIFY2((question != nullptr) != !centered.empty(), what.constData());
            centered.clear();
            if (question != nullptr) {
                QTest::mouseClick(question->findChild<QPushButton*>(QStringLiteral("questionNo")),
                                  Qt::LeftButton);
                delete question;
            }
            QVERIFY2(!fixture.entry().writing() && !fixture.workbench.tasks().isBusy(),
                     what.constData());
            ++asked;
        }
    }
    QVERIFY2(asked > 10, QByteArray::number(asked).constData());
    QVERIFY(fixture.workbench.session().journal().open()->empty());
}

void TestTableConsent::thePanelAsksLikeTheTable()
{
    ConsentFixture fixture;
    QVERIFY(fixture.isReady(consentFamilies().front()));
    auto* panel = fixture.page.findChild<ui::RegisterPanel*>();
    Q_EMIT panel->writeRequested(QStringLiteral("unload_condition"), 32, false);
    QVERIFY(fixture.question() != nullptr);
    QVERIFY(!fixture.entry().writing() && !fixture.workbench.tasks().isBusy());
}

void TestTableConsent::undoAndRedoAskAgain_data()
{
    using Items = std::vector<device::WriteItem>;
    const QString min = QStringLiteral("min_angle_limit");
    const QString max = QStringLiteral("max_angle_limit");
    QTest::addColumn<Items>("before");
    QTest::addColumn<Items>("after");
    QTest::addColumn<bool>("undoAsks");
    QTest::addColumn<bool>("redoAsks");
    QTest::newRow("dangerous register")
        << Items{{QStringLiteral("unload_condition"), 44}}
        << Items{{QStringLiteral("unload_condition"), 32}} << true << true;
    QTest::newRow("both limits, neither a mode by itself")
        << Items{{min, 100}, {max, 4000}} << Items{{min, 0}, {max, 0}} << true << true;
    QTest::newRow("limits where there were none")
        << Items{{min, 0}, {max, 0}} << Items{{min, 100}, {max, 4000}} << true << true;
    QTest::newRow("harmless") << Items{{QStringLiteral("position_p"), 40}}
                              << Items{{QStringLiteral("position_p"), 30}} << false << false;
}

void TestTableConsent::undoAndRedoAskAgain()
{
    QFETCH(const std::vector<device::WriteItem>, before);
    QFETCH(const std::vector<device::WriteItem>, after);
    QFETCH(const bool, undoAsks);
    QFETCH(const bool, redoAsks);
    ConsentFixture fixture;
    QVERIFY(fixture.isReady(consentFamilies().front()));
    session::WriteService& writes = fixture.workbench.writes();
    const auto holds = [&](const std::vector<device::WriteItem>& items) {
        return !fixture.workbench.tasks().isBusy() && !fixture.entry().writing() &&
               std::all_of(items.begin(), items.end(), [&](const device::WriteItem& item) {
                   return fixture.entry().servo.raw(item.key) == item.raw;
               });
    };
    for (const auto& items : {before, after}) {
        writes.write(fixture.selection.current(), {items, false, device::Consent::confirmed()});
        QTRY_VERIFY(holds(items));
    }
    for (const bool isUndo : {true, false}) {
        const bool asks = isUndo ? undoAsks : redoAsks;
        const auto& from = isUndo ? after : before;
        const auto& to = isUndo ? before : after;
        const auto trigger = [&] {
            (isUndo ? ui::undo : ui::redo)(writes, fixture.workbench.registry(), fixture.selection,
                                           &fixture.page);
        };
        trigger();
        QCOMPARE(fixture.question() != nullptr, asks);
        if (asks) {
            QVERIFY(holds(from));
            QPointer<QDialog> first = fixture.question();
            QTest::mouseClick(first->findChild<QPushButton*>(QStringLiteral("questionNo")),
                              Qt::LeftButton);
            QTRY_VERIFY(first.isNull());
            trigger();
            QPointer<QDialog> second = fixture.question();
            QVERIFY(holds(from) && second != nullptr);
            QTest::mouseClick(second->findChild<QPushButton*>(QStringLiteral("questionYes")),
                              Qt::LeftButton);
        }
        QTRY_VERIFY(holds(to));
    }
}

void TestTableConsent::limitsAskInSpeedModeToo()
{
    ConsentFixture fixture;
    QVERIFY(fixture.isReady(consentFamilies().front()));
    const auto written = [&](const char* key, std::int64_t raw) {
        return support::waitFor([&] {
            return fixture.entry().servo.raw(QLatin1String(key)) == raw &&
                   !fixture.workbench.tasks().isBusy() && !fixture.entry().writing();
        });
    };
    fixture.workbench.writes().write(
        fixture.selection.current(),
        {{{QStringLiteral("operating_mode"), 1}}, false, device::Consent::confirmed()});
    QVERIFY(written("operating_mode", 1));
    fixture.enter(QStringLiteral("max_angle_limit"), 0);
    QDialog* question = fixture.question();
    QVERIFY(question != nullptr);
    const auto* risk = question->findChild<QLabel*>(QStringLiteral("questionRisk"));
    QVERIFY(risk != nullptr && risk->text().contains(QStringLiteral("can turn without limit")));
    QTest::mouseClick(question->findChild<QPushButton*>(QStringLiteral("questionYes")),
                      Qt::LeftButton);
    QVERIFY(written("max_angle_limit", 0));
}

/// Of several writes, the question names the one that switches the mode.
void TestTableConsent::theQuestionNamesTheMode()
{
    ConsentFixture fixture;
    QVERIFY(fixture.isReady(consentFamilies().front()));
    const auto question = ui::writeQuestion(
        fixture.entry(),
        {{QStringLiteral("min_angle_limit"), 100}, {QStringLiteral("operating_mode"), 1}}, false);
    QVERIFY(question);
    QVERIFY2(question->title.startsWith(QStringLiteral("Change the mode")),
             qPrintable(question->title));
    QVERIFY2(question->text.contains(QStringLiteral("Writing 1 to Operating mode")),
             qPrintable(question->text));
    QVERIFY(!question->risk.contains(QStringLiteral("can turn without limit")));
    const auto alsoLimits = ui::writeQuestion(
        fixture.entry(),
        {{QStringLiteral("operating_mode"), 1}, {QStringLiteral("max_angle_limit"), 0}}, false);
    QVERIFY(alsoLimits);
    QVERIFY2(alsoLimits->risk.contains(QStringLiteral("can turn without limit")),
             qPrintable(alsoLimits->risk));
}

SERVODESK_TEST(TestTableConsent)
#include "tst_table_consent.moc"
