// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_limit.h"

#include "device/motion/move_limits.h"
#include "ui/common/theme.h"
#include "ui/common/widget_text.h"
#include "ui/operate/control_slider.h"
#include "ui/widgets/press_guard.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace ui {
namespace {
constexpr std::int64_t fullScale = 1000; ///< raw: 100 %
constexpr double rawPerPercent = 10;
constexpr double maxStallTorque = 500; ///< kg·cm
const QString detailsKey = QStringLiteral("operate/torque_limit_details");

QString stallTorqueKey(const QString& model)
{
    return QStringLiteral("stall_torque/") + model;
}
} // namespace

ControlLimit::ControlLimit(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_title(new QLabel(this))
    , m_more(new QToolButton(this))
    , m_details(new QWidget(this))
    , m_percent(new QDoubleSpinBox(this))
    , m_slider(new ControlSlider(m_details))
    , m_force(new QLabel(this))
    , m_stallTitle(new QLabel(m_details))
    , m_stall(new QDoubleSpinBox(m_details))
    , m_advice(new QLabel(m_details))
{
    setObjectName(QStringLiteral("controlLimit"));
    build();
    connect(m_slider, &ControlSlider::moved, this, [this](std::int64_t raw, bool dragged) {
        m_percent->setValue(static_cast<double>(raw) / rawPerPercent);
        m_editing = true;
        if (!dragged)
            request(raw);
    });
    connect(m_slider, &ControlSlider::released, this, [this] {
        if (const auto raw = m_slider->value(); raw && m_editing)
            request(*raw);
    });
    connect(m_percent->findChild<QLineEdit*>(), &QLineEdit::textEdited, this,
            [this] { m_editing = true; });
    connect(m_percent, &QDoubleSpinBox::valueChanged, this, &ControlLimit::edited);
    connect(m_percent, &QDoubleSpinBox::editingFinished, this, [this] {
        if (m_editing)
            request(std::llround(m_percent->value() * rawPerPercent));
    });
    connect(m_stall, &QDoubleSpinBox::editingFinished, this, [this] {
        if (m_model.isEmpty() || m_stall->value() == stallTorque())
            return;
        m_settings.setPageValue(stallTorqueKey(m_model), m_stall->value());
        fill();
    });
    new PressGuard(m_slider);
    retranslate();
    hide();
}

void ControlLimit::build()
{
    m_title->setObjectName(QStringLiteral("torqueLimitTitle"));
    m_percent->setObjectName(QStringLiteral("torqueLimitPercent"));
    m_percent->setRange(0, fullScale / rawPerPercent);
    m_percent->setDecimals(1);
    m_percent->setSuffix(QStringLiteral(" %"));
    m_percent->setKeyboardTracking(false);
    m_slider->setObjectName(QStringLiteral("torqueLimitSlider"));
    m_slider->setScale(
        {0, fullScale, 0, fullScale, false, QStringLiteral("0"), QStringLiteral("100 %")});
    m_force->setObjectName(QStringLiteral("torqueLimitForce"));
    m_stall->setObjectName(QStringLiteral("stallTorque"));
    m_stall->setRange(0, maxStallTorque);
    m_stall->setDecimals(1);
    m_stall->setSuffix(QStringLiteral(" kg·cm"));
    m_stall->setKeyboardTracking(false);
    m_advice->setObjectName(QStringLiteral("grippingAdvice"));
    m_advice->setWordWrap(true);
    // The wheel works only after a click.
    for (QWidget* box : {static_cast<QWidget*>(m_percent), static_cast<QWidget*>(m_stall)}) {
        box->setFocusPolicy(Qt::StrongFocus);
        box->installEventFilter(this);
    }
    m_title->setBuddy(m_percent);
    m_stallTitle->setBuddy(m_stall);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(4);
    auto* head = new QHBoxLayout;
    head->setSpacing(4);
    head->addWidget(m_more);
    head->addWidget(m_title, 1);
    head->addWidget(m_force);
    head->addWidget(m_percent);
    column->addLayout(head);
    column->addWidget(m_details);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins({});
    details->setSpacing(4);
    details->addWidget(m_slider);
    auto* stall = new QHBoxLayout;
    stall->addWidget(m_stallTitle, 1);
    stall->addWidget(m_stall);
    details->addLayout(stall);
    details->addWidget(m_advice);
    m_more->setObjectName(QStringLiteral("torqueLimitMore"));
    m_more->setProperty("disclosure", true);
    m_more->setCheckable(true);
    m_more->setFocusPolicy(Qt::StrongFocus);
    connect(m_more, &QToolButton::toggled, this, [this](bool shown) {
        m_settings.setPageValue(detailsKey, shown);
        showDetails(shown);
    });
    const bool shown = m_settings.pageValue(detailsKey, false).toBool();
    m_more->setChecked(shown);
    showDetails(shown);
}

int ControlLimit::detailsHeight() const
{
    if (m_details->isHidden())
        return 0;
    const QLayout* details = m_details->layout();
    return details->totalHeightForWidth(width()) + layout()->spacing();
}

void ControlLimit::showDetails(bool shown)
{
    m_more->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    m_details->setVisible(shown);
}

double ControlLimit::stallTorque() const
{
    return m_model.isEmpty() ? 0 : m_settings.pageValue(stallTorqueKey(m_model), 0.0).toDouble();
}

/// By the user: typed and finished, stepped, or moved with the slider.
void ControlLimit::edited()
{
    m_editing = true;
    m_slider->setValue(std::llround(m_percent->value() * rawPerPercent));
    showForce();
}

/// For fast turns of the wheel: one write at a time, and of the waiting ones only the latest.
void ControlLimit::request(std::int64_t raw)
{
    m_editing = false;
    if (m_pending) {
        m_sent = raw;
        m_next = raw;
    } else {
        send(raw);
    }
}

void ControlLimit::send(std::int64_t raw)
{
    m_sent = raw;
    m_next.reset();
    m_pending = true;
    Q_EMIT limitRequested(raw);
}

void ControlLimit::showServo(const session::ServoEntry* entry, bool usable)
{
    const bool known = entry != nullptr && entry->servo.profile && entry->servo.profile->writable;
    const device::TorqueLimit limit =
        known ? device::torqueLimit(*entry->servo.profile) : device::TorqueLimit{};
    setVisible(limit.reg != nullptr);
    setEnabled(usable);
    if (limit.reg == nullptr)
        return;
    if (std::exchange(m_servo, entry->ref) != entry->ref) {
        m_editing = false;
        m_sent.reset();
        m_next.reset();
    }
    const bool other = m_model != entry->servo.profile->modelName;
    m_model = entry->servo.profile->modelName;
    m_temporary = limit.temporary;
    m_read = entry->servo.raw(*limit.reg);
    if (other)
        m_stall->setValue(stallTorque());
    const auto write = entry->writes.find(limit.reg->key);
    m_pending = write != entry->writes.end() && write->second.pending > 0;
    if (!m_pending) {
        const bool failed = write != entry->writes.end() && write->second.error;
        m_sent.reset();
        if (const auto next = std::exchange(m_next, std::nullopt); next && !failed && usable)
            send(*next);
    }
    fill();
}

void ControlLimit::discardEdit()
{
    m_editing = false;
    m_next.reset();
    fill();
}

void ControlLimit::fill()
{
    m_title->setText(m_temporary ? tr("Torque limit (until power-off)") : tr("Torque limit"));
    const auto raw = m_sent ? m_sent : m_read;
    if (!m_editing && raw) {
        const QSignalBlocker blocker(m_percent);
        m_slider->setValue(raw);
        m_percent->setValue(static_cast<double>(*raw) / rawPerPercent);
    }
    showForce();
}

void ControlLimit::showForce()
{
    const double stall = stallTorque();
    const double share = m_percent->value() / 100;
    m_force->setText(stall > 0 ? tr("≈ %1 kg·cm").arg(stall * share, 0, 'f', 1) : QString());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Quiet, palette()));
    m_advice->setPalette(colors);
    m_force->setPalette(colors);
}

void ControlLimit::retranslate()
{
    setAccessText(m_more, tr("Torque limit details"),
                  tr("Shows the slider and explains how to set a gripping force"));
    m_percent->setAccessibleName(tr("Torque limit"));
    m_percent->setToolTip(tr("Percentage of the stall torque (Enter sends the value; Esc turns "
                             "torque off on the whole bus and shows the present value again)"));
    m_slider->setAccessibleName(tr("Torque limit"));
    m_slider->setToolTip(tr("Maximum output; sent when the slider is released"));
    m_stallTitle->setText(tr("Stall torque of this model"));
    m_stall->setSpecialValueText(tr("not entered"));
    m_stall->setAccessibleName(m_stallTitle->text());
    m_stall->setToolTip(tr("Enter the data sheet value for your supply voltage; the value is "
                           "stored for this model, not written to the servo"));
    m_advice->setText(
        tr("For gripping, set the percentage of the stall torque that the part can withstand (for "
           "example, 10 % of 10 kg·cm is 1 kg·cm). A lower limit also makes the servo slower. Use "
           "this method only for parts that all have the same mass."));
    fill();
}

bool ControlLimit::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ControlLimit::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fill();
}
} // namespace ui
