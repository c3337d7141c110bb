// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark: the program's palette, the few style rules above Fusion, the matching icons, and
// the colors that carry a meaning. Switchable while the program runs; "system" follows the desktop.
// Main thread. Ask for colors when painting, never store them.
#pragma once

#include "session/settings.h"

#include <QColor>
#include <QObject>
#include <QPalette>

#include <optional>

namespace ui {
enum class Tone : std::uint8_t { Good, Warn, Bad, Quiet, Accent };

/// Readable on the base and window colors of this palette. Never the only sign of anything.
QColor tone(Tone tone, const QPalette& palette);
bool isDark(const QPalette& palette);

class SystemTheme;

class ThemeSwitch final : public QObject {
    Q_OBJECT

public:
    /// Needs the QApplication; applies nothing yet.
    explicit ThemeSwitch(QObject* parent = nullptr);

    session::Theme theme() const { return m_theme; }
    void apply(session::Theme theme);

Q_SIGNALS:
    void changed(); ///< chosen, and palette and icon theme fit the choice

private:
    void show();
    void paint();
    bool usesDarkTheme() const;

    session::Theme m_theme = session::Theme::System;
    SystemTheme* m_desktop;
    std::optional<bool> m_shownDark; ///< nothing before the first time
};
} // namespace ui
