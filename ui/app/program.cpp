// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/program.h"

#include <QApplication>

namespace ui {
int runProgram(int argc, char* argv[])
{
    QApplication app(argc, argv);
    return 0;
}
} // namespace ui
