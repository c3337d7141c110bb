// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/register_editor.h"

#include "text/language.h"
#include "ui/editors/bits_editor.h"
#include "ui/editors/enum_editor.h"
#include "ui/editors/number_editor.h"
#include "ui/editors/value_error_text.h"

namespace ui {
using catalog::Encoding;

RegisterEditor::RegisterEditor(EditContext context, QWidget* parent)
    : QWidget(parent)
    , m_context(std::move(context))
{
    setAccessibleName(text::localized(m_context.meaning.name));
}

void RegisterEditor::setContext(const EditContext& context)
{
    m_context = context;
    setAccessibleName(text::localized(m_context.meaning.name));
    contextChanged();
}

base::Result<std::int64_t> RegisterEditor::parse() const
{
    return catalog::parseValue(inputText(), *m_context.reg, m_context.meaning);
}

base::Result<std::int64_t> RegisterEditor::value() const
{
    const auto raw = parse();
    if (!raw)
        return raw;
    const auto allowed =
        catalog::checkNewValue(*raw, *m_context.reg, m_context.meaning, m_context.currentRaw);
    if (!allowed)
        return tl::unexpected(allowed.error());
    return raw;
}

QString RegisterEditor::inputError() const
{
    const auto raw = value();
    return raw ? QString()
               : inputErrorText(raw.error(), inputText(), *m_context.reg, m_context.meaning);
}

void RegisterEditor::markModified()
{
    m_modified = true;
    Q_EMIT userEdited();
}

/// ui::StopKey leaves only the editors of cells their Esc.
QString RegisterEditor::keyHint() const
{
    if (m_context.inCell)
        return tr("Press Enter to write or Esc to cancel.");
    const QString stops =
        tr("Esc turns torque off on the whole bus and shows the present value again.");
    return m_context.ownerHandlesEnter ? text::joinSentences({tr("Enter sends the value."), stops})
                                       : stops;
}

RegisterEditor* makeRegisterEditor(const EditContext& context, QWidget* parent)
{
    switch (context.meaning.encoding) {
    case Encoding::Enum:
        return new EnumEditor(context, parent);
    case Encoding::Bits:
        return new BitsEditor(context, parent);
    case Encoding::Unsigned:
    case Encoding::SignBit:
    case Encoding::SignBit11Ext12:
    case Encoding::TwosComplement:
        break;
    }
    return new NumberEditor(context, parent);
}
} // namespace ui
