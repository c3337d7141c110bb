// SPDX-License-Identifier: GPL-3.0-or-later
// One function per command. Pure data; any thread.
#pragma once

#include "cli/command.h"

namespace cli {
Command portsCommand();
Command scanCommand();
Command findCommand();
Command infoCommand();
Command firmwareListCommand();
Command firmwareUpdateCommand();
Command firmwareRescueCommand();
Command dumpCommand();
Command readCommand();
Command writeCommand();
Command setIdCommand();
Command setBaudCommand();
Command centerCommand();
Command restoreDefaultsCommand();
Command rebootCommand();
Command identifyCommand();
Command clearAlarmCommand();
Command torqueCommand();
Command stopCommand();
Command modeCommand();
Command moveCommand();
Command watchCommand();
Command sweepCommand();
Command stepResponseCommand();
Command stepRunsCommand();
Command stepReportCommand();
Command stepCompareCommand();
Command sweepRunsCommand();
Command sweepReportCommand();
Command sweepReferenceCommand();
Command sweepCompareCommand();
Command rawCommand();
Command recoverCommand();
Command historySyncCommand();
Command snapshotSaveCommand();
Command snapshotShowCommand();
Command snapshotDiffCommand();
Command snapshotRestoreCommand();
Command armShowCommand();
Command armCalibrateCommand();
Command armCompareCommand();
Command armApplyCommand();
Command armExportCommand();
Command armPrepareCommand();
Command armTestCommand();
Command bundleSaveCommand();
Command bundleRestoreCommand();
Command templateMakeCommand();
Command templateApplyCommand();
Command commissionCommand();
Command commissionReportCommand();
Command diagnoseCommand();
Command historyShowCommand();
Command historyLabelCommand();
Command historySnapshotCommand();
Command historyTableCommand();
Command historyCommand();
Command tourCommand();
} // namespace cli
