// SPDX-License-Identifier: GPL-3.0-or-later
// The limits a sweep test judges by: a table of figures with the numbers to warn and to fail at.
// From a file, to a file, or the built-in ones. Errors are shown at once, and limits with errors
// cannot be used. Files are read and written on another thread. Deletes itself; main thread.
#pragma once

#include "results/sweep_limits.h"

#include <QDialog>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace session {
class Settings;
}

namespace ui {
class LimitsModel;

class LimitsDialog final : public QDialog {
    Q_OBJECT

public:
    /// `model` and `series`: whose built-in limits are offered ("STS3215", "STS").
    LimitsDialog(session::Settings& settings, const results::SweepLimits& limits,
                 const QString& model, const QString& series, QWidget* parent = nullptr);

    results::SweepLimits limits() const;
    /// Why these limits cannot be used; empty: they can.
    QString problem() const;
    void load(const QString& path);
    void save(const QString& path);

Q_SIGNALS:
    void limitsAccepted(const results::SweepLimits& limits); ///< and the dialog closes
    void loaded(const QString& path);
    void saved(const QString& path);

private:
    session::Settings& m_settings;
    void build();
    QLayout* buildLineButtons();
    QLayout* buildButtons();
    void connectAll();
    void setLimits(const results::SweepLimits& limits);
    void refresh();
    void askForFile(bool saving);
    void onFileError(const base::Error& error);
    void showResult(const QString& message, bool bad);
    void addLine();
    void removeLine();
    void retranslate();

    QString m_model;
    QString m_series;
    QString m_loadedName; ///< shown in the language of the interface
    LimitsModel* m_lines;
    QFormLayout* m_form = nullptr;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_models = nullptr;
    QLineEdit* m_tolerance = nullptr;
    QTableView* m_table = nullptr;
    QLabel* m_problem = nullptr;
    QPushButton* m_add = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_builtIn = nullptr;
    QPushButton* m_load = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_cancel = nullptr;
};
} // namespace ui
