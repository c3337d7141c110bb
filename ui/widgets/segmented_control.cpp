// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/segmented_control.h"

#include "ui/widgets/flow_layout.h"

#include <QButtonGroup>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QRadioButton>
#include <QStyle>

#include <algorithm>
#include <numeric>
#include <vector>

namespace ui {
namespace {
constexpr int besideText = 9;
constexpr int aboveText = 5;
constexpr double corner = 4;

/// A radio button for screen readers.
class Segment final : public QRadioButton {
public:
    explicit Segment(SegmentedControl& control)
        : QRadioButton(&control)
        , m_control(control)
    {
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
    bool hitButton(const QPoint& position) const override { return rect().contains(position); }

    void keyPressEvent(QKeyEvent* event) override
    {
        const int key = event->key();
        const bool back = key == Qt::Key_Left || key == Qt::Key_Up;
        if (m_control.arrowsSelect() || (!back && key != Qt::Key_Right && key != Qt::Key_Down)) {
            QRadioButton::keyPressEvent(event);
            return;
        }
        if (QAbstractButton* next = m_control.segment(group()->id(this) + (back ? -1 : 1)))
            next->setFocus(Qt::TabFocusReason);
    }

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
    /// Round at the corners of the whole control, straight where the next segment begins.
    QPainterPath outline(const QRectF& box) const
    {
        bool atLeft = false;
        bool atRight = false;
        bool higher = false;
        bool lower = false;
        for (const QObject* child : parent()->children()) {
            const auto* other = qobject_cast<const QAbstractButton*>(child);
            if (other == nullptr || other == this || other->isHidden())
                continue;
            if (other->y() == y())
                (other->x() < x() ? atLeft : atRight) = true;
            else
                (other->y() < y() ? higher : lower) = true;
        }
        // What lies outside the widget is not seen: the next segment draws the line between them.
        QPainterPath path;
        path.addRoundedRect(box.adjusted(atLeft ? -corner : 0, higher ? -corner : 0,
                                         atRight ? corner + 1 : 0, lower ? corner + 1 : 0),
                            corner, corner);
        if (atLeft) {
            path.moveTo(box.topLeft());
            path.lineTo(box.bottomLeft() + QPointF(0, lower ? 1 : 0));
        }
        if (higher) {
            path.moveTo(box.topLeft());
            path.lineTo(box.topRight() + QPointF(atRight ? 1 : 0, 0));
        }
        return path;
    }

    const SegmentedControl& m_control;
};

/// One row of natural widths; where that has no room, as few rows as fit, as a grid that fills the
/// width.
class SegmentLayout final : public FlowLayout {
public:
    explicit SegmentLayout(QWidget* parent)
        : FlowLayout(parent, 0)
    {}

    int heightForWidth(int width) const override { return rowsFor(width) * sizeHint().height(); }

    void setGeometry(const QRect& rect) override
    {
        const int rows = rowsFor(rect.width());
        if (rows <= 1) {
            FlowLayout::setGeometry(rect);
            return;
        }
        setRect(rect);
        const std::vector<int> edges = columnEdges(rows, rect.width());
        const int columns = static_cast<int>(edges.size()) - 1;
        const int height = sizeHint().height();
        for (int i = 0; i < count(); ++i) {
            const auto column = static_cast<std::size_t>(i % columns);
            const int left = edges[column];
            const int right = i == count() - 1 ? edges.back() : edges[column + 1];
            const QRect cell(rect.x() + left, rect.y() + i / columns * height, right - left,
                             height);
            itemAt(i)->setGeometry(
                QStyle::visualRect(parentWidget()->layoutDirection(), rect, cell));
        }
    }

private:
    /// The x of each column's left side and of the right side of the last; room left over is
    /// shared.
    std::vector<int> columnEdges(int rows, int width) const
    {
        const int columns = (count() + rows - 1) / rows;
        std::vector<int> edges(static_cast<std::size_t>(columns) + 1, 0);
        for (int i = 0; i < count(); ++i) {
            int& widest = edges[static_cast<std::size_t>(i % columns) + 1];
            widest = std::max(widest, itemAt(i)->sizeHint().width());
        }
        std::partial_sum(edges.begin(), edges.end(), edges.begin());
        const int spare = std::max(0, width - edges.back());
        for (int column = 1; column <= columns; ++column)
            edges[static_cast<std::size_t>(column)] += spare * column / columns;
        return edges;
    }

    int rowsFor(int width) const
    {
        int rows = 1;
        while (rows < count() && columnEdges(rows, 0).back() > width)
            ++rows;
        return rows;
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
    new SegmentLayout(this);
    connect(m_group, &QButtonGroup::idClicked, this, &SegmentedControl::chosen);
}

QAbstractButton* SegmentedControl::addSegment(const QString& objectName)
{
    auto* button = new Segment(*this);
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
