// SPDX-License-Identifier: GPL-3.0-or-later
// Where a recording is written, what it contains, and how long it lasts. It only asks; deletes
// itself. Main thread.
#pragma once

#include "session/settings.h"

#include <QDialog>

class QButtonGroup;
class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;
class QSpinBox;

namespace ui {
struct RecordRequest {
    QString path;
    bool onlyShown = true; ///< the curves of the chart; else all that is read
    int seconds = 0;       ///< 0: until stopped
};

class RecordDialog final : public QDialog {
    Q_OBJECT

public:
    RecordDialog(session::Settings& settings, QWidget* parent);

    RecordRequest request() const;
    void showError(const QString& message); ///< it could not begin; the dialog stays

Q_SIGNALS:
    void recordingRequested(const ui::RecordRequest& request);

private:
    void build();
    void buildForm();
    void browse();
    void start();
    void retranslate();

    session::Settings& m_settings;
    QFormLayout* m_form = nullptr;
    QLineEdit* m_path = nullptr;
    QPushButton* m_browse = nullptr;
    QRadioButton* m_shown = nullptr;
    QRadioButton* m_all = nullptr;
    QCheckBox* m_limited = nullptr;
    QSpinBox* m_seconds = nullptr;
    QLabel* m_error = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_cancel = nullptr;
    QString m_confirmedPath; ///< a file of this name may be replaced: it was asked
};
} // namespace ui
