// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of editor by keyboard and mouse: what it shows, what it accepts, and its messages for
// invalid input. The delegate is tested on a table of its own.
#include "gui/servo_entry_builder.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/editors/value_error_text.h"
#include "ui/memory/memory_filter.h"
#include "ui/memory/memory_model.h"
#include "ui/memory/memory_view.h"
#include "ui/memory/register_delegate.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

using guitest::entryOf;
using guitest::put;
using ui::MemoryColumn;
using ui::RegisterEditor;

class TestRegisterEditors : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void kindFollowsTheRegister_data();
    void kindFollowsTheRegister();
    void numbersAreTyped_data();
    void numbersAreTyped();
    void numbersStep();
    void physicalValuesKeepTheirUnit();
    void listsShowNumbers();
    void listsKeepTheReadValue();
    void bitsAddUp();
    void unnamedBitsArePreserved();
    void editingTheSumChecksTheBits();
    void errorMessagesSayWhatToDo_data();
    void errorMessagesSayWhatToDo();
    void errorMessagesAreShort();
    void theReadValueIsAlwaysAccepted();

    void enterWrites();
    void escapeCancels();
    void invalidInputKeepsTheEditorOpen();
    void invalidPastedTextWritesNothing();
    void losingFocusWritesNothingAndReportsIt();
    void untouchedWritesNothing();
    void digitsStartEditing();
    void readOnlyRowsAreMarked();
    void pollingDoesNotDisturbTyping();
    void bitsFitInATable();

private:
    RegisterEditor* make(const char* key, bool physical = false);

    session::ServoEntry m_entry;
    QWidget m_home;
};

namespace {
/// A table with its delegate, as the page has it.
struct EditorFixture {
    ui::MemoryModel model;
    ui::MemoryFilter filter;
    ui::MemoryView view{nullptr};
    ui::RegisterDelegate* delegate = new ui::RegisterDelegate(&view);
    QSignalSpy writeRequests{&model, &ui::MemoryModel::writeRequested};
    bool active = false;
    QSignalSpy left{delegate, &ui::RegisterDelegate::editorLeft};

    explicit EditorFixture(const session::ServoEntry& entry)
    {
        filter.setSourceModel(&model);
        view.setItemDelegate(delegate);
        view.setModel(&filter);
        model.setEntry(&entry, {});
        view.resize(900, 500);
        view.resizeColumns();
        view.show();
        view.activateWindow();
        active = QTest::qWaitForWindowActive(&view);
        view.setFocus();
    }

    QModelIndex at(const char* key, MemoryColumn column = MemoryColumn::Value)
    {
        return filter.mapFromSource(
            model.index(model.rowOf(QString::fromLatin1(key)), static_cast<int>(column)));
    }

    RegisterEditor* open(const char* key, MemoryColumn column = MemoryColumn::Value)
    {
        view.setCurrentIndex(at(key, column));
        QTest::keyClick(&view, Qt::Key_Return);
        return delegate->openEditor();
    }

    QString message() const
    {
        const auto* label = view.viewport()->findChild<QLabel*>(QStringLiteral("editorMessage"));
        return label != nullptr ? label->text() : QString();
    }
};

void type(RegisterEditor* editor, const QString& text)
{
    editor->selectAll();
    QTest::keyClicks(editor->is().front(), text);
}
} // namespace

void TestRegisterEditors::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    // Editors must not outlive their registers: a change of the language reaches them later.
    qDeleteAll(m_home.findChildren<RegisterEditor*>(QString(), Qt::FindDirectChildrenOnly));
    text::installTranslator(QStringLiteral("en"));
    m_entry = entryOf(guitest::sts3215);
}

RegisterEditor* TestRegisterEditors::make(const char* key, bool physical)
{
    qDeleteAll(m_home.children());
    const catalog::Register* reg = m_entry.servo.profile->find(QString::fromLatin1(key));
    const auto raw = m_entry.servo.raw(*reg);
    RegisterEditor* editor =
        ui::makeRegisterEditor({reg, m_entry.servo.meaning(*reg), raw, physical, false}, &m_home);
    editor->setRaw(raw);
    return editor;
}

