// SPDX-License-Identifier: GPL-3.0-or-later
// The baud rates of a search as checkboxes; opens below its button. Owned by the search panel; main
// thread.
#pragma once

#include "ui/widgets/popup_frame.h"

#include <vector>

class QListWidget;

namespace ui {
class RateChooser final : public PopupFrame {
    Q_OBJECT

public:
    explicit RateChooser(QWidget* parent = nullptr);

    std::vector<int> rates() const; ///< the checked ones, highest first
    void setRates(const std::vector<int>& rates);

Q_SIGNALS:
    void changed();

private:
    void retranslate();

    QListWidget* m_list;
};
} // namespace ui
