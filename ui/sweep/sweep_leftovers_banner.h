// SPDX-License-Identifier: GPL-3.0-or-later
// Shows in the banner of the sweep page why a test failed and what it has left in its servos, until
// that is resolved or the user dismisses it. One message at a time. Owned by the page; main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/sweep/sweep_test.h"

namespace ui {
class Banner;

class SweepLeftoversBanner final : public QObject {
    Q_OBJECT

public:
    SweepLeftoversBanner(session::SweepTest& test, const session::ServoRegistry& registry,
                         const session::HistoryService& history, Banner& banner, QObject* parent);

    void hide();
    /// Of the test that has ended. Nothing if it has left nothing and did not fail.
    void show(const std::optional<base::Error>& error = {});

private:
    void showNotSaved(const base::Error& error, const QString& file);
    void update();
    QString unrevertedSettingsText() const;

    const session::ServoRegistry& m_registry;
    session::SweepTest& m_test;
    Banner& m_banner;
    bool m_shown = false;                 ///< what the test has left in its servos
    std::optional<base::Error> m_failure; ///< shown beside it
};
} // namespace ui