void TestRegisterEditors::kindFollowsTheRegister_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("kind");
    QTest::newRow("number") << "position_p"
                            << "ui::NumberEditor";
    QTest::newRow("signed number") << "goal_position"
                                   << "ui::NumberEditor";
    QTest::newRow("list") << "operating_mode"
                          << "ui::EnumEditor";
    QTest::newRow("bits") << "unload_condition"
                          << "ui::BitsEditor";
}

void TestRegisterEditors::kindFollowsTheRegister()
{
    QFETCH(QString, key);
    QFETCH(QString, kind);
    QCOMPARE(QString::fromLatin1(make(qPrintable(key))->metaObject()->className()), kind);
}

void TestRegisterEditors::numbersAreTyped_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<bool>("physical");
    QTest::addColumn<QString>("inputText");
    QTest::addColumn<int>("raw");
    QTest::newRow("plain") << "position_p" << false << "40" << 40;
    QTest::newRow("hexadecimal") << "position_p" << false << "0x28" << 40;
    QTest::newRow("with its unit") << "max_voltage" << false << "8.5 V" << 85;
    QTest::newRow("another spelling of the unit") << "max_voltage" << false << "8500mV" << 85;
    QTest::newRow("in the unit's editor without unit") << "max_voltage" << true << "8.5" << 85;
    QTest::newRow("in the unit's editor with unit") << "max_voltage" << true << "8.5V" << 85;
    QTest::newRow("negative") << "goal_position" << false << "-100" << -100;
    QTest::newRow("degrees") << "goal_position" << true << "90" << 1024;
}

void TestRegisterEditors::numbersAreTyped()
{
    QFETCH(QString, key);
    QFETCH(bool, physical);
    QFETCH(QString, inputText);
    QFETCH(int, raw);
    RegisterEditor* editor = make(qPrintable(key), physical);
    QVERIFY(!editor->isModified());
    QSignalSpy edited(editor, &RegisterEditor::userEdited);
    type(editor, inputText);
    QVERIFY(editor->isModified());
    QVERIFY(edited.count() > 0);
    QVERIFY2(editor->value().has_value(), qPrintable(editor->inputError()));
    QCOMPARE(*editor->value(), raw);
}

void TestRegisterEditors::numbersStep()
{
    RegisterEditor* editor = make("position_p");
    QTest::keyClick(editor->is().front(), Qt::Key_Up);
    QCOMPARE(*editor->value(), 33);
    QVERIFY(editor->isModified());
    type(editor, QStringLiteral("254"));
    QTest::keyClick(editor->is().front(), Qt::Key_Up);
    QCOMPARE(*editor->value(), 254);
    type(editor, QStringLiteral("0"));
    QTest::keyClick(editor->is().front(), Qt::Key_Down);
    QCOMPARE(*editor->value(), 0);
}

void TestRegisterEditors::physicalValuesKeepTheirUnit()
{
    put(m_entry, QStringLiteral("max_voltage"), 80);
    RegisterEditor* editor = make("max_voltage", true);
    QCOMPARE(editor->inputText(), QStringLiteral("8.0 V"));
    QCOMPARE(*editor->value(), 80);
    QTest::keyClick(editor->is().front(), Qt::Key_Up);
    QCOMPARE(editor->inputText(), QStringLiteral("8.1 V"));
    QCOMPARE(*editor->value(), 81);
}

void TestRegisterEditors::listsShowNumbers()
{
    RegisterEditor* editor = make("operating_mode");
    auto* box = editor->findChild<QComboBox*>(QStringLiteral("valueList"));
    QCOMPARE(box->count(), 4);
    QVERIFY(box->itemText(1).startsWith(QStringLiteral("1 — ")));
    QCOMPARE(box->currentIndex(), 0);
    QTest::keyClick(box, Qt::Key_Down);
    QVERIFY(editor->isModified());
    QCOMPARE(*editor->value(), 1);
}

