// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons above the trend chart, in one row where there is room. Shows states and emits
// requests. Owned by its parent; main thread.
#pragma once

#include "base/clock.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace ui {
class FlowLayout;

class TrendToolbar final : public QWidget {
    Q_OBJECT

public:
    explicit TrendToolbar(QWidget* parent = nullptr);

    void setFollowing(bool following);
    void setShownWidth(base::Duration width);
    void setCursorsShown(bool shown);
    void setLanes(bool on);
    void setTrigger(const QString& text, bool waiting); ///< empty: none
    void showMenu(const QPoint& place);                 ///< on the screen
    /// "00:12 · 5580 rows"; empty: nothing is recorded.
    void setRecording(const QString& text);
    void setRate(int hz); ///< 0: as fast as the wire allows
    void setMemory(int megabytes);
    void setReplaying(bool replaying);
    void setPresets(const QStringList& names);

Q_SIGNALS:
    void followRequested(bool on);
    void widthRequested(base::Duration width);
    void fitRequested();
    void backRequested();
    void cursorsRequested(bool on);
    void lanesRequested(bool on);
    void channelsRequested();
    void triggerRequested();
    void recordRequested();
    void openRequested();
    void liveRequested();
    void exportRequested();
    void clearRequested();
    void presetRequested(const QString& name);
    void presetSaveRequested();
    void presetRemoveRequested(const QString& name);
    void rateRequested(int hz); ///< 0: as fast as the wire allows
    void memoryRequested(int megabytes);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* addButton(const char* name, const char* icon, bool checkable = false);
    void connectControls();
    void fitTexts();
    void fillMenu();
    void addRates();
    void addMemories();
    void addChoice(QMenu* menu, const QString& text, bool isChosen,
                   const std::function<void()>& choose);
    void addPresets();
    void retranslate();
    void retranslateWidths();

    FlowLayout* m_layout = nullptr;
    QToolButton* m_pause = nullptr;
    QComboBox* m_width = nullptr;
    QToolButton* m_fit = nullptr;
    QToolButton* m_lanes = nullptr;
    QToolButton* m_cursors = nullptr;
    QToolButton* m_channels = nullptr;
    QToolButton* m_trigger = nullptr;
    QToolButton* m_more = nullptr;
    QToolButton* m_live = nullptr;
    QToolButton* m_record = nullptr;
    QLabel* m_recordState = nullptr;
    QMenu* m_menu = nullptr;
    QStringList m_presets;
    QString m_triggerWords;
    QString m_recordWords;
    int m_rate = 0;   ///< Hz
    int m_memory = 0; ///< MB
    bool m_replaying = false;
    bool m_isFitting = false;
};
} // namespace ui
