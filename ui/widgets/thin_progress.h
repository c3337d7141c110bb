// SPDX-License-Identifier: GPL-3.0-or-later
// A progress bar as a thin line; the numbers are shown as text beside it. Owned by its parent; main
// thread.
#pragma once

#include <QProgressBar>

namespace ui {
class ThinProgress final : public QProgressBar {
    Q_OBJECT

public:
    explicit ThinProgress(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};
} // namespace ui
