// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line: one servo after the other is plugged in alone, recognized, given
// template, ID and rate, checked, and unplugged again. Waits for servos at any rate and in every
// language; writes nothing while two answer; every finished servo is on the disk before the next is
// asked for. Nothing moves. The job's thread, for as long as the batch takes; it holds the whole
// bus and leaves it at the rate it had. What happens to one servo is its row; errors that end the
// line: BadArgument, LinkLost, Preempted, FileUnwritable, DiskFull, and those of the journal.
#pragma once

#include "device/consent.h"
#include "device/servo.h"
#include "jobs/job.h"
#include "results/commission_batch.h"

namespace jobs {
struct CommissionSpec {
    std::vector<int>
        ids{};    ///< to assign, in this order; IDs that the batch has assigned are skipped
    int baud = 0; ///< 0: each keeps its rate
    std::optional<snapshot::Snapshot> settings{}; ///< template; identity rows are not taken from it
    QString templateName{};
    device::Consent consent{}; ///< to dangerous rows of the template
    bool center = false;
    bool automatic = false;   ///< no click; what would need one is set aside
    int count = 0;            ///< ends after this number of servos; 0: when no ID is left
    std::vector<int> rates{}; ///< to search; empty: all
    std::vector<base::Protocol> protocols{}; ///< empty: all
    QString labelFormat = results::defaultLabelFormat();
};

enum class CommissionStep : std::uint8_t {
    Waiting, ///< for the next servo
    Blocked, ///< see the obstacle; goes on by itself when it is gone
    Checking,
    Confirm, ///< for the click
    Snapshot,
    Template,
    Id,
    Rate,
    Center,
    Health,
    Unplug, ///< done: waits until it is gone
};

enum class CommissionObstacle : std::uint8_t {
    None,
    DuplicateId,  ///< see `heard`
    DuplicateIds, ///< two under one ID
    Unreadable,   ///< a device replies but cannot be identified
    Lost,         ///< disconnected before it was done: continues when it is connected again
};

struct DetectedServo {
    QString model; ///< empty: not recognized
    results::ServoLocation place{};
    bool operator==(const DetectedServo&) const = default;
};

/// What the line is doing, to be shown.
struct CommissionView {
    CommissionStep step = CommissionStep::Waiting;
    CommissionObstacle obstacle = CommissionObstacle::None;
    std::vector<DetectedServo> detected{}; ///< Blocked
    snapshot::SnapshotServo servo{};       ///< the one at hand
    int baud = 0;                          ///< at which it answers
    int newId = -1;                        ///< the ID it gets, or has; Waiting: the next one's
    int newBaud = 0;
    bool isResumed = false; ///< it was unfinished and is completed now
    int candidateId = -1;   ///< Confirm: it may be the one that was to have this ID
    QString snapshot{};     ///< file with its table before the first write; empty: nothing written
    std::vector<results::CommissionIssue> issues{}; ///< Confirm: problems of the servo
    bool operator==(const CommissionView&) const = default;
};

enum class CommissionAnswer : std::uint8_t {
    None,      ///< not yet
    Continue,  ///< despite its issues
    SameServo, ///< it is the one that was to have `candidateId`
    Skip,
};

struct CommissionCallbacks {
    std::function<void(const CommissionView&)> onChange{};
    std::function<void(const results::CommissionRow&)> onRow{}; ///< on the disk already
    std::function<void()>
        onBatch{}; ///< the batch has changed, also what is unfinished; on the disk
    /// Called about twenty times a second while the step is Confirm. Empty: never answered.
    std::function<CommissionAnswer()> answer{};
    /// Called once before the first write to a servo: saves its table and returns the file.
    std::function<base::Result<QString>(const device::Context&, device::Servo&)> save{};
    /// A servo with the factory ID is about to be written to: a servo that has a name under this ID
    /// in the history is another one.
    std::function<base::Result<void>(const device::Servo&)> onNewServo{};
    /// It has its ID, and this label belongs to it; `another`: no servo of the history is this one.
    /// Called again if the label changes later. A failure is a remark of its row.
    std::function<base::Result<void>(const device::Servo&, const QString& label, bool another)>
        name{};
};

enum class CommissionEnd : std::uint8_t { Stopped, IdsExhausted, CountReached };

/// `batch` is what openCommissionBatch() gave for `csvPath`, and is kept there.
base::Result<CommissionEnd> commission(const device::Context& context, const CommissionSpec& spec,
                                       results::CommissionBatch& batch, const QString& csvPath,
                                       const CommissionCallbacks& callbacks = {});
} // namespace jobs
