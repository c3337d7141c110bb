// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/language_switch.h"

#include "text/language.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QLocale>

static void initQtTranslations()
{
    Q_INIT_RESOURCE(qt_translations);
}

namespace ui {
void LanguageSwitch::apply(const QString& language)
{
    initQtTranslations();
    QCoreApplication::removeTranslator(&m_qt);
    const QString chosen = text::installTranslator(language);
    const bool isUiChinese = chosen == QLatin1String("zh_CN");
    QLocale::setDefault(isUiChinese ? QLocale(QLocale::Chinese, QLocale::China)
                                    : QLocale(QLocale::English, QLocale::UnitedStates));
    if (isUiChinese && m_qt.load(QStringLiteral(":/i18n/qtbase_zh_CN.qm")))
        QCoreApplication::installTranslator(&m_qt);
    Q_EMIT changed();
}

bool LanguageSwitch::chinese() const
{
    return text::isUiChinese();
}

bool LanguageSwitch::canShowChinese()
{
    return !QFontDatabase::families(QFontDatabase::SimplifiedChinese).isEmpty();
}
} // namespace ui
