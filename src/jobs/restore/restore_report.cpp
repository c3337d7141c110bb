// SPDX-License-Identifier: GPL-3.0-or-later
// A restore's outcome in words and as the record that is kept of it.
#include "jobs/restore/restore.h"

namespace jobs {
QString verdictName(RestoreVerdict verdict)
{
    switch (verdict) {
    case RestoreVerdict::AlreadySet:
        return QStringLiteral("already-so");
    case RestoreVerdict::Done:
        return QStringLiteral("done");
    case RestoreVerdict::Failed:
        return QStringLiteral("failed");
    case RestoreVerdict::RolledBack:
        return QStringLiteral("rolled-back");
    }
    return {};
}

record::RestoreResult toRestoreResult(const RestoreOutcome& outcome, const device::Servo& servo,
                                      const QString& source, const QString& program)
{
    const catalog::Profile& profile = *servo.profile;
    record::RestoreResult result;
    result.program = program;
    result.at = QDateTime::currentDateTimeUtc();
    result.source = source;
    result.port = servo.port;
    result.baud = servo.baud;
    result.servo = {servo.id,
                    profile.modelName,
                    profile.identity.modelId(),
                    profile.identity.firmware(),
                    profile.mapKey,
                    base::protocolName(profile.protocol)};
    result.verdict = verdictName(outcome.verdict);
    result.lock = device::lockName(outcome.lock);
    for (const RestoreRowResult& row : outcome.rows) {
        record::RestoreResultRow line;
        line.key = row.write.key;
        line.address = row.write.address;
        line.before = row.write.oldRaw;
        line.newRaw = row.write.newRaw;
        line.readBack = row.write.readBack;
        if (const catalog::Register* reg = profile.find(line.key)) {
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
