// SPDX-License-Identifier: GPL-3.0-or-later
// What restoring a snapshot would do to a servo: every row with its present value, its value in the
// file, whether it may be written and why (not), and the exact writes for the selected rows, in
// safe order. By roles and flags of the map, so that every family works; to another model or
// firmware by key. Pure values, nothing on the wire; any thread; never fails. With a context it
// asks the journal, and then it belongs on the job's thread.
#pragma once

#include "device/consent.h"
#include "device/context.h"
#include "device/servo.h"
#include "device/temporary_values.h"
#include "snapshot/snapshot.h"

#include <QFlags>

namespace jobs {
/// The reasons for the state of a row; several may apply. text::restoreReasonText describes them.
enum class RestoreReason : std::uint32_t {
    Same = 1U << 0U,       ///< nothing to write
    Identity = 1U << 1U,   ///< ID, rate: off unless requested; written last, as jobs of their own
    Live = 1U << 2U,       ///< torque, goals, lock …: saved for the record, never restored
    OptIn = 1U << 3U,      ///< lost at power-off (41, 48): may be ticked
    MovesShaft = 1U << 4U, ///< turns the shaft or shifts its zero (31, LX offset)
    ReadOnly = 1U << 5U,
    Factory = 1U << 6U,        ///< belongs to the factory values
    NeedsConsent = 1U << 7U,   ///< dangerous: may be ticked, is off without the user's consent
    NoSuchRegister = 1U << 8U, ///< this servo has no register of that name: cannot be mapped
    NotInFile = 1U << 9U,      ///< nothing to restore from; never used for a template
    NoValue = 1U << 10U,       ///< in the file, but without a value (it could not be read)
    NotRead = 1U << 11U,       ///< the servo's value is not known
    OutsideRange = 1U << 12U,  ///< not a value that this model accepts
    OtherMeaning = 1U << 13U,  ///< other unit or other kind of number here: cannot be mapped
    Converted = 1U << 14U,     ///< same physical value, other raw number here
    PlainNumber = 1U << 15U, ///< without a unit, from another family: may be ticked, off by default
    NotChosen = 1U << 16U,   ///< left out by RestoreChoice::only
    /// A limit of voltage, temperature, current or torque of another model: may be ticked by name
    /// and with consent, off by default
    OtherModelLimit = 1U << 17U,
    WouldAlarm = 1U << 18U, ///< with its present readings the servo would be in an alarm at once
    /// Has the value, but from a temporary write: written once more, permanently
    OnlyTemporary = 1U << 19U,
};
Q_DECLARE_FLAGS(RestoreReasons, RestoreReason)
QString restoreReasonName(RestoreReason reason);        ///< "off-unless-asked", for JSON and text
QStringList restoreReasonNames(RestoreReasons reasons); ///< in the order above

/// The stages in the order of writing.
enum class RestoreStage : std::uint8_t {
    Limits, ///< angle, voltage, temperature, torque: before what they limit
    Mode,   ///< mode, phase, resolution, offset: what others depend on
    Gains,
    Rest,
    Link, ///< reply delay, response level: late, because they change the communication
    Live, ///< 41, 48 where ticked
    Id,
    Baud,
};

struct RestoreRow {
    QString key;
    int address = 0; ///< here; the file's where this servo has no such register
    std::optional<std::int64_t> now{};
    std::optional<std::int64_t> newRaw{}; ///< in this servo's raw numbers; none: cannot be mapped
    std::optional<std::int64_t> fileRaw{};
    std::optional<double> fileValue{};
    QString fileUnit{};
    RestoreReasons reasons{};
    RestoreStage stage = RestoreStage::Rest;
    bool isSelectable = false;
    bool selected = false;
    bool isRequested = false; ///< by name: a row of a template, or of RestoreChoice::only
    /// The fault that this value would cause now ("voltage", "temperature", "current",
    /// "overload"); empty: none. And the reading that shows it.
    QString alarm{};
    double reading = 0;
    QString readingUnit{};
    bool operator==(const RestoreRow&) const = default;
};

/// What the user selects beyond the default.
struct RestoreChoice {
    QStringList only{};             ///< keys; empty: all
    bool identity = false;          ///< ID and rate as well
    device::Consent consent{};      ///< dangerous rows are selected as well
    bool live = false;              ///< rows that are lost at power-off (41, 48)
    QStringList otherModelLimits{}; ///< consent: these limits are written to another model as well
};

struct RestorePlan {
    int id = -1;                    ///< of the servo it was made for
    device::Servo servo{};          ///< as it was read
    std::vector<RestoreRow> rows{}; ///< those that differ and may be ticked first, then by address
    bool otherModel = false;
    QString sourceModel{}; ///< the model of the file
    bool otherFirmware = false;
    bool otherMap = false;
    bool isTemplate = false;
    /// From the journal; restored with a position mode (device::savedSpeed).
    std::optional<std::int64_t> positionSpeed{};

