// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"

namespace cli {
const std::vector<CommandGroup>& commandGroups()
{
    static const std::vector<CommandGroup> groups{
        {QT_TRANSLATE_NOOP("cli", "Find and read:"),
         {portsCommand(), findCommand(), scanCommand(), diagnoseCommand(), infoCommand(),
          dumpCommand(), readCommand(), firmwareListCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Write:"),
         {writeCommand(), setIdCommand(), setBaudCommand(), centerCommand(),
          restoreDefaultsCommand(), rebootCommand(), clearAlarmCommand(), firmwareUpdateCommand(),
          firmwareRescueCommand(), commissionCommand(), commissionReportCommand(),
          recoverCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Move and watch:"),
         {torqueCommand(), stopCommand(), modeCommand(), moveCommand(), watchCommand(),
          identifyCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Test:"),
         {sweepCommand(), sweepRunsCommand(), sweepReportCommand(), sweepReferenceCommand(),
          sweepCompareCommand(), stepResponseCommand(), stepRunsCommand(), stepReportCommand(),
          stepCompareCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Save and restore:"),
         {snapshotSaveCommand(), snapshotShowCommand(), snapshotDiffCommand(),
          snapshotRestoreCommand(), bundleSaveCommand(), bundleRestoreCommand(),
          templateMakeCommand(), templateApplyCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Robot arm:"),
         {armShowCommand(), armCalibrateCommand(), armExportCommand(), armCompareCommand(),
          armApplyCommand(), armPrepareCommand(), armTestCommand()}},
        // "history" comes after its subcommands, because the first match is taken.
        {QT_TRANSLATE_NOOP("cli", "History:"),
         {historyShowCommand(), historyLabelCommand(), historySnapshotCommand(),
          historyTableCommand(), historySyncCommand(), historyCommand()}},
        {QT_TRANSLATE_NOOP("cli", "Tools:"), {rawCommand(), tourCommand()}},
    };
    return groups;
}

const std::vector<Command>& commands()
{
    static const std::vector<Command> all = [] {
        std::vector<Command> list;
        for (const CommandGroup& group : commandGroups())
            list.insert(list.end(), group.commands.begin(), group.commands.end());
        return list;
    }();
    return all;
}
} // namespace cli
