// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_model.h"

#include "text/arm_text.h"
#include "text/language.h"
#include "ui/common/theme.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/task_text.h"
#include "ui/widgets/test_text.h"

#include <array>
#include <cmath>

namespace ui {
namespace {
using base::JointState;
using session::ArmCalibration;
using session::ArmJoint;
using Field = int jobs::JointCalibration::*;

constexpr double degreesPerTurn = 360;

const device::Servo* servoOf(const session::Workbench& workbench, const ArmJoint& one)
{
    const session::ServoEntry* entry = workbench.registry().servo(one.servo);
    return entry != nullptr && entry->servo.profile ? &entry->servo : nullptr;
}

double degreesOf(const device::Servo& servo, std::int64_t steps)
{
    return static_cast<double>(steps) * servo.profile->angleRangeDeg.value_or(degreesPerTurn) /
           servo.profile->stepsPerTurn;
}

bool wasRecorded(const ArmJoint& one)
{
    return one.range.state != JointState::NoReply;
}

/// Equal limits are none.
bool hasRange(const ArmJoint& one)
{
    return one.joint.kind != base::JointKind::Wheel &&
           (wasRecorded(one) || (one.held && one.held->rangeMin < one.held->rangeMax));
}

/// "850", or "850 → 142" where another value is planned.
QString changeText(const ArmJoint& one, Field field)
{
    const QString held = one.held ? QString::number((*one.held).*field) : QStringLiteral("–");
    if (!one.planned || (one.held && (*one.held).*field == (*one.planned).*field))
        return held;
    return QStringLiteral("%1 → %2").arg(held).arg((*one.planned).*field);
}

/// "elbow_flex: Operating mode speed → position, Position loop P 32 → 16"; empty: no changes.
QString changesLine(const jobs::JointServo& joint, const jobs::JointSettings& settings)
{
    QStringList texts;
    for (const jobs::SettingChange& one : jobs::changesOf(*joint.servo, settings)) {
        const auto value = [&](std::int64_t raw) {
            return one.reg->encoding == catalog::Encoding::Bits
                       ? QString::number(raw)
                       : valueText(*joint.servo, one.reg->key, raw);
        };
        texts << QStringLiteral("%1 %2 → %3")
                     .arg(registerText(*joint.servo, one.reg->key), value(one.now),
                          value(one.wanted));
    }
    return texts.isEmpty() ? QString()
                           : ArmModel::tr("%1: %2", "joint, changes")
                                 .arg(joint.joint.name, text::joinItems(texts));
}
} // namespace

QStringList positionChanges(const ArmCalibration& calibration, bool isPlannedOnly)
{
    QStringList lines;
    const std::vector<jobs::JointServo> servos = calibration.jointServos();
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (servos[i].servo != nullptr && (!isPlannedOnly || calibration.joints()[i].planned))
            lines << changesLine(servos[i],
                                 jobs::positionSettings(*servos[i].servo, servos[i].joint.kind));
    }
    lines.removeAll(QString());
    return lines;
}

QStringList lerobotChanges(const ArmCalibration& calibration)
{
    QStringList lines;
    for (const jobs::JointServo& one : calibration.jointServos()) {
        if (one.servo != nullptr)
            lines << changesLine(one, one.lerobotSettings());
    }
    lines.removeAll(QString());
    return lines;
}

ArmModel::ArmModel(session::Workbench& workbench, QObject* parent)
    : QAbstractTableModel(parent)
    , m_workbench(workbench)
    , m_calibration(workbench.armCalibration())
    , m_rows(static_cast<int>(m_calibration.joints().size()))
{}

int ArmModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int ArmModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : columns;
}

void ArmModel::update()
{
    const int rows = static_cast<int>(m_calibration.joints().size());
    if (rows != m_rows) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
    }
    if (rows > 0)
        Q_EMIT dataChanged(index(0, 0), index(rows - 1, columns - 1));
}

void ArmModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

QVariant ArmModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= static_cast<int>(m_calibration.joints().size()))
        return {};
    const ArmJoint& one = m_calibration.joints()[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return text(one, column);
    case Qt::ToolTipRole:
        return column == RangeColumn ? QVariant() : text(one, column);
    case Qt::TextAlignmentRole:
        return column == JointColumn || column == StateColumn
                   ? QVariant()
                   : QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    case toneRole:
        return column == StateColumn ? toneOf(one) : QVariant();
    case jointBarRole:
        return barOf(one);
    default:
        return {};
    }
}

bool ArmModel::isRecording(const ArmJoint& one) const
{
    return m_calibration.step() == ArmCalibration::Step::Recording && wasRecorded(one);
}

/// A running job says so itself.
bool ArmModel::isSilent(const ArmJoint& one) const
{
    const session::ServoEntry* entry = m_workbench.registry().servo(one.servo);
    return entry != nullptr && entry->silent && !m_calibration.isBusy();
}

/// In steps as the servo reports it. A running job reads it itself; it is polled otherwise.
std::optional<std::int64_t> ArmModel::positionOf(const ArmJoint& one) const
{
    const device::Servo* servo = servoOf(m_workbench, one);
    if (servo == nullptr)
        return std::nullopt;
    if (one.test && one.test->state == base::MoveTestState::Moving)
        return one.test->position;
    if (isRecording(one))
        return one.range.reading;
    const session::ServoEntry& entry = *m_workbench.registry().servo(one.servo);
    const catalog::Register* reg = servo->profile->byRole(catalog::Role::PresentPosition);
    const bool isShown = reg != nullptr && (m_calibration.isBusy() ||
                                            isFresh(entry, m_workbench.link(), m_workbench.now()));
    return isShown ? entry.displayedRaw(*reg) : std::nullopt;
}

