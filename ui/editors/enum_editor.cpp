// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/enum_editor.h"

#include "text/language.h"
#include "ui/common/follow_language.h"

#include <QComboBox>
#include <QVBoxLayout>

namespace ui {
/// QComboBox emits activated() also for values passed with arrow keys or the wheel.
class ValueComboBox final : public QComboBox {
public:
    using QComboBox::QComboBox;
    bool isStepping() const { return m_stepping; }

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        m_stepping = true;
        QComboBox::keyPressEvent(event);
        m_stepping = false;
    }
    void wheelEvent(QWheelEvent* event) override
    {
        m_stepping = true;
        QComboBox::wheelEvent(event);
        m_stepping = false;
    }

private:
    bool m_stepping = false;
};

EnumEditor::EnumEditor(const EditContext& context, QWidget* parent)
    : RegisterEditor(context, parent)
    , m_box(new ValueComboBox(this))
{
    m_box->setObjectName(QStringLiteral("valueList"));
    m_box->setFrame(!context.inCell);
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_box);
    setFocusProxy(m_box);
    setAutoFillBackground(context.inCell);
    connect(m_box, &QComboBox::currentIndexChanged, this, &EnumEditor::markModified);
    connect(m_box, &QComboBox::activated, this, [this] {
        if (!m_box->isStepping())
            Q_EMIT valueChosen();
    });
    fill(std::nullopt);
    followLanguage(this, [this] { retranslate(); });
}

void EnumEditor::fill(std::optional<std::int64_t> raw)
{
    const QSignalBlocker blocker(m_box);
    m_box->clear();
    const auto add = [this](std::int64_t number, const QString& name) {
        m_box->addItem(QStringLiteral("%1 — %2").arg(number).arg(name),
                       static_cast<qlonglong>(number));
    };
    for (const catalog::NamedValue& value : context().reg->values)
        add(value.value, text::localized(value.name));
    if (raw && m_box->findData(static_cast<qlonglong>(*raw)) < 0)
        add(*raw, tr("not documented"));
    m_box->setCurrentIndex(raw ? m_box->findData(static_cast<qlonglong>(*raw)) : -1);
}

void EnumEditor::setRaw(std::optional<std::int64_t> raw)
{
    fill(raw);
    clearModified();
}

QString EnumEditor::inputText() const
{
    return m_box->currentIndex() < 0 ? QString() : m_box->currentData().toString();
}

QList<QWidget*> EnumEditor::is() const
{
    return {m_box};
}

void EnumEditor::retranslate()
{
    const QVariant chosen = m_box->currentData();
    fill(chosen.isValid() ? std::optional<std::int64_t>(chosen.toLongLong()) : std::nullopt);
    m_box->setAccessibleName(accessibleName());
    m_box->setToolTip(tr("Select a value. %1").arg(keyHint()));
}
} // namespace ui
