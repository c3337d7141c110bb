// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/number_editor.h"

#include "catalog/raw_range.h"
#include "ui/common/follow_language.h"
#include "ui/editors/register_text.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace ui {
namespace {
catalog::RawRange allowed(const EditContext& context)
{
    const catalog::ValueFormat& meaning = context.meaning;
    const auto fits =
        catalog::representableRange(context.reg->size, meaning.encoding, meaning.signBit);
    return {std::max(fits.min, meaning.min.value_or(fits.min)),
            std::min(fits.max, meaning.max.value_or(fits.max))};
}

bool inUnit(const EditContext& context)
{
    return context.inPhysicalUnit && !context.meaning.unit.isEmpty();
}
} // namespace

NumberSpin::NumberSpin(NumberEditor& editor)
    : QAbstractSpinBox(&editor)
    , m_editor(editor)
{
    connect(lineEdit(), &QLineEdit::textEdited, this, &NumberSpin::textEdited);
}

void NumberSpin::setText(const QString& text)
{
    lineEdit()->setText(text);
}

QString NumberSpin::typedText() const
{
    return lineEdit()->text();
}

void NumberSpin::stepBy(int steps)
{
    m_editor.show(m_editor.valueAfterSteps(steps));
    selectAll();
    Q_EMIT textEdited();
}

/// What is typed stays: the editor reports what is wrong with it.
QValidator::State NumberSpin::validate(QString&, int&) const
{
    return QValidator::Acceptable;
}

QAbstractSpinBox::StepEnabled NumberSpin::stepEnabled() const
{
    return isReadOnly() ? StepNone : StepUpEnabled | StepDownEnabled;
}

NumberEditor::NumberEditor(const EditContext& context, QWidget* parent)
    : RegisterEditor(context, parent)
    , m_spin(new NumberSpin(*this))
{
    m_spin->setObjectName(QStringLiteral("numberSpin"));
    m_spin->setAlignment(Qt::AlignRight);
    m_spin->setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
    m_spin->setFrame(!context.inCell);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_spin);
    setFocusProxy(m_spin);
    setAutoFillBackground(context.inCell);
    connect(m_spin, &NumberSpin::textEdited, this, &NumberEditor::markModified);
    followLanguage(this, [this] { retranslate(); });
}

void NumberEditor::show(std::int64_t raw)
{
    m_spin->setText(inUnit(context()) ? physicalText(raw, *context().reg, context().meaning)
                                      : QString::number(raw));
}

void NumberEditor::enterValue(std::int64_t raw)
{
    show(raw);
    markModified();
}

void NumberEditor::setRaw(std::optional<std::int64_t> raw)
{
    m_start = raw;
    if (raw)
        show(*raw);
    else
        m_spin->setText({});
    clearModified();
}

QString NumberEditor::inputText() const
{
    return m_spin->typedText();
}

QList<QWidget*> NumberEditor::is() const
{
    return {m_spin};
}

void NumberEditor::selectAll()
{
    m_spin->selectAll();
}

base::Result<std::int64_t> NumberEditor::parse() const
{
    static const QRegularExpression bare(QStringLiteral("^\\s*[-+−]?\\d+(\\.\\d+)?\\s*$"));
    QString text = inputText();
    if (inUnit(context()) && bare.match(text).hasMatch())
        text += context().meaning.unit;
    return catalog::parseValue(text, *context().reg, context().meaning);
}

std::int64_t NumberEditor::valueAfterSteps(int steps) const
{
    const auto range = allowed(context());
    const auto typedNow = parse();
    const std::int64_t from = typedNow ? *typedNow
                                       : m_start.value_or(context().reg->defaultRaw.value_or(
                                             std::max<std::int64_t>(0, range.min)));
    // A value outside the range moves step by step and does not jump to the other end.
    return std::clamp(from + steps, std::min(range.min, from), std::max(range.max, from));
}

void NumberEditor::contextChanged()
{
    retranslate();
}

void NumberEditor::retranslate()
{
    const QString range = rangeText(*context().reg, context().meaning, inUnit(context()));
    m_spin->setAccessibleName(accessibleName());
    const QString what =
        inUnit(context()) ? tr("%1, in %2").arg(range, context().meaning.unit) : range;
    m_spin->setToolTip(tr("%1. %2").arg(what, keyHint()));
}
} // namespace ui
