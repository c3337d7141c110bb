// SPDX-License-Identifier: GPL-3.0-or-later
// The undo command as a button that names what it would undo. Its width is fixed, because it must
// not move under the pointer. Owned by the window; main thread.
#pragma once

#include <QToolButton>

namespace ui {
class UndoButton final : public QToolButton {
    Q_OBJECT

public:
    UndoButton(QAction* undo, QWidget* parent);

private:
    void showName();
};
} // namespace ui
