// SPDX-License-Identifier: GPL-3.0-or-later
// One number of a move: its name, a box for the raw number (a value with its unit can be typed as
// well), and the physical value. It shows what the servo has, or what was sent to it since. A newer
// reading never replaces what the user is typing. Sends nothing itself. Owned by its parent; main
// thread.
#pragma once

#include "device/servo.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ui {
class NumberEditor;

class ControlField final : public QWidget {
    Q_OBJECT

public:
    /// `name`: object name of the box; the labels are called after it.
    /// `wide`: the value with its unit is beside the title, not below the number.
    ControlField(const QString& name, QWidget* parent, bool wide = false);

    void setTitle(const QString& title);
    /// Null: the field is hidden. The profile keeps the register alive.
    void setRegister(const catalog::ProfilePtr& profile, const catalog::Register* reg);
    const catalog::Register* reg() const { return m_reg; }
    /// The latest reading, or what was sent since, while the user is not typing.
    void showReading(const device::Servo& servo) { showReading(servo, effectiveRaw(servo)); }
    /// The same with another number than the register's own.
    void showReading(const device::Servo& servo, std::optional<std::int64_t> raw);
    /// A start that is not the register's (the size of a step).
    void setRaw(std::int64_t raw);

    /// As shown and understood; nullopt while it is empty or makes no sense.
    std::optional<std::int64_t> value() const;
    bool isEdited() const;
    /// What was typed is dropped: it shows again what the servo has, or its own start.
    void discardEdit();
    QString inputError() const;
    /// On its way: newer than anything that is read. What was typed stays typed until it is there.
    void setPending(std::int64_t raw);
    /// This is in the servo now: newer than what was read before `at`.
    void setSent(std::int64_t raw, base::Duration at);
    /// Something was sent later than this register was read.
    bool isSentAfterRead(const device::Servo& servo, const catalog::Register* read) const;
    /// What was sent did not get there, or is out of date; what is being typed stays.
    void clearSent();
    /// Another servo or another mode: nothing that was shown still counts.
    void resetValue();
    void enterValue(std::int64_t raw); ///< as if the user had typed it
    /// What the servo is to have, whatever is being typed.
    std::optional<std::int64_t> effectiveRaw(const device::Servo& servo) const;

Q_SIGNALS:
    void edited();        ///< typed or stepped by the user
    void returnPressed(); ///< Enter

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeEditor(const device::Servo& servo);
    void showPhysical();
    void reservePhysical();

    QString m_name;
    QString m_titleText;
    QLabel* m_title;
    QVBoxLayout* m_editorLayout;
    QLabel* m_physical;
    QPointer<NumberEditor> m_editor;
    catalog::ProfilePtr m_profile;
    const catalog::Register* m_reg = nullptr;
    std::optional<std::int64_t> m_sent;
    base::Duration m_sentAt{};
    std::optional<std::int64_t> m_start; ///< follows no reading, but begins here
};
} // namespace ui
