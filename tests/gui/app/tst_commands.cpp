// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands: every command has texts in both languages, an icon that is part of the
// program, a unique shortcut if it has one, and is enabled only when it can be used.
#include "gui/main_window_fixture.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "ui/app/help_window.h"

#include <QSet>
#include <QToolButton>

using ui::Command;

namespace {
std::vector<Command> all()
{
    std::vector<Command> list;
    for (int i = 0; i < static_cast<int>(Command::Count); ++i)
        list.push_back(static_cast<Command>(i));
    return list;
}

QStringList iconsNamedIn(const QString& folder)
{
    static const QRegularExpression name(
        QStringLiteral("fromTheme\\(\\s*QStringLiteral\\(\"([a-z0-9-]+)\"\\)"));
    QStringList names;
    QDirIterator files(folder, {QStringLiteral("*.cpp")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const QString text = QString::fromUtf8(file.readAll());
        for (auto match = name.globalMatch(text); match.hasNext();)
            names << match.next().captured(1);
    }
    return names;
}
} // namespace

class TestCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void everyCommandHasTextsInBothLanguages()
    {
        gui::MainWindowFixture fixture;
        QStringList english;
        for (const Command command : all()) {
            const QAction* action = fixture.action(command);
            QVERIFY(!action->text().isEmpty());
            QVERIFY(!action->toolTip().isEmpty());
            english << action->whatsThis();
        }
        fixture.setLanguage(QStringLiteral("zh_CN"));
        for (const Command command : all()) {
            const QString tip = fixture.action(command)->whatsThis();
            QVERIFY2(tip != english[static_cast<int>(command)], qPrintable(tip));
        }
    }

    /// "断开(&D)" is for a menu; a button shows "断开".
    void buttonsShowNoMnemonics()
    {
        gui::MainWindowFixture fixture(QStringLiteral("zh_CN"));
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.action(Command::Disconnect)->text().contains(QStringLiteral("(&")));
        int seen = 0;
        for (const QToolButton* button : fixture.window->findChildren<QToolButton*>()) {
            const bool command = button->defaultAction() != nullptr;
            seen += command ? 1 : 0;
            for (const QString& words : {button->text(), button->accessibleName()})
                QVERIFY2(!command || !words.contains(QLatin1Char('(')), qPrintable(words));
        }
        QVERIFY(seen > 5);
        QCOMPARE(fixture.find<QToolButton>("connectButton")->text(), QStringLiteral("断开"));
    }

    void helpOpensOnce()
    {
        gui::MainWindowFixture fixture;
        fixture.action(Command::Help)->trigger();
        fixture.action(Command::Help)->trigger();
        QCOMPARE(fixture.window->findChildren<ui::HelpWindow*>().size(), 1);
        QVERIFY(fixture.window->findChild<ui::HelpWindow*>()->isVisible());
    }

    void noTwoCommandsShareAShortcut()
    {
        gui::MainWindowFixture fixture;
        QSet<QString> used;
        for (const Command command : all()) {
            const QString keys = fixture.action(command)->shortcut().toString();
            if (keys.isEmpty())
                continue;
            QVERIFY2(!used.contains(keys), qPrintable(keys));
            used.insert(keys);
        }
        QVERIFY(used.size() > 10);
    }

    void everyIconIsInTheResources()
    {
        gui::MainWindowFixture fixture;
        QStringList names = iconsNamedIn(QStringLiteral(SOURCE_DIR "/ui"));
        for (const Command command : all()) {
            if (!fixture.action(command)->icon().isNull())
                names << fixture.action(command)->icon().name();
        }
        QVERIFY(names.size() > 15);
        for (const QString& name : names) {
            for (const char* theme : {"breeze", "breeze-dark"}) {
                const QString file =
                    QStringLiteral(":/icons/%1/22/%2.svg").arg(QLatin1String(theme), name);
                QVERIFY2(QFile::exists(file), qPrintable(file));
            }
        }
    }

    void commandsAreEnabledWhenUsable()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.action(Command::Connect)->isEnabled());
        QVERIFY(!fixture.action(Command::Search)->isEnabled());
        QVERIFY(!fixture.action(Command::SetId)->isEnabled());
        QVERIFY(fixture.connectTo(QStringLiteral("sim:demo")));
        QVERIFY(!fixture.action(Command::Connect)->isEnabled());
        QVERIFY(fixture.action(Command::Search)->isEnabled());
        QVERIFY(fixture.action(Command::PowerCycle)->isEnabled());
        QVERIFY(!fixture.action(Command::SetId)->isEnabled());
        QVERIFY(fixture.choose(1));
        QVERIFY(fixture.action(Command::SetId)->isEnabled());
        QVERIFY(!fixture.action(Command::Undo)->isEnabled());
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 40}}, false, {}});
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.action(Command::Undo)->isEnabled());
        fixture.action(Command::Undo)->trigger();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("position_p"), std::optional<std::int64_t>(32));
    }
};

SERVODESK_TEST(TestCommands)
#include "tst_commands.moc"
