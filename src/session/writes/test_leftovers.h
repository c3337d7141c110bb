// SPDX-License-Identifier: GPL-3.0-or-later
// What a test has left in its servos: torque it could not prove to be off, a motion it could not
// end, settings it could not put back. While there is any the registers concerned are read
// regularly, and each is removed once a reading proves that it is over. Workbench must outlive it;
// main thread.
#pragma once

#include "jobs/sweep/sweep.h"
#include "session/workbench.h"

namespace session {
class TestLeftovers final : public QObject {
    Q_OBJECT

public:
    /// `user`: the name of its subscription.
    TestLeftovers(Workbench& workbench, const QString& user, QObject* parent = nullptr);

    void clear();
    /// `notices`: those with NoticeCode::SettingNotRestored count.
    void setLeftovers(std::vector<jobs::UnreleasedTorque> torque, const device::Notices& notices);

    const std::vector<jobs::UnreleasedTorque>& torque() const { return m_torque; }
    const device::Notices& settings() const { return m_settings; }
    bool empty() const { return m_torque.empty() && m_settings.empty(); }

Q_SIGNALS:
    void changed(); ///< something of it is over

private:
    void addServo(int id);
    void updateSubscription();
    void check(ServoRef ref);
    bool concerns(const device::Servo& servo) const;

    Workbench& m_workbench;
    QString m_user;
    std::vector<jobs::UnreleasedTorque> m_torque;
    device::Notices m_settings;
    std::map<int, base::ServoIdentity> m_servos; ///< by ID; they may enter the list anew
    base::Duration m_since{}; ///< workbench clock: only what is read later proves
    bool m_subscribed = false;
};
} // namespace session
