// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/commands.h"

#include "ui/common/language_switch.h"
#include "ui/common/undo_text.h"

#include <QCoreApplication>
#include <QIcon>
#include <QRegularExpression>

namespace ui {
namespace {
/// Conditions of a command; all of them must hold.
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
    NoTest = 1U << 11, ///< no test uses the bus
    NoPort = 1U << 12, ///< and none is expected back
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
     QT_TRANSLATE_NOOP("Commands", "Opens the selected port and searches it for servos"), "network-connect", "F2", NotOpen},
    {Command::Disconnect, QT_TRANSLATE_NOOP("Commands", "&Disconnect"),
     QT_TRANSLATE_NOOP("Commands", "Closes the port; a write in progress is completed first"), "network-disconnect", "Shift+F2", Open},
    {Command::FindServos, QT_TRANSLATE_NOOP("Commands", "&Find servos on all ports…"),
     QT_TRANSLATE_NOOP("Commands", "Searches every serial port at every baud rate; writes nothing"), "edit-find", "", NoPort},
    {Command::UseSimulation, QT_TRANSLATE_NOOP("Commands", "Use the &simulated bus"),
     QT_TRANSLATE_NOOP("Commands", "Lets you try all features on simulated servos without any hardware"), "system-run", "", Always},
    {Command::UseSimulatedArm, QT_TRANSLATE_NOOP("Commands", "Use the simulated robot &arm"),
     QT_TRANSLATE_NOOP("Commands", "Lets you try the calibration of a robot arm without any hardware"), "system-run", "", Always},
    {Command::PowerCycle, QT_TRANSLATE_NOOP("Commands", "&Power-cycle the simulated servos"),
     QT_TRANSLATE_NOOP("Commands", "Temporary values are lost, as with a real power-off"), "system-reboot", "", Open | Simulated},
    {Command::Search, QT_TRANSLATE_NOOP("Commands", "&Search"),
     QT_TRANSLATE_NOOP("Commands", "Searches the bus for servos; writes nothing"), "edit-find", "F5", Open | NoTest},
    {Command::StopSearch, QT_TRANSLATE_NOOP("Commands", "S&top"),
     QT_TRANSLATE_NOOP("Commands", "Ends the search; the servos found so far stay in the list"), "process-stop", "Shift+F5", Searching},
    {Command::Diagnose, QT_TRANSLATE_NOOP("Commands", "&Why is a servo not replying?"),
     QT_TRANSLATE_NOOP("Commands", "Checks the bus, tries other baud rates and protocols, and identifies the cause; writes nothing"), "dialog-question", "", Open | NoTest},
    {Command::StopTask, QT_TRANSLATE_NOOP("Commands", "Stop the running &task"),
     QT_TRANSLATE_NOOP("Commands", "Ends the current task; a write in progress is completed safely first"), "process-stop", "Ctrl+.", Busy},
    {Command::ReadTable, QT_TRANSLATE_NOOP("Commands", "&Read all"),
     QT_TRANSLATE_NOOP("Commands", "Reads the whole memory table of the selected servo; writes "
                                   "nothing"), "view-refresh", "F6", Open | Chosen},
    {Command::FindRegister, QT_TRANSLATE_NOOP("Commands", "&Find a register"),
     QT_TRANSLATE_NOOP("Commands", "Moves the focus to the memory table filter"), "edit-find", "Ctrl+F", Always},
    {Command::CloseLock, QT_TRANSLATE_NOOP("Commands", "&Lock the EPROM"),
     QT_TRANSLATE_NOOP("Commands", "Locks the EPROM to prevent accidental permanent changes"), "object-locked", "", Open | Writable | LockIsOpen},
    {Command::CopyRows, QT_TRANSLATE_NOOP("Commands", "&Copy rows"),
     QT_TRANSLATE_NOOP("Commands", "Copies the selected rows of the memory table as text"), "edit-copy", "Ctrl+C", Known},
    {Command::ExportTable, QT_TRANSLATE_NOOP("Commands", "&Export the table…"),
     QT_TRANSLATE_NOOP("Commands", "Saves the memory table as a CSV or HTML file"), "document-export", "Ctrl+E", Known},
    {Command::PrintTable, QT_TRANSLATE_NOOP("Commands", "&Print the table…"),
     QT_TRANSLATE_NOOP("Commands", "Prints the memory table"), "document-print", "Ctrl+P", Known},
    {Command::Undo, QT_TRANSLATE_NOOP("Commands", "&Undo"),
     QT_TRANSLATE_NOOP("Commands", "Writes back the values from before the last change"), "edit-undo", "Ctrl+Z", Open | HasUndo},
    {Command::Redo, QT_TRANSLATE_NOOP("Commands", "Re&do"),
     QT_TRANSLATE_NOOP("Commands", "Reapplies the last undone change"), "edit-redo", "Ctrl+Shift+Z", Open | HasRedo},
    {Command::SetId, QT_TRANSLATE_NOOP("Commands", "Set &ID…"),
     QT_TRANSLATE_NOOP("Commands", "Changes the ID of the servo after checking that the new ID is free"), "tag", "Ctrl+I", Open | Writable},
    {Command::SetBaud, QT_TRANSLATE_NOOP("Commands", "Set &baud rate…"),
     QT_TRANSLATE_NOOP("Commands", "Changes the servo's baud rate and continues communicating at the new rate"), "speedometer", "Ctrl+B", Open | Writable},
    {Command::Center, QT_TRANSLATE_NOOP("Commands", "Set &midpoint…"),
     QT_TRANSLATE_NOOP("Commands", "Sets the present position as the midpoint"), "zoom-fit-best", "", Open | Writable},
    {Command::RestoreDefaults, QT_TRANSLATE_NOOP("Commands", "Reset to factory &defaults…"),
     QT_TRANSLATE_NOOP("Commands", "Resets all settings to factory defaults; saves the memory "
                                   "table first"), "edit-reset", "", Open | Writable},
    {Command::Reboot, QT_TRANSLATE_NOOP("Commands", "&Reboot…"),
     QT_TRANSLATE_NOOP("Commands", "Turns torque off, reboots the servo and waits for its reply"), "system-reboot", "", Open | Writable},
    {Command::UpdateFirmware, QT_TRANSLATE_NOOP("Commands", "&Update firmware…"),
     QT_TRANSLATE_NOOP("Commands", "Writes the vendor's firmware file to the selected servo, after checks"), "", "", Open | Writable | NoTest},
    {Command::RescueFirmware, QT_TRANSLATE_NOOP("Commands", "Rescue fir&mware…"),
     QT_TRANSLATE_NOOP("Commands", "Writes firmware to a servo that is in its bootloader"), "", "", Open | NoTest},
    {Command::Identify, QT_TRANSLATE_NOOP("Commands", "Blin&k LED"),
     QT_TRANSLATE_NOOP("Commands", "Blinks the servo's LED for a few seconds"), "flashlight-on", "Ctrl+L", Open | Writable},
    {Command::ClearAlarm, QT_TRANSLATE_NOOP("Commands", "Clear &alarm…"),
     QT_TRANSLATE_NOOP("Commands", "Shows what caused the alarm and lets you clear it"), "dialog-warning", "", Open | Known},
    {Command::OpenIntents, QT_TRANSLATE_NOOP("Commands", "Interrupted &writes…"),
     QT_TRANSLATE_NOOP("Commands", "Lists interrupted writes from earlier sessions"), "view-history", "", Open},
    {Command::PageOperate, QT_TRANSLATE_NOOP("Commands", "&Operate"),
     QT_TRANSLATE_NOOP("Commands", "Drive and monitor the servo"), "", "Ctrl+1", Always},
    {Command::PageMemory, QT_TRANSLATE_NOOP("Commands", "&Memory table"),
     QT_TRANSLATE_NOOP("Commands", "View and change the stored settings of the servo"), "", "Ctrl+2", Always},
    {Command::PageSweep, QT_TRANSLATE_NOOP("Commands", "S&weep test"),
     QT_TRANSLATE_NOOP("Commands", "Run a sweep test and evaluate the result"), "", "Ctrl+3", Always},
    {Command::PageStep, QT_TRANSLATE_NOOP("Commands", "S&tep response"),
     QT_TRANSLATE_NOOP("Commands", "See how a servo responds to a step, and try other gains"), "", "Ctrl+4", Always},
    {Command::PageSnapshots, QT_TRANSLATE_NOOP("Commands", "S&napshots"),
     QT_TRANSLATE_NOOP("Commands", "Save, compare and restore servo settings"), "", "Ctrl+5", Always},
    {Command::TakeSnapshot, QT_TRANSLATE_NOOP("Commands", "Take s&napshot"),
     QT_TRANSLATE_NOOP("Commands", "Reads the whole memory table and saves it in the history"), "document-save", "Ctrl+S", Open | Known},
    {Command::PageCommission, QT_TRANSLATE_NOOP("Commands", "&Commissioning"),
     QT_TRANSLATE_NOOP("Commands", "Set up servos one at a time"), "", "Ctrl+6", Always},
    {Command::PageArm, QT_TRANSLATE_NOOP("Commands", "&Arm"),
     QT_TRANSLATE_NOOP("Commands", "Calibrate a robot arm by moving its joints"), "", "Ctrl+7", Always},
    {Command::PageFirmware, QT_TRANSLATE_NOOP("Commands", "&Firmware"),
     QT_TRANSLATE_NOOP("Commands", "Compare the firmware versions of the servos"), "", "Ctrl+8", Always},
    {Command::PageHistory, QT_TRANSLATE_NOOP("Commands", "&History"),
     QT_TRANSLATE_NOOP("Commands", "All writes, snapshots, tests and alarms"), "", "Ctrl+9", Always},
    {Command::PreviousTests, QT_TRANSLATE_NOOP("Commands", "&Earlier tests…"),
     QT_TRANSLATE_NOOP("Commands", "Lists saved tests and lets you compare two or mark one as the reference"), "view-history", "Ctrl+H", Always},
    {Command::PauseTrend, QT_TRANSLATE_NOOP("Commands", "&Pause the chart"),
     QT_TRANSLATE_NOOP("Commands", "Pauses or resumes the chart; measuring continues"), "media-playback-pause", "F7", Always},
    {Command::Record, QT_TRANSLATE_NOOP("Commands", "&Record…"),
     QT_TRANSLATE_NOOP("Commands", "Starts or stops recording measured values to a file"), "media-record", "Ctrl+R", Open},
    {Command::OpenRecording, QT_TRANSLATE_NOOP("Commands", "Op&en a recording…"),
     QT_TRANSLATE_NOOP("Commands", "Shows a recording in the chart"), "document-open", "Ctrl+O", Always},
    {Command::TorqueOffAll, QT_TRANSLATE_NOOP("Commands", "All &torque off"),
     QT_TRANSLATE_NOOP("Commands", "Immediately turns torque off on the whole bus (Esc, even in the input fields of the motion panel; Shift+Esc anywhere)"), "process-stop", "", Always},
    {Command::ThemeSystem, QT_TRANSLATE_NOOP("Commands", "&System"),
     QT_TRANSLATE_NOOP("Commands", "Follows the light or dark setting of the desktop"), "", "", Always, true},
    {Command::ThemeLight, QT_TRANSLATE_NOOP("Commands", "&Light"),
     QT_TRANSLATE_NOOP("Commands", "Dark text on a light window"), "", "", Always, true},
    {Command::ThemeDark, QT_TRANSLATE_NOOP("Commands", "&Dark"),
     QT_TRANSLATE_NOOP("Commands", "Light text on a dark window"), "", "", Always, true},
    {Command::English, "&English", QT_TRANSLATE_NOOP("Commands", "Shows the interface in English"), "", "", Always, true},
    {Command::Chinese, "简体中文(&Z)", QT_TRANSLATE_NOOP("Commands", "Shows the interface in Simplified Chinese"), "", "", Always, true},
    {Command::MessageLog, QT_TRANSLATE_NOOP("Commands", "&Messages"),
     QT_TRANSLATE_NOOP("Commands", "All messages since the program started"), "view-list-text", "F8", Always, true},
    {Command::Help, QT_TRANSLATE_NOOP("Commands", "&Help"),
     QT_TRANSLATE_NOOP("Commands", "How to connect, search, read and write"), "help-contents", "F1", Always},
    {Command::Shortcuts, QT_TRANSLATE_NOOP("Commands", "&Keyboard shortcuts"),
     QT_TRANSLATE_NOOP("Commands", "Lists all shortcuts"), "input-keyboard", "Ctrl+F1", Always},
    {Command::About, QT_TRANSLATE_NOOP("Commands", "&About ServoDesk"),
     QT_TRANSLATE_NOOP("Commands", "Version, license and file locations"), "help-about", "", Always},
    {Command::Quit, QT_TRANSLATE_NOOP("Commands", "&Quit"),
     QT_TRANSLATE_NOOP("Commands", "Quits the program; a write in progress is completed first"), "application-exit", "Ctrl+Q", Always},
}};
// clang-format on

