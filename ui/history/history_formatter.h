// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the history as text, in the current language: one list for each kind. Pure except for a
// cache of register maps; main thread.
#pragma once

#include "history/history.h"
#include "history/history_export.h"
#include "history/history_profiles.h"
#include "ui/common/theme.h"

#include <map>
#include <span>

namespace ui {
enum class HistoryCell : std::uint8_t {
    Text,
    Time, ///< of the row itself
    Number,
    Outcome, ///< in the row's tone
    Detail,  ///< not in the list
};

struct HistoryColumn {
    const char* header; ///< to be translated in the context "History"
    HistoryCell cell = HistoryCell::Text;
};

struct HistoryLine {
    std::int64_t number = 0; ///< of the row in its list
    std::int64_t servo = 0;  ///< number of its servo; 0: several or none
    QDateTime at{};          ///< UTC
    QStringList cells{};
    QString title{};         ///< "Position loop P", "manual": what the row is about
    Tone tone = Tone::Quiet; ///< of the outcome
    /// Name and value of everything known, in the order of the columns; no name: a sentence.
    std::vector<std::pair<QString, QString>> details{};
    QString label{}; ///< the user's, where there is one
    QString note{};
    bool isStepResponse = false;                  ///< a test run that the step page can show
    std::optional<history::HistoryWrite> write{}; ///< of the list of writes

    QString tip() const; ///< all details
};

class HistoryFormatter {
public:
    explicit HistoryFormatter(const catalog::Catalog& catalog)
        : m_profiles(catalog)
    {}

    void addServos(const std::vector<history::HistoryServo>& servos);
    /// Null: not among those added.
    const history::HistoryServo* servo(std::int64_t number) const;
    /// Of the cells of formatLine(), in their order.
    static std::span<const HistoryColumn> columns(history::HistoryKind kind);
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
