// SPDX-License-Identifier: GPL-3.0-or-later
// Which PostgreSQL server gets copies of the history, under which name for this bench. Kept in the
// settings; sending begins at once. A connection string that cannot be used, or that contains a
// password, is refused here with the reason. Does not block; main thread.
#pragma once

#include "session/history/history_sender.h"
#include "session/settings.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace ui {
class HistoryServerDialog final : public QDialog {
    Q_OBJECT

public:
    HistoryServerDialog(session::Settings& settings, session::HistorySender& sender,
                        QWidget* parent);

    void accept() override;

private:
    void retranslate();
    void setError(std::optional<base::Error> error);

    session::Settings& m_settings;
    session::HistorySender& m_sender;
    QLabel* m_explanation;
    QLabel* m_addressName;
    QLineEdit* m_address;
    QLabel* m_benchName;
    QLineEdit* m_bench;
    QLabel* m_hint;
    QLabel* m_errorLabel;
    std::optional<base::Error> m_error; ///< why the string was refused
    QDialogButtonBox* m_buttons;
};
} // namespace ui
