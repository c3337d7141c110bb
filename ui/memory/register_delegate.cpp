// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/register_delegate.h"

#include "device/write_meaning.h"
#include "ui/common/theme.h"
#include "ui/editors/bits_editor.h"
#include "ui/memory/memory_model.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QStyle>

namespace ui {
namespace {
/// The row behind an index of the view, which sees the table through a filter.
const MemoryRow* rowForIndex(const QModelIndex& index)
{
    QModelIndex source = index;
    const QAbstractItemModel* model = index.model();
    while (const auto* proxy = qobject_cast<const QAbstractProxyModel*>(model)) {
        source = proxy->mapToSource(source);
        model = proxy->sourceModel();
    }
    const auto* memory = qobject_cast<const MemoryModel*>(model);
    return memory != nullptr && source.isValid() ? &memory->row(source.row()) : nullptr;
}

int cellMargin()
{
    return QApplication::style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
}

bool isSecondaryColumn(MemoryColumn column)
{
    return column != MemoryColumn::Address && column != MemoryColumn::Name &&
           column != MemoryColumn::Value;
}

std::optional<Tone> toneOf(const MemoryRow& row, MemoryColumn column)
{
    if (column == MemoryColumn::State)
        return stateTone(row.state);
    if (column == MemoryColumn::Access && row.isWritable && device::alwaysNeedsConsent(*row.reg))
        return Tone::Warn;
    if (column == MemoryColumn::Value && (row.isStale || !row.raw))
        return Tone::Quiet;
    return isSecondaryColumn(column) ? std::optional(Tone::Quiet) : std::nullopt;
}

/// With space before the column behind it. What is too long for its cell gets lines, each of them
/// with that space; the rows of the table are as high as these need.
QString rightAligned(const QString& text, int width, const QFontMetrics& metrics)
{
    static const QString space = QStringLiteral("\u00a0\u00a0");
    const int room = width - 2 * cellMargin();
    if (width <= 0 || metrics.horizontalAdvance(text + space) <= room)
        return text + space;
    QString lines;
    QString line;
    for (const QString& word : text.split(QLatin1Char(' '))) {
        const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
        if (!line.isEmpty() && metrics.horizontalAdvance(longer + space) > room) {
            lines += line + space + QChar::LineSeparator;
            line = word;
        } else {
            line = longer;
        }
    }
    return lines + line + space;
}

RegisterEditor* editorOf(QObject* object)
{
    for (; object != nullptr; object = object->parent()) {
        if (auto* editor = qobject_cast<RegisterEditor*>(object))
            return editor;
    }
    return nullptr;
}
} // namespace

void RegisterDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const MemoryRow* row = rowForIndex(index);
    if (row == nullptr)
        return;
    QPalette& colors = option->palette;
    const auto tone = toneOf(*row, memoryColumn(index));
    const QColor text = tone ? ui::tone(*tone, colors) : colors.color(QPalette::Text);
    colors.setColor(QPalette::Text, text);
    colors.setColor(QPalette::HighlightedText, text); // the selection is pale
    if (memoryColumn(index) == MemoryColumn::Name)
        option->features |= QStyleOptionViewItem::WrapText;
    if ((option->displayAlignment & Qt::AlignRight) != 0)
        option->text = rightAligned(option->text, option->rect.width(), option->fontMetrics);
}

QSize RegisterDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    size.rwidth() += option.fontMetrics.averageCharWidth();
    return size;
}

QWidget* RegisterDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                        const QModelIndex& index) const
{
    const MemoryRow* row = rowForIndex(index);
    if (row == nullptr)
        return nullptr;
    EditContext context{row->reg, row->meaning, row->raw,
                        memoryColumn(index) == MemoryColumn::Physical, true};
    RegisterEditor* editor = makeRegisterEditor(context, parent);
    editor->setObjectName(QStringLiteral("cellEditor"));
    auto* self = const_cast<RegisterDelegate*>(this);
    for (QWidget* inputWidget : editor->is())
        inputWidget->installEventFilter(self);
    connect(editor, &RegisterEditor::userEdited, this, [self, editor] {
        const bool isBlank = editor->inputText().trimmed().isEmpty();
        self->showMessage(editor, isBlank ? QString() : editor->inputError());
    });
    connect(editor, &RegisterEditor::valueChosen, self, [self, editor] { self->finish(editor); });
    m_editor = editor;
    return editor;
}

void RegisterDelegate::setEditorData(QWidget* widget, const QModelIndex& index) const
{
    auto* editor = qobject_cast<RegisterEditor*>(widget);
    const MemoryRow* row = rowForIndex(index);
    // A live reading must not take away what is being typed.
    if (editor == nullptr || row == nullptr || editor->isModified() ||
        editor->property("filled").toBool())
        return;
    editor->setRaw(row->editValue());
    editor->selectAll();
    editor->setProperty("filled", true);
}

