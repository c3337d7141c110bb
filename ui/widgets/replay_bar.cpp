// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/replay_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr std::array speeds{0.1, 0.5, 1.0, 2.0, 5.0, 20.0, 100.0};
constexpr int defaultSpeed = 2;
constexpr int sliderSteps = 10000;
constexpr auto interval = 33ms;

QString clock(Duration at)
{
    const auto total = double(at.count()) / 1e6;
    const int minutes = int(total / 60);
    return QStringLiteral("%1:%2").arg(minutes).arg(total - minutes * 60, 5, 'f', 2,
                                                    QLatin1Char('0'));
}
} // namespace

ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    m_play = new QToolButton(this);
    m_play->setObjectName(QStringLiteral("replayPlay"));
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setObjectName(QStringLiteral("replaySlider"));
    m_slider->setRange(0, sliderSteps);
    m_speed = new QComboBox(this);
    m_speed->setObjectName(QStringLiteral("replaySpeed"));
    for (const double speed : speeds)
        m_speed->addItem(QStringLiteral("× %1").arg(speed));
    m_speed->setCurrentIndex(defaultSpeed);
    m_label = new QLabel(this);
    m_label->setObjectName(QStringLiteral("replayLabel"));
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    row->addWidget(m_label);
    row->addWidget(m_speed);
    m_tick.setInterval(interval);
    connect(&m_tick, &QTimer::timeout, this, &ReplayBar::advance);
    connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        const auto length = m_span.to - m_span.from;
        seek(m_span.from + Duration(length.count() * value / sliderSteps));
    });
    retranslate();
}

void ReplayBar::setRecording(const QString& name, const recording::TimeSpan& span)
{
    setPlaying(false);
    m_name = name;
    m_span = span;
    seek(span.from);
    retranslate();
}

void ReplayBar::setPlaying(bool on)
{
    if (on && m_position >= m_span.to)
        seek(m_span.from);
    if (on) {
        m_since.start();
        m_tick.start();
    } else {
        m_tick.stop();
    }
    retranslate();
}

void ReplayBar::advance()
{
    const double speed = speeds.at(static_cast<std::size_t>(std::max(m_speed->currentIndex(), 0)));
    const auto gone =
        Duration(static_cast<Duration::rep>(double(m_since.nsecsElapsed()) / 1e3 * speed));
    m_since.restart();
    seek(m_position + gone);
    if (m_position >= m_span.to)
        setPlaying(false);
}

void ReplayBar::seek(Duration place)
{
    m_position = std::clamp(place, m_span.from, std::max(m_span.from, m_span.to));
    updatePositionLabel();
    Q_EMIT positionChanged(m_position);
}

void ReplayBar::updatePositionLabel()
{
    const auto length = std::max<Duration::rep>((m_span.to - m_span.from).count(), 1);
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(int((m_position - m_span.from).count() * sliderSteps / length));
    m_label->setText(clock(m_position - m_span.from) + QStringLiteral(" / ") +
                     clock(m_span.to - m_span.from));
}

void ReplayBar::retranslate()
{
    const QString icon = isPlaying() ? QStringLiteral("media-playback-pause")
                                     : QStringLiteral("media-playback-start");
    m_play->setIcon(QIcon::fromTheme(icon));
    m_play->setAccessibleName(isPlaying() ? tr("Pause") : tr("Play"));
    m_play->setToolTip(isPlaying() ? tr("Pause") : tr("Plays the recording"));
    m_slider->setAccessibleName(tr("Position in the recording"));
    m_slider->setToolTip(m_name.isEmpty() ? tr("Position in the recording") : m_name);
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("Playback speed"));
    m_label->setAccessibleName(tr("Time in the recording"));
}

void ReplayBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslate();
}
} // namespace ui
