// SPDX-License-Identifier: GPL-3.0-or-later
// Edits the joints of a robot arm and saves them as an arm file. An arm is always a built-in one or
// a file, so that the next start has it again. Does not block; deletes itself when closed; main
// thread. A file that cannot be written is named in the dialog.
#pragma once

#include "jobs/arm/arm.h"
#include "session/settings.h"

#include <QDialog>

class QCheckBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace ui {
class ArmDialog final : public QDialog {
    Q_OBJECT

public:
    /// `path`: of the arm's file; empty for a built-in or a new one, which has no joints yet.
    ArmDialog(const jobs::Arm& arm, const QString& path, session::Settings& settings,
              QWidget* parent);

Q_SIGNALS:
    void saved(const QString& path); ///< before it closes

private:
    void build();
    void fill(const jobs::Arm& arm);
    void addJoint(const jobs::Joint& joint);
    void addNext();
    void removeSelected();
    jobs::Arm arm() const;
    QString problem() const; ///< why it cannot be saved; empty: it can
    void save();
    void saveTo(const QString& path);
    void update();
    void retranslate();

    session::Settings& m_settings;
    QString m_path;
    bool m_isNew;
    QLabel* m_summary;
    QLineEdit* m_name;
    QCheckBox* m_isLeader;
    QTableWidget* m_table;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_problem;
    QFormLayout* m_form;
    QDialogButtonBox* m_buttons;
};
} // namespace ui
