// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/control_fields.h"

#include "ui/app/theme.h"
#include "ui/pages/control_field.h"
#include "ui/pages/control_words.h"

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

QString noCurrentWords()
{
    return ControlFields::tr("Current 0 = no torque at all");
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
        connect(field, &ControlField::entered, this, &ControlFields::entered);
        connect(field, &ControlField::changed, this, [this, i] { typed(static_cast<Which>(i)); });
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

void ControlFields::showServo(const session::ServoEntry& entry, bool several)
{
    const device::MoveFieldSet set = device::moveFields(entry.servo);
    const catalog::Mode* mode = entry.servo.mode();
    const QString key = mode != nullptr ? mode->key : QString();
    const bool other = entry.ref != m_ref || key != m_mode;
    m_ref = entry.ref;
    m_mode = key;
    m_several = several;
    const std::array has{set.speed, set.acceleration, set.time, set.current};
    for (std::size_t i = 0; i < Count; ++i) {
        const auto& profile = entry.servo.profile;
        m_fields[i]->setRegister(profile, has[i] ? profile->byRole(roles[i]) : nullptr);
        if (other)
            m_fields[i]->startAnew();
        m_fields[i]->follow(entry.servo);
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
void ControlFields::typed(Which which)
{
    if (which == Speed && m_fields[Time]->reg() != nullptr)
        m_fields[Time]->forgetEdit();
    if (which == Time && m_fields[Speed]->reg() != nullptr)
        m_fields[Speed]->forgetEdit();
    showHint();
}

/// Not changed, but seen. Of speed and time only the one that counts, as typed() has it.
bool ControlFields::forAll(Which which) const
{
    const bool byTime = device::zeroSpeed(m_servo) == device::ZeroSpeed::ByTime &&
                        m_fields[Speed]->value() == 0 && m_fields[Time]->reg() != nullptr;
    switch (which) {
    case Speed:
        return m_several && !byTime && !m_fields[Time]->edited();
    case Acceleration:
        return m_several;
    case Time:
        return m_several && byTime && !m_fields[Speed]->edited();
    default:
        return false;
    }
}

std::optional<QString> ControlFields::wished(Which which) const
{
    const ControlField& field = *m_fields[which];
    const catalog::Register* reg = field.reg();
    const auto raw = field.value();
    if (reg == nullptr || !raw)
        return std::nullopt;
    // A travel time that shares the goal's frame goes out with it, as shown or as 0.
    const catalog::Register* goal = device::goalRegister(m_servo);
    const bool travels =
        which == Time && goal != nullptr && reg->block && reg->block == goal->block;
    if (!field.edited() && !travels && !forAll(which))
        return std::nullopt;
    return device::exactText(*raw, m_servo.meaning(*reg));
}

void ControlFields::fill(session::MoveWish& wish) const
{
    wish.speed = wished(Speed);
    wish.acceleration = wished(Acceleration);
    wish.time = wished(Time);
    wish.current = wished(Current);
}

QString ControlFields::complaint() const
{
    for (const ControlField* field : m_fields) {
        if (field->reg() != nullptr && field->edited() && !field->value())
            return field->complaint();
    }
    return {};
}

void ControlFields::wasSent(const session::MoveWish& wish, base::Duration at)
{
    const std::array sent{wish.speed, wish.acceleration, wish.time, wish.current};
    for (std::size_t i = 0; i < Count; ++i) {
        ControlField& field = *m_fields[i];
        if (!sent[i] || field.reg() == nullptr)
            continue;
        const auto raw = catalog::parseValue(*sent[i], *field.reg(), m_servo.meaning(*field.reg()));
        if (raw)
            field.wasSent(*raw, at);
    }
    // A time acts only while the speed is 0, so that is what the servo has now.
    if (wish.time && m_fields[Speed]->reg() != nullptr)
        m_fields[Speed]->wasSent(0, at);
    showHint();
}

void ControlFields::showHint()
{
    const bool speed = m_fields[Speed]->reg() != nullptr;
    const auto raw = m_fields[Speed]->value();
    const bool limit = m_fields[Current]->reg() != nullptr && m_fields[Current]->value() == 0;
    QString words = speed ? speedHint(m_servo, raw) : QString();
    if (limit)
        words = noCurrentWords();
    m_hint->setText(words);
    reserveHint();
    QPalette colours = palette();
    const bool warns = limit || (speed && noFaster(m_servo, raw));
    colours.setColor(QPalette::WindowText, tone(warns ? Tone::Warn : Tone::Quiet, palette()));
    m_hint->setPalette(colours);
}

/// As much room as the longest sentence needs: what stands below must not move while a speed is
/// being typed.
void ControlFields::reserveHint()
{
    QStringList all{m_hint->text()};
    if (m_fields[Speed]->reg() != nullptr)
        all << speedHint(m_servo, 0) << speedHint(m_servo, std::numeric_limits<int>::max());
    if (m_fields[Current]->reg() != nullptr)
        all << noCurrentWords();
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

void ControlFields::forgetEdits()
{
    for (ControlField* field : m_fields)
        field->forgetEdit();
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
