// SPDX-License-Identifier: GPL-3.0-or-later
// Commissioning: one factory servo after the other gets template, ID and rate. Settings at the
// left, what to do next in large words and the batch at the right. Opening the page writes nothing;
// once started, a servo that is plugged in alone is set up after one click, or without any. Owned
// by the window; main thread.
#pragma once

#include "session/commissioning.h"
#include "session/settings.h"
#include "ui/app/bench.h"

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
    CommissionPage(Bench& bench, session::Settings& settings, QWidget* parent = nullptr);

    session::Commissioning& line() { return m_line; }

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
    void restoreChoices();
    void rememberChoices();
    void chooseTemplate();
    void chooseBatch();
    void start();
    void looked();
    void begin();
    void askFirst();
    void tellDangerous();
    void copyLabels();
    void showState();
    void showView();
    QString whyNot() const; ///< it cannot be started; empty: it can
    bool pathsFine() const;
    QString headline() const;
    QString detail() const;
    QString unfinishedWords() const;
    QString askedWords() const;

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskLives; ///< a window may hide its pages on its way out
    session::Settings& m_settings;
    session::Commissioning m_line;
    CommissionModel* m_model = nullptr;
    QTimer m_lookSoon;     ///< at the files, when typing has come to rest
    bool m_wanted = false; ///< Start was clicked: it begins when the files have been looked at
    bool m_ended = false;  ///< the line has run on this batch

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
    QLabel* m_why = nullptr;
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
    QLabel* m_sum = nullptr;
};
} // namespace ui
