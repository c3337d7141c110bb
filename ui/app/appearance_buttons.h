// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons for language and theme, and the commands for the same; remembers what was chosen.
// Owned by the window; main thread.
#pragma once

#include "session/settings.h"
#include "ui/common/commands.h"

#include <QWidget>

class QToolButton;

namespace ui {
class LanguageSwitch;
class ThemeSwitch;

class AppearanceButtons final : public QWidget {
    Q_OBJECT

public:
    AppearanceButtons(ThemeSwitch& theme, LanguageSwitch& language, Commands& commands,
                      session::Settings& settings, QWidget* parent);

    void retranslate();

private:
    void connectCommands();
    void onLanguageChanged();
    void onThemeChanged();
    void showChoices();

    ThemeSwitch& m_theme;
    LanguageSwitch& m_language;
    Commands& m_commands;
    session::Settings& m_settings;
    QToolButton* m_languageButton;
    QToolButton* m_themeButton;
};
} // namespace ui
