// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands: every command has words in both languages, an icon that is inside the
// program, a shortcut of its own if it has one, and is of use only when it can be.
#include "gui/window_bench.h"
#include "ui/dialogs/help_window.h"

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

    void everyCommandHasWordsInBothLanguages()
    {
        gui::WindowBench bench;
        QStringList english;
        for (const Command command : all()) {
            const QAction* action = bench.action(command);
            QVERIFY(!action->text().isEmpty());
            QVERIFY(!action->toolTip().isEmpty());
            english << action->whatsThis();
        }
        bench.speak(QStringLiteral("zh_CN"));
        for (const Command command : all()) {
            const QString tip = bench.action(command)->whatsThis();
            QVERIFY2(tip != english[static_cast<int>(command)], qPrintable(tip));
        }
    }

    /// "断开(&D)" is for a menu; a button says "断开".
    void buttonsShowNoKeysOfMenus()
    {
        gui::WindowBench bench(QStringLiteral("zh_CN"));
        QVERIFY(bench.ready(1));
        QVERIFY(bench.action(Command::Disconnect)->text().contains(QStringLiteral("(&")));
        int seen = 0;
        for (const QToolButton* button : bench.window->findChildren<QToolButton*>()) {
            const bool command = button->defaultAction() != nullptr;
            seen += command ? 1 : 0;
            for (const QString& words : {button->text(), button->accessibleName()})
                QVERIFY2(!command || !words.contains(QLatin1Char('(')), qPrintable(words));
        }
        QVERIFY(seen > 5);
        QCOMPARE(bench.find<QToolButton>("connectButton")->text(), QStringLiteral("断开"));
    }

    void helpOpensOnce()
    {
        gui::WindowBench bench;
        bench.action(Command::Help)->trigger();
        bench.action(Command::Help)->trigger();
        QCOMPARE(bench.window->findChildren<ui::HelpWindow*>().size(), 1);
        QVERIFY(bench.window->findChild<ui::HelpWindow*>()->isVisible());
    }

    void noTwoCommandsShareAShortcut()
    {
        gui::WindowBench bench;
        QSet<QString> used;
        for (const Command command : all()) {
            const QString keys = bench.action(command)->shortcut().toString();
            if (keys.isEmpty())
                continue;
            QVERIFY2(!used.contains(keys), qPrintable(keys));
            used.insert(keys);
        }
        QVERIFY(used.size() > 10);
    }

    void everyIconIsInsideTheProgram()
    {
        gui::WindowBench bench;
        QStringList names = iconsNamedIn(QStringLiteral(SOURCE_DIR "/ui"));
        for (const Command command : all()) {
            if (!bench.action(command)->icon().isNull())
                names << bench.action(command)->icon().name();
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

    void commandsAreOfUseWhenTheyCanBe()
    {
        gui::WindowBench bench;
        QVERIFY(bench.action(Command::Connect)->isEnabled());
        QVERIFY(!bench.action(Command::Search)->isEnabled());
        QVERIFY(!bench.action(Command::SetId)->isEnabled());
        QVERIFY(bench.connectTo(QStringLiteral("sim:demo")));
        QVERIFY(!bench.action(Command::Connect)->isEnabled());
        QVERIFY(bench.action(Command::Search)->isEnabled());
        QVERIFY(bench.action(Command::PowerCycle)->isEnabled());
        QVERIFY(!bench.action(Command::SetId)->isEnabled());
        QVERIFY(bench.choose(1));
        QVERIFY(bench.action(Command::SetId)->isEnabled());
        QVERIFY(!bench.action(Command::Undo)->isEnabled());
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), 40}}, false, false});
        QVERIFY(bench.settled());
        QVERIFY(bench.action(Command::Undo)->isEnabled());
        bench.action(Command::Undo)->trigger();
        QVERIFY(bench.settled());
        QCOMPARE(bench.raw("position_p"), std::optional<std::int64_t>(32));
    }
};

QTEST_MAIN(TestCommands)
#include "tst_commands.moc"
