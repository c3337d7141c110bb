// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for a port that is in no list: a path, or the address of a TCP bridge. Open it with open();
// it deletes itself. Main thread.
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace ui {
class PortDialog final : public QDialog {
    Q_OBJECT

public:
    explicit PortDialog(QWidget* parent = nullptr);

    /// "bench:4000" → "tcp://bench:4000", "ttyUSB0" → "/dev/ttyUSB0"; empty: nothing usable.
    static QString portFrom(const QString& portEntered);

Q_SIGNALS:
    void portEntered(const QString& port);

private:
    void retranslate();

    QLabel* m_label;
    QLineEdit* m_edit;
    QDialogButtonBox* m_buttons;
};
} // namespace ui
