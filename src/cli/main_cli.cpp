// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"
#include "cli/program.h"
#include "cli/utf8_locale.h"

#include <QCoreApplication>

int main(int argc, char** argv)
{
    cli::useUtf8();
    const cli::Interrupt interrupt; // before Qt starts threads of its own
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("servodesk"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SERVODESK_VERSION));
    return cli::runProgram(QCoreApplication::arguments().mid(1), interrupt.stop());
}
