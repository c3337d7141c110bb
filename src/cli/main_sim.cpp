// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"
#include "cli/input/sim_options.h"
#include "cli/output/terminal_text.h"
#include "cli/output/utf8_locale.h"
#include "text/error_text.h"

#include <QCoreApplication>

#include <iostream>

namespace {
std::string shown(const QString& text)
{
    return cli::terminalSafe(text).toStdString();
}
} // namespace

int main(int argc, char** argv)
{
    cli::useUtf8();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("servodesk"));
    const auto line = cli::parseSimCommandLine(argc, argv);
    if (!line.options) {
        (line.exitCode == 0 ? std::cout : std::cerr) << shown(QString::fromStdString(line.message));
        return line.exitCode;
    }
    const auto announce = [](const QString& path) {
        std::cout << "port: " << shown(path) << std::endl;
    };
    const auto tell = [](const QString& what) { std::cout << shown(what) << std::endl; };
    if (const auto run = session::runSimulator(*line.options, announce, tell); !run) {
        const auto words = text::describe(run.error());
        std::cerr << "servodesk-sim: " << shown(words.message) << '\n'
                  << shown(words.remedy) << '\n';
        return cli::exitCode(run.error().code);
    }
    return 0;
}
