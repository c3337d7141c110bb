// SPDX-License-Identifier: GPL-3.0-or-later
// One of several buttons side by side of which one is selected; the selected one has the accent
// color, in both themes. Owned by its parent; main thread.
#pragma once

#include <QToolButton>

namespace ui {
class SegmentButton final : public QToolButton {
    Q_OBJECT

public:
    explicit SegmentButton(QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
};
} // namespace ui
