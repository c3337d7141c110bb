// SPDX-License-Identifier: GPL-3.0-or-later
// Which memory tables are compared: the selected servo, the selected snapshots, and the other
// servos and the factory default chosen in the Columns menu. While it is active, the servos among
// them are read regularly. The workbench may be gone before it; owned by the snapshots page; main
// thread.
#pragma once

#include "ui/common/app_context.h"
#include "ui/snapshots/compare_model.h"

#include <QPointer>

#include <set>

class QMenu;

namespace ui {
struct SnapshotSelection;

class CompareTables final : public QObject {
    Q_OBJECT

public:
    CompareTables(AppContext& appContext, QObject* parent);

    /// The selected servo; null: none is, or its model is not known.
    const session::ServoEntry* servo() const;
    std::vector<CompareColumn> columns(const std::vector<SnapshotSelection>& snapshots) const;
    /// A line for each servo whose table may differ from its present settings, with its age.
    QStringList ages() const;
    /// The servos of the bus that are known now, and the factory default.
    void fillMenu(QMenu& menu);
    /// Reads the servos regularly, or no longer.
    void setActive(bool active);

Q_SIGNALS:
    void selectionChanged(); ///< in the menu
    void servoChanged();     ///< one that is compared

private:
    CompareColumn columnOf(session::ServoRef ref) const;
    std::set<session::ServoRef> servos() const;
    void selectOther(session::ServoRef ref, bool on);

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard;
    Selection& m_selection;
    bool m_factory = false;                              ///< a column
    std::set<session::ServoRef> m_others;                ///< columns
    std::vector<session::SubscriptionItem> m_subscribed; ///< read regularly for this page
};
} // namespace ui
