// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of servodesk. A value; parsing prints nothing.
#pragma once

#include "session/session.h"
#include "session/settings.h"

#include <QSize>
#include <QStringList>

namespace ui {
struct Options {
    std::optional<session::PortRequest> port{}; ///< connect and search at the start
    QString language{};                         ///< empty: as remembered
    std::optional<session::Theme> theme{};
    QString page{};
    std::optional<int> select{}; ///< ID
    QString screenshot{};        ///< file; the program then ends
    int afterMs = 1500;
    QSize size{};            ///< of the window; invalid: as remembered
    bool isSelfTest = false; ///< see self_test.h; the program then ends
    QStringList files{};     ///< snapshots, bundles and recordings to open
};

struct ParsedOptions {
    Options options;
    QString error; ///< what makes no sense; empty: all is well
    QString print; ///< help or version: print it and end
};

/// `arguments` with the program's name in front. Needs the application object.
ParsedOptions parseOptions(const QStringList& arguments);
} // namespace ui
