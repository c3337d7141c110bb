// SPDX-License-Identifier: GPL-3.0-or-later
// Edits label and note of a saved item. Does not block; main thread.
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace ui {
class NoteDialog final : public QDialog {
    Q_OBJECT

public:
    NoteDialog(const QString& label, const QString& note, QWidget* parent);

    void setNoteVisible(bool visible); ///< false: a label only
    QString label() const;
    QString note() const;

private:
    void retranslate();

    QLabel* m_labelName;
    QLineEdit* m_label;
    QLabel* m_noteName;
    QPlainTextEdit* m_note;
    QDialogButtonBox* m_buttons;
};
} // namespace ui
