// SPDX-License-Identifier: GPL-3.0-or-later
// The toolbar of the memory page: filter, order, live reading, the padlock, and the commands for
// the whole table. Remembers its choices in the settings. Owned by the page; main thread.
#pragma once

#include "session/settings.h"
#include "ui/common/commands.h"
#include "ui/memory/memory_filter.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace ui {
class FlowLayout;
class LockBadge;

class MemoryToolbar final : public QWidget {
    Q_OBJECT

public:
    MemoryToolbar(Commands& commands, session::Settings& settings, QWidget* parent);

    LockBadge* lockBadge() const { return m_lock; }
    bool physicalFirst() const;
    /// Nullopt: off; 0: as fast as the wire allows.
    std::optional<base::Duration> livePeriod() const;
    void focusSearch();

Q_SIGNALS:
    void textChanged(const QString& text);
    void rowFilterChanged(ui::RowFilter choice);
    void groupChanged(std::optional<catalog::Area> group);
    void physicalFirstChanged(bool on);
    void livePeriodChanged();
    void helpRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void addFind();
    void addChoices();
    void addOrder();
    void addLive();
    void addCommands();
    QToolButton* segment(const QString& name, QButtonGroup* group, QWidget* box);
    QToolButton* commandButton(const QString& name, Command command, bool withText);
    void retranslate();
    void retranslateLists();

    Commands& m_commands;
    session::Settings& m_settings;
    FlowLayout* m_layout;
    QLineEdit* m_find = nullptr;
    QButtonGroup* m_rowFilters = nullptr;
    QButtonGroup* m_order = nullptr;
    QComboBox* m_groups = nullptr;
    QLabel* m_liveLabel = nullptr;
    QComboBox* m_live = nullptr;
    LockBadge* m_lock = nullptr;
    QToolButton* m_help = nullptr;
    std::vector<QToolButton*> m_commandButtons;
};
} // namespace ui
