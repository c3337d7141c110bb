// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the bench with snapshots: one servo as its plan says, or one snapshot, template
// or bundle for several. Values made on the main thread; callbacks arrive there, and are dropped
// when their guard is gone.
#pragma once

#include "jobs/restore/restore_many.h"
#include "session/servos/servo_entry.h"

#include <QPointer>

namespace session {
struct RestoreCompletion {
    std::optional<base::Error> error{}; ///< nothing was written
    std::optional<jobs::RestoreOutcome> outcome{};
};

struct RestoreRequest {
    jobs::RestorePlan plan{};  ///< with its ticks; made for the servo as it is in the list
    device::Consent consent{}; ///< to the dangerous rows that are selected
    jobs::OnFailure onFailure = jobs::OnFailure::Stop;
    QPointer<QObject> guard{};
    std::function<void(const RestoreCompletion&)> done{};
};

struct ApplyCompletion {
    std::optional<base::Error> error{};
    std::vector<jobs::ApplyResult> servos{}; ///< those it came to, also when it ended early
};

struct ApplyRequest {
    snapshot::Snapshot snapshot{};            ///< for `ids`; not looked at with a bundle
    std::optional<snapshot::Bundle> bundle{}; ///< by the IDs in it
    std::vector<int> ids{};
    jobs::ApplyOptions options{}; ///< beforeWrite is set by the bench
    QPointer<QObject> guard{};
    std::function<void(const jobs::ApplyResult&)> onServo{};
    std::function<void(const ApplyCompletion&)> done{};
};
} // namespace session
