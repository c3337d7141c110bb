// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a snapshot become a template for other servos: those that can be given to others,
// ticked at first where they are not the factory's. Opened, never waited for; main thread.
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
    /// `profile`: of the snapshot's kind; must be known.
    TemplateDialog(const record::Snapshot& from, catalog::ProfilePtr profile, QWidget* parent);

    QStringList keys() const; ///< ticked, in the order of the table

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill(const record::Snapshot& from);
    void retranslate();
    void updateCount();

    catalog::ProfilePtr m_profile;
    QLabel* m_summary;
    QTableWidget* m_table;
    QDialogButtonBox* m_buttons;
};
} // namespace ui
