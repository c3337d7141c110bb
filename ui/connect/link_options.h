// SPDX-License-Identifier: GPL-3.0-or-later
// The rarely used settings of a port: parity, reply timeout, silence between Modbus frames,
// retries. Opens below its button. Owned by its parent; main thread.
#pragma once

#include "session/connection.h"
#include "ui/widgets/popup_frame.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace ui {
class LinkOptions final : public PopupFrame {
    Q_OBJECT

public:
    explicit LinkOptions(QWidget* parent = nullptr);

    /// Fills in parity, timeout, silence and retries.
    void apply(session::PortRequest& request) const;
    void show(const session::PortRequest& request);
    bool isDefault() const; ///< nothing set

Q_SIGNALS:
    void changed();

private:
    void retranslate();

    QComboBox* m_parity;
    QSpinBox* m_replyTimeout; ///< ms; 0: automatic
    QSpinBox* m_silence;      ///< µs; 0: as in the standard
    QSpinBox* m_retries;      ///< -1: automatic
    QFormLayout* m_form;
};
} // namespace ui