void TestRegisterEditors::listsKeepTheReadValue()
{
    put(m_entry, QStringLiteral("operating_mode"), 9);
    RegisterEditor* editor = make("operating_mode");
    auto* box = editor->findChild<QComboBox*>(QStringLiteral("valueList"));
    QVERIFY(box->currentText().startsWith(QStringLiteral("9 — ")));
    QVERIFY(!editor->isModified());
    QCOMPARE(*editor->value(), 9);
    editor->setRaw(std::nullopt);
    QVERIFY(!editor->value().has_value());
    QVERIFY(!editor->inputError().isEmpty());
}

void TestRegisterEditors::bitsAddUp()
{
    put(m_entry, QStringLiteral("unload_condition"), 32);
    RegisterEditor* editor = make("unload_condition");
    m_home.show();
    auto* sum = editor->findChild<QLineEdit*>(QStringLiteral("bitsSum"));
    QCOMPARE(sum->text(), QStringLiteral("32"));
    QTest::mouseClick(editor->findChild<QCheckBox*>(QStringLiteral("bit3")), Qt::LeftButton, {},
                      QPoint(8, 8));
    QCOMPARE(sum->text(), QStringLiteral("40"));
    auto* two = editor->findChild<QCheckBox*>(QStringLiteral("bit2"));
    QVERIFY(two->text().contains(QStringLiteral("temperature (4)")));
    two->setFocus();
    QTest::keyClick(two, Qt::Key_Space);
    QCOMPARE(sum->text(), QStringLiteral("44"));
    QCOMPARE(*editor->value(), 44);
    QVERIFY(editor->isModified());
    m_home.hide();
}

void TestRegisterEditors::unnamedBitsArePreserved()
{
    put(m_entry, QStringLiteral("unload_condition"), 128 + 4);
    RegisterEditor* editor = make("unload_condition");
    auto* seven = editor->findChild<QCheckBox*>(QStringLiteral("bit7"));
    auto* six = editor->findChild<QCheckBox*>(QStringLiteral("bit6"));
    QVERIFY(!seven->isHidden());
    QVERIFY(seven->isChecked());
    QVERIFY(seven->text().contains(QStringLiteral("(128)")));
    QVERIFY(six->isHidden());
    editor->findChild<QCheckBox*>(QStringLiteral("bit5"))->click();
    QCOMPARE(*editor->value(), 128 + 32 + 4);
    // Taken away by mistake, it can be put back.
    seven->click();
    QVERIFY(!seven->isHidden());
    QCOMPARE(*editor->value(), 32 + 4);
    seven->click();
    QCOMPARE(*editor->value(), 128 + 32 + 4);
}

void TestRegisterEditors::editingTheSumChecksTheBits()
{
    RegisterEditor* editor = make("unload_condition");
    type(editor, QStringLiteral("33"));
    QVERIFY(editor->findChild<QCheckBox*>(QStringLiteral("bit0"))->isChecked());
    QVERIFY(editor->findChild<QCheckBox*>(QStringLiteral("bit5"))->isChecked());
    QVERIFY(!editor->findChild<QCheckBox*>(QStringLiteral("bit2"))->isChecked());
    type(editor, QStringLiteral("overload+voltage"));
    QCOMPARE(*editor->value(), 33);
    type(editor, QStringLiteral("rubbish"));
    QVERIFY(!editor->value().has_value());
}

void TestRegisterEditors::errorMessagesSayWhatToDo_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("inputText");
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("remedy");
    QTest::newRow("letters") << "position_p"
                             << "abc"
                             << "abc"
                             << "0–254";
    QTest::newRow("nothing") << "position_p"
                             << ""
                             << "No value entered"
                             << "0–254";
    QTest::newRow("too large") << "position_p"
                               << "255"
                               << "outside"
                               << "0–254";
    QTest::newRow("negative") << "position_p"
                              << "-1"
                              << "outside"
                              << "0–254";
    QTest::newRow("fraction") << "position_p"
                              << "1.5"
                              << "1.5"
                              << "whole number";
    QTest::newRow("wrong unit") << "max_voltage"
                                << "20 kg"
                                << "20 kg"
                                << "unit";
    QTest::newRow("huge") << "position_p"
                          << "99999999999999999999999"
                          << "9999"
                          << "0–254";
    QTest::newRow("less than a step") << "protection_current"
                                      << "1 mA"
                                      << "below the resolution"
                                      << "unit";
}

