// SPDX-License-Identifier: GPL-3.0-or-later
// What few people need to set about a port: parity, time-out, the silence between Modbus frames,
// retries. A small window that opens beside its button and closes by itself. Owned by its parent;
// main thread.
#pragma once

#include "session/connection.h"

#include <QFrame>

class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace ui {
class LinkOptions final : public QFrame {
    Q_OBJECT

public:
    explicit LinkOptions(QWidget* parent = nullptr);

    /// Fills in parity, patience, silence, retries.
    void apply(session::PortRequest& request) const;
    void show(const session::PortRequest& request);
    bool isDefault() const; ///< nothing set
    /// Opens below `button`, inside the screen.
    void popUpBelow(const QWidget& button);

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QComboBox* m_parity;
    QSpinBox* m_replyTimeout; ///< ms; 0: by itself
    QSpinBox* m_silence;      ///< µs; 0: the standard's
    QSpinBox* m_retries;      ///< -1: as the program thinks best
    QFormLayout* m_form;
};
} // namespace ui
