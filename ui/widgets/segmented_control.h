// SPDX-License-Identifier: GPL-3.0-or-later
// Two to six choices side by side of which one is selected, in one frame; in more than one row
// only if there is no room. Owned by its parent; main thread.
#pragma once

#include <QAbstractButton>
#include <QWidget>

class QButtonGroup;

namespace ui {
class SegmentedControl : public QWidget {
    Q_OBJECT

public:
    explicit SegmentedControl(QWidget* parent);

    /// The first gets number 0. Text, tooltip and accessible name are the caller's, by
    /// setButtonText().
    QAbstractButton* addSegment(const QString& objectName);
    QAbstractButton* segment(int index) const;
    /// Removes all segments.
    void clear();

    /// Arrow keys select, as in any group of radio buttons, unless a choice has consequences: then
    /// they move the focus, and the space bar selects.
    void setArrowsSelect(bool select) { m_arrowsSelect = select; }
    bool arrowsSelect() const { return m_arrowsSelect; }

    /// -1: none is selected.
    int selected() const;
    /// Sends no signal. -1 deselects all.
    void select(int index);

Q_SIGNALS:
    void chosen(int index); ///< by the user, also the selected one again

private:
    QButtonGroup* m_group;
    bool m_arrowsSelect = true;
};
} // namespace ui
