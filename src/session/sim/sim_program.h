// SPDX-License-Identifier: GPL-3.0-or-later
// The program servodesk-sim without its command line: builds the simulated bus, keeps its EPROMs in
// the state file, serves it on a pseudo-terminal in real time until stopped. Main thread only.
#pragma once

#include "base/clock.h"
#include "base/error.h"

#include <QString>

#include <functional>
#include <optional>

namespace session {
struct SimOptions {
    QString preset = QStringLiteral("demo");
    QString servos; ///< a list such as "sts3215@1,scs15@3"; replaces the preset
    std::optional<int> baud;
    QString symlink;   ///< symbolic link to the terminal; empty: none
    QString stateFile; ///< empty: nothing is kept
    std::optional<base::Duration> runFor;
    bool wireTime = false;
    base::Duration latency{};
    bool echo = false;
    QString faults;
    std::optional<base::Duration> epromTime;
    std::uint64_t seed = 1;
};

/// Returns when stopped (SIGTERM, SIGINT) or `runFor` has passed. `announce` is told the terminal's
/// path once clients may open it, `tell` what is plugged in and out of a bag. Errors: BadArgument
/// (servos, preset, faults), FileFormat, FileUnreadable, FileUnwritable (state file), PortFailed
/// (no pseudo-terminal, link not possible).
base::Result<void> runSimulator(const SimOptions& options,
                                const std::function<void(const QString& path)>& announce,
                                const std::function<void(const QString& line)>& log = {});
} // namespace session