/// Without the menu key: in Chinese texts it is in brackets, which a button must not show.
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

unsigned situation(const session::Workbench& workbench, const Selection& selection)
{
    const bool open = workbench.link().state() == session::LinkState::Open;
    const bool idle = workbench.link().state() == session::LinkState::Off ||
                      workbench.link().state() == session::LinkState::Lost;
    unsigned now = (open ? Open : 0U) | (idle ? NotOpen : 0U);
    now |= workbench.link().state() == session::LinkState::Off ? NoPort : 0U;
    now |= workbench.link().isSimulated() ? Simulated : 0U;
    now |= workbench.search().isSearching() ? Searching : 0U;
    now |= workbench.tasks().isBusy() ? Busy : 0U;
    now |= workbench.tasks().isTesting() ? 0U : NoTest;
    now |= workbench.writes().undoStep() != nullptr ? HasUndo : 0U;
    now |= workbench.writes().redoStep() != nullptr ? HasRedo : 0U;
    if (const session::ServoEntry* servo = workbench.registry().servo(selection.current())) {
        const auto& profile = servo->servo.profile;
        now |= Chosen | (profile ? Known : 0U) | (profile && profile->writable ? Writable : 0U);
        now |= servo->isLockOpen().value_or(false) ? LockIsOpen : 0U;
    }
    return now;
}
} // namespace

