// SPDX-License-Identifier: GPL-3.0-or-later
// The names of a restore's outcome, and the record that is saved of it.
#include "base/enum_names.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"

namespace jobs {
namespace {
constexpr base::EnumName<RestoreVerdict> restoreVerdictNames[]{
    {RestoreVerdict::AlreadySet, "already-so"},
    {RestoreVerdict::Done, "done"},
    {RestoreVerdict::Failed, "failed"},
    {RestoreVerdict::RolledBack, "rolled-back"},
};
} // namespace

QString verdictName(RestoreVerdict verdict)
{
    return base::nameOf(restoreVerdictNames, verdict);
}

snapshot::RestoreResult toRestoreResult(const RestoreOutcome& outcome, const device::Servo& servo,
                                        const QString& source, const QString& program)
{
    snapshot::RestoreResult result;
    result.program = program;
    result.at = QDateTime::currentDateTimeUtc();
    result.source = source;
    result.port = servo.port;
    result.baud = servo.baud;
    result.servo = snapshotServo(servo);
    result.verdict = verdictName(outcome.verdict);
    result.lock = device::lockName(outcome.lock);
    for (const RestoreRowResult& row : outcome.rows) {
        snapshot::RestoreResultRow line;
        line.key = row.write.key;
        line.address = row.write.address;
        line.before = row.write.oldRaw;
        line.newRaw = row.write.newRaw;
        line.readBack = row.write.readBack;
        if (const catalog::Register* reg = servo.profile->find(line.key)) {
            const catalog::ValueFormat meaning = servo.meaning(*reg);
            line.newValue = catalog::toPhysical(line.newRaw, meaning);
            line.unit = meaning.unit;
        }
        line.outcome = device::outcomeName(row.write.outcome);
        line.error = row.write.error ? base::errorName(row.write.error->code) : QString();
        line.rolledBack = row.rolledBack;
        result.rows.push_back(std::move(line));
    }
    return result;
}
} // namespace jobs
