// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_goal.h"

#include "ui/common/theme.h"
#include "ui/common/widget_text.h"
#include "ui/editors/register_text.h"
#include "ui/operate/control_field.h"
#include "ui/operate/control_slider.h"
#include "ui/operate/control_text.h"
#include "ui/widgets/press_guard.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace ui {
using catalog::Role;
using device::GoalKind;

namespace {
bool isContinuous(std::optional<GoalKind> kind)
{
    return kind == GoalKind::Speed || kind == GoalKind::Pwm || kind == GoalKind::Current;
}

/// The present position in units of the goal: what torque-on would hold.
std::optional<std::int64_t> presentPosition(const device::Servo& servo)
{
    const auto present = servo.raw(Role::PresentPosition);
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    if (!present)
        return std::nullopt;
    return std::llround(static_cast<double>(*present) / static_cast<double>(factor));
}
} // namespace

ControlGoal::ControlGoal(QWidget* parent)
    : QWidget(parent)
    , m_slider(new ControlSlider(this))
    , m_field(new ControlField(QStringLiteral("goal"), this, true))
    , m_steps(new QWidget(this))
    , m_stop(new QPushButton(this))
    , m_directionLabel(new QLabel(this))
{
    setObjectName(QStringLiteral("controlGoal"));
    m_slider->setObjectName(QStringLiteral("goalSlider"));
    m_stop->setObjectName(QStringLiteral("goalStop"));
    m_directionLabel->setObjectName(QStringLiteral("goalWay"));
    buildSteps();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    column->addWidget(m_directionLabel);
    column->addWidget(m_slider);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_field, 1);
    row->addWidget(m_stop, 0, Qt::AlignVCenter);
    column->addLayout(row);
    column->addWidget(m_steps);
    connect(m_slider, &ControlSlider::moved, this, [this](std::int64_t raw, bool dragged) {
        m_field->discardEdit();
        setShownGoal(raw);
        Q_EMIT goalMoved(raw, dragged);
    });
    connect(m_slider, &ControlSlider::released, this, &ControlGoal::dragEnded);
    connect(m_field, &ControlField::returnPressed, this, &ControlGoal::returnPressed);
    connect(m_stop, &QPushButton::clicked, this, &ControlGoal::stopRequested);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_slider, m_minus, m_plus, m_repeat})
        new PressGuard(widget); // not the stop button: it must always act
    retranslate();
}

void ControlGoal::buildSteps()
{
    m_minus = new QPushButton(m_steps);
    m_plus = new QPushButton(m_steps);
    m_repeat = new QPushButton(m_steps);
    m_stepsLeft = new QLabel(m_steps);
    m_minus->setObjectName(QStringLiteral("stepMinus"));
    m_plus->setObjectName(QStringLiteral("stepPlus"));
    m_repeat->setObjectName(QStringLiteral("stepAgain"));
    m_stepsLeft->setObjectName(QStringLiteral("stepsLeft"));
    m_stepsLeft->setWordWrap(true);
    auto* column = new QVBoxLayout(m_steps);
    column->setContentsMargins({});
    auto* row = new QHBoxLayout;
    row->addWidget(m_minus, 1);
    row->addWidget(m_plus, 1);
    row->addWidget(m_repeat, 1);
    column->addLayout(row);
    column->addWidget(m_stepsLeft);
    const auto step = [this](int sign) {
        if (const auto size = m_field->value())
            Q_EMIT stepRequested(sign * std::abs(*size));
    };
    connect(m_minus, &QPushButton::clicked, this, [step] { step(-1); });
    connect(m_plus, &QPushButton::clicked, this, [step] { step(1); });
    connect(m_repeat, &QPushButton::clicked, this, &ControlGoal::repeatRequested);
}

std::optional<std::int64_t> ControlGoal::effectiveRaw(const session::ServoEntry& entry) const
{
    const bool position = m_kind == GoalKind::Position || m_kind == GoalKind::Turns;
    // Without torque an old goal has no meaning: the present position counts.
    const catalog::Register* torque = entry.servo.profile->byRole(Role::TorqueSwitch);
    if (position && entry.servo.raw(Role::TorqueSwitch) != 1 &&
        !m_field->isSentAfterRead(entry.servo, torque))
        return presentPosition(entry.servo);
    return m_field->effectiveRaw(entry.servo);
}

void ControlGoal::showServo(const session::ServoEntry& entry, const Steps& steps)
{
    const device::Servo& servo = entry.servo;
    const auto kind = device::goalKind(servo);
    const bool fresh = kind != m_kind || entry.ref != m_servo;
    m_kind = kind;
    m_servo = entry.ref;
    m_positive = device::positiveDirection(servo);
    m_field->setRegister(servo.profile, device::goalRegister(servo));
    if (fresh)
        m_field->resetValue();
    const bool step = kind == GoalKind::Step;
    m_slider->setVisible(kind && !step);
    m_steps->setVisible(step);
    m_stop->setVisible(isContinuous(kind));
    m_directionLabel->setVisible(isContinuous(kind));
    if (!kind)
        return;
    if (step) {
        m_field->showReading(servo, std::nullopt);
        if (fresh)
            m_field->setRaw(servo.profile->stepsPerTurn / 4);
        fillSteps(steps);
    } else {
        const auto raw = effectiveRaw(entry);
        m_field->showReading(servo, m_slider->isDragging() || m_dialDrag ? m_shown : raw);
        fillSlider(entry);
        if (!m_slider->isDragging() && !m_dialDrag) {
            m_slider->setValue(raw);
            setShownGoal(raw);
        }
    }
    retranslate();
}

