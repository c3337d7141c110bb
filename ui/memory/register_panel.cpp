// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/register_panel.h"

#include "text/language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/memory/memory_text.h"
#include "ui/memory/register_help.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace ui {
namespace {
void setTone(QLabel* label, Tone toneValue, const QPalette& basePalette)
{
    QPalette colors;
    colors.setColor(QPalette::WindowText, tone(toneValue, basePalette));
    if (label->palette().color(QPalette::WindowText) != colors.color(QPalette::WindowText))
        label->setPalette(colors);
}

/// An empty line takes no space.
void setTextOrHide(QLabel* label, const QString& text)
{
    if (label->text() != text)
        label->setText(text);
    label->setVisible(!text.isEmpty());
}
} // namespace

RegisterPanel::RegisterPanel(QWidget* parent)
    : QScrollArea(parent)
    , m_body(new QWidget(this))
    , m_column(new QVBoxLayout(m_body))
{
    setObjectName(QStringLiteral("registerPanel"));
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_title = addLabel(QStringLiteral("registerTitle"));
    m_help = addLabel(QStringLiteral("registerHelp"));
    m_editorLayout = new QVBoxLayout;
    m_column->addLayout(m_editorLayout);
    addButtons(); // above what comes and goes, which must not move them
    m_before = addLabel(QStringLiteral("registerBefore"));
    m_inputError = addLabel(QStringLiteral("registerComplaint"));
    m_persistence = addLabel(QStringLiteral("registerKeeping"));
    m_state = addLabel(QStringLiteral("registerState"));
    m_relations = addLabel(QStringLiteral("registerRelations"));
    m_facts = addLabel(QStringLiteral("registerFacts"));
    m_column->addStretch();
    setWidget(m_body);
    makeTransparent(this);
    m_column->setContentsMargins({});
    updateColors();
    retranslate();
}

QLabel* RegisterPanel::addLabel(const QString& name)
{
    auto* label = new QLabel(m_body);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_column->addWidget(label);
    return label;
}

void RegisterPanel::addButtons()
{
    m_write = new QPushButton(m_body);
    m_write->setObjectName(QStringLiteral("writeValue"));
    makeMainAction(m_write);
    m_writeTemporarily = new QPushButton(m_body);
    m_writeTemporarily->setObjectName(QStringLiteral("writeTemporarily"));
    auto* row = new FlowLayout;
    row->addWidget(m_write);
    row->addWidget(m_writeTemporarily);
    m_column->addLayout(row);
    for (QWidget* writer : {m_write, m_writeTemporarily})
        new PressGuard(writer);
    connect(m_write, &QPushButton::clicked, this, [this] { write(false); });
    connect(m_writeTemporarily, &QPushButton::clicked, this, [this] { write(true); });
}

void RegisterPanel::showRow(session::ServoRef servo, const MemoryRow* row,
                            const catalog::ProfilePtr& profile, bool physical)
{
    if (row == nullptr) {
        delete m_editor.data();
        m_row.reset();
        m_profile.reset();
        fill();
        return;
    }
    const bool fresh = needsNewEditor(servo, *row, physical);
    if (fresh)
        delete m_editor.data(); // before the profile its register lives in
    m_servo = servo;
    m_profile = profile;
    m_row = *row;
    if (fresh)
        makeEditor(physical);
    fill();
}

bool RegisterPanel::needsNewEditor(session::ServoRef servo, const MemoryRow& row,
                                   bool physical) const
{
    return !m_row || servo != m_servo || row.reg != m_row->reg ||
           row.isWritable != m_row->isWritable || row.meaning.encoding != m_row->meaning.encoding ||
           (m_editor != nullptr && m_editor->context().inPhysicalUnit != physical);
}

void RegisterPanel::makeEditor(bool physical)
{
    if (!m_row->isWritable)
        return;
    const EditContext context{m_row->reg, m_row->meaning, m_row->raw, physical, false};
    m_editor = makeRegisterEditor(context, m_body);
    m_editor->setObjectName(QStringLiteral("panelEditor"));
    m_editorLayout->addWidget(m_editor);
    connect(m_editor, &RegisterEditor::userEdited, this, &RegisterPanel::checkInput);
    QWidget* before = this;
    for (QWidget* taker : m_editor->is()) {
        setTabOrder(before, taker);
        before = taker;
    }
    setTabOrder(before, m_write);
    m_editor->show();
}

