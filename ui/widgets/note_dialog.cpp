// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/note_dialog.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int initialWidth = 420;
constexpr int noteLines = 5;
} // namespace

NoteDialog::NoteDialog(const QString& label, const QString& note, QWidget* parent)
    : QDialog(parent)
    , m_labelName(new QLabel(this))
    , m_label(new QLineEdit(label, this))
    , m_noteName(new QLabel(this))
    , m_note(new QPlainTextEdit(note, this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("noteDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_label->setObjectName(QStringLiteral("noteLabel"));
    m_note->setObjectName(QStringLiteral("noteText"));
    m_note->setTabChangesFocus(true);
    m_note->setFixedHeight(noteLines * fontMetrics().lineSpacing());
    m_buttons->button(QDialogButtonBox::Save)->setObjectName(QStringLiteral("noteSave"));
    makeMainAction(m_buttons->button(QDialogButtonBox::Save));
    m_buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("noteCancel"));
    m_labelName->setBuddy(m_label);
    m_noteName->setBuddy(m_note);
    auto* column = new QVBoxLayout(this);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_labelName, m_label, m_noteName, m_note, m_buttons})
        column->addWidget(widget);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(initialWidth, sizeHint().height());
    followLanguage(this, [this] { retranslate(); });
}

void NoteDialog::setNoteVisible(bool visible)
{
    m_noteName->setVisible(visible);
    m_note->setVisible(visible);
    adjustSize();
}

QString NoteDialog::label() const
{
    return m_label->text().trimmed();
}

QString NoteDialog::note() const
{
    return m_note->toPlainText().trimmed();
}

void NoteDialog::retranslate()
{
    setWindowTitle(tr("Label and note"));
    setAccessibleName(windowTitle());
    m_labelName->setText(tr("&Label"));
    m_label->setAccessibleName(tr("Label"));
    m_label->setToolTip(tr("Short name shown in lists, for example “reference, tested”"));
    m_noteName->setText(tr("&Note"));
    m_note->setAccessibleName(tr("Note"));
    m_note->setToolTip(tr("Additional information"));
    QPushButton* save = m_buttons->button(QDialogButtonBox::Save);
    setButtonText(save, tr("Save"), tr("Saves the label and the note"));
    QPushButton* cancel = m_buttons->button(QDialogButtonBox::Cancel);
    setButtonText(cancel, tr("Cancel"), tr("Discards the changes"));
}
} // namespace ui
