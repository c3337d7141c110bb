// SPDX-License-Identifier: GPL-3.0-or-later
// A row of widgets that continues in the next line where the width ends. Owned by its widget; main
// thread.
#pragma once

#include <QLayout>

#include <vector>

namespace ui {
class FlowLayout : public QLayout {
public:
    explicit FlowLayout(QWidget* parent = nullptr, int spacing = 8);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

protected:
    /// For a layout that places the items itself.
    void setRect(const QRect& rect) { QLayout::setGeometry(rect); }

private:
    /// Places the items, or only measures; the height they need.
    int arrange(const QRect& rect, bool measureOnly) const;

    void placeLine(const QRect& rect, std::size_t first, std::size_t last, int y, int height) const;

    std::vector<QLayoutItem*> m_items; ///< owned
};
} // namespace ui
