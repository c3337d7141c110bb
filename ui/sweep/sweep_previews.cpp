// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_previews.h"

#include "device/motion/move_limits.h"

#include <algorithm>

namespace ui {
using namespace std::chrono_literals;

namespace {
constexpr auto previewDelay = 250ms; ///< after the last letter
constexpr auto retryAfter = 1s;      ///< of a servo that answers again
constexpr auto retryPeriod = 3s;     ///< of one that nothing else reads

QString settingsOf(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile)
        return {};
    const catalog::Mode* mode = entry->servo.mode();
    const auto span = device::goalSliderRange(entry->servo);
    return QStringLiteral("%1 %2 %3 %4")
        .arg(mode != nullptr ? mode->key : QString())
        .arg(span ? span->min : 0)
        .arg(span ? span->max : 0)
        .arg(int(entry->stopped) + 2 * int(entry->silent));
}

bool isWithoutAnswer(const session::SweepPreview& preview)
{
    using base::ErrorCode;
    return preview.error && (preview.error->code == ErrorCode::NoReply ||
                             preview.error->code == ErrorCode::Garbled ||
                             preview.error->code == ErrorCode::UnexpectedReply ||
                             preview.error->code == ErrorCode::LineBusy);
}
} // namespace

SweepPreviews::SweepPreviews(session::SweepTest& test, const session::ServoRegistry& registry,
                             QObject* parent)
    : QObject(parent)
    , m_test(test)
    , m_registry(registry)
{
    m_delayTimer.setSingleShot(true);
    m_delayTimer.setInterval(previewDelay);
    connect(&m_delayTimer, &QTimer::timeout, this, &SweepPreviews::due);
    m_retryTimer.setSingleShot(true);
    m_retryTimer.setInterval(retryPeriod);
    connect(&m_retryTimer, &QTimer::timeout, this, &SweepPreviews::outdated);
    connect(&test, &session::SweepTest::previewReady, this, &SweepPreviews::take);
    connect(&registry, &session::ServoRegistry::servoChanged, this, &SweepPreviews::onServoRead);
    connect(&registry, &session::ServoRegistry::tableChanged, this, &SweepPreviews::onServoRead);
}

bool SweepPreviews::isWrongMode(const session::SweepPreview& preview)
{
    return preview.error && preview.error->reason == base::Reason::NotInPositionMode;
}

/// Changes from now on cause another reading, earlier ones do not: a reading of several silent
/// servos takes long and would never come to its end.
void SweepPreviews::request(const session::SweepTestRequest& request)
{
    rememberSettings(request.servos);
    m_test.preview(request);
}

void SweepPreviews::clear(const std::vector<session::ServoRef>& servos)
{
    rememberSettings(servos);
    m_previews.clear();
}

void SweepPreviews::follow(const std::vector<session::ServoRef>& servos)
{
    m_requested = servos;
    for (const session::ServoRef ref : servos)
        m_knownSettings.try_emplace(ref, settingsOf(m_registry.servo(ref)));
}

void SweepPreviews::rememberSettings(const std::vector<session::ServoRef>& servos)
{
    m_requested = servos;
    m_knownSettings.clear();
    for (const session::ServoRef ref : servos)
        m_knownSettings[ref] = settingsOf(m_registry.servo(ref));
}

void SweepPreviews::take(const std::vector<session::SweepPreview>& previews)
{
    m_previews = previews;
    m_receivedAt = m_registry.now();
    rememberSettings(std::vector(m_requested));
    if (std::any_of(previews.begin(), previews.end(), isWithoutAnswer))
        m_retryTimer.start();
    else
        m_retryTimer.stop();
    Q_EMIT received();
}

/// Mode or limits have changed, or a servo that could not be read answers: the previews may be
/// wrong now.
void SweepPreviews::onServoRead(session::ServoRef ref)
{
    const auto known = m_knownSettings.find(ref);
    if (known == m_knownSettings.end())
        return;
    const bool changed = known->second != settingsOf(m_registry.servo(ref));
    if (changed)
        Q_EMIT settingsChanged();
    // Readings come faster than the timer runs, so they must not restart it.
    if (!m_delayTimer.isActive() && (changed || isAnySilentOneHeard()))
        Q_EMIT outdated();
}

/// After a reading without an answer.
bool SweepPreviews::isAnySilentOneHeard() const
{
    return std::any_of(m_previews.begin(), m_previews.end(),
                       [this](const session::SweepPreview& one) {
                           const session::ServoEntry* entry = m_registry.servo(one.servo);
                           return isWithoutAnswer(one) && entry != nullptr && !entry->silent &&
                                  entry->lastSeen - m_receivedAt > retryAfter;
                       });
}
} // namespace ui
