// SPDX-License-Identifier: GPL-3.0-or-later
// Which list of the history is shown, from which source, and the filters by servo, register and
// time. Keeps no history itself: it fills its choices from the service it is given, without
// waiting. Owned by the history page; main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/settings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDateEdit;

namespace ui {
/// Whose history is shown.
struct HistorySourceChoice {
    bool isServer = false;               ///< false: the history of this computer
    std::optional<std::int64_t> bench{}; ///< on the server; nullopt: all benches
};

class HistoryFilterBar final : public QWidget {
    Q_OBJECT

public:
    HistoryFilterBar(const session::Settings& settings, QWidget* parent);

    HistorySourceChoice source() const;
    history::HistoryKind kind() const;
    history::HistoryFilter filter() const;
    /// Only the filters that the current list has.
    void showFiltersOfKind();
    /// Asks `service` for the servos and registers to choose from, and a server for its benches.
    /// What was chosen stays chosen while it is still there.
    void loadChoices(session::HistoryService& service, bool isServer);
    /// Shows only entries of this servo, if it is among the choices.
    void selectServo(std::int64_t number);
    /// The benches of the server; empty: not known.
    void setBenches(std::vector<history::HistoryBench> benches);

Q_SIGNALS:
    void sourceChanged();
    void filterChanged();

private:
    void build();
    void connectAll();
    void retranslate();
    void showSources();
    void showServos(const std::vector<history::HistoryServo>& servos, bool isServer);

    const session::Settings& m_settings;
    std::vector<history::HistoryBench> m_benches;
    QComboBox* m_source = nullptr;
    QComboBox* m_kind = nullptr;
    QComboBox* m_servo = nullptr;
    QComboBox* m_register = nullptr;
    QComboBox* m_period = nullptr;
    QDateEdit* m_from = nullptr;
    QDateEdit* m_until = nullptr;
    QCheckBox* m_onlyErrors = nullptr;
};
} // namespace ui
