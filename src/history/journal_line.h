// SPDX-License-Identifier: GPL-3.0-or-later
// One line of the journal file of earlier versions. Each line is one JSON object with "v"
// (format version) and "type" (begin, end, keep); they are no longer written, and all
// published versions can be read. Pure; any thread.
#pragma once

#include "base/journal.h"

#include <QByteArray>

#include <variant>

namespace history {
struct BeginLine {
    base::Intent intent;
};

struct EndLine {
    QString uuid;
    base::IntentResult end;
    QDateTime at{};
};

struct FactLine {
    base::ServoIdentity servo;
    QString name;
    std::vector<std::int64_t> values;
    QDateTime at{};
};

using JournalLine = std::variant<BeginLine, EndLine, FactLine>;

/// FileFormat; the detail has the reason.
base::Result<JournalLine> decodeJournalLine(const QByteArray& text);
} // namespace history
