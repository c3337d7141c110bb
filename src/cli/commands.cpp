// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"

namespace cli {
const std::vector<Command>& commands()
{
    // "history" comes after its subcommands, because the first match is taken.
    static const std::vector<Command> all{portsCommand(),
                                          scanCommand(),
                                          infoCommand(),
                                          dumpCommand(),
                                          readCommand(),
                                          writeCommand(),
                                          setIdCommand(),
                                          setBaudCommand(),
                                          centerCommand(),
                                          restoreDefaultsCommand(),
                                          rebootCommand(),
                                          identifyCommand(),
                                          clearAlarmCommand(),
                                          torqueCommand(),
                                          stopCommand(),
                                          modeCommand(),
                                          moveCommand(),
                                          watchCommand(),
                                          sweepCommand(),
                                          sweepRunsCommand(),
                                          sweepReportCommand(),
                                          sweepReferenceCommand(),
                                          sweepCompareCommand(),
                                          stepResponseCommand(),
                                          stepRunsCommand(),
                                          stepReportCommand(),
                                          stepCompareCommand(),
                                          rawCommand(),
                                          recoverCommand(),
                                          snapshotSaveCommand(),
                                          snapshotShowCommand(),
                                          snapshotDiffCommand(),
                                          snapshotRestoreCommand(),
                                          bundleSaveCommand(),
                                          bundleRestoreCommand(),
                                          templateMakeCommand(),
                                          templateApplyCommand(),
                                          commissionCommand(),
                                          historySyncCommand(),
                                          historyShowCommand(),
                                          historyLabelCommand(),
                                          historySnapshotCommand(),
                                          historyTableCommand(),
                                          historyCommand(),
                                          tourCommand()};
    return all;
}
} // namespace cli
