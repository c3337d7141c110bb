// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes as rows: time, servo, what was to be changed, and what was found on the servo.
// Values as jobs::recover found them. The tooltip of every cell contains all its text. Main thread.
#pragma once

#include "jobs/recover/recover.h"

#include <QAbstractTableModel>

namespace ui {
enum class IntentColumn : std::uint8_t { When, Servo, What, Change, Found, Lock, Count };

class IntentsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    /// `catalog` outlives it; gives registers and models their names.
    explicit IntentsModel(const catalog::Catalog& catalog, QObject* parent = nullptr);

    void setIntents(std::vector<jobs::RecoveryResult> intents);
    void remove(const QString& uuid);
    const jobs::RecoveryResult* at(int row) const; ///< null: no such row
    void retranslate();
    /// One that is not in the table: "ID 1 · STS3215, write: …, on /dev/ttyUSB0, 2026-01-31 …".
    QString line(const base::Intent& intent) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString cell(const jobs::RecoveryResult& one, IntentColumn column) const;
    QString toolTipText(const jobs::RecoveryResult& one) const;

    const catalog::Catalog& m_catalog;
    std::vector<jobs::RecoveryResult> m_intents;
};

/// Of the kind of servo the journal names.
catalog::ProfilePtr profileOf(const catalog::Catalog& catalog, const base::ServoIdentity& identity);
/// "write", "set ID" …
QString intentLabel(const base::Intent& intent);
/// What stands in the servo now.
QString findingText(jobs::Finding finding);
} // namespace ui
