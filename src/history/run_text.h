// SPDX-License-Identifier: GPL-3.0-or-later
// The stored document of one test run. The thread that opened the file; BadArgument: there is no
// such run; errors as in history/history_file.h.
#pragma once

#include "base/error.h"

#include <QByteArray>

namespace history {
class HistoryFile;

base::Result<QByteArray> runText(const HistoryFile& file, std::int64_t number);
} // namespace history
