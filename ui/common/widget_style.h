// SPDX-License-Identifier: GPL-3.0-or-later
// What every page is built of: cards with padding on the window's quiet ground, their headings, and
// the program's one kind of table. The colors are in the theme's style rules. Main thread; the
// widgets stay with their owner.
#pragma once

class QLabel;
class QPushButton;
class QScrollArea;
class QTableView;
class QWidget;

namespace ui {
constexpr int cardMargin = 8;    ///< inside a card, and between cards
constexpr int dialogMargin = 16; ///< around the content of a dialog
constexpr int cellMargin = 5;    ///< at both sides of the text in a table, as in its header
constexpr int rowPadding = 10;   ///< of a table, list or tree, above its text's height

/// Gives the panel a card's ground, border and padding. Call it when the panel has its layout.
void makeCard(QWidget* panel);

/// The same for a panel that a table fills up to the border.
void makeTableCard(QWidget* panel);

/// Shows the ground of the card the area lies on. Call it when the area has its widget.
void makeTransparent(QScrollArea* area);

/// The title of a card or of a part of it.
void makeHeading(QLabel* label);

/// A sentence in the middle of a pane that has nothing to show yet.
void makeEmptyState(QLabel* label);

/// The one button of a card or dialog that does what it is there for.
void makeMainAction(QPushButton* button);

/// Whole rows are selected, every second row is tinted, there is no grid, and Tab leaves the table.
/// Columns, editing and selection mode are the caller's.
void styleTable(QTableView* table);
} // namespace ui
