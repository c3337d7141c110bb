// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/commands.h"

#include "ui/common/language_switch.h"
#include "ui/common/undo_text.h"

#include <QCoreApplication>
#include <QIcon>
#include <QRegularExpression>

namespace ui {
namespace {
/// What must be so for a command to be of use; all of them.
enum When : unsigned {
    Always = 0,
    Open = 1U << 0,
    NotOpen = 1U << 1,
    Simulated = 1U << 2,
    Searching = 1U << 3,
    Busy = 1U << 4,
    Chosen = 1U << 5,     ///< a servo is selected
    Known = 1U << 6,      ///< and it could be identified
    Writable = 1U << 7,   ///< and ServoDesk knows its family well enough to write
    LockIsOpen = 1U << 8, ///< and its EPROM lock reads open
    HasUndo = 1U << 9,
    HasRedo = 1U << 10,
    NoTest = 1U << 11, ///< no lasting test has the bus
};

struct Row {
    Command command;
    const char* text; ///< context "Commands"
    const char* tip;
    const char* icon; ///< Breeze; empty: none
    const char* keys; ///< portable text; empty: none
    unsigned when;
    bool checkable = false;
};

// clang-format off
const std::array<Row, static_cast<std::size_t>(Command::Count)> table{{
    {Command::Connect, QT_TRANSLATE_NOOP("Commands", "&Connect"),
     QT_TRANSLATE_NOOP("Commands", "Open the chosen port and search it"), "network-connect", "F2", NotOpen},
    {Command::Disconnect, QT_TRANSLATE_NOOP("Commands", "&Disconnect"),
     QT_TRANSLATE_NOOP("Commands", "Close the port; a running write ends first"), "network-disconnect", "Shift+F2", Open},
    {Command::UseSimulation, QT_TRANSLATE_NOOP("Commands", "Use the &simulated bus"),
     QT_TRANSLATE_NOOP("Commands", "Try everything on simulated servos, without hardware"), "system-run", "", Always},
    {Command::PowerCycle, QT_TRANSLATE_NOOP("Commands", "S&witch the simulated servos off and on"),
     QT_TRANSLATE_NOOP("Commands", "What was written temporarily is lost, as at a real power-off"), "system-reboot", "", Open | Simulated},
    {Command::Search, QT_TRANSLATE_NOOP("Commands", "&Search"),
     QT_TRANSLATE_NOOP("Commands", "Search the bus for servos; writes nothing"), "edit-find", "F5", Open | NoTest},
    {Command::StopSearch, QT_TRANSLATE_NOOP("Commands", "S&top"),
     QT_TRANSLATE_NOOP("Commands", "End the search; what was found stays"), "process-stop", "Shift+F5", Searching},
    {Command::StopTask, QT_TRANSLATE_NOOP("Commands", "Stop the running &task"),
     QT_TRANSLATE_NOOP("Commands", "End what is being done to a servo; a write in progress ends safely first"), "process-stop", "Ctrl+.", Busy},
    {Command::ReadTable, QT_TRANSLATE_NOOP("Commands", "&Read all"),
     QT_TRANSLATE_NOOP("Commands", "Read the whole memory table of the selected servo; writes nothing"), "view-refresh", "F6", Open | Chosen},
    {Command::FindRegister, QT_TRANSLATE_NOOP("Commands", "&Find a register"),
     QT_TRANSLATE_NOOP("Commands", "Go to the field that filters the memory table"), "edit-find", "Ctrl+F", Always},
    {Command::CloseLock, QT_TRANSLATE_NOOP("Commands", "Close the EPROM &lock"),
     QT_TRANSLATE_NOOP("Commands", "Close the lock that stands open, so that nothing is changed for good by accident"), "object-locked", "", Open | Writable | LockIsOpen},
    {Command::CopyRows, QT_TRANSLATE_NOOP("Commands", "&Copy rows"),
     QT_TRANSLATE_NOOP("Commands", "Copy the selected rows of the table as text"), "edit-copy", "Ctrl+C", Known},
    {Command::ExportTable, QT_TRANSLATE_NOOP("Commands", "&Export the table…"),
     QT_TRANSLATE_NOOP("Commands", "Write the memory table to a CSV or HTML file"), "document-export", "Ctrl+E", Known},
    {Command::PrintTable, QT_TRANSLATE_NOOP("Commands", "&Print the table…"),
     QT_TRANSLATE_NOOP("Commands", "Print the memory table"), "document-print", "Ctrl+P", Known},
    {Command::Undo, QT_TRANSLATE_NOOP("Commands", "&Undo"),
     QT_TRANSLATE_NOOP("Commands", "Write the old values of the last change back"), "edit-undo", "Ctrl+Z", Open | HasUndo},
    {Command::Redo, QT_TRANSLATE_NOOP("Commands", "Re&do"),
     QT_TRANSLATE_NOOP("Commands", "Write the change again that was undone"), "edit-redo", "Ctrl+Shift+Z", Open | HasRedo},
    {Command::SetId, QT_TRANSLATE_NOOP("Commands", "Set &ID…"),
     QT_TRANSLATE_NOOP("Commands", "Give the servo another ID, which is proven free first"), "tag", "Ctrl+I", Open | Writable},
    {Command::SetBaud, QT_TRANSLATE_NOOP("Commands", "Set &baud rate…"),
     QT_TRANSLATE_NOOP("Commands", "Give the servo another baud rate, and follow it there"), "speedometer", "Ctrl+B", Open | Writable},
    {Command::Center, QT_TRANSLATE_NOOP("Commands", "&Centre here…"),
     QT_TRANSLATE_NOOP("Commands", "Make the present position the middle"), "zoom-fit-best", "", Open | Writable},
    {Command::RestoreDefaults, QT_TRANSLATE_NOOP("Commands", "Restore &defaults…"),
     QT_TRANSLATE_NOOP("Commands", "Back to factory settings; the table is saved first"), "edit-reset", "", Open | Writable},
    {Command::Reboot, QT_TRANSLATE_NOOP("Commands", "&Restart…"),
     QT_TRANSLATE_NOOP("Commands", "Take torque off, restart the servo and wait for it"), "system-reboot", "", Open | Writable},
    {Command::Identify, QT_TRANSLATE_NOOP("Commands", "Identi&fy"),
     QT_TRANSLATE_NOOP("Commands", "Let the servo show its LED for some seconds"), "flashlight-on", "Ctrl+L", Open | Writable},
    {Command::ClearAlarm, QT_TRANSLATE_NOOP("Commands", "Clear &alarm…"),
     QT_TRANSLATE_NOOP("Commands", "Show what holds the alarm and release it by its cause"), "dialog-warning", "", Open | Known},
    {Command::OpenIntents, QT_TRANSLATE_NOOP("Commands", "Interrupted &writes…"),
     QT_TRANSLATE_NOOP("Commands", "Writes of earlier sessions that have no end in the journal"), "view-history", "", Open},
    {Command::PageOperate, QT_TRANSLATE_NOOP("Commands", "&Operate"),
     QT_TRANSLATE_NOOP("Commands", "Drive the servo and watch it"), "", "Ctrl+1", Always},
    {Command::PageMemory, QT_TRANSLATE_NOOP("Commands", "&Memory table"),
     QT_TRANSLATE_NOOP("Commands", "Read and change what the servo keeps"), "", "Ctrl+2", Always},
    {Command::PageSweep, QT_TRANSLATE_NOOP("Commands", "S&weep test"),
     QT_TRANSLATE_NOOP("Commands", "Run servos through their paces and judge them"), "", "Ctrl+3", Always},
    {Command::PageStep, QT_TRANSLATE_NOOP("Commands", "S&tep response"),
     QT_TRANSLATE_NOOP("Commands", "See how a servo answers a step, and try other gains"), "", "Ctrl+4", Always},
    {Command::PageSnapshots, QT_TRANSLATE_NOOP("Commands", "S&napshots"),
     QT_TRANSLATE_NOOP("Commands", "Save, compare and restore what servos keep"), "", "Ctrl+5", Always},
    {Command::TakeSnapshot, QT_TRANSLATE_NOOP("Commands", "Take s&napshot"),
     QT_TRANSLATE_NOOP("Commands", "Read the whole table and keep it in the history"), "document-save", "Ctrl+S", Open | Known},
    {Command::PageCommission, QT_TRANSLATE_NOOP("Commands", "&Commissioning"),
     QT_TRANSLATE_NOOP("Commands", "Set up servos plugged in one after the other"), "", "Ctrl+6", Always},
    {Command::PageHistory, QT_TRANSLATE_NOOP("Commands", "&History"),
     QT_TRANSLATE_NOOP("Commands", "What was ever written, saved, tested and alarmed"), "", "Ctrl+7", Always},
    {Command::PreviousTests, QT_TRANSLATE_NOOP("Commands", "&Earlier tests…"),
     QT_TRANSLATE_NOOP("Commands", "Look at kept tests, compare two, choose a reference"), "view-history", "Ctrl+H", Always},
    {Command::PauseTrend, QT_TRANSLATE_NOOP("Commands", "&Pause the chart"),
     QT_TRANSLATE_NOOP("Commands", "Let the chart stand still, or follow again; measuring goes on"), "media-playback-pause", "F7", Always},
    {Command::Record, QT_TRANSLATE_NOOP("Commands", "&Record…"),
     QT_TRANSLATE_NOOP("Commands", "Write what is measured to a file, or end that"), "media-record", "Ctrl+R", Open},
    {Command::OpenRecording, QT_TRANSLATE_NOOP("Commands", "Op&en a recording…"),
     QT_TRANSLATE_NOOP("Commands", "Show a recording in the chart"), "document-open", "Ctrl+O", Always},
    {Command::TorqueOffAll, QT_TRANSLATE_NOOP("Commands", "&Torque off — all"),
     QT_TRANSLATE_NOOP("Commands", "Take torque off the whole bus at once (Esc, also in a field of the motion panel; whatever is open: Shift+Esc)"), "process-stop", "", Always},
    {Command::ThemeSystem, QT_TRANSLATE_NOOP("Commands", "Theme of the &system"),
     QT_TRANSLATE_NOOP("Commands", "Light or dark as the desktop is"), "", "", Always, true},
    {Command::ThemeLight, QT_TRANSLATE_NOOP("Commands", "&Light"),
     QT_TRANSLATE_NOOP("Commands", "Dark text on a light window"), "", "", Always, true},
    {Command::ThemeDark, QT_TRANSLATE_NOOP("Commands", "&Dark"),
     QT_TRANSLATE_NOOP("Commands", "Light text on a dark window"), "", "", Always, true},
    {Command::English, "&English", QT_TRANSLATE_NOOP("Commands", "The interface in English"), "", "", Always, true},
    {Command::Chinese, "简体中文(&Z)", QT_TRANSLATE_NOOP("Commands", "The interface in Simplified Chinese"), "", "", Always, true},
    {Command::MessageLog, QT_TRANSLATE_NOOP("Commands", "&Messages"),
     QT_TRANSLATE_NOOP("Commands", "Everything that was reported since the start"), "view-list-text", "F8", Always, true},
    {Command::Help, QT_TRANSLATE_NOOP("Commands", "&Help"),
     QT_TRANSLATE_NOOP("Commands", "How to connect, search, read and write"), "help-contents", "F1", Always},
    {Command::Shortcuts, QT_TRANSLATE_NOOP("Commands", "&Keyboard shortcuts"),
     QT_TRANSLATE_NOOP("Commands", "The list of all shortcuts"), "input-keyboard", "Ctrl+F1", Always},
    {Command::About, QT_TRANSLATE_NOOP("Commands", "&About ServoDesk"),
     QT_TRANSLATE_NOOP("Commands", "Version, licence and where files are kept"), "help-about", "", Always},
    {Command::Quit, QT_TRANSLATE_NOOP("Commands", "&Quit"),
     QT_TRANSLATE_NOOP("Commands", "End the program; a running write ends first"), "application-exit", "Ctrl+Q", Always},
}};
// clang-format on

/// Without the key of a menu: Chinese ones carry it in brackets, which a button must not show.
QString buttonText(QString text)
{
    static const QRegularExpression menuKey(QStringLiteral("\\(&.\\)"));
    return text.remove(menuKey).remove(QLatin1Char('&'));
}

const Row& rowOf(std::size_t index)
{
    Q_ASSERT(static_cast<std::size_t>(table[index].command) == index);
    return table[index];
}

unsigned situation(const session::Desk& desk, const Selection& selection)
{
    const bool open = desk.state() == session::LinkState::Open;
    const bool idle =
        desk.state() == session::LinkState::Off || desk.state() == session::LinkState::Lost;
    unsigned now = (open ? Open : 0U) | (idle ? NotOpen : 0U);
    now |= desk.isSimulated() ? Simulated : 0U;
    now |= desk.isSearching() ? Searching : 0U;
    now |= desk.isBusy() ? Busy : 0U;
    now |= desk.isTesting() ? 0U : NoTest;
    now |= desk.undoStep() != nullptr ? HasUndo : 0U;
    now |= desk.redoStep() != nullptr ? HasRedo : 0U;
    if (const session::ServoEntry* servo = desk.servo(selection.current())) {
        const auto& profile = servo->servo.profile;
        now |= Chosen | (profile ? Known : 0U) | (profile && profile->writable ? Writable : 0U);
        now |= servo->isLockOpen().value_or(false) ? LockIsOpen : 0U;
    }
    return now;
}
} // namespace

Commands::Commands(session::Desk& desk, const Selection& selection, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_selection(selection)
{
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        auto* action = new QAction(this);
        action->setShortcut(QKeySequence(QString::fromLatin1(rowOf(i).keys)));
        action->setCheckable(rowOf(i).checkable);
        action->setObjectName(QStringLiteral("command%1").arg(i));
        action->setMenuRole(QAction::NoRole);
        m_actions[i] = action;
    }
    retranslate();
    updateIcons();
    const auto again = [this] { refresh(); };
    connect(&desk, &session::Desk::linkChanged, this, again);
    connect(&desk, &session::Desk::searchChanged, this, again);
    connect(&desk, &session::Desk::taskChanged, this, again);
    connect(&desk, &session::Desk::undoChanged, this, again);
    connect(&desk, &session::Desk::servoChanged, this, again);
    connect(&desk, &session::Desk::servoRemoved, this, again);
    connect(&desk, &session::Desk::servosCleared, this, again);
    connect(&selection, &Selection::changed, this, again);
    refresh();
}

void Commands::retranslate()
{
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        QAction* action = m_actions[i];
        const Row& row = rowOf(i);
        action->setText(row.command == Command::Chinese && !LanguageSwitch::canShowChinese()
                            ? QStringLiteral("Simplified &Chinese")
                            : QCoreApplication::translate("Commands", row.text));
        action->setIconText(buttonText(action->text()));
        QString tip = QCoreApplication::translate("Commands", row.tip);
        action->setWhatsThis(tip); // no status tip: it would take the place of results
        if (!action->shortcut().isEmpty())
            tip +=
                QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
        action->setToolTip(tip);
    }
    updateUndoTexts();
}