Commands::Commands(session::Workbench& workbench, const Selection& selection, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
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
    connect(&workbench.link(), &session::LinkController::linkChanged, this, &Commands::refresh);
    connect(&workbench.search(), &session::SearchService::searchChanged, this, &Commands::refresh);
    connect(&workbench.tasks(), &session::TaskQueue::taskChanged, this, &Commands::refresh);
    connect(&workbench.writes(), &session::WriteService::undoChanged, this, &Commands::refresh);
    connect(&workbench.registry(), &session::ServoRegistry::servoChanged, this, &Commands::refresh);
    connect(&workbench.registry(), &session::ServoRegistry::servoRemoved, this, &Commands::refresh);
    connect(&workbench.registry(), &session::ServoRegistry::servosCleared, this,
            &Commands::refresh);
    connect(&selection, &Selection::changed, this, &Commands::refresh);
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

/// Undo and Redo name what they change, and in which servo.
void Commands::updateUndoTexts()
{
    const auto name = [this](Command command, const session::UndoStep* step, bool back) {
        const Row& row = rowOf(static_cast<std::size_t>(command));
        QAction* action = m_actions[static_cast<std::size_t>(command)];
        const QString verb = QCoreApplication::translate("Commands", row.text);
        QString tip = QCoreApplication::translate("Commands", row.tip);
        QString text = verb;
        if (step != nullptr) {
            const UndoText words = undoText(m_workbench.registry(), *step, back);
            text = tr("%1: %2").arg(verb, words.brief);
            tip += QLatin1Char('\n') + words.lines.join(QLatin1Char('\n'));
        }
        action->setText(text);
        action->setIconText(buttonText(text));
        action->setWhatsThis(tip);
        action->setToolTip(tip + QStringLiteral(" (%1)").arg(
                                     action->shortcut().toString(QKeySequence::NativeText)));
    };
    name(Command::Undo, m_workbench.writes().undoStep(), true);
    name(Command::Redo, m_workbench.writes().redoStep(), false);
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
    const unsigned now = situation(m_workbench, m_selection);
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        unsigned needed = rowOf(i).when;
        if ((needed & (Writable | HasUndo | HasRedo)) != 0)
            needed |= NoTest;
        m_actions[i]->setEnabled((needed & ~now) == 0);
    }
}
} // namespace ui