void RegisterDelegate::setModelData(QWidget* widget, QAbstractItemModel* model,
                                    const QModelIndex& index) const
{
    auto* editor = qobject_cast<RegisterEditor*>(widget);
    const auto raw = editor != nullptr ? editor->value() : base::Result<std::int64_t>();
    if (editor != nullptr && editor->isModified() && raw)
        model->setData(index, static_cast<qlonglong>(*raw), Qt::EditRole);
}

/// A bit field needs more room than its cell: it stands above the neighbors, inside the table.
void RegisterDelegate::updateEditorGeometry(QWidget* widget, const QStyleOptionViewItem& option,
                                            const QModelIndex&) const
{
    auto* editor = qobject_cast<RegisterEditor*>(widget);
    if (editor == nullptr)
        return;
    QRect place = option.rect;
    const QSize preferred = editor->sizeHint();
    const QRect room = editor->parentWidget()->rect();
    const bool bits = qobject_cast<BitsEditor*>(editor) != nullptr;
    place.setWidth(std::max(place.width(), preferred.width()));
    place.setHeight(bits ? preferred.height() : std::max(place.height(), 0));
    place.moveLeft(std::max(0, std::min(place.left(), room.width() - place.width())));
    if (bits)
        place.moveBottom(std::max(std::min(place.bottom(), room.bottom()), place.height() - 1));
    editor->setGeometry(place);
    editor->raise();
    positionMessage(editor);
}

bool RegisterDelegate::eventFilter(QObject* object, QEvent* event)
{
    RegisterEditor* editor = editorOf(object);
    if (editor == nullptr || editor != m_editor)
        return false;
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
        return false;
    case QEvent::KeyPress:
        return keyPressed(editor, static_cast<QKeyEvent*>(event)->key());
    case QEvent::FocusOut: {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason &&
            editorOf(QApplication::focusWidget()) != editor)
            discard(editor);
        return false;
    }
    default:
        return false;
    }
}

bool RegisterDelegate::keyPressed(RegisterEditor* editor, int key)
{
    switch (key) {
    case Qt::Key_Escape:
        showMessage(editor, {});
        m_editor = nullptr; // losing the focus now is no leaving
        Q_EMIT closeEditor(editor, RevertModelCache);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        finish(editor);
        return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        if (qobject_cast<BitsEditor*>(editor) != nullptr)
            return false;
        finish(editor);
        return true;
    default:
        return false;
    }
}

void RegisterDelegate::finish(RegisterEditor* editor)
{
    if (editor->isModified()) {
        const QString inputError = editor->inputError();
        showMessage(editor, inputError);
        if (!inputError.isEmpty())
            return;
        Q_EMIT commitData(editor);
    }
    showMessage(editor, {});
    m_editor = nullptr;
    Q_EMIT closeEditor(editor, NoHint);
}

void RegisterDelegate::discard(RegisterEditor* editor)
{
    showMessage(editor, {});
    m_editor = nullptr;
    const QString inputError = editor->isModified() ? editor->inputError() : QString();
    if (editor->isModified())
        Q_EMIT editorLeft(
            inputError.isEmpty()
                ? tr("“%1” was not written because you left the cell without pressing Enter.")
                      .arg(editor->inputText())
                : inputError);
    Q_EMIT closeEditor(editor, RevertModelCache);
}

void RegisterDelegate::showMessage(RegisterEditor* editor, const QString& words) const
{
    if (words.isEmpty()) {
        delete m_message.data();
        return;
    }
    if (m_message == nullptr) {
        m_message = new QLabel(editor->parentWidget());
        m_message->setObjectName(QStringLiteral("editorMessage"));
        m_message->setFrameShape(QFrame::StyledPanel);
        m_message->setAutoFillBackground(true);
        m_message->setBackgroundRole(QPalette::ToolTipBase);
        m_message->setMargin(6);
        m_message->setWordWrap(true);
        // It goes with the editor, however that ends.
        connect(editor, &QObject::destroyed, m_message, &QObject::deleteLater);
    }
    QPalette colors = editor->palette();
    colors.setColor(QPalette::WindowText, ui::tone(Tone::Bad, colors));
    m_message->setPalette(colors);
    m_message->setText(QStringLiteral("✗ ") + words);
    m_message->setAccessibleName(words);
    positionMessage(editor);
    m_message->show();
    m_message->raise();
}

void RegisterDelegate::positionMessage(RegisterEditor* editor) const
{
    if (m_message == nullptr)
        return;
    constexpr int maxWidth = 380;
    const QRect room = editor->parentWidget()->rect();
    const QRect at = editor->geometry();
    const int width = std::min(maxWidth, room.width());
    const int height = m_message->heightForWidth(width);
    const int left = std::clamp(at.right() - width + 1, 0, std::max(0, room.width() - width));
    const bool below = at.bottom() + height <= room.bottom();
    m_message->setGeometry(left, below ? at.bottom() + 1 : std::max(0, at.top() - height), width,
                           height);
}
} // namespace ui
