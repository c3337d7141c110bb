// SPDX-License-Identifier: GPL-3.0-or-later
// The fields that define a search: IDs, baud rates, protocol, timeout. Remembered between starts.
// Owned by the search panel; main thread.
#pragma once

#include "jobs/scan/scan.h"
#include "session/settings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace ui {
class RateChooser;

class SearchScope final : public QWidget {
    Q_OBJECT

public:
    explicit SearchScope(session::Settings& settings, QWidget* parent = nullptr);

    jobs::ScanSpec spec() const;
    /// A bridge sets the rate: there is nothing to choose.
    void setHasBaud(bool canSetBaud);

Q_SIGNALS:
    void changed();

private:
    void build();
    void load();
    void save();
    void updateFields();
    void retranslate();

    session::Settings& m_settings;
    bool m_hasBaud = true;
    QLabel* m_idLabel;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QComboBox* m_rates;
    QToolButton* m_choose;
    RateChooser* m_chooser;
    QComboBox* m_protocol;
    QCheckBox* m_slow;
};
} // namespace ui
