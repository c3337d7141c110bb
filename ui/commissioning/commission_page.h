// SPDX-License-Identifier: GPL-3.0-or-later
// Commissioning: one factory servo after the other gets template, ID and rate. Settings at the
// left, what to do next in large words and the batch at the right. Opening the page writes nothing;
// once started, a servo that is plugged in alone is set up after one click, or without any. Owned
// by the window; main thread.
#pragma once

#include "session/commission/commissioning.h"
#include "session/settings.h"
#include "ui/common/app_context.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableView;
class QToolButton;

namespace ui {
class Banner;
class CommissionModel;

class CommissionPage final : public QWidget {
    Q_OBJECT

public:
    CommissionPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);

    session::Commissioning& commissioning() { return m_commissioning; }

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    // commission_page_build.cpp
    void build();
    QWidget* buildSetup();
    QWidget* buildWork();
    QWidget* pathField(QLineEdit*& edit, QToolButton*& browse, const char* name);
    QPushButton* button(const char* name);
    void retranslate();

    void connectAll();
    void loadSettings();
    void saveSettings();
    void chooseTemplate();
    void chooseBatch();
    void start();
    void onFilesChecked();
    void startCommissioning();
    void askForConfirmation();
    void updateDangerousText();
    void copyLabels();
    void showState();
    void showView();
    QString blockedReason() const; ///< it cannot be started; empty: it can
    bool arePathsValid() const;
    QString headline() const;
    QString detail() const;
    QString unfinishedText() const;
    QString pendingQuestionText() const;

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskGuard; ///< a window may hide its pages on its way out
    session::Settings& m_settings;
    session::Commissioning m_commissioning;
    CommissionModel* m_model = nullptr;
    QTimer m_fileCheckTimer; ///< at the files, when typing has come to rest
    bool m_startPending =
        false;                 ///< Start was clicked: it begins when the files have been looked at
    bool m_batchEnded = false; ///< the line has run on this batch

    Banner* m_banner = nullptr;
    QWidget* m_setup = nullptr; ///< locked while the line runs
    QFormLayout* m_form = nullptr;
    QLineEdit* m_template = nullptr;
    QToolButton* m_browseTemplate = nullptr;
    QSpinBox* m_firstId = nullptr;
    QSpinBox* m_lastId = nullptr;
    QComboBox* m_rate = nullptr;
    QCheckBox* m_center = nullptr;
    QCheckBox* m_automatic = nullptr;
    QCheckBox* m_dangerous = nullptr; ///< only for a template that has such rows
    QLineEdit* m_label = nullptr;
    QLineEdit* m_batch = nullptr;
    QToolButton* m_browseBatch = nullptr;
    QLabel* m_reasonLabel = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_plug = nullptr; ///< simulated servos only
    QPushButton* m_unplug = nullptr;
    QLabel* m_headline = nullptr;
    QLabel* m_detail = nullptr;
    QLabel* m_saved = nullptr; ///< where the table of the servo at hand is
    QPushButton* m_continue = nullptr;
    QPushButton* m_same = nullptr;
    QPushButton* m_aside = nullptr;
    QTableView* m_table = nullptr;
    QPushButton* m_copy = nullptr;
    QLabel* m_summary = nullptr;
};
} // namespace ui