    const RestoreRow* find(const QString& key) const;
    /// False, and without effect, when the row may not be ticked.
    bool setSelected(const QString& key, bool on);
    /// A ticked row is dangerous: write only with the user's consent.
    bool needsConsent() const;
    /// Rows that differ, or might, and cannot be written here, for the list of omitted rows.
    std::vector<const RestoreRow*> unmappedRows() const;
    int count(RestoreReason reason) const;
};

/// The rows that keep the servo from matching the file after the plan is executed: rows that
/// differ, or might, and are not written, for any reason. Identity, live, read-only and factory
/// rows are included only if requested by name. Owned by the plan.
std::vector<const RestoreRow*> omittedRows(const RestorePlan& plan);

/// `servo`: with its whole table read (device::readAll). The choice decides the ticks.
RestorePlan planRestore(const device::Servo& servo, const snapshot::Snapshot& snapshot,
                        const RestoreChoice& choice = {});
/// Also with the speed saved for position modes, and with the rows marked that match the file until
/// power-off only; without both if the journal cannot be read.
RestorePlan planRestore(const device::Context& context, const device::Servo& servo,
                        const snapshot::Snapshot& snapshot, const RestoreChoice& choice = {});

/// Marks the rows that only need to be kept, and ticks those that may be ticked by default. For a
/// plan that was made without the journal.
void selectTemporary(RestorePlan& plan, const device::TemporaryValues& temporary,
                     device::Consent consent);
/// From the journal; none if it cannot be read.
void selectTemporary(const device::Context& context, RestorePlan& plan, device::Consent consent);

/// Rows that would cause an alarm that the servo does not have now, ticked or not. Owned by the
/// plan.
std::vector<const RestoreRow*> predictedAlarms(const RestorePlan& plan);

/// One register write to come.
struct RestoreWrite {
    QString key;
    int address = 0;
    std::optional<std::int64_t> from{};
    std::int64_t to = 0;
    RestoreStage stage = RestoreStage::Rest;
    bool isRewrite = false; ///< the servo has the value, perhaps until power-off only
    bool operator==(const RestoreWrite&) const = default;
};
/// Exactly the ticked rows that differ or are not kept, in the order of writing. Empty: a restore
/// sends nothing that could change the servo.
std::vector<RestoreWrite> plannedWrites(const RestorePlan& plan);

/// All steps of the restore, for --dry-run and the window.
enum class RestoreStepKind : std::uint8_t {
    TorqueOff, ///< and it stays off
    Unlock,
    Write,
    Neutralize, ///< another mode: its command is set to rest, before anything can turn
    Lock,
    SetId,
    SetBaud,
};
struct RestoreStep {
    RestoreStepKind kind = RestoreStepKind::Write;
    QString key{};
    std::optional<std::int64_t> from{};
    std::optional<std::int64_t> to{};
    bool operator==(const RestoreStep&) const = default;
};
std::vector<RestoreStep> plannedSteps(const RestorePlan& plan);
QString restoreStepName(RestoreStepKind kind); ///< "torque-off", "unlock", "write" …
} // namespace jobs

Q_DECLARE_OPERATORS_FOR_FLAGS(jobs::RestoreReasons)
