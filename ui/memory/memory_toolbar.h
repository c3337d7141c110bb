// SPDX-License-Identifier: GPL-3.0-or-later
// The toolbar of the memory page: filter, order, the padlock, and a menu with live reading and the
// commands for the whole table. Remembers its choices in the settings. Owned by the page; main
// thread.
#pragma once

#include "session/settings.h"
#include "ui/common/commands.h"
#include "ui/memory/memory_filter.h"

#include <QWidget>

class QComboBox;
class QAction;
class QLineEdit;
class QMenu;
class QToolButton;

namespace ui {
class FlowLayout;
class LockBadge;
class SegmentedControl;

class MemoryToolbar final : public QWidget {
    Q_OBJECT

public:
    MemoryToolbar(Commands& commands, session::Settings& settings, QWidget* parent);

    LockBadge* lockBadge() const { return m_lock; }
    bool physicalFirst() const;
    /// Nullopt: off; 0: as fast as the wire allows.
    std::optional<base::Duration> livePeriod() const;
    void focusSearch();
    /// Empty until it is opened; the page fills it.
    QMenu* columnMenu() const { return m_columns; }

Q_SIGNALS:
    void textChanged(const QString& text);
    void rowFilterChanged(ui::RowFilter choice);
    void groupChanged(std::optional<catalog::Area> group);
    void physicalFirstChanged(bool on);
    void livePeriodChanged();
    void helpRequested();

private:
    void addFind();
    void addChoices();
    void addOrder();
    void addReadAll();
    void addMenu();
    void addLive();
    void retranslate();
    void retranslateLists();
    static QString liveRateText(int rate);
    void showLiveRate();

    Commands& m_commands;
    session::Settings& m_settings;
    FlowLayout* m_layout;
    QLineEdit* m_find = nullptr;
    SegmentedControl* m_rowFilters = nullptr;
    SegmentedControl* m_order = nullptr;
    QComboBox* m_groups = nullptr;
    LockBadge* m_lock = nullptr;
    QToolButton* m_readAll = nullptr;
    QToolButton* m_more = nullptr;
    QMenu* m_menu = nullptr;
    QMenu* m_live = nullptr;
    QMenu* m_columns = nullptr;
    QAction* m_help = nullptr;
    int m_liveRate = 0; ///< as stored
};
} // namespace ui
