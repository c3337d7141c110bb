// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the history in words, in the language of the moment: one list for each kind. Pure but for
// a cache of register maps; main thread.
#pragma once

#include "history/history.h"
#include "history/history_export.h"
#include "history/history_profiles.h"
#include "ui/common/theme.h"

namespace ui {
struct HistoryLine {
    std::int64_t number = 0; ///< of the row in its list
    std::int64_t servo = 0;  ///< number of its servo; 0: several or none
    QDateTime at{};          ///< UTC
    QStringList cells{};
    Tone tone = Tone::Quiet; ///< of the outcome
    QString tip{};           ///< all there is to say
    QString label{};         ///< the user's, where there is one
    QString note{};
};

class HistoryFormatter {
public:
    explicit HistoryFormatter(const catalog::Catalog& catalog)
        : m_profiles(catalog)
    {}

    void addServos(const std::vector<record::HistoryServo>& servos) { m_profiles.add(servos); }
    static QStringList headers(record::HistoryKind kind);
    static int toneColumn(record::HistoryKind kind); ///< -1: none
    static QString kindName(record::HistoryKind kind);
    static QString servoTitle(const record::HistoryServo& servo);

    HistoryLine formatLine(const record::HistoryWrite& row) const;
    HistoryLine formatLine(const record::HistorySnapshot& row) const;
    HistoryLine formatLine(const record::HistoryAlarm& row) const;
    HistoryLine formatLine(const record::HistoryRecording& row) const;
    HistoryLine formatLine(const record::HistoryServo& row) const;
    HistoryLine formatLine(const record::TestRun& row) const;

private:
    record::HistoryProfiles m_profiles;
};
} // namespace ui
