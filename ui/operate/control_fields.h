// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a move besides its goal: speed, acceleration, time and current, if this family and
// mode have them. Owned by the control panel; main thread.
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

    /// `multiple`: what is shown is sent to all selected servos, whatever they had. One alone gets
    /// only what was changed.
    void showServo(const session::ServoEntry& entry, bool multiple);
    void retranslate();

    /// Adds to the request what the user has changed (several servos: what is shown), and what is
    /// sent with every goal.
    void fill(session::MoveRequest& request) const;
    /// Why a changed field is invalid; empty: all are valid.
    QString inputError() const;
    void setSent(const session::MoveRequest& request, base::Duration at);
    /// Discards what was typed.
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
    std::array<bool, Count> m_has{}; ///< in the present layout
};
} // namespace ui
