// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/bits_editor.h"

#include "report/fonts.h"
#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyleOptionFrame>
#include <QStylePainter>

#include <algorithm>

namespace ui {
namespace {
QString hexText(std::int64_t raw)
{
    return QStringLiteral("0x") + QStringLiteral("%1").arg(raw, 2, 16, QLatin1Char('0')).toUpper();
}
} // namespace

BitsEditor::BitsEditor(const EditContext& context, QWidget* parent)
    : RegisterEditor(context, parent)
    , m_grid(new QGridLayout)
    , m_label(new QLabel(this))
    , m_sum(new QLineEdit(this))
    , m_hex(new QLabel(this))
{
    build();
    connect(m_sum, &QLineEdit::textEdited, this, &BitsEditor::onSumEdited);
    setFocusProxy(m_sum);
    setAutoFillBackground(context.inCell);
    setBackgroundRole(QPalette::Base);
    followLanguage(this, [this] { retranslate(); });
    showBitValues(0, true);
}

void BitsEditor::build()
{
    const bool inCell = context().inCell;
    for (int bit = 0; bit < context().reg->size * 8; ++bit)
        m_boxes.push_back({bit, makeBox(bit)});
    if (const QStringList families = report::codeFamilies(); !families.isEmpty()) {
        QFont code = font();
        code.setFamilies(families);
        m_hex->setFont(code);
    }
    m_sum->setObjectName(QStringLiteral("bitsSum"));
    m_sum->setAlignment(Qt::AlignRight);
    m_sum->setFixedWidth(m_sum->fontMetrics().horizontalAdvance(QStringLiteral("0000000")) + 16);
    m_label->setBuddy(m_sum);
    auto* row = new QHBoxLayout;
    row->addWidget(m_label);
    row->addWidget(m_sum);
    row->addWidget(m_hex);
    row->addStretch();
    auto* layout = new QVBoxLayout(this);
    const int margin = inCell ? 8 : 0;
    layout->setContentsMargins(margin, margin, margin, margin);
    m_grid->setHorizontalSpacing(16);
    m_grid->setVerticalSpacing(inCell ? 2 : 4);
    layout->addLayout(m_grid);
    layout->addLayout(row);
}

QCheckBox* BitsEditor::makeBox(int bit)
{
    auto* box = new QCheckBox(this);
    box->setObjectName(QStringLiteral("bit%1").arg(bit));
    connect(box, &QCheckBox::clicked, this, &BitsEditor::onBoxClicked);
    return box;
}

bool BitsEditor::isNamed(int bit) const
{
    const auto& values = context().reg->values;
    return std::any_of(values.begin(), values.end(),
                       [bit](const catalog::NamedValue& value) { return value.value == bit; });
}

QString BitsEditor::bitLabel(int bit) const
{
    for (const catalog::NamedValue& value : context().reg->values) {
        if (value.value == bit)
            return text::localized(value.name);
    }
    return tr("bit %1, unnamed").arg(bit);
}

void BitsEditor::setRaw(std::optional<std::int64_t> raw)
{
    showBitValues(raw.value_or(0), true);
    if (raw) {
        showSum(*raw);
    } else {
        m_sum->clear();
        m_hex->clear();
    }
    clearModified();
}

QString BitsEditor::inputText() const
{
    return m_sum->text();
}

QList<QWidget*> BitsEditor::is() const
{
    QList<QWidget*> widgets{m_sum};
    for (const Box& one : m_boxes)
        widgets << one.box;
    return widgets;
}

void BitsEditor::selectAll()
{
    m_sum->selectAll();
}

void BitsEditor::onBoxClicked()
{
    std::int64_t raw = 0;
    for (const Box& one : m_boxes) {
        if (one.box->isChecked())
            raw |= std::int64_t{1} << one.bit;
    }
    showSum(raw);
    markModified();
}

void BitsEditor::onSumEdited()
{
    if (const auto raw = parse()) {
        showBitValues(*raw, false);
        m_hex->setText(hexText(*raw));
    } else {
        m_hex->clear();
    }
    markModified();
}

void BitsEditor::showSum(std::int64_t raw)
{
    m_sum->setText(QString::number(raw));
    m_hex->setText(hexText(raw));
}

void BitsEditor::showBitValues(std::int64_t raw, bool fresh)
{
    for (Box& one : m_boxes) {
        const bool set = (raw >> one.bit & 1) != 0;
        one.box->setChecked(set);
        // Once listed it stays, so that an unnamed bit taken away by mistake can be put back.
        one.listed = isNamed(one.bit) || set || (!fresh && one.listed);
    }
    arrange();
}

/// Two columns in a cell, where height is scarce; one in the panel, where width is scarce.
void BitsEditor::arrange()
{
    const auto count = static_cast<int>(
        std::count_if(m_boxes.begin(), m_boxes.end(), [](const Box& one) { return one.listed; }));
    const int rows = context().inCell && count > 4 ? (count + 1) / 2 : std::max(count, 1);
    int place = 0;
    for (const Box& one : m_boxes) {
        m_grid->removeWidget(one.box);
        one.box->setVisible(one.listed);
        if (!one.listed)
            continue;
        m_grid->addWidget(one.box, place % rows, place / rows);
        ++place;
    }
}

void BitsEditor::retranslate()
{
    m_label->setText(tr("Value"));
    m_sum->setAccessibleName(accessibleName());
    m_sum->setToolTip(tr("The sum of the selected bits. %1").arg(keyHint()));
    for (const Box& one : m_boxes) {
        const std::int64_t weight = std::int64_t{1} << one.bit;
        setButtonText(one.box, QStringLiteral("%1 (%2)").arg(bitLabel(one.bit)).arg(weight),
                      isNamed(one.bit) ? tr("Bit %1, adds %2 to the value").arg(one.bit).arg(weight)
                                       : tr("Bit %1, adds %2 to the value; not named in the data "
                                            "sheet, so it is kept unchanged")
                                             .arg(one.bit)
                                             .arg(weight));
    }
}

/// A frame around the boxes where they lie over the table.
void BitsEditor::paintEvent(QPaintEvent*)
{
    if (!context().inCell)
        return;
    QStylePainter painter(this);
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}
} // namespace ui
