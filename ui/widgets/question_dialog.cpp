// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/question_dialog.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace ui {
namespace {
/// Wide enough for a sentence, narrow enough to read it.
constexpr int textWidth = 440;
constexpr int otherResult = QDialog::Accepted + 1;

class QuestionDialog final : public QDialog {
public:
    QuestionDialog(QWidget* parent, const Question& question);

    /// False once the guard is destroyed. Not a QPointer: a widget emits destroyed() before its
    /// pointers are cleared, but after its members are destroyed.
    bool isConfirmed() const { return m_confirmed; }

protected:
    void changeEvent(QEvent* event) override;

private:
    QLabel* addText(QVBoxLayout* column, const QString& text, const QString& name);
    void addRisk(QVBoxLayout* column, const QString& risk);
    void addButtons(QVBoxLayout* column, const Question& question);
    void showSign();

    QLabel* m_sign = nullptr;
    bool m_confirmed = true;
};

QuestionDialog::QuestionDialog(QWidget* parent, const Question& question)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("question"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(question.title);
    setAccessibleName(question.title);
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->setSpacing(12);
    QLabel* title = addText(column, question.title, QStringLiteral("questionTitle"));
    QFont font = title->font();
    font.setBold(true);
    title->setFont(font);
    if (!question.text.isEmpty())
        addText(column, question.text, QStringLiteral("questionText"));
    if (!question.risk.isEmpty())
        addRisk(column, question.risk);
    addButtons(column, question);
    setFixedSize(sizeHint());
    if (question.guard != nullptr)
        connect(question.guard, &QObject::destroyed, this, [this] {
            m_confirmed = false;
            reject();
        });
}

QLabel* QuestionDialog::addText(QVBoxLayout* column, const QString& text, const QString& name)
{
    auto* label = new QLabel(text, this);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setFixedWidth(textWidth);
    column->addWidget(label);
    return label;
}

void QuestionDialog::addRisk(QVBoxLayout* column, const QString& risk)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_sign = new QLabel(this);
    m_sign->setObjectName(QStringLiteral("questionSign"));
    showSign();
    row->addWidget(m_sign, 0, Qt::AlignTop);
    auto* label = new QLabel(risk, this);
    label->setObjectName(QStringLiteral("questionRisk"));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    const int size = style()->pixelMetric(QStyle::PM_LargeIconSize, nullptr, this);
    label->setFixedWidth(textWidth - size - row->spacing());
    row->addWidget(label, 1);
    column->addLayout(row);
}

void QuestionDialog::addButtons(QVBoxLayout* column, const Question& question)
{
    auto* row = new QHBoxLayout;
    row->addStretch();
    auto* no =
        new QPushButton(question.rejectText.isEmpty() ? QCoreApplication::translate("Ask", "Cancel")
                                                      : question.rejectText,
                        this);
    no->setObjectName(QStringLiteral("questionNo"));
    no->setAccessibleName(no->text());
    no->setToolTip(QCoreApplication::translate("Ask", "Leaves everything unchanged"));
    auto* yes = new QPushButton(question.acceptText, this);
    yes->setObjectName(QStringLiteral("questionYes"));
    yes->setAccessibleName(question.acceptText);
    yes->setToolTip(question.risk.isEmpty() ? question.title : question.risk);
    row->addWidget(no);
    if (!question.alternativeText.isEmpty()) {
        auto* other = new QPushButton(question.alternativeText, this);
        other->setObjectName(QStringLiteral("questionOther"));
        other->setAccessibleName(question.alternativeText);
        other->setToolTip(question.alternativeToolTip);
        other->setAutoDefault(false);
        row->addWidget(other);
        connect(other, &QPushButton::clicked, this, [this] { done(otherResult); });
    }
    row->addWidget(yes);
    column->addLayout(row);
    connect(no, &QPushButton::clicked, this, &QDialog::reject);
    connect(yes, &QPushButton::clicked, this, &QDialog::accept);
    QPushButton* first = question.acceptIsDefault ? yes : no;
    first->setDefault(true);
    first->setFocus();
}

void QuestionDialog::showSign()
{
    const int size = style()->pixelMetric(QStyle::PM_LargeIconSize, nullptr, this);
    const QIcon icon = style()->standardIcon(QStyle::SP_MessageBoxWarning, nullptr, this);
    m_sign->setPixmap(icon.pixmap(size, size));
}

void QuestionDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::StyleChange && m_sign != nullptr)
        showSign();
}
} // namespace

void ask(QWidget* parent, const Question& question, std::function<void()> yes)
{
    auto* dialog = new QuestionDialog(parent, question);
    QObject::connect(dialog, &QDialog::finished, dialog,
                     [dialog, yes = std::move(yes), no = question.rejected,
                      other = question.alternativeAction](int result) {
                         const auto& answer = result == QDialog::Accepted ? yes
                                              : result == otherResult     ? other
                                                                          : no;
                         if (dialog->isConfirmed() && answer)
                             answer();
                     });
    dialog->open();
}
} // namespace ui