/// The text has a sign already if no data sheet gives the direction of rotation.
QString ControlGoal::withDirection(const QString& sign, const QString& words) const
{
    return m_positive == device::PositiveDirection::Forward ? words
                                                            : sign + QLatin1Char(' ') + words;
}

void ControlGoal::fillSlider(const session::ServoEntry& entry)
{
    const auto span = device::goalSliderRange(entry.servo);
    const auto scale = device::goalScaleRange(entry.servo);
    if (!span || !scale)
        return;
    const bool centered = *m_kind != GoalKind::Position;
    const auto end = [&](std::int64_t raw, bool plus) {
        const QString number = QString::number(raw);
        return isContinuous(m_kind) ? withDirection(turnSymbol(m_positive, plus), number) : number;
    };
    m_slider->setScale({scale->min, scale->max, span->min, span->max, centered,
                        end(span->min, false), end(span->max, true)});
}

void ControlGoal::fillSteps(const Steps& steps)
{
    m_repeat->setEnabled(steps.canRepeat);
    const QString left =
        tr("Steps since connecting: %1. Remaining: %2 %3, %4 %5 (±7.5 turns in total)")
            .arg(steps.sum)
            .arg(turnSymbol(m_positive, true))
            .arg(device::remainingSteps(steps.sum, true))
            .arg(turnSymbol(m_positive, false))
            .arg(device::remainingSteps(steps.sum, false));
    m_stepsLeft->setText(left);
}

void ControlGoal::setShownGoal(std::optional<std::int64_t> raw)
{
    if (raw == m_shown)
        return;
    m_shown = raw;
    if (raw)
        Q_EMIT goalShown(*raw);
}

std::optional<std::int64_t> ControlGoal::goal() const
{
    return m_field->value();
}

QString ControlGoal::inputError() const
{
    return m_field->inputError();
}

void ControlGoal::setPending(std::int64_t raw)
{
    // A reading from before the goal is sent is the old goal.
    m_pendingGoal = raw;
    if (m_kind != GoalKind::Step)
        m_field->setPending(raw);
}

void ControlGoal::clearPending()
{
    if (std::exchange(m_pendingGoal, std::nullopt))
        clearSent();
}

void ControlGoal::setSent(std::int64_t raw, base::Duration at)
{
    if (m_pendingGoal && m_pendingGoal != raw)
        return; // a newer one is on its way
    m_pendingGoal.reset();
    if (m_kind != GoalKind::Step)
        m_field->setSent(raw, at);
}

void ControlGoal::clearSent()
{
    if (m_kind != GoalKind::Step)
        m_field->clearSent();
}

void ControlGoal::discardEdit()
{
    m_field->discardEdit();
}

void ControlGoal::enterValue(std::int64_t raw)
{
    m_field->enterValue(raw);
}

void ControlGoal::cancelDrag()
{
    m_dialDrag = false;
}

void ControlGoal::setFromDial(std::int64_t raw)
{
    if (!m_kind || m_kind == GoalKind::Step)
        return;
    m_dialDrag = true;
    m_slider->setValue(raw);
    m_field->discardEdit();
    setShownGoal(raw);
    Q_EMIT goalMoved(raw, true);
}

void ControlGoal::endDialDrag()
{
    m_dialDrag = false;
    Q_EMIT dragEnded();
}

void ControlGoal::retranslate()
{
    const QString plus =
        turnSymbol(m_positive, true) + QLatin1Char(' ') + turnText(m_positive, true);
    const QString minus =
        turnSymbol(m_positive, false) + QLatin1Char(' ') + turnText(m_positive, false);
    QString title = tr("Goal");
    if (m_kind == GoalKind::Step)
        title = tr("Step size");
    else if (m_kind == GoalKind::Speed)
        title = tr("Speed");
    else if (m_kind == GoalKind::Pwm)
        title = tr("PWM");
    else if (m_kind == GoalKind::Current)
        title = tr("Current");
    m_field->setTitle(title);
    m_directionLabel->setText(
        tr("− %1    ·    + %2")
            .arg(withDirection(turnSymbol(m_positive, false), turnText(m_positive, false)),
                 withDirection(turnSymbol(m_positive, true), turnText(m_positive, true))));
    m_slider->setAccessibleName(title);
    m_slider->setToolTip(tr("Drag, or use the arrow keys, Page Up/Down, Home and End; click once "
                            "to enable the mouse wheel (Ctrl: fine, Shift: coarse)"));
    m_minus->setText(minus);
    m_plus->setText(plus);
    for (QPushButton* button : {m_minus, m_plus}) {
        button->setAccessibleName(button->text());
        button->setToolTip(
            tr("Moves by the step size in this direction, starting where the last step ended"));
    }
    setButtonText(m_repeat, tr("Repeat"), tr("Repeats the last step"));
    m_stop->setText(tr("■ Stop"));
    m_stop->setAccessibleName(tr("Stop turning"));
    m_stop->setToolTip(tr("Stops the motion of this servo; torque stays on"));
}
} // namespace ui
