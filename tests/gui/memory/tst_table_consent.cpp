// SPDX-License-Identifier: GPL-3.0-or-later
// Every value of every register that must ask, entered into the memory table of every family: a
// question or the action's own dialog comes first, and without it nothing is written. What undo and
// redo write asks again. See tst_consent for what is beneath, tst_cli_consent for the command line.
#include "gui/workbench_fixture.h"
#include "support/consent_rules.h"
#include "support/test_main.h"
#include "ui/app/undo_redo.h"
#include "ui/memory/memory_page.h"
#include "ui/memory/memory_view.h"

#include <QAction>
#include <QDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

using support::consentFamilies;
using ui::Command;
using ui::MemoryModel;

Q_DECLARE_METATYPE(std::vector<device::WriteItem>)

class TestTableConsent : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyRiskyValueAsks_data();
    void everyRiskyValueAsks();
    void redoAsksAgain_data();
    void redoAsksAgain();
    void limitsInSpeedModeAskNothing();
};

namespace {
struct Fixture : gui::WorkbenchFixture {
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
    Fixture fixture;
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

void TestTableConsent::redoAsksAgain_data()
{
    using Items = std::vector<device::WriteItem>;
    QTest::addColumn<Items>("items");
    QTest::newRow("dangerous register") << Items{{QStringLiteral("unload_condition"), 32}};
    QTest::newRow("both limits, neither a mode by itself")
        << Items{{QStringLiteral("min_angle_limit"), 0}, {QStringLiteral("max_angle_limit"), 0}};
}

void TestTableConsent::redoAsksAgain()
{
    QFETCH(const std::vector<device::WriteItem>, items);
    Fixture fixture;
    QVERIFY(fixture.isReady(consentFamilies().front()));
    session::WriteService& writes = fixture.workbench.writes();
    writes.write(fixture.selection.current(),
                 {{{QStringLiteral("min_angle_limit"), 100}}, false, {}});
    QTRY_COMPARE(fixture.entry().servo.raw(QStringLiteral("min_angle_limit")), 100);
    const QString key = items.back().key;
    const auto before = fixture.entry().servo.raw(key);
    writes.write(fixture.selection.current(), {items, false, device::Consent::confirmed()});
    QTRY_COMPARE(fixture.entry().servo.raw(key), items.back().raw);
    QTRY_VERIFY(writes.undoStep() != nullptr);
    ui::undo(writes, fixture.selection);
    QTRY_COMPARE(fixture.entry().servo.raw(key), before);
    QTRY_VERIFY(writes.redoStep() != nullptr);
    ui::redo(writes, fixture.workbench.registry(), fixture.selection, &fixture.page);
    QVERIFY(fixture.question() != nullptr);
    QVERIFY(!fixture.entry().writing());
    // Without the question the device refuses.
    delete fixture.question();
    writes.redo();
    QTRY_VERIFY(!fixture.workbench.tasks().isBusy() && !fixture.entry().writing());
    QCOMPARE(fixture.entry().servo.raw(key), before);
}

void TestTableConsent::limitsInSpeedModeAskNothing()
{
    Fixture fixture;
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
    QVERIFY(!fixture.question());
    QVERIFY(written("max_angle_limit", 0));
}

SERVODESK_TEST(TestTableConsent)
#include "tst_table_consent.moc"