/// Undo and Redo say what they change back, and in which servo.
void Commands::updateUndoTexts()
{
    const auto name = [this](Command command, const session::UndoStep* step, bool back) {
        const Row& row = rowOf(static_cast<std::size_t>(command));
        QAction* action = m_actions[static_cast<std::size_t>(command)];
        const QString verb = QCoreApplication::translate("Commands", row.text);
        QString tip = QCoreApplication::translate("Commands", row.tip);
        QString text = verb;
        if (step != nullptr) {
            const UndoText words = undoText(m_desk, *step, back);
            text = tr("%1: %2").arg(verb, words.brief);
            tip += QLatin1Char('\n') + words.lines.join(QLatin1Char('\n'));
        }
        action->setText(text);
        action->setIconText(buttonText(text));
        action->setWhatsThis(tip);
        action->setToolTip(tip + QStringLiteral(" (%1)").arg(
                                     action->shortcut().toString(QKeySequence::NativeText)));
    };
    name(Command::Undo, m_desk.undoStep(), true);
    name(Command::Redo, m_desk.redoStep(), false);
}

void Commands::updateIcons()
{
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        if (const char* icon = rowOf(i).icon; *icon != '\0')
            m_actions[i]->setIcon(QIcon::fromTheme(QString::fromLatin1(icon)));
    }
}

void Commands::refresh()
{
    updateUndoTexts();
    const unsigned now = situation(m_desk, m_selection);
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        unsigned needed = rowOf(i).when;
        if ((needed & (Writable | HasUndo | HasRedo)) != 0)
            needed |= NoTest;
        m_actions[i]->setEnabled((needed & ~now) == 0);
    }
}
} // namespace ui
