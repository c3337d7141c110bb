// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a commissioning line: the files of batch and template, the IDs to assign, baud
// rate, label and options. Remembers them in the settings of the program, except those that allow
// something dangerous. Owned by the commissioning page; main thread.
#pragma once

#include "jobs/commission/commission.h"
#include "session/settings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;
class QToolButton;

namespace ui {
class CommissionForm final : public QWidget {
    Q_OBJECT

public:
    CommissionForm(session::Settings& settings, QWidget* parent);

    QString batchPath() const;
    QString templatePath() const;
    /// Why the line cannot start with these files or IDs; empty: it can.
    QString pathProblem() const;
    bool arePathsValid() const; ///< as names of files
    QString idProblem() const;

    /// Registers of the template that need consent; the box to give it is shown only with any.
    void setDangerousKeys(const QStringList& keys);
    /// The user has ticked that box.
    bool isDangerousIncluded() const;

    /// Without the template, which the job loads. Gives the consent that was ticked: the caller has
    /// asked before.
    jobs::CommissionSpec spec() const;
    void save();

Q_SIGNALS:
    void filesChanged(); ///< path of batch or template
    void changed();      ///< anything that decides whether the line can start

private:
    void build();
    QWidget* pathField(QLineEdit*& edit, QToolButton*& browse, const char* name);
    void load();
    void connectAll();
    void retranslate();
    void showDangerousKeys();
    void chooseTemplate();
    void chooseBatch();

    session::Settings& m_settings;
    QStringList m_dangerousKeys;
    QFormLayout* m_form = nullptr;
    QLineEdit* m_batch = nullptr;
    QToolButton* m_browseBatch = nullptr;
    QLineEdit* m_template = nullptr;
    QToolButton* m_browseTemplate = nullptr;
    QSpinBox* m_firstId = nullptr;
    QSpinBox* m_lastId = nullptr;
    QComboBox* m_rate = nullptr;
    QLineEdit* m_label = nullptr;
    QCheckBox* m_center = nullptr;
    QCheckBox* m_automatic = nullptr;
    QCheckBox* m_dangerous = nullptr; ///< only for a template that has such rows
};
} // namespace ui
