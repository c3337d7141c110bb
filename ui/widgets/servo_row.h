// SPDX-License-Identifier: GPL-3.0-or-later
// One servo of the list as text: what is known about it, its state, and remarks. Contains only what
// was really read; the rest is shown as unknown. A value; main thread. The texts are made in the
// current language.
#pragma once

#include "session/workbench.h"
#include "ui/common/theme.h"

#include <QMetaType>

namespace ui {
struct ServoRemark {
    Tone tone = Tone::Warn;
    QString text;
    bool operator==(const ServoRemark&) const = default;
};

struct ServoRow {
    session::ServoRef ref = 0;
    int id = -1;
    QString model;
    QString firmware; ///< "3.10"; empty: unknown
    QString map;
    QString line;
    QString rate;
    QString protocol;
    QString alarm; ///< "fine", "overload", "no answer" …
    Tone alarmTone = Tone::Quiet;
    QString lastSeen; ///< "12 s ago"
    std::vector<ServoRemark> remarks;
    bool isSilent = false;

    QString details() const;     ///< "fw 3.10 · sts-sms · TTL · 1 M"
    QString toolTipText() const; ///< many lines: the tooltip
    bool operator==(const ServoRow&) const = default;
};

/// `firmwareDiffers`: from that of the other servos of its model.
ServoRow servoRow(const session::ServoEntry& entry,
                  const std::optional<catalog::KnownFirmware>& newer, base::Duration now,
                  bool firmwareDiffers = false);
} // namespace ui
Q_DECLARE_METATYPE(ui::ServoRow)
