// SPDX-License-Identifier: GPL-3.0-or-later
// The setup of a chart, saved under a name: channels, their style, time span. Channels are named by
// their keys, so a preset fits other servos with the same IDs. Stored in the settings; what cannot
// be read there is left out. Main thread.
#pragma once

#include "session/settings.h"
#include "ui/charts/trend_channel.h"

#include <QStringList>

namespace ui {
struct PresetChannel {
    QString key;
    bool visible = true;
    QColor color{};
    double scale = 1.0;
    double offset = 0.0;
    bool operator==(const PresetChannel&) const = default;
};

struct TrendPreset {
    base::Duration width = std::chrono::seconds(10);
    std::vector<PresetChannel> channels{};
    bool operator==(const TrendPreset&) const = default;
};

QStringList presetNames(const session::Settings& settings); ///< sorted
std::optional<TrendPreset> loadPreset(const session::Settings& settings, const QString& name);
/// Replaces one of the same name. False: no name.
bool savePreset(session::Settings& settings, const QString& name, const TrendPreset& preset);
void deletePreset(session::Settings& settings, const QString& name);
} // namespace ui
