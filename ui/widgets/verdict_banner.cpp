// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/verdict_banner.h"

#include "ui/widgets/flow_layout.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr double gradeSize = 1.25; ///< of the text beside it
constexpr int chipSide = 9;
constexpr int chipAbove = 3;
constexpr double groundShare = 0.10; ///< of the tone, in the banner's ground

class Chip final : public QAbstractButton {
public:
    explicit Chip(QWidget* parent)
        : QAbstractButton(parent)
    {
        setCheckable(true);
        setAttribute(Qt::WA_Hover);
    }

    void setTone(Tone tone)
    {
        m_tone = tone;
        update();
    }

    QSize sizeHint() const override
    {
        return {fontMetrics().horizontalAdvance(text()) + 2 * chipSide,
                fontMetrics().height() + 2 * chipAbove};
    }

    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QColor color = tone(m_tone, palette());
        const bool on = isChecked() || underMouse() || hasFocus();
        const double line = isChecked() ? 2 : 1;
        const QRectF frame = QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2);
        painter.setPen(QPen(on ? color : palette().color(QPalette::Mid), line));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
        painter.setPen(color);
        painter.drawText(rect(), Qt::AlignCenter, text());
        if (!hasFocus())
            return;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
        painter.drawRoundedRect(frame.adjusted(3, 3, -3, -3), frame.height() / 2 - 3,
                                frame.height() / 2 - 3);
    }

private:
    Tone m_tone = Tone::Quiet;
};

QColor mixed(const QColor& ground, const QColor& color, double share)
{
    const auto part = [share](int a, int b) { return static_cast<int>(a + (b - a) * share); };
    return {part(ground.red(), color.red()), part(ground.green(), color.green()),
            part(ground.blue(), color.blue())};
}
} // namespace

VerdictBanner::VerdictBanner(QWidget* parent)
    : QFrame(parent)
    , m_grade(new QLabel(this))
    , m_reason(new QLabel(this))
    , m_chipRow(new QWidget(this))
    , m_chips(new QButtonGroup(this))
{
    QFont large = font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * gradeSize);
    m_grade->setFont(large);
    m_reason->setWordWrap(true);
    for (QLabel* label : {m_grade, m_reason}) {
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    m_chipRow->setSizePolicy(policy);
    new FlowLayout(m_chipRow, 6);
    m_chipRow->hide();
    auto* words = new QHBoxLayout;
    words->setSpacing(12);
    words->addWidget(m_grade);
    words->addWidget(m_reason, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 7, 12, 7);
    column->setSpacing(6);
    column->addLayout(words);
    column->addWidget(m_chipRow);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    connect(m_chips, &QButtonGroup::idClicked, this, &VerdictBanner::chipClicked);
}

void VerdictBanner::setVerdict(Tone tone, const QString& grade, const QString& reason)
{
    const bool isNew = grade != m_grade->text();
    m_tone = tone;
    m_grade->setText(grade);
    m_reason->setText(reason);
    m_reason->setToolTip(reason);
    setAccessibleName(text());
    if (isNew && isVisible()) { // a screen reader says it, wherever the focus is
        QAccessibleEvent alert(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    }
    update();
}

void VerdictBanner::setChips(const std::vector<VerdictChip>& chips, int selected)
{
    while (m_chips->buttons().size() > static_cast<qsizetype>(chips.size()))
        delete m_chips->button(static_cast<int>(m_chips->buttons().size()) - 1);
    for (std::size_t i = 0; i < chips.size(); ++i) {
        const int index = static_cast<int>(i);
        auto* chip = static_cast<Chip*>(m_chips->button(index));
        if (chip == nullptr) {
            chip = new Chip(m_chipRow);
            chip->setObjectName(QStringLiteral("verdictChip_%1").arg(index));
            m_chips->addButton(chip, index);
            m_chipRow->layout()->addWidget(chip);
        }
        chip->setText(chips[i].text);
        chip->setTone(chips[i].tone);
        chip->setToolTip(chips[i].tip);
        chip->setAccessibleName(chips[i].tip);
        chip->setChecked(index == selected);
        chip->updateGeometry();
    }
    m_chipRow->setVisible(!chips.empty());
}

QString VerdictBanner::text() const
{
    return m_reason->text().isEmpty() ? m_grade->text()
                                      : m_grade->text() + QStringLiteral(": ") + m_reason->text();
}

void VerdictBanner::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = tone(m_tone, palette());
    QPalette colors = m_grade->palette();
    if (colors.color(QPalette::WindowText) != color) { // also after a change of theme
        colors.setColor(QPalette::WindowText, color);
        m_grade->setPalette(colors);
    }
    painter.setPen(m_tone == Tone::Quiet ? palette().color(QPalette::Mid) : color);
    painter.setBrush(mixed(palette().color(QPalette::Base), color, groundShare));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}
} // namespace ui
