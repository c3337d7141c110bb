// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_fields.h"

#include "ui/common/theme.h"
#include "ui/operate/control_field.h"
#include "ui/operate/control_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

namespace ui {
using catalog::Role;

namespace {
constexpr std::array roles{Role::GoalSpeed, Role::Acceleration, Role::GoalTime, Role::GoalCurrent};
constexpr int columns = 2;

QString noCurrentText()
{
    return ControlFields::tr("Current 0 = no torque");
}
} // namespace

ControlFields::ControlFields(QWidget* parent)
    : QWidget(parent)
    , m_grid(new QGridLayout)
    , m_hint(new QLabel(this))
{
    setObjectName(QStringLiteral("controlFields"));
    static const char* const names[] = {"speed", "acceleration", "time", "current"};
    for (std::size_t i = 0; i < Count; ++i) {
        auto* field = new ControlField(QString::fromLatin1(names[i]), this);
        m_fields[i] = field;
        connect(field, &ControlField::returnPressed, this, &ControlFields::returnPressed);
        connect(field, &ControlField::edited, this,
                [this, i] { onFieldEdited(static_cast<Field>(i)); });
    }
    m_hint->setObjectName(QStringLiteral("speedHint"));
    m_hint->setWordWrap(true);
    m_grid->setHorizontalSpacing(10);
    m_grid->setVerticalSpacing(4);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(4);
    column->addLayout(m_grid);
    column->addWidget(m_hint);
    retranslate();
}

void ControlFields::showServo(const session::ServoEntry& entry, bool multiple)
{
    const device::MoveFieldSet set = device::moveFields(entry.servo);
    const catalog::Mode* mode = entry.servo.mode();
    const QString key = mode != nullptr ? mode->key : QString();
    const bool other = entry.ref != m_ref || key != m_mode;
    m_ref = entry.ref;
    m_mode = key;
    m_multiple = multiple;
    const std::array has{set.speed, set.acceleration, set.time, set.current};
    for (std::size_t i = 0; i < Count; ++i) {
        const auto& profile = entry.servo.profile;
        m_fields[i]->setRegister(profile, has[i] ? profile->byRole(roles[i]) : nullptr);
        if (other)
            m_fields[i]->resetValue();
        m_fields[i]->showReading(entry.servo);
    }
    m_servo = entry.servo;
    if (std::exchange(m_has, has) != has)
        arrange();
    setVisible(has != decltype(has){});
    showHint();
}

void ControlFields::arrange()
{
    int shown = 0;
    int i = 0;
    for (ControlField* field : m_fields) {
        m_grid->removeWidget(field);
        if (!m_has[static_cast<std::size_t>(i++)])
            continue;
        m_grid->addWidget(field, shown / columns, shown % columns, Qt::AlignTop);
        ++shown;
    }
    for (int column = 0; column < columns; ++column)
        m_grid->setColumnStretch(column, 1);
}

/// Speed and time exclude each other: the one typed last counts.
void ControlFields::onFieldEdited(Field which)
{
    if (which == Speed && m_fields[Time]->reg() != nullptr)
        m_fields[Time]->discardEdit();
    if (which == Time && m_fields[Speed]->reg() != nullptr)
        m_fields[Speed]->discardEdit();
    showHint();
}

/// Not changed, but shown. Of speed and time only the one that counts.
bool ControlFields::appliesToAll(Field which) const
{
    const bool byTime = device::zeroSpeed(m_servo) == device::ZeroSpeed::ByTime &&
                        m_fields[Speed]->value() == 0 && m_fields[Time]->reg() != nullptr;
    switch (which) {
    case Speed:
        return m_multiple && !byTime && !m_fields[Time]->isEdited();
    case Acceleration:
        return m_multiple;
    case Time:
        return m_multiple && byTime && !m_fields[Speed]->isEdited();
    default:
        return false;
    }
}

std::optional<QString> ControlFields::requestedValue(Field which) const
{
    const ControlField& field = *m_fields[which];
    const catalog::Register* reg = field.reg();
    const auto raw = field.value();
    if (reg == nullptr || !raw)
        return std::nullopt;
    // A travel time in the same frame as the goal is sent with it, as shown or as 0.
    const catalog::Register* goal = device::goalRegister(m_servo);
    const bool isRequired =
        which == Time && goal != nullptr && reg->block && reg->block == goal->block;
    if (!field.isEdited() && !isRequired && !appliesToAll(which))
        return std::nullopt;
    return device::exactValueText(*raw, m_servo.meaning(*reg));
}

void ControlFields::fill(session::MoveRequest& request) const
{
    request.speed = requestedValue(Speed);
    request.acceleration = requestedValue(Acceleration);
    request.time = requestedValue(Time);
    request.current = requestedValue(Current);
}

QString ControlFields::inputError() const
{
    for (const ControlField* field : m_fields) {
        if (field->reg() != nullptr && field->isEdited() && !field->value())
            return field->inputError();
    }
    return {};
}

void ControlFields::setSent(const session::MoveRequest& request, base::Duration at)
{
    const std::array sent{request.speed, request.acceleration, request.time, request.current};
    for (std::size_t i = 0; i < Count; ++i) {
        ControlField& field = *m_fields[i];
        if (!sent[i] || field.reg() == nullptr)
            continue;
        const auto raw = catalog::parseValue(*sent[i], *field.reg(), m_servo.meaning(*field.reg()));
        if (raw)
            field.setSent(*raw, at);
    }
    // A time acts only while the speed is 0, so that is what the servo has now.
    if (request.time && m_fields[Speed]->reg() != nullptr)
        m_fields[Speed]->setSent(0, at);
    showHint();
}

void ControlFields::showHint()
{
    const bool speed = m_fields[Speed]->reg() != nullptr;
    const auto raw = m_fields[Speed]->value();
    const bool limit = m_fields[Current]->reg() != nullptr && m_fields[Current]->value() == 0;
    QString words = speed ? speedHint(m_servo, raw) : QString();
    if (limit)
        words = noCurrentText();
    m_hint->setText(words);
    reserveHint();
    QPalette colors = palette();
    const bool warns = limit || (speed && isAboveMaxSpeed(m_servo, raw));
    colors.setColor(QPalette::WindowText, tone(warns ? Tone::Warn : Tone::Quiet, palette()));
    m_hint->setPalette(colors);
}

/// Reserves the space of the longest sentence: nothing below may move while a speed is typed.
void ControlFields::reserveHint()
{
    QStringList all{m_hint->text()};
    if (m_fields[Speed]->reg() != nullptr)
        all << speedHint(m_servo, 0) << speedHint(m_servo, std::numeric_limits<int>::max());
    if (m_fields[Current]->reg() != nullptr)
        all << noCurrentText();
    int height = 0;
    for (const QString& words : all) {
        if (words.isEmpty())
            continue;
        const QRect room(0, 0, width(), std::numeric_limits<short>::max());
        height = std::max(
            height, m_hint->fontMetrics().boundingRect(room, Qt::TextWordWrap, words).height());
    }
    m_hint->setVisible(height > 0);
    m_hint->setMinimumHeight(height);
}

void ControlFields::discardEdits()
{
    for (ControlField* field : m_fields)
        field->discardEdit();
    showHint();
}

void ControlFields::retranslate()
{
    m_fields[Speed]->setTitle(tr("Speed"));
    m_fields[Acceleration]->setTitle(tr("Acceleration"));
    m_fields[Time]->setTitle(tr("Time (ms)"));
    m_fields[Current]->setTitle(tr("Current limit"));
    if (m_servo.profile)
        showHint();
}

void ControlFields::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    const bool concerns =
        event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (concerns && m_servo.profile)
        showHint();
}

void ControlFields::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        reserveHint();
}
} // namespace ui
