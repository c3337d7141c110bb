// SPDX-License-Identifier: GPL-3.0-or-later
// All shortcuts and what they do, from the command table. Open it with open(); it deletes itself.
#pragma once

#include "ui/common/commands.h"

#include <QDialog>

namespace ui {
class ShortcutsDialog final : public QDialog {
    Q_OBJECT

public:
    ShortcutsDialog(const Commands& commands, QWidget* parent);
};
} // namespace ui