void TestRegisterEditors::errorMessagesSayWhatToDo()
{
    QFETCH(QString, key);
    QFETCH(QString, inputText);
    QFETCH(QString, what);
    QFETCH(QString, remedy);
    RegisterEditor* editor = make(qPrintable(key));
    editor->findChild<QLineEdit*>()->clear();
    QTest::keyClicks(editor->is().front(), inputText);
    QVERIFY(!editor->value().has_value());
    const QString inputError = editor->inputError();
    QVERIFY2(inputError.contains(what), qPrintable(inputError));
    QVERIFY2(inputError.contains(remedy), qPrintable(inputError));
    QVERIFY2(inputError.contains(QStringLiteral("Nothing was written")), qPrintable(inputError));
}

void TestRegisterEditors::errorMessagesAreShort()
{
    RegisterEditor* editor = make("position_p");
    editor->findChild<QLineEdit*>()->setText(QString(100'000, u'x'));
    QVERIFY(editor->inputError().size() < 400);
}

void TestRegisterEditors::theReadValueIsAlwaysAccepted()
{
    put(m_entry, QStringLiteral("cw_dead_zone"), 99); // documented: 0–32
    RegisterEditor* editor = make("cw_dead_zone");
    QVERIFY(editor->value().has_value());
    type(editor, QStringLiteral("98"));
    QVERIFY(!editor->value().has_value());
    type(editor, QStringLiteral("99"));
    QVERIFY(editor->value().has_value());
}

void TestRegisterEditors::enterWrites()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    QVERIFY(editor);
    type(editor, QStringLiteral("40"));
    QTest::keyClick(editor->is().front(), Qt::Key_Return);
    QCOMPARE(table.writeRequests.count(), 1);
    QCOMPARE(table.writeRequests.at(0).at(0).toString(), QStringLiteral("position_p"));
    QCOMPARE(table.writeRequests.at(0).at(1).toInt(), 40);
    QVERIFY(!table.delegate->openEditor());
    QCOMPARE(table.left.count(), 0);
    QCOMPARE(table.message(), QString());
}

void TestRegisterEditors::escapeCancels()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    type(editor, QStringLiteral("40"));
    QTest::keyClick(editor->is().front(), Qt::Key_Escape);
    QVERIFY(!table.delegate->openEditor());
    QCOMPARE(table.writeRequests.count(), 0);
    QCOMPARE(table.left.count(), 0);
}

void TestRegisterEditors::invalidInputKeepsTheEditorOpen()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    type(editor, QStringLiteral("4x"));
    QVERIFY(table.message().contains(QStringLiteral("4x")));
    QTest::keyClick(editor->is().front(), Qt::Key_Return);
    QCOMPARE(table.delegate->openEditor(), editor);
    QCOMPARE(table.writeRequests.count(), 0);
    QVERIFY(table.message().contains(QStringLiteral("0–254")));
    // What is put right goes through, and the message goes away.
    type(editor, QStringLiteral("41"));
    QCOMPARE(table.message(), QString());
    QTest::keyClick(editor->is().front(), Qt::Key_Return);
    QCOMPARE(table.writeRequests.count(), 1);
    QCOMPARE(table.writeRequests.at(0).at(1).toInt(), 41);
}

void TestRegisterEditors::invalidPastedTextWritesNothing()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    QGuiApplication::clipboard()->setText(
        QStringLiteral("Dear all,\nplease find attached\t=cmd|' /C calc'!A0\n\u202e\u0000 12"));
    editor->selectAll();
    QTest::keyClick(editor->is().front(), Qt::Key_V, Qt::ControlModifier);
    QVERIFY(editor->inputText().contains(QStringLiteral("Dear all")));
    QVERIFY(!table.message().isEmpty());
    QTest::keyClick(editor->is().front(), Qt::Key_Enter);
    QCOMPARE(table.writeRequests.count(), 0);
    QTest::keyClick(editor->is().front(), Qt::Key_Escape);
    QCOMPARE(table.writeRequests.count(), 0);
    QCOMPARE(table.message(), QString());
}

