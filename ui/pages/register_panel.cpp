// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/register_panel.h"

#include "text/language.h"
#include "ui/app/theme.h"
#include "ui/models/memory_words.h"
#include "ui/pages/register_help.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace ui {
namespace {
void setTone(QLabel* label, Tone wanted, const QPalette& around)
{
    QPalette colours;
    colours.setColor(QPalette::WindowText, tone(wanted, around));
    if (label->palette().color(QPalette::WindowText) != colours.color(QPalette::WindowText))
        label->setPalette(colours);
}

/// An empty line costs no room.
void setOrHide(QLabel* label, const QString& text)
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
    m_editorPlace = new QVBoxLayout;
    m_column->addLayout(m_editorPlace);
    addButtons(); // above what comes and goes, which must not move them
    m_before = addLabel(QStringLiteral("registerBefore"));
    m_complaint = addLabel(QStringLiteral("registerComplaint"));
    m_keeping = addLabel(QStringLiteral("registerKeeping"));
    m_state = addLabel(QStringLiteral("registerState"));
    m_relations = addLabel(QStringLiteral("registerRelations"));
    m_facts = addLabel(QStringLiteral("registerFacts"));
    m_column->addStretch();
    setWidget(m_body);
    updateColours();
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
    m_write->setProperty("mainAction", true);
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
    return !m_row || servo != m_servo || row.reg != m_row->reg || row.writable != m_row->writable ||
           row.meaning.encoding != m_row->meaning.encoding ||
           (m_editor != nullptr && m_editor->context().physical != physical);
}

void RegisterPanel::makeEditor(bool physical)
{
    if (!m_row->writable)
        return;
    const EditContext context{m_row->reg, m_row->meaning, m_row->raw, physical, false};
    m_editor = makeRegisterEditor(context, m_body);
    m_editor->setObjectName(QStringLiteral("panelEditor"));
    m_editorPlace->addWidget(m_editor);
    connect(m_editor, &RegisterEditor::edited, this, &RegisterPanel::checkInput);
    QWidget* before = this;
    for (QWidget* taker : m_editor->keyTakers()) {
        setTabOrder(before, taker);
        before = taker;
    }
    setTabOrder(before, m_write);
    m_editor->show();
}

void RegisterPanel::fill()
{
    const bool some = m_row.has_value();
    const bool writable = some && m_row->writable;
    setOrHide(m_title,
              some ? QStringLiteral("%1 · %2").arg(m_row->reg->address).arg(registerName(*m_row))
                   : tr("Select a register to see what it does."));
    setOrHide(m_help, some ? m_row->reg->help.in(text::inChinese()) : QString());
    setOrHide(m_facts, some ? registerFacts(*m_row).join(QLatin1Char('\n')) : QString());
    setOrHide(m_relations, some && m_profile
                               ? registerRelations(*m_row, *m_profile).join(QLatin1Char('\n'))
                               : QString());
    setOrHide(m_state,
              some ? tr("State: %1").arg(stateWord(*m_row)) + QLatin1Char('\n') + stateHelp(*m_row)
                   : QString());
    setOrHide(m_keeping, writable ? keepingSentence(*m_row->reg) : QString());
    m_write->setVisible(writable);
    m_writeTemporarily->setVisible(writable && mayWriteTemporarily(*m_row->reg));
    fillEditor();
    updateColours();
}

/// The latest reading goes into the editor as long as nobody has begun to change it.
void RegisterPanel::fillEditor()
{
    if (m_editor == nullptr) {
        setOrHide(m_before, {});
        setOrHide(m_complaint, {});
        return;
    }
    EditContext context = m_editor->context();
    context.meaning = m_row->meaning;
    context.present = m_row->raw;
    m_editor->setContext(context);
    const auto raw = m_row->editable();
    const auto now = m_editor->value();
    if (!m_editor->touched() && !(raw && now && *raw == *now))
        m_editor->setRaw(raw);
    checkInput();
}

void RegisterPanel::forgetEdit()
{
    if (m_editor == nullptr || !m_row)
        return;
    m_editor->setRaw(m_row->editable());
    checkInput();
}

void RegisterPanel::checkInput()
{
    QStringList words;
    if (m_row->raw)
        words << tr("now %1").arg(rawWord(*m_row->raw, *m_row->reg, m_row->meaning));
    if (m_row->changed())
        words << tr("was %1").arg(*m_row->first);
    setOrHide(m_before, words.join(QStringLiteral(" · ")));
    const bool begun = m_editor->touched() && !m_editor->typed().trimmed().isEmpty();
    const QString complaint = begun ? m_editor->complaint() : QString();
    setOrHide(m_complaint, complaint.isEmpty() ? QString() : QStringLiteral("✗ ") + complaint);
}

void RegisterPanel::write(bool temporary)
{
    if (m_editor == nullptr)
        return;
    const auto raw = m_editor->value();
    if (!raw) {
        setOrHide(m_complaint, QStringLiteral("✗ ") + m_editor->complaint());
        return;
    }
    const QString key = m_row->reg->key;
    m_editor->setRaw(*raw); // no longer somebody's unfinished input
    Q_EMIT writeWanted(key, *raw, temporary);
}

void RegisterPanel::updateColours()
{
    const QPalette around = palette();
    setTone(m_facts, Tone::Quiet, around);
    setTone(m_keeping, Tone::Quiet, around);
    setTone(m_before, Tone::Quiet, around);
    setTone(m_complaint, Tone::Bad, around);
    setTone(m_state, m_row ? stateTone(m_row->state) : Tone::Quiet, around);
    QFont bold = font();
    bold.setBold(true);
    if (m_title->font() != bold)
        m_title->setFont(bold);
}

void RegisterPanel::retranslate()
{
    setAccessibleName(tr("Help of the register"));
    setToolTip(tr("What the selected register does, and a place to change it"));
    m_write->setText(tr("Write"));
    m_write->setAccessibleName(m_write->text());
    m_write->setToolTip(tr("Write this value, read it back, and keep it where the register can"));
    m_writeTemporarily->setText(tr("Write temporarily"));
    m_writeTemporarily->setAccessibleName(m_writeTemporarily->text());
    m_writeTemporarily->setToolTip(
        tr("Try the value: the lock stays closed, and it is lost at power-off"));
    fill();
}

void RegisterPanel::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        updateColours();
}

void RegisterPanel::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    // As wide with the scroll bar as without it, so that its coming moves nothing.
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    m_body->setMaximumWidth(width() - 2 * frameWidth() - bar);
}
} // namespace ui
