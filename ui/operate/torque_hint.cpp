// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/torque_hint.h"

#include "ui/common/theme.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/press_guard.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace ui {
namespace {
const QString neverAskKey = QStringLiteral("operate/no_torque_hint");
}

TorqueHint::TorqueHint(session::Settings& settings, QWidget* parent)
    : QFrame(parent)
    , m_settings(settings)
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_neverAsk(new QCheckBox(this))
    , m_cancel(new QPushButton(this))
    , m_yes(new QPushButton(this))
{
    setObjectName(QStringLiteral("torqueHint"));
    m_title->setObjectName(QStringLiteral("torqueHintTitle"));
    m_text->setObjectName(QStringLiteral("torqueHintText"));
    m_neverAsk->setObjectName(QStringLiteral("torqueHintNever"));
    m_cancel->setObjectName(QStringLiteral("torqueHintCancel"));
    m_yes->setObjectName(QStringLiteral("torqueHintGo"));
    m_text->setWordWrap(true);
    m_title->setWordWrap(true);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addWidget(m_neverAsk);
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(m_cancel);
    row->addWidget(m_yes);
    column->addLayout(row);
    connect(m_cancel, &QPushButton::clicked, this, &TorqueHint::dismiss);
    connect(m_yes, &QPushButton::clicked, this, &TorqueHint::proceed);
    new PressGuard(m_yes); // what it lets go on moves the servo
    retranslate();
    hide();
}

bool TorqueHint::isConfirmed(std::function<void()> action)
{
    if (m_answered || m_settings.pageValue(neverAskKey, false).toBool())
        return true;
    m_action = std::move(action);
    show();
    m_yes->setFocus();
    return false;
}

void TorqueHint::dismiss()
{
    m_action = nullptr;
    hide();
}

void TorqueHint::proceed()
{
    m_answered = true;
    if (m_neverAsk->isChecked())
        m_settings.setPageValue(neverAskKey, true);
    const auto action = std::exchange(m_action, nullptr);
    hide();
    if (action)
        action();
}

void TorqueHint::retranslate()
{
    m_title->setText(QStringLiteral("⚠ ") +
                     tr("Check before turning torque on for the first time in this session"));
    m_text->setText(tr("• The bracket and horn cannot catch or jam\n• Fingers and cables are away "
                       "from the shaft\n• The polarity and voltage of the power supply are "
                       "correct\n• Above 12 V, the power wires are thick enough"));
    setButtonText(m_neverAsk, tr("Do not show this again"), tr("Applies to later sessions too"));
    setButtonText(m_cancel, tr("Cancel"), tr("Leaves the servo as it is"));
    setButtonText(m_yes, tr("Continue"),
                  tr("Performs the requested action; this reminder does not appear again "
                     "until the program is restarted"));
}

void TorqueHint::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor line = tone(Tone::Warn, palette());
    QColor ground = line;
    ground.setAlphaF(0.12F);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(line, 1));
    painter.setBrush(palette().color(QPalette::Window)); // it may float over a chart
    painter.drawRoundedRect(frame, 6, 6);
    painter.setBrush(ground);
    painter.drawRoundedRect(frame, 6, 6);
}
} // namespace ui