void TestRegisterEditors::losingFocusWritesNothingAndReportsIt()
{
    EditorFixture table(m_entry);
    QVERIFY(table.active);
    RegisterEditor* editor = table.open("position_p");
    type(editor, QStringLiteral("40"));
    table.view.setFocus(Qt::MouseFocusReason);
    QVERIFY(!table.delegate->openEditor());
    QCOMPARE(table.writeRequests.count(), 0);
    QCOMPARE(table.left.count(), 1);
    QVERIFY(table.left.at(0).at(0).toString().contains(QStringLiteral("40")));
}

void TestRegisterEditors::untouchedWritesNothing()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    QTest::keyClick(editor->is().front(), Qt::Key_Return);
    QCOMPARE(table.writeRequests.count(), 0);
    editor = table.open("position_p");
    table.view.setFocus(Qt::MouseFocusReason);
    QCOMPARE(table.writeRequests.count(), 0);
    QCOMPARE(table.left.count(), 0);
}

void TestRegisterEditors::digitsStartEditing()
{
    EditorFixture table(m_entry);
    table.view.setCurrentIndex(table.at("position_p", MemoryColumn::Name));
    QTest::keyClick(&table.view, Qt::Key_X);
    QVERIFY(!table.delegate->openEditor());
    QTest::keyClick(&table.view, Qt::Key_5);
    RegisterEditor* editor = table.delegate->openEditor();
    QVERIFY(editor);
    QCOMPARE(editor->inputText(), QStringLiteral("5"));
    QTest::keyClick(editor->is().front(), Qt::Key_Return);
    QCOMPARE(table.writeRequests.count(), 1);
    QCOMPARE(table.writeRequests.at(0).at(1).toInt(), 5);
}

void TestRegisterEditors::readOnlyRowsAreMarked()
{
    EditorFixture table(m_entry);
    QSignalSpy readOnlySignals(&table.view, &ui::MemoryView::readOnlyActivated);
    QVERIFY(!table.open("present_voltage"));
    QCOMPARE(readOnlySignals.count(), 1);
}

void TestRegisterEditors::pollingDoesNotDisturbTyping()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("position_p");
    put(m_entry, QStringLiteral("position_p"), 90);
    table.model.setEntry(&m_entry, {});
    type(editor, QStringLiteral("40"));
    put(m_entry, QStringLiteral("position_p"), 91);
    table.model.setEntry(&m_entry, {});
    QCOMPARE(table.delegate->openEditor(), editor);
    QCOMPARE(editor->inputText(), QStringLiteral("40"));
}

void TestRegisterEditors::bitsFitInATable()
{
    EditorFixture table(m_entry);
    RegisterEditor* editor = table.open("led_alarm_condition");
    QVERIFY(editor);
    const QRect room = table.view.viewport()->rect();
    QVERIFY(room.contains(editor->geometry()));
    QVERIFY(editor->height() >= editor->sizeHint().height());
    // The last visible row has no room below.
    QTest::keyClick(editor->is().front(), Qt::Key_Escape);
    table.view.resize(900, 220);
    table.view.scrollTo(table.at("phase"), QAbstractItemView::PositionAtBottom);
    editor = table.open("phase");
    QVERIFY(editor);
    QVERIFY(table.view.viewport()->rect().contains(editor->geometry()));
    editor->findChild<QCheckBox*>(QStringLiteral("bit4"))->setFocus();
    QCOMPARE(table.delegate->openEditor(), editor);
    QTest::keyClick(editor->findChild<QCheckBox*>(QStringLiteral("bit4")), Qt::Key_Space);
    QTest::keyClick(editor->findChild<QCheckBox*>(QStringLiteral("bit4")), Qt::Key_Return);
    QCOMPARE(table.writeRequests.count(), 1);
    QCOMPARE(table.writeRequests.at(0).at(1).toInt(), 16);
}

SERVODESK_TEST(TestRegisterEditors)
#include "tst_register_editors.moc"
