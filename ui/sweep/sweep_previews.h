// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the servos of a sweep test can run it, read from them before the test, and when that has
// to be read again: after a change of mode or limits, or once a silent servo answers. The page
// decides whether a reading may start. Owned by the page; main thread, never waits.
#pragma once

#include "session/sweep/sweep_test.h"

#include <QTimer>

namespace ui {
class SweepPreviews final : public QObject {
    Q_OBJECT

public:
    SweepPreviews(session::SweepTest& test, const session::ServoRegistry& registry,
                  QObject* parent);

    const std::vector<session::SweepPreview>& all() const { return m_previews; }
    static bool isWrongMode(const session::SweepPreview& preview);

    void schedule() { m_delayTimer.start(); } ///< due() follows, once no more changes come
    void cancel() { m_delayTimer.stop(); }
    void request(const session::SweepTestRequest& request); ///< received() follows
    void clear(const std::vector<session::ServoRef>& servos);
    /// Notes the settings of servos that were not noted yet: they may fall silent before the
    /// reading.
    void follow(const std::vector<session::ServoRef>& servos);

Q_SIGNALS:
    void due();
    void received();
    void settingsChanged(); ///< a servo has another mode or other limits, or no longer answers
    void outdated();        ///< a new reading is worthwhile

private:
    void take(const std::vector<session::SweepPreview>& previews);
    void onServoRead(session::ServoRef ref);
    bool isAnySilentOneHeard() const;
    void rememberSettings(const std::vector<session::ServoRef>& servos);

    session::SweepTest& m_test;
    const session::ServoRegistry& m_registry;
    QTimer m_delayTimer;
    QTimer m_retryTimer; ///< after a reading without an answer: nothing else may read those servos
    std::vector<session::SweepPreview> m_previews;
    std::vector<session::ServoRef> m_requested;           ///< the servos of the latest request
    base::Duration m_receivedAt{};                        ///< the registry's clock
    std::map<session::ServoRef, QString> m_knownSettings; ///< mode and limits when they were read
};
} // namespace ui
