// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_field.h"

#include "ui/common/theme.h"
#include "ui/editors/number_editor.h"
#include "ui/operate/control_text.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>

namespace ui {
namespace {
QString notAcceptedText()
{
    return QStringLiteral("✗ ") + ControlField::tr("invalid");
}
} // namespace

ControlField::ControlField(const QString& name, QWidget* parent, bool wide)
    : QWidget(parent)
    , m_name(name)
    , m_title(new QLabel(this))
    , m_editorLayout(new QVBoxLayout)
    , m_physical(new QLabel(this))
{
    setObjectName(name + QStringLiteral("Field"));
    m_title->setObjectName(name + QStringLiteral("Title"));
    m_physical->setObjectName(name + QStringLiteral("Physical"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(2);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    column->addLayout(head);
    column->addLayout(m_editorLayout);
    if (wide)
        head->addWidget(m_physical);
    else
        column->addWidget(m_physical);
    hide();
}

void ControlField::setTitle(const QString& title)
{
    m_titleText = title;
    reservePhysical(); // also after a change of language
    m_title->setText(title);
    if (m_editor != nullptr) {
        for (QWidget* inputWidget : m_editor->is())
            inputWidget->setAccessibleName(title);
    }
}

void ControlField::setRegister(const catalog::ProfilePtr& profile, const catalog::Register* reg)
{
    if (profile == m_profile && reg == m_reg)
        return;
    delete m_editor.data(); // before the profile its register lives in
    m_profile = profile;
    m_reg = reg;
    m_sent.reset();
    m_start.reset();
    setVisible(reg != nullptr);
}

void ControlField::makeEditor(const device::Servo& servo)
{
    const EditContext context{.reg = m_reg,
                              .meaning = servo.meaning(*m_reg),
                              .currentRaw = servo.raw(*m_reg),
                              .ownerHandlesEnter = true};
    m_editor = new NumberEditor(context, this);
    m_editor->setObjectName(m_name + QStringLiteral("Editor"));
    m_editorLayout->addWidget(m_editor);
    for (QWidget* inputWidget : m_editor->is()) {
        inputWidget->setObjectName(m_name);
        inputWidget->installEventFilter(this);
        inputWidget->setFocusPolicy(Qt::StrongFocus); // the wheel works only after a click
        inputWidget->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("−30719")) +
                                     40);
    }
    m_title->setBuddy(m_editor);
    setTitle(m_titleText);
    connect(m_editor, &NumberEditor::userEdited, this, [this] {
        showPhysical();
        Q_EMIT edited();
    });
    m_editor->setVisible(true);
}

std::optional<std::int64_t> ControlField::effectiveRaw(const device::Servo& servo) const
{
    if (m_reg == nullptr)
        return std::nullopt;
    const auto readAt = servo.image.readAt(m_reg->offset);
    const bool newer = readAt && *readAt > m_sentAt;
    return m_sent && !newer ? m_sent : servo.raw(*m_reg);
}

void ControlField::showReading(const device::Servo& servo, std::optional<std::int64_t> raw)
{
    if (m_reg == nullptr)
        return;
    const catalog::ValueFormat meaning = servo.meaning(*m_reg);
    // The same register may hold another kind of number in another mode.
    if (m_editor != nullptr && m_editor->context().meaning.encoding != meaning.encoding) {
        delete m_editor.data();
        m_sent.reset();
    }
    if (m_editor == nullptr)
        makeEditor(servo);
    EditContext context = m_editor->context();
    context.meaning = meaning;
    context.currentRaw = servo.raw(*m_reg);
    m_editor->setContext(context);
    setTitle(m_titleText);
    if (!m_start && !m_editor->isModified()) {
        const auto now = m_editor->value();
        if (!(raw && now && *raw == *now))
            m_editor->setRaw(raw);
    }
    showPhysical();
}

void ControlField::setRaw(std::int64_t raw)
{
    m_start = raw;
    if (m_editor != nullptr && value() != raw)
        m_editor->setRaw(raw);
    showPhysical();
}

std::optional<std::int64_t> ControlField::value() const
{
    if (m_editor == nullptr)
        return std::nullopt;
    const auto raw = m_editor->value();
    return raw ? std::optional(*raw) : std::nullopt;
}

bool ControlField::isEdited() const
{
    return m_editor != nullptr && m_editor->isModified();
}

void ControlField::discardEdit()
{
    if (m_editor != nullptr && m_editor->isModified())
        m_editor->setRaw(m_start ? m_start : m_sent ? m_sent : m_editor->context().currentRaw);
    showPhysical();
}

QString ControlField::inputError() const
{
    return m_editor != nullptr ? m_editor->inputError() : QString();
}

void ControlField::setPending(std::int64_t raw)
{
    m_sent = raw;
    m_sentAt = base::Duration::max();
}

void ControlField::setSent(std::int64_t raw, base::Duration at)
{
    m_sent = raw;
    m_sentAt = at;
    // The user may have continued typing while it was being sent.
    if (m_editor != nullptr && value() == raw && !m_start)
        m_editor->setRaw(raw);
}

bool ControlField::isSentAfterRead(const device::Servo& servo, const catalog::Register* read) const
{
    const auto readAt = read != nullptr ? servo.image.readAt(read->offset) : std::nullopt;
    return m_sent && (!readAt || *readAt <= m_sentAt);
}

void ControlField::enterValue(std::int64_t raw)
{
    if (m_editor != nullptr)
        m_editor->enterValue(raw);
}

void ControlField::clearSent()
{
    m_sent.reset();
    if (m_editor != nullptr && !m_editor->isModified() && !m_start)
        m_editor->setRaw(std::nullopt);
}

void ControlField::resetValue()
{
    m_sent.reset();
    m_start.reset();
    if (m_editor != nullptr)
        m_editor->setRaw(std::nullopt);
}

/// A sign from another font may be higher than the digits; nothing below may move when it
/// appears.
void ControlField::reservePhysical()
{
    const QRect room(0, 0, std::numeric_limits<short>::max(), std::numeric_limits<short>::max());
    int height = 0;
    for (const QString& words : {notAcceptedText(), QStringLiteral("0.0°")})
        height = std::max(height, m_physical->fontMetrics().boundingRect(room, 0, words).height());
    m_physical->setMinimumHeight(height);
}

void ControlField::showPhysical()
{
    const auto raw = value();
    const bool wrong = isEdited() && !raw;
    const QString words = wrong ? notAcceptedText()
                          : raw && m_editor != nullptr
                              ? physicalValueText(*raw, *m_reg, m_editor->context().meaning)
                              : QString();
    if (m_physical->text() != words)
        m_physical->setText(words);
    m_physical->setToolTip(wrong ? inputError() : QString());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(wrong ? Tone::Bad : Tone::Quiet, palette()));
    if (m_physical->palette() != colors)
        m_physical->setPalette(colors);
}

bool ControlField::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            Q_EMIT returnPressed();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ControlField::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showPhysical();
    if (event->type() == QEvent::FontChange)
        reservePhysical();
}
} // namespace ui
