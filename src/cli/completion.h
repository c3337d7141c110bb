// SPDX-License-Identifier: GPL-3.0-or-later
// What a shell offers to complete a command line of servodesk-cli with; the shells' own files
// (packaging/linux/completions) ask for it by "servodesk-cli --complete LINE". Lists the ports of
// this computer, opens none. Main thread (translated texts); never fails.
#pragma once

#include <QStringList>

namespace cli {
struct Completion {
    QString word;
    QString help{}; ///< may be empty
    bool operator==(const Completion&) const = default;
};

/// `line`: up to the cursor, with the name of the program. Empty: nothing but files would fit.
std::vector<Completion> completionsOf(const QString& line);
/// One per line, the help behind a tab.
QString completionText(const std::vector<Completion>& completions);
} // namespace cli
