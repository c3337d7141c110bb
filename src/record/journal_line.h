// SPDX-License-Identifier: GPL-3.0-or-later
// One line of the journal file <-> what it says. Each line is one JSON object with "v" (format
// version) and "type" (begin, end, keep). Lines are never changed once written, so a reader must
// understand every version that was ever published. Pure; any thread.
#pragma once

#include "base/journal.h"

#include <QByteArray>

#include <variant>

namespace record {
struct BeginLine {
    base::Intent intent;
};

struct EndLine {
    QString uuid;
    base::IntentEnd end;
    QDateTime at{}; ///< when it was read; writing takes encodeJournalLine's
};

struct KeepLine {
    base::ServoIdentity servo;
    QString name;
    std::vector<std::int64_t> values;
    QDateTime at{}; ///< as EndLine's
};

using JournalLine = std::variant<BeginLine, EndLine, KeepLine>;

/// Without the line feed. `at` is the time of writing, UTC.
QByteArray encodeJournalLine(const JournalLine& line, const QDateTime& at);

/// FileFormat says what is wrong with it.
base::Result<JournalLine> decodeJournalLine(const QByteArray& text);
} // namespace record
