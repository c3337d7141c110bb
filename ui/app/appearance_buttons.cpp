// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/appearance_buttons.h"

#include "ui/common/language_switch.h"
#include "ui/common/theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

namespace ui {
namespace {
const QString englishCode = QStringLiteral("en");
const QString chineseCode = QStringLiteral("zh_CN");

/// The usual sign for light and dark: a disk, one half filled.
QIcon themeIcon(const QPalette& palette, double ratio)
{
    constexpr int side = 16;
    QPixmap picture(QSize(side, side) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF disk(1.5, 1.5, side - 3, side - 3);
    painter.setPen(QPen(palette.color(QPalette::ButtonText), 1.4));
    painter.drawEllipse(disk);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::ButtonText));
    painter.drawPie(disk, -90 * 16, 180 * 16);
    return picture;
}
} // namespace

AppearanceButtons::AppearanceButtons(ThemeSwitch& theme, LanguageSwitch& language,
                                     Commands& commands, session::Settings& settings,
                                     QWidget* parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_language(language)
    , m_commands(commands)
    , m_settings(settings)
    , m_languageButton(new QToolButton(this))
    , m_themeButton(new QToolButton(this))
{
    m_languageButton->setObjectName(QStringLiteral("languageButton"));
    m_themeButton->setObjectName(QStringLiteral("themeButton"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->addWidget(m_languageButton);
    row->addWidget(m_themeButton);
    connectCommands();
    connect(m_languageButton, &QToolButton::clicked, this,
            [this] { m_language.apply(m_language.chinese() ? englishCode : chineseCode); });
    connect(m_themeButton, &QToolButton::clicked, this, [this] {
        m_theme.apply(isDark(palette()) ? session::Theme::Light : session::Theme::Dark);
    });
    connect(&m_language, &LanguageSwitch::changed, this, &AppearanceButtons::onLanguageChanged);
    connect(&m_theme, &ThemeSwitch::changed, this, &AppearanceButtons::onThemeChanged);
    showChoices();
}

void AppearanceButtons::connectCommands()
{
    const auto on = [this](Command command, auto slot) {
        connect(m_commands.action(command), &QAction::triggered, this, slot);
    };
    on(Command::ThemeSystem, [this] { m_theme.apply(session::Theme::System); });
    on(Command::ThemeLight, [this] { m_theme.apply(session::Theme::Light); });
    on(Command::ThemeDark, [this] { m_theme.apply(session::Theme::Dark); });
    on(Command::English, [this] { m_language.apply(englishCode); });
    on(Command::Chinese, [this] { m_language.apply(chineseCode); });
}

void AppearanceButtons::onLanguageChanged()
{
    m_settings.setLanguage(m_language.chinese() ? chineseCode : englishCode);
    showChoices();
}

void AppearanceButtons::onThemeChanged()
{
    m_settings.setTheme(m_theme.theme());
    m_commands.updateIcons();
    showChoices();
}

void AppearanceButtons::showChoices()
{
    m_commands.action(Command::Chinese)->setChecked(m_language.chinese());
    m_commands.action(Command::English)->setChecked(!m_language.chinese());
    const session::Theme theme = m_theme.theme();
    m_commands.action(Command::ThemeSystem)->setChecked(theme == session::Theme::System);
    m_commands.action(Command::ThemeLight)->setChecked(theme == session::Theme::Light);
    m_commands.action(Command::ThemeDark)->setChecked(theme == session::Theme::Dark);
    m_themeButton->setIcon(themeIcon(palette(), devicePixelRatioF()));
}

void AppearanceButtons::retranslate()
{
    const bool hasFont = LanguageSwitch::canShowChinese();
    const QString name = hasFont ? QStringLiteral("中") : QStringLiteral("ZH");
    m_languageButton->setText(m_language.chinese() ? name + QStringLiteral(" / EN")
                                                   : QStringLiteral("EN / ") + name);
    m_languageButton->setToolTip(hasFont ? tr("Switches between English and Chinese")
                                         : tr("Switches between English and Chinese; no Chinese "
                                              "font is installed (Debian: fonts-noto-cjk)"));
    m_languageButton->setAccessibleName(tr("Language"));
    m_themeButton->setToolTip(tr("Switches between the light and dark themes"));
    m_themeButton->setAccessibleName(tr("Theme"));
}
} // namespace ui