QVariant ArmModel::barOf(const ArmJoint& one) const
{
    const device::Servo* servo = servoOf(m_workbench, one);
    if (servo == nullptr || !hasRange(one))
        return {};
    const double turn = servo->profile->stepsPerTurn;
    const auto position = positionOf(one);
    JointBar bar;
    bar.isRecorded = wasRecorded(one);
    const bool isFullTurn = one.range.state == JointState::FullTurn;
    if (!bar.isRecorded || isFullTurn) {
        bar.low = isFullTurn ? 0 : one.held->rangeMin / turn;
        bar.high = isFullTurn ? 1 : one.held->rangeMax / turn;
        if (position)
            bar.now = static_cast<double>(*position) / turn;
        return QVariant::fromValue(bar);
    }
    // The middle of the range is the middle of the bar, so that no seam divides it.
    const double middle = static_cast<double>(one.range.low + one.range.high) / 2;
    const auto fraction = [&](double steps) { return 0.5 + (steps - middle) / turn; };
    bar.low = fraction(static_cast<double>(one.range.low));
    bar.high = fraction(static_cast<double>(one.range.high));
    if (position && one.range.state != JointState::LostTrack) {
        const double moved = static_cast<double>(*position - one.range.reading);
        const double now = fraction(static_cast<double>(one.range.now) + moved);
        bar.now = servo->profile->multiTurn ? now - std::floor(now) : now;
    }
    return QVariant::fromValue(bar);
}

QString ArmModel::travelText(const ArmJoint& one) const
{
    const device::Servo* servo = servoOf(m_workbench, one);
    if (servo == nullptr || !hasRange(one))
        return {};
    const std::int64_t steps =
        wasRecorded(one) ? one.range.high - one.range.low : one.held->rangeMax - one.held->rangeMin;
    return QStringLiteral("%1°").arg(degreesOf(*servo, steps), 0, 'f', 0);
}

QString ArmModel::text(const ArmJoint& one, int column) const
{
    switch (column) {
    case IdColumn:
        return QString::number(one.joint.id);
    case JointColumn:
        return one.joint.name;
    case PositionColumn: {
        const auto position = positionOf(one);
        return position ? QString::number(*position) : QStringLiteral("–");
    }
    case DegreesColumn:
        return travelText(one);
    case StateColumn:
        return stateText(one);
    case OffsetColumn:
        return changeText(one, &jobs::JointCalibration::homingOffset);
    case MinColumn:
        return changeText(one, &jobs::JointCalibration::rangeMin);
    case MaxColumn:
        return changeText(one, &jobs::JointCalibration::rangeMax);
    default:
        return {};
    }
}

QString ArmModel::stateText(const ArmJoint& one) const
{
    const device::Servo* servo = servoOf(m_workbench, one);
    if (servo == nullptr)
        return tr("not in the list");
    if (isSilent(one))
        return text::jointStateText(JointState::NoReply);
    if (!one.joint.model.isEmpty() && servo->profile->modelName != one.joint.model)
        return tr("%1 instead of %2").arg(servo->profile->modelName, one.joint.model);
    if (one.joint.kind == base::JointKind::Wheel)
        return tr("wheel: not calibrated");
    if (one.test)
        return text::moveTestStateText(one.test->state);
    return wasRecorded(one) ? text::jointStateText(one.range.state) : QString();
}

QVariant ArmModel::toneOf(const ArmJoint& one) const
{
    const device::Servo* servo = servoOf(m_workbench, one);
    if (servo == nullptr || isSilent(one))
        return static_cast<int>(Tone::Bad);
    if (!one.joint.model.isEmpty() && servo->profile->modelName != one.joint.model)
        return static_cast<int>(Tone::Warn);
    if (one.test)
        return toneOfTest(one.test->state);
    switch (one.range.state) {
    case JointState::Recorded:
        return static_cast<int>(Tone::Good);
    case JointState::FullTurn:
        return static_cast<int>(one.joint.kind == base::JointKind::Continuous ? Tone::Good
                                                                              : Tone::Warn);
    case JointState::KeepMoving:
    case JointState::LostTrack:
        return static_cast<int>(Tone::Warn);
    case JointState::NotMoved:
    case JointState::NoReply:
        break;
    }
    return {};
}

QVariant ArmModel::toneOfTest(base::MoveTestState state)
{
    if (state == base::MoveTestState::Moving)
        return {};
    return static_cast<int>(state == base::MoveTestState::Reached ? Tone::Good : Tone::Bad);
}

QVariant ArmModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section != JointColumn && section != StateColumn &&
        section != RangeColumn)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    if (role != Qt::DisplayRole)
        return {};
    const std::array titles{tr("ID"),    tr("Joint"),  tr("Position"), tr("Travel"), tr("Range"),
                            tr("State"), tr("Offset"), tr("Min"),      tr("Max")};
    return section < columns ? titles[static_cast<std::size_t>(section)] : QString();
}
} // namespace ui
