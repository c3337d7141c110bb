// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/program.h"

int main(int argc, char* argv[])
{
    return ui::runProgram(argc, argv);
}
