// SPDX-License-Identifier: GPL-3.0-or-later
// Play, pause, speed and position of a recording that is shown again. Knows time only; the chart
// follows positionChanged(). Owned by its parent; main thread.
#pragma once

#include "recording/sample_store.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace ui {
class ReplayBar final : public QWidget {
    Q_OBJECT

public:
    explicit ReplayBar(QWidget* parent = nullptr);

    /// A new recording, shown from its beginning, standing still.
    void setRecording(const QString& name, const recording::TimeSpan& span);
    base::Duration position() const { return m_position; }
    bool isPlaying() const { return m_tick.isActive(); }
    void setPlaying(bool on);

Q_SIGNALS:
    void positionChanged(base::Duration place);

protected:
    void changeEvent(QEvent* event) override;

private:
    void advance();
    void seek(base::Duration place);
    void retranslate();
    void updatePositionLabel();

    recording::TimeSpan m_span;
    base::Duration m_position{};
    QString m_name;
    QToolButton* m_play = nullptr;
    QSlider* m_slider = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_label = nullptr;
    QTimer m_tick;
    QElapsedTimer m_since;
};
} // namespace ui