void RegisterPanel::fill()
{
    const bool hasRow = m_row.has_value();
    const bool writable = hasRow && m_row->isWritable;
    setTextOrHide(m_title,
                  hasRow
                      ? QStringLiteral("%1 · %2").arg(m_row->reg->address).arg(registerName(*m_row))
                      : tr("Select a register to see what it does."));
    setTextOrHide(m_help, hasRow ? text::localized(m_row->reg->help) : QString());
    setTextOrHide(m_facts, hasRow ? registerFacts(*m_row).join(QLatin1Char('\n')) : QString());
    setTextOrHide(m_relations, hasRow && m_profile
                                   ? registerRelations(*m_row, *m_profile).join(QLatin1Char('\n'))
                                   : QString());
    setTextOrHide(m_state, hasRow ? tr("State: %1").arg(stateText(*m_row)) + QLatin1Char('\n') +
                                        stateHelp(*m_row)
                                  : QString());
    setTextOrHide(m_persistence, writable ? persistenceText(*m_row->reg) : QString());
    m_write->setVisible(writable);
    m_writeTemporarily->setVisible(writable && canWriteTemporarily(*m_row->reg));
    fillEditor();
    updateColors();
}

/// The latest reading goes into the editor until the user begins to change it.
void RegisterPanel::fillEditor()
{
    if (m_editor == nullptr) {
        setTextOrHide(m_before, {});
        setTextOrHide(m_inputError, {});
        return;
    }
    EditContext context = m_editor->context();
    context.meaning = m_row->meaning;
    context.currentRaw = m_row->raw;
    m_editor->setContext(context);
    const auto raw = m_row->editValue();
    const auto now = m_editor->value();
    if (!m_editor->isModified() && !(raw && now && *raw == *now))
        m_editor->setRaw(raw);
    checkInput();
}

void RegisterPanel::discardEdit()
{
    if (m_editor == nullptr || !m_row)
        return;
    m_editor->setRaw(m_row->editValue());
    checkInput();
}

void RegisterPanel::checkInput()
{
    QStringList parts;
    if (m_row->raw)
        parts << tr("now %1").arg(rawWord(*m_row->raw, *m_row->reg, m_row->meaning));
    if (m_row->isChanged())
        parts << tr("was %1").arg(*m_row->firstRaw);
    setTextOrHide(m_before, parts.join(QStringLiteral(" · ")));
    const bool begun = m_editor->isModified() && !m_editor->inputText().trimmed().isEmpty();
    const QString inputError = begun ? m_editor->inputError() : QString();
    setTextOrHide(m_inputError,
                  inputError.isEmpty() ? QString() : QStringLiteral("✗ ") + inputError);
}

void RegisterPanel::write(bool temporary)
{
    if (m_editor == nullptr)
        return;
    const auto raw = m_editor->value();
    if (!raw) {
        setTextOrHide(m_inputError, QStringLiteral("✗ ") + m_editor->inputError());
        return;
    }
    const QString key = m_row->reg->key;
    m_editor->setRaw(*raw); // no longer an unfinished input
    Q_EMIT writeRequested(key, *raw, temporary);
}

void RegisterPanel::updateColors()
{
    const QPalette basePalette = palette();
    setTone(m_facts, Tone::Quiet, basePalette);
    setTone(m_persistence, Tone::Quiet, basePalette);
    setTone(m_before, Tone::Quiet, basePalette);
    setTone(m_inputError, Tone::Bad, basePalette);
    setTone(m_state, m_row ? stateTone(m_row->state) : Tone::Quiet, basePalette);
    QFont bold = font();
    bold.setBold(true);
    if (m_title->font() != bold)
        m_title->setFont(bold);
}

void RegisterPanel::retranslate()
{
    setAccessibleName(tr("Register help"));
    setToolTip(tr("Explains the selected register and lets you change it"));
    setButtonText(m_write, tr("Write"),
                  tr("Writes this value and reads it back; the value is kept after power-off if "
                     "the register supports permanent storage"));
    setButtonText(
        m_writeTemporarily, tr("Write temporarily"),
        tr("Writes the value without unlocking the EPROM; the value is lost at power-off"));
    fill();
}

void RegisterPanel::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        updateColors();
}

void RegisterPanel::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    // The same width with and without the scroll bar, so that nothing moves when it appears.
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    m_body->setMaximumWidth(width() - 2 * frameWidth() - bar);
}
} // namespace ui
