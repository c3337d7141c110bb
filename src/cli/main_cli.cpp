// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"
#include "cli/output/utf8_locale.h"
#include "cli/program.h"
#include "session/detachable_worker.h"

#include <QGuiApplication>

#include <algorithm>
#include <memory>

namespace {
/// A PDF report needs fonts, and fonts need a GUI application. Everything else does without, and so
/// runs on machines that cannot start one.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv)
{
    const bool paper = std::any_of(argv, argv + argc, [](const char* word) {
        return QByteArray(word).toLower().endsWith(".pdf");
    });
    if (!paper)
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen"); // no display needed
    return std::make_unique<QGuiApplication>(argc, argv);
}
} // namespace

int main(int argc, char** argv)
{
    cli::useUtf8();
    const cli::Interrupt interrupt; // before Qt starts threads
    const auto application = makeApplication(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("servodesk"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SERVODESK_VERSION));
    return session::DetachableWorker::exitCode(
        cli::runProgram(QCoreApplication::arguments().mid(1), interrupt.stop()));
}
