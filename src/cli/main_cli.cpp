// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"
#include "cli/output/utf8_locale.h"
#include "cli/program.h"
#include "session/detachable_worker.h"

#include <QGuiApplication>

#include <algorithm>
#include <memory>

namespace {
/// Paper needs fonts, and those a GUI application; nothing else here does, so that the program also
/// runs where there is none.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv)
{
    const bool paper = std::any_of(argv, argv + argc, [](const char* word) {
        return QByteArray(word).toLower().endsWith(".pdf");
    });
    if (!paper)
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen"); // a display is of no use
    return std::make_unique<QGuiApplication>(argc, argv);
}
} // namespace

int main(int argc, char** argv)
{
    cli::useUtf8();
    const cli::Interrupt interrupt; // before Qt starts threads of its own
    const auto application = makeApplication(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("servodesk"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SERVODESK_VERSION));
    return session::DetachableWorker::exitCode(
        cli::runProgram(QCoreApplication::arguments().mid(1), interrupt.stop()));
}
