// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the rows of a snapshot that become a template for other servos. Lists the rows that other
// servos can have, with a tick where they differ from the factory default. Does not block; main
// thread.
#pragma once

#include "catalog/profile.h"
#include "snapshot/snapshot.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QTableWidget;

namespace ui {
class TemplateDialog final : public QDialog {
    Q_OBJECT

public:
    /// `profile` of the model of the snapshot; must not be null.
    TemplateDialog(const snapshot::Snapshot& from, catalog::ProfilePtr profile, QWidget* parent);

    QStringList keys() const; ///< ticked, in the order of the table

private:
    void fill(const snapshot::Snapshot& from);
    void retranslate();
    void updateCount();

    catalog::ProfilePtr m_profile;
    QLabel* m_summary;
    QTableWidget* m_table;
    QDialogButtonBox* m_buttons;
};
} // namespace ui
