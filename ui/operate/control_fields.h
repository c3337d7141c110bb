// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a move beside its goal: speed, acceleration, time and current, as far as this
// family and mode have them; others are absent. Owned by the control panel; main thread.
#pragma once

#include "session/motion/motion_controller.h"

#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;

namespace ui {
class ControlField;

class ControlFields final : public QWidget {
    Q_OBJECT

public:
    explicit ControlFields(QWidget* parent);

    /// `several`: others are to get the same; what is shown is sent to all of them, whatever they
    /// had. One alone gets only what was changed.
    void showServo(const session::ServoEntry& entry, bool multiple);
    void retranslate();

    /// Adds to the wish what the user has changed (several servos: what he sees), and what goes out
    /// with every goal.
    void fill(session::MoveRequest& request) const;
    /// Why a changed field makes no sense; empty: all is well.
    QString inputError() const;
    void setSent(const session::MoveRequest& request, base::Duration at);
    /// What was typed is dropped.
    void discardEdits();

Q_SIGNALS:
    void returnPressed();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum Field : std::uint8_t { Speed, Acceleration, Time, Current, Count };
    void arrange();
    void onFieldEdited(Field which);
    void showHint();
    void reserveHint();
    std::optional<QString> requestedValue(Field which) const;
    bool appliesToAll(Field which) const;

    std::array<ControlField*, Count> m_fields{};
    QGridLayout* m_grid;
    QLabel* m_hint;
    device::Servo m_servo; ///< as shown
    session::ServoRef m_ref = 0;
    QString m_mode;
    bool m_multiple = false;
    std::array<bool, Count> m_has{}; ///< as they are laid out
};
} // namespace ui
