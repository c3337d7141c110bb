// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/restore/restore_many.h"

#include "base/enum_names.h"
#include "device/reader.h"
#include "jobs/restore/take_snapshot.h"

namespace jobs {
using base::ErrorCode;

namespace {
ApplyVerdict verdictOf(RestoreVerdict verdict)
{
    switch (verdict) {
    case RestoreVerdict::AlreadySet:
        return ApplyVerdict::AlreadySet;
    case RestoreVerdict::Done:
        return ApplyVerdict::Done;
    case RestoreVerdict::Failed:
        return ApplyVerdict::Failed;
    case RestoreVerdict::RolledBack:
        return ApplyVerdict::RolledBack;
    }
    return ApplyVerdict::Error;
}

ApplyResult failed(int id, const base::Error& error)
{
    ApplyResult applied;
    applied.id = id;
    applied.verdict =
        error.code == ErrorCode::NoReply ? ApplyVerdict::NoReply : ApplyVerdict::Error;
    applied.error = error;
    return applied;
}

/// After these errors no servo can be reached any more.
bool endsJob(const ApplyResult& applied)
{
    return applied.error && (applied.error->code == ErrorCode::LinkLost ||
                             applied.error->code == ErrorCode::Stopped ||
                             applied.error->code == ErrorCode::Preempted);
}

std::vector<base::Protocol> protocolsOf(const snapshot::Snapshot& snapshot,
                                        const ApplyOptions& options)
{
    if (!options.protocols.empty())
        return options.protocols;
    return {base::protocolFromName(snapshot.servo.protocol).value_or(base::Protocol::Feetech)};
}

bool sameModel(const device::Servo& servo, const snapshot::Snapshot& snapshot)
{
    return servo.profile->mapKey == snapshot.servo.map &&
           servo.profile->identity.modelId() == snapshot.servo.modelId;
}

/// The first error on the wire, so that a lost link ends the list.
std::optional<base::Error> linkError(const RestoreOutcome& outcome)
{
    for (const RestoreRowResult& row : outcome.rows) {
        const auto& error = row.write.error;
        if (error && (error->code == ErrorCode::LinkLost || error->code == ErrorCode::Preempted))
            return error;
    }
    return std::nullopt;
}

ApplyResult applyToServo(const device::Context& context, int id, const snapshot::Snapshot& snapshot,
                         const ApplyOptions& options, bool requireSameModel,
                         const ProgressFn& progress)
{
    auto servo = device::identifyAmong(context, id, protocolsOf(snapshot, options));
    if (!servo)
        return failed(id, servo.error());
    ApplyResult applied;
    applied.id = id;
    applied.servo = *servo;
    if (requireSameModel && !sameModel(*servo, snapshot)) {
        applied.verdict = ApplyVerdict::OtherServo;
        return applied;
    }
    if (const auto read = device::readAll(context, *servo); !read)
        return failed(id, read.error());
    RestoreChoice choice = options.choice;
    choice.identity = false;
    applied.plan = planRestore(context, *servo, snapshot, choice);
    applied.servo = *servo;
    if (options.dryRun) {
        applied.verdict =
            plannedWrites(applied.plan).empty() ? ApplyVerdict::AlreadySet : ApplyVerdict::Planned;
        return applied;
    }
    const auto outcome = restore(context, *servo, applied.plan, options.restore, progress);
    applied.servo = *servo;
    if (!outcome) {
        applied.verdict = ApplyVerdict::Error;
        applied.error = outcome.error();
        return applied;
    }
    applied.outcome = *outcome;
    applied.verdict = verdictOf(outcome->verdict);
    applied.error = linkError(*outcome);
    return applied;
}

struct Target {
    int id = -1;
    const snapshot::Snapshot* snapshot = nullptr;
};

std::vector<ApplyResult> applyAll(const device::Context& context,
                                  const std::vector<Target>& targets, const ApplyOptions& options,
                                  bool requireSameModel, const ProgressFn& progress,
                                  const ApplyResultFn& onServo)
{
    std::vector<ApplyResult> all;
    std::optional<base::Error> end;
    const auto report = [&](const Progress& ofServo) {
        if (progress)
            progress({(double(all.size()) + ofServo.fraction) / double(targets.size()),
                      {},
                      int(all.size())});
    };
    for (const Target& target : targets) {
        if (!end && context.stop.isRequested())
            end = base::Error{ErrorCode::Stopped, QStringLiteral("restore"), {}, target.id};
        if (end)
            all.push_back(failed(target.id, *end));
        else
            all.push_back(applyToServo(context, target.id, *target.snapshot, options,
                                       requireSameModel, report));
        if (!end && endsJob(all.back()))
            end = all.back().error;
        if (onServo)
            onServo(all.back());
        report({});
    }
    return all;
}

constexpr base::EnumName<ApplyVerdict> applyVerdictNames[]{
    {ApplyVerdict::AlreadySet, "already-so"},  {ApplyVerdict::Done, "done"},
    {ApplyVerdict::Failed, "failed"},          {ApplyVerdict::RolledBack, "rolled-back"},
    {ApplyVerdict::Planned, "planned"},        {ApplyVerdict::NoReply, "no-answer"},
    {ApplyVerdict::OtherServo, "other-servo"}, {ApplyVerdict::Error, "error"},
};
} // namespace

QString verdictName(ApplyVerdict verdict)
{
    return base::nameOf(applyVerdictNames, verdict);
}

std::vector<ApplyResult> applyToServos(const device::Context& context, const std::vector<int>& ids,
                                       const snapshot::Snapshot& snapshot,
                                       const ApplyOptions& options, const ProgressFn& progress,
                                       const ApplyResultFn& onServo)
{
    std::vector<Target> targets;
    for (const int id : ids)
        targets.push_back({id, &snapshot});
    return applyAll(context, targets, options, false, progress, onServo);
}

std::vector<ApplyResult> restoreBundle(const device::Context& context,
                                       const snapshot::Bundle& bundle, const ApplyOptions& options,
                                       const ProgressFn& progress, const ApplyResultFn& onServo)
{
    std::vector<Target> targets;
    for (const snapshot::Snapshot& snapshot : bundle.servos)
        targets.push_back({snapshot.servo.id, &snapshot});
    return applyAll(context, targets, options, !options.otherModel, progress, onServo);
}

base::Result<snapshot::Bundle> takeBundle(const device::Context& context,
                                          std::vector<device::Servo>& servos,
                                          const QString& program, const ProgressFn& progress)
{
    snapshot::Bundle bundle;
    bundle.program = program;
    bundle.at = QDateTime::currentDateTimeUtc();
    bundle.port = context.bus.portName();
    for (device::Servo& servo : servos) {
        if (context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("bundle"), {}, servo.id);
        auto snapshot = takeSnapshot(context, servo, program);
        if (!snapshot)
            return tl::unexpected(snapshot.error());
        bundle.servos.push_back(std::move(*snapshot));
        if (progress)
            progress({double(bundle.servos.size()) / double(servos.size()),
                      {},
                      int(bundle.servos.size())});
    }
    return bundle;
}
} // namespace jobs
