// SPDX-License-Identifier: GPL-3.0-or-later
// The help of the selected register: what it does, its facts and relations, its state, and an
// editor with "Write" and "Write temporarily". A newer reading never replaces what the user is
// typing. Owned by the page; main thread.
#pragma once

#include "ui/editors/register_editor.h"
#include "ui/memory/memory_row.h"

#include <QPointer>
#include <QScrollArea>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui {
class RegisterPanel final : public QScrollArea {
    Q_OBJECT

public:
    explicit RegisterPanel(QWidget* parent);

    /// Null: nothing selected. The row is copied; `profile` keeps its register alive.
    void showRow(session::ServoRef servo, const MemoryRow* row, const catalog::ProfilePtr& profile,
                 bool physical);
    RegisterEditor* editor() const { return m_editor; }
    /// What was typed and not written is dropped.
    void discardEdit();

Q_SIGNALS:
    void writeRequested(const QString& key, qint64 raw, bool temporary);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QLabel* addLabel(const QString& name);
    void addButtons();
    bool needsNewEditor(session::ServoRef servo, const MemoryRow& row, bool physical) const;
    void makeEditor(bool physical);
    void fill();
    void fillEditor();
    void checkInput();
    void write(bool temporary);
    void retranslate();
    void updateColors();

    QWidget* m_body;
    QVBoxLayout* m_column;
    QLabel* m_title;
    QLabel* m_help;
    QLabel* m_facts;
    QLabel* m_relations;
    QLabel* m_state;
    QVBoxLayout* m_editorLayout;
    QLabel* m_before;
    QLabel* m_inputError;
    QPushButton* m_write = nullptr;
    QPushButton* m_writeTemporarily = nullptr;
    QLabel* m_persistence;
    QPointer<RegisterEditor> m_editor;

    session::ServoRef m_servo = 0;
    catalog::ProfilePtr m_profile;
    std::optional<MemoryRow> m_row;
};
} // namespace ui
