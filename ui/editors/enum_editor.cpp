// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/enum_editor.h"

#include "text/language.h"

#include <QComboBox>
#include <QEvent>
#include <QVBoxLayout>

namespace ui {
/// QComboBox calls a value activated that arrow keys or the wheel merely passed by.
class ValueList final : public QComboBox {
public:
    using QComboBox::QComboBox;
    bool passing() const { return m_passing; }

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        m_passing = true;
        QComboBox::keyPressEvent(event);
        m_passing = false;
    }
    void wheelEvent(QWheelEvent* event) override
    {
        m_passing = true;
        QComboBox::wheelEvent(event);
        m_passing = false;
    }

private:
    bool m_passing = false;
};

EnumEditor::EnumEditor(const EditContext& context, QWidget* parent)
    : RegisterEditor(context, parent)
    , m_box(new ValueList(this))
{
    m_box->setObjectName(QStringLiteral("valueList"));
    m_box->setFrame(!context.inCell);
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_box);
    setFocusProxy(m_box);
    setAutoFillBackground(context.inCell);
    connect(m_box, &QComboBox::currentIndexChanged, this, &EnumEditor::userEdited);
    connect(m_box, &QComboBox::activated, this, [this] {
        if (!m_box->passing())
            Q_EMIT chosen();
    });
    fill(std::nullopt);
    retranslate();
}

void EnumEditor::fill(std::optional<std::int64_t> raw)
{
    const QSignalBlocker quiet(m_box);
    m_box->clear();
    const auto add = [this](std::int64_t number, const QString& name) {
        m_box->addItem(QStringLiteral("%1 — %2").arg(number).arg(name),
                       static_cast<qlonglong>(number));
    };
    for (const catalog::NamedValue& value : context().reg->values)
        add(value.value, value.name.in(text::inChinese()));
    if (raw && m_box->findData(static_cast<qlonglong>(*raw)) < 0)
        add(*raw, tr("not documented"));
    m_box->setCurrentIndex(raw ? m_box->findData(static_cast<qlonglong>(*raw)) : -1);
}

void EnumEditor::setRaw(std::optional<std::int64_t> raw)
{
    fill(raw);
    untouched();
}

QString EnumEditor::typed() const
{
    return m_box->currentIndex() < 0 ? QString() : m_box->currentData().toString();
}

QList<QWidget*> EnumEditor::keyTakers() const
{
    return {m_box};
}

void EnumEditor::retranslate()
{
    const QVariant chosen = m_box->currentData();
    fill(chosen.isValid() ? std::optional<std::int64_t>(chosen.toLongLong()) : std::nullopt);
    m_box->setAccessibleName(accessibleName());
    m_box->setToolTip(tr("Choose a value. %1").arg(keysHelp()));
}

void EnumEditor::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    RegisterEditor::changeEvent(event);
}
} // namespace ui
