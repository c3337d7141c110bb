// SPDX-License-Identifier: GPL-3.0-or-later
// A framed popup that opens below its button, inside the screen, and closes by itself. Owned by its
// parent; main thread.
#pragma once

#include <QFrame>

namespace ui {
class PopupFrame : public QFrame {
    Q_OBJECT

public:
    PopupFrame(const char* name, QWidget* parent);

    void popUpBelow(const QWidget& button);
};
} // namespace ui
