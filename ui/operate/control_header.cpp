// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_header.h"

#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/operate/control_mode.h"
#include "ui/operate/control_torque.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui {
namespace {
/// The stop did not reach the servo, or another program has turned torque on again.
bool isOnSinceStop(const session::ServoEntry& entry)
{
    const catalog::Register* torque =
        entry.servo.profile ? entry.servo.profile->byRole(catalog::Role::TorqueSwitch) : nullptr;
    const auto at = torque != nullptr ? entry.servo.image.readAt(torque->offset) : std::nullopt;
    return at && *at > entry.stoppedAt && entry.servo.raw(*torque) == 1;
}
} // namespace

ControlHeader::ControlHeader(Commands& commands, QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_torque(new ControlTorque(commands, this))
    , m_mode(new ControlMode(this))
    , m_stopped(new QLabel(this))
{
    m_title->setObjectName(QStringLiteral("controlTitle"));
    m_title->setWordWrap(true);
    makeHeading(m_title);
    m_stopped->setObjectName(QStringLiteral("controlStopped"));
    QSizePolicy keepsRoom = m_stopped->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_stopped->setSizePolicy(keepsRoom);
    m_stopped->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    auto* head = new QWidget(this); // a layout in the column would take its spacing
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins({});
    row->addWidget(m_title, 1);
    row->addWidget(m_torque);
    column->addWidget(head);
    column->addWidget(m_mode);
    column->addWidget(m_stopped);
}

void ControlHeader::showServo(const session::ServoEntry* entry, std::size_t others)
{
    QString title = tr("Motion");
    if (entry != nullptr) {
        title = tr("Motion — ID %1").arg(entry->servo.id);
        if (others > 0) // one line in any case
            title += QLatin1Char(' ') + tr("+ %1 more").arg(others);
        else if (entry->servo.profile)
            title += QStringLiteral(" · ") + entry->servo.profile->modelName;
    }
    if (m_title->text() != title)
        m_title->setText(title);
}

void ControlHeader::showStopped(const session::ServoEntry* entry, bool stopped)
{
    m_stopped->setVisible(stopped && entry != nullptr);
    const bool stillOn = stopped && entry != nullptr && isOnSinceStop(*entry);
    m_stopped->setText(QStringLiteral("■ ") +
                       (stillOn ? tr("Stopped, but torque is on. Press Esc to turn it off.")
                                : tr("Stopped. Turn torque on to continue.")));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Warn, palette()));
    m_stopped->setPalette(colors);
}
} // namespace ui
