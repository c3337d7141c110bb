// SPDX-License-Identifier: GPL-3.0-or-later
// What one line of the journal file of earlier versions says. Each line is one JSON object with "v"
// (format version) and "type" (begin, end, keep); nothing writes them any more, and all that was
// ever published is understood. Pure; any thread.
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

/// FileFormat says what is wrong with it.
base::Result<JournalLine> decodeJournalLine(const QByteArray& text);
} // namespace record
