// SPDX-License-Identifier: GPL-3.0-or-later
// Remembers the sizes of dialogs that the user has resized, each under its object name, and gives
// them back when the dialog opens again. Only dialogs with a list or a text take part: the size of
// a form or a question follows from its content. Owned by the window; main thread.
#pragma once

#include "session/settings.h"

#include <QHash>
#include <QObject>
#include <QSize>

class QDialog;

namespace ui {
/// From its constructor: this dialog takes part.
void rememberSize(QDialog& dialog);

class DialogSizes final : public QObject {
    Q_OBJECT

public:
    explicit DialogSizes(session::Settings& settings, QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void restore(QDialog& dialog);
    void save(const QDialog& dialog);

    session::Settings& m_settings;
    QHash<const QObject*, QSize> m_shown; ///< as each visible one was opened
};
} // namespace ui
