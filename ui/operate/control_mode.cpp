// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_mode.h"

#include "ui/common/widget_text.h"
#include "ui/operate/control_text.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/segment_button.h"

#include <QButtonGroup>

namespace ui {
namespace {
constexpr int between = 2;
}

ControlMode::ControlMode(QWidget* parent)
    : QWidget(parent)
    , m_row(new FlowLayout(this, between))
{
    setObjectName(QStringLiteral("controlMode"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    retranslate();
}

void ControlMode::build()
{
    delete m_group;
    m_group = new QButtonGroup(this);
    while (QLayoutItem* item = m_row->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (!m_profile)
        return;
    int index = 0;
    for (const catalog::Mode& mode : m_profile->modes) {
        auto* button = new SegmentButton(this);
        button->setObjectName(QStringLiteral("mode_") + mode.key);
        setButtonText(button, modeTitle(mode),
                      tr("%1. Click to preview what switching to this mode changes.")
                          .arg(modeHelp(mode.key)));
        new PressGuard(button);
        m_group->addButton(button, index++);
        m_row->addWidget(button);
        connect(button, &SegmentButton::clicked, this, [this, key = mode.key] {
            check(); // the servo decides which one it is in
            if (key != m_mode)
                Q_EMIT requested(key);
        });
    }
    check();
}

void ControlMode::check()
{
    m_group->setExclusive(false);
    int index = 0;
    for (const catalog::Mode& mode : m_profile->modes)
        m_group->button(index++)->setChecked(mode.key == m_mode);
    m_group->setExclusive(!m_mode.isEmpty());
}

void ControlMode::showServo(const session::ServoEntry* entry, bool usable)
{
    const bool shown = entry != nullptr && entry->servo.profile && entry->servo.profile->writable;
    const catalog::ProfilePtr profile = shown ? entry->servo.profile : nullptr;
    const catalog::Mode* mode = shown ? entry->servo.mode() : nullptr;
    const QString key = mode != nullptr ? mode->key : QString();
    if (profile != m_profile) {
        m_profile = profile;
        m_mode = key;
        build();
    } else if (key != m_mode) {
        m_mode = key;
        check();
    }
    setVisible(shown);
    setEnabled(usable);
}

void ControlMode::retranslate()
{
    setAccessibleName(tr("Operating mode"));
    if (m_profile)
        build();
}
} // namespace ui
