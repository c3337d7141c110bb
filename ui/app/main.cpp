// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/detachable_worker.h"
#include "ui/app/program.h"

int main(int argc, char* argv[])
{
    return session::DetachableWorker::exitCode(ui::runProgram(argc, argv));
}
