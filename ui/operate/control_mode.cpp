// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_mode.h"

#include "ui/common/widget_text.h"
#include "ui/operate/control_text.h"
#include "ui/widgets/press_guard.h"

namespace ui {
ControlMode::ControlMode(QWidget* parent)
    : SegmentedControl(parent)
{
    setObjectName(QStringLiteral("controlMode"));
    setArrowsSelect(false); // a choice opens the preview
    connect(this, &SegmentedControl::chosen, this, [this](int index) {
        showMode(); // the servo decides which one it is in
        const QString& key = m_profile->modes[static_cast<std::size_t>(index)].key;
        if (key != m_mode)
            Q_EMIT requested(key);
    });
    retranslate();
}

void ControlMode::build()
{
    clear();
    if (!m_profile)
        return;
    for (const catalog::Mode& mode : m_profile->modes) {
        QAbstractButton* button = addSegment(QStringLiteral("mode_") + mode.key);
        setButtonText(button, modeTitle(mode),
                      tr("%1 (click to preview what changes when you switch to this mode)")
                          .arg(modeHelp(mode.key)));
        new PressGuard(button);
    }
    showMode();
}

void ControlMode::showMode()
{
    int selected = -1;
    for (std::size_t i = 0; i < m_profile->modes.size(); ++i)
        selected = m_profile->modes[i].key == m_mode ? static_cast<int>(i) : selected;
    select(selected);
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
        showMode();
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
