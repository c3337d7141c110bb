// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/multi_servo_restore.h"

#include "cli/output/restore_text.h"
#include "cli/translate.h"
#include "session/snapshot/safety_snapshot.h"

namespace cli {
MultiServoRestore::MultiServoRestore(Run& run, const Values& values)
    : m_run(run)
    , m_values(values)
{
    m_line.emplace(run.console(), translate("cli", "Restoring"));
}

jobs::ApplyOptions MultiServoRestore::options()
{
    jobs::ApplyOptions options;
    options.choice = choiceOf(m_values);
    options.restore = restoreOptionsOf(m_values);
    options.restore.beforeWrite = [this](const device::Context& context, device::Servo& servo) {
        return m_run.backupTable(context, servo);
    };
    options.dryRun = m_values.has("--dry-run");
    if (m_run.globals().protocol)
        options.protocols = {*m_run.globals().protocol};
    return options;
}

jobs::ProgressFn MultiServoRestore::progress()
{
    return [this](const jobs::Progress& progress) { m_line->update(progress); };
}

base::Result<Exit> MultiServoRestore::finish(const std::vector<jobs::ApplyResult>& all,
                                             const QString& file, Json document)
{
    m_line.reset();
    Json::Array servos;
    QString text = appliedText(all);
    for (const jobs::ApplyResult& one : all)
        servos.push_back(jsonApplied(one));
    if (!file.isEmpty())
        document.add("file", file);
    document.add("dry_run", m_values.has("--dry-run")).add("servos", std::move(servos));
    if (const auto result = m_values.option("--result")) {
        const auto saved = snapshot::saveRestoreResults(resultsOf(all, file), *result);
        if (!saved)
            return tl::unexpected(saved.error());
        document.add("result", *result);
        text += translate("cli", "Result saved to %1").arg(*result) + QLatin1Char('\n');
    }
    m_run.finish(std::move(document), text);
    return exitCode(all);
}
} // namespace cli
