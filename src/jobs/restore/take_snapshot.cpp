// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/take_snapshot.h"

#include "device/reader.h"

namespace jobs {
snapshot::SnapshotServo snapshotServo(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    return {servo.id,
            profile.modelName,
            profile.identity.modelId(),
            profile.identity.firmware(),
            profile.mapKey,
            base::protocolName(profile.protocol)};
}

snapshot::Snapshot emptySnapshot(const device::Servo& servo, const QString& program)
{
    snapshot::Snapshot snapshot;
    snapshot.program = program;
    snapshot.at = QDateTime::currentDateTimeUtc();
    snapshot.port = servo.port;
    snapshot.baud = servo.baud;
    snapshot.servo = snapshotServo(servo);
    return snapshot;
}

snapshot::Snapshot snapshotOf(const device::Servo& servo, const QString& program)
{
    snapshot::Snapshot snapshot = emptySnapshot(servo, program);
    for (const catalog::Register& reg : servo.profile->registers) {
        const catalog::ValueFormat meaning = servo.meaning(reg);
        const auto raw = servo.raw(reg);
        snapshot::SnapshotRegister row;
        row.key = reg.key;
        row.address = reg.address;
        row.raw = raw;
        if (raw)
            row.value = catalog::toPhysical(*raw, meaning);
        row.unit = meaning.unit;
        row.area = reg.area;
        row.access = reg.access;
        snapshot.registers.push_back(std::move(row));
    }
    return snapshot;
}

base::Result<snapshot::Snapshot> takeSnapshot(const device::Context& context, device::Servo& servo,
                                              const QString& program)
{
    if (const auto read = device::readAll(context, servo); !read)
        return tl::unexpected(read.error());
    return snapshotOf(servo, program);
}
} // namespace jobs
