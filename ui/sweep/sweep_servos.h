// SPDX-License-Identifier: GPL-3.0-or-later
// Which servos a sweep test is for, the range of those that have one of their own, and the limits
// each is judged by. Ticks follow the selection of the window until they are set by hand. Owned by
// the sweep page; main thread. Sends nothing.
#pragma once

#include "results/sweep_limits.h"
#include "results/sweep_run.h"
#include "results/sweep_spec.h"
#include "session/servos/servo_registry.h"
#include "session/settings.h"
#include "ui/common/selection.h"

#include <QAbstractItemView>
#include <QTimer>
#include <QWidget>

#include <map>
#include <set>

class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace ui {
class SweepServos final : public QWidget {
    Q_OBJECT

public:
    SweepServos(session::ServoRegistry& registry, Selection& selection, session::Settings& settings,
                QWidget* parent);

    /// Those that can be tested, in the order of the list.
    std::vector<session::ServoRef> selected() const;
    std::map<int, results::SweepRange> ranges() const; ///< by ID, of the ticked ones
    /// The user's for this model, which the settings keep, else the built-in ones.
    results::SweepLimits limits(session::ServoRef ref) const;
    void setLimits(const QString& model, const QString& series, const results::SweepLimits& limits);

    /// The verdict of the latest test for each; empty: none yet, and no column for it.
    struct Verdict {
        results::Grade grade = results::Grade::NotMeasured;
        QString text{}; ///< shown in the tool tip
        bool operator==(const Verdict&) const = default;
    };
    void setVerdicts(const std::map<session::ServoRef, Verdict>& verdicts);
    void markRow(session::ServoRef ref);
    /// While a test runs rows can be clicked, but nothing can be changed.
    void setLocked(bool locked);

Q_SIGNALS:
    void clicked(session::ServoRef ref);
    void changed();
    void limitsRequested(session::ServoRef ref); ///< to be looked at and edited

private:
    void rebuild();
    void fitHeight();
    void fillRow(int row, const session::ServoEntry& entry);
    Qt::ItemFlags servoFlags() const;
    void onItemEdited(QTableWidgetItem* item);
    void followSelection();
    void showLimits();
    void showVerdicts();
    void retranslate();
    session::ServoRef refAt(int row) const;
    const std::optional<results::SweepLimits>& ownLimits(const QString& model) const;

    session::ServoRegistry& m_registry;
    Selection& m_selection;
    session::Settings& m_settings;
    QLabel* m_title;
    QTableWidget* m_table;
    QLabel* m_limitsName;
    QPushButton* m_limits;
    const QAbstractItemView::EditTriggers m_editTriggers;
    QTimer m_rebuild; ///< several changes of the list are one
    std::set<session::ServoRef> m_ticked;
    bool m_userSelected = false; ///< m_ticked is the user's choice, not the selection
    std::map<session::ServoRef, results::SweepRange> m_ranges;
    std::map<session::ServoRef, Verdict> m_verdicts;
    mutable std::map<QString, std::optional<results::SweepLimits>> m_modelLimits; ///< as read
    bool m_filling = false;
    bool m_locked = false;
};
} // namespace ui
