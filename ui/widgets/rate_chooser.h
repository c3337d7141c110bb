// SPDX-License-Identifier: GPL-3.0-or-later
// The rates of a search, to be ticked; opens below its button. Owned by the search panel; main
// thread.
#pragma once

#include <QFrame>

#include <vector>

class QListWidget;

namespace ui {
class RateChooser final : public QFrame {
    Q_OBJECT

public:
    explicit RateChooser(QWidget* parent = nullptr);

    std::vector<int> rates() const; ///< ticked, highest first
    void setRates(const std::vector<int>& rates);
    void popUpBelow(const QWidget& button);

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QListWidget* m_list;
};
} // namespace ui
