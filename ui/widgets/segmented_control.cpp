// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/segmented_control.h"

#include "ui/widgets/flow_layout.h"

#include <QButtonGroup>
#include <QPainter>
#include <QPainterPath>

namespace ui {
namespace {
constexpr int besideText = 9;
constexpr int aboveText = 5;
constexpr double corner = 4;

class Segment final : public QAbstractButton {
public:
    explicit Segment(QWidget* parent)
        : QAbstractButton(parent)
    {
        setCheckable(true);
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
    }

    QSize sizeHint() const override
    {
        return {fontMetrics().horizontalAdvance(text()) + 2 * besideText,
                fontMetrics().height() + 2 * aboveText};
    }

    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPalette& colors = palette();
        const bool on = isChecked() && isEnabled();
        const QColor ground = on ? colors.color(QPalette::Active, QPalette::Highlight)
                              : isDown() || (underMouse() && isEnabled())
                                  ? colors.color(QPalette::Window)
                                  : colors.color(QPalette::Button);
        painter.setBrush(ground);
        painter.setPen(on ? ground : colors.color(QPalette::Mid));
        painter.drawPath(outline(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5)));
        painter.setPen(on ? colors.color(QPalette::Active, QPalette::HighlightedText)
                          : colors.color(QPalette::ButtonText));
        painter.drawText(rect(), Qt::AlignCenter, text());
        if (!isEnabled() && isChecked()) // which one was selected is still seen
            painter.fillRect(QRect(besideText, height() - 4, width() - 2 * besideText, 2),
                             colors.color(QPalette::Mid));
        if (!hasFocus())
            return;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(on ? colors.color(QPalette::Active, QPalette::HighlightedText)
                          : colors.color(QPalette::Highlight));
        painter.drawRoundedRect(QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5), 2, 2);
    }

private:
    /// Round at the ends of a row, straight where the next segment begins.
    QPainterPath outline(const QRectF& box) const
    {
        bool left = true;
        bool right = true;
        for (const QObject* child : parent()->children()) {
            const auto* other = qobject_cast<const QAbstractButton*>(child);
            if (other == nullptr || other == this || other->isHidden() || other->y() != y())
                continue;
            (other->x() < x() ? left : right) = false;
        }
        // What lies outside the widget is not seen: the next segment draws the line between them.
        QPainterPath path;
        path.addRoundedRect(box.adjusted(left ? 0 : -corner, 0, right ? 0 : corner + 1, 0), corner,
                            corner);
        if (!left) {
            path.moveTo(box.topLeft());
            path.lineTo(box.bottomLeft());
        }
        return path;
    }
};
} // namespace

SegmentedControl::SegmentedControl(QWidget* parent)
    : QWidget(parent)
    , m_group(new QButtonGroup(this))
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    new FlowLayout(this, 0);
    connect(m_group, &QButtonGroup::idClicked, this, &SegmentedControl::chosen);
}

QAbstractButton* SegmentedControl::addSegment(const QString& objectName)
{
    auto* button = new Segment(this);
    button->setObjectName(objectName);
    m_group->addButton(button, static_cast<int>(m_group->buttons().size()));
    layout()->addWidget(button);
    return button;
}

QAbstractButton* SegmentedControl::segment(int index) const
{
    return m_group->button(index);
}

void SegmentedControl::clear()
{
    for (QAbstractButton* button : m_group->buttons())
        delete button; // leaves group and layout by itself
}

int SegmentedControl::selected() const
{
    return m_group->checkedId();
}

void SegmentedControl::select(int index)
{
    m_group->setExclusive(false);
    for (QAbstractButton* button : m_group->buttons())
        button->setChecked(m_group->id(button) == index);
    m_group->setExclusive(index >= 0);
    for (QAbstractButton* button : m_group->buttons()) // Tab goes to the selected one
        button->setFocusPolicy(index < 0 || button->isChecked() ? Qt::StrongFocus : Qt::ClickFocus);
}
} // namespace ui
