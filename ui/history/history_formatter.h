// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the history as text, in the current language: one list for each kind. Pure except for a
// cache of register maps; main thread.
#pragma once

#include "history/history.h"
#include "history/history_export.h"
#include "history/history_profiles.h"
#include "ui/common/theme.h"

#include <map>

namespace ui {
struct HistoryLine {
    std::int64_t number = 0; ///< of the row in its list
    std::int64_t servo = 0;  ///< number of its servo; 0: several or none
    QDateTime at{};          ///< UTC
    QStringList cells{};
    Tone tone = Tone::Quiet; ///< of the outcome
    /// Name and value of everything known, in the order of the columns; no name: a sentence.
    std::vector<std::pair<QString, QString>> details{};
    QString label{}; ///< the user's, where there is one
    QString note{};
    bool isStepResponse = false;                  ///< a test run that the step page can show
    std::optional<history::HistoryWrite> write{}; ///< of the list of writes

    QString tip() const;   ///< all details
    QString title() const; ///< "Position loop P", "manual": what the row is about
};

class HistoryFormatter {
public:
    explicit HistoryFormatter(const catalog::Catalog& catalog)
        : m_profiles(catalog)
    {}

    void addServos(const std::vector<history::HistoryServo>& servos);
    /// Null: not among those added.
    const history::HistoryServo* servo(std::int64_t number) const;
    static QStringList headers(history::HistoryKind kind);
    /// Columns that a list shows; the others are details.
    static int listColumns(history::HistoryKind kind);
    static int timeColumn(history::HistoryKind kind); ///< of the row itself; -1: none
    static int toneColumn(history::HistoryKind kind); ///< -1: none
    /// In few letters: only the time of an entry of today, no seconds of an older one.
    static QString listTime(const QDateTime& at, const QDate& today);
    static QString kindName(history::HistoryKind kind);
    static QString servoTitle(const history::HistoryServo& servo);

    HistoryLine formatLine(const history::HistoryWrite& row) const;
    HistoryLine formatLine(const history::HistorySnapshot& row) const;
    HistoryLine formatLine(const history::HistoryAlarm& row) const;
    HistoryLine formatLine(const history::HistoryRecording& row) const;
    HistoryLine formatLine(const history::HistoryServo& row) const;
    HistoryLine formatLine(const history::TestRun& row) const;

private:
    history::HistoryProfiles m_profiles;
    std::map<std::int64_t, history::HistoryServo> m_servos; ///< by number
};
} // namespace ui
