// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of what the user is asked to do: measure here, only this servo, these two wires. Drawn
// in the colors of the theme from resources/drawings. Owned by its parent; main thread.
#pragma once

#include "base/diagnosis.h"

#include <QWidget>

class QSvgRenderer;

namespace ui {
class RemedyDrawing final : public QWidget {
    Q_OBJECT

public:
    explicit RemedyDrawing(QWidget* parent);

    void setCause(base::Cause cause); ///< hidden where words are enough
    void clear();

    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void load();
    void setDrawing(const QString& name);

    QString m_name; ///< of the file; empty: none
    QSvgRenderer* m_renderer;
};
} // namespace ui
