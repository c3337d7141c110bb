// SPDX-License-Identifier: GPL-3.0-or-later
// The writes to one servo from the journal, newest first, one row per register. Owned by the
// history panel; main thread.
#pragma once

#include "session/servos/servo_entry.h"

#include <QAbstractListModel>

namespace ui {
class ServoHistoryModel final : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    /// Null: empty. The entry is not kept; unchanged history changes nothing.
    void setEntry(const session::ServoEntry* entry);
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    struct Line {
        QString uuid;
        QDateTime at;
        base::IntentKind kind = base::IntentKind::Write;
        bool temporary = false;
        QString end; ///< "done", "failed" …; empty: not ended
        base::JournalItem item;
        bool operator==(const Line& other) const;
    };
    static std::vector<Line> linesOf(const session::ServoEntry& entry);
    QString text(const Line& line) const;
    QString tip(const Line& line) const;
    QString valueText(const Line& line, std::int64_t raw) const;

    session::ServoRef m_ref = 0;
    catalog::ProfilePtr m_profile;
    std::vector<Line> m_lines;
};
} // namespace ui
