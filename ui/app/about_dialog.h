// SPDX-License-Identifier: GPL-3.0-or-later
// Version, license, and where the program keeps its files. Open it with open(); it deletes itself.
#pragma once

#include <QDialog>

namespace ui {
class AboutDialog final : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* parent);
};
} // namespace ui
